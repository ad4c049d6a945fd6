#pragma once

#include <functional>
#include <vector>

#include <particulate/kinematics/starts.hpp>
#include <particulate/scattering/red_cell.hpp>

namespace particulate::scattering {

/// Whether two spheroids are apart, decided with certainty.
///
/// \f[ \max_{0 < \lambda < 1} \lambda (1 - \lambda)\, R^T \left[(1 - \lambda) A^{-1} + \lambda B^{-1}\right]^{-1} R
///     \ge 1, \qquad A^{-1} = \sum_i a_i^2\, u_i u_i^T \f]
///
/// with R between the centres. The function of lambda is concave: any lambda at which it reaches 1 certifies that they
/// are apart; where its value and slope leave no room for 1 in what is left of the interval, they overlap.
///
/// @equation{R 9.3.3} Perram and Wertheim, @cite perram1985.
/// @param one         a spheroid
/// @param other       another
/// @param separation  from the centre of the one to that of the other: its centre is not looked at [m]
/// @return false: they overlap; touching counts as apart
bool are_apart(const Spheroid& one, const Spheroid& other, const Eigen::Vector3d& separation);

/// Bodies that were put somewhere.
template <class B>
struct Placed {
  std::vector<B> bodies;  ///< none of which overlap
  long attempts = 0;      ///< places tried [-]
};

/// A direction, all alike.
///
/// @param uniform  draws a number in [0, 1), two of them
/// @return unit vector
Eigen::Vector3d random_direction(const std::function<double()>& uniform);

/// Spheres by random sequential addition. @see kinematics::random_addition()
///
/// @param n        how many
/// @param radius   of each [m]
/// @param to       the box, what counts as inside, and the periods
/// @param uniform  draws a number in [0, 1)
/// @return spheres in the order in which they were put
/// @throws std::invalid_argument as random_addition()
Placed<Sphere> place_spheres(Eigen::Index n, double radius, const kinematics::Addition& to,
                             const std::function<double()>& uniform);

/// Spheroids of one size by random sequential addition, each with an axis in a random direction; the overlap of two is
/// decided by are_apart().
///
/// @equation{R 9.3.3} Oblates of 4:1 come to a standstill near a fraction of 0.28.
/// @param n        how many
/// @param like     radii of each
/// @param to       the box, what counts as inside (whole bodies, or centres), and the periods
/// @param uniform  draws a number in [0, 1), five a try
/// @return spheroids in the order in which they were put
/// @throws std::invalid_argument for what cannot be meant, and where no place was found: with the fraction reached
Placed<Spheroid> place_spheroids(Eigen::Index n, const Spheroid& like, const kinematics::Addition& to,
                                 const std::function<double()>& uniform);

/// Red cells of one size likewise, apart by their bounding spheroids: two cells that would nest in each other's dimples
/// are not, which keeps the fraction lower than it could be.
///
/// @equation{R B.2}
/// @param n        how many
/// @param like     radius of each
/// @param to       the box, what counts as inside, and the periods
/// @param uniform  draws a number in [0, 1), five a try
/// @return cells in the order in which they were put
/// @throws std::invalid_argument as place_spheroids()
Placed<RedCell> place_red_cells(Eigen::Index n, const RedCell& like, const kinematics::Addition& to,
                                const std::function<double()>& uniform);

}  // namespace particulate::scattering
