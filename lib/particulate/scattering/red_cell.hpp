#pragma once

#include <particulate/scattering/body.hpp>

namespace particulate::scattering {

/// A red blood cell: the biconcave disc of Evans and Fung.
///
/// \f[ z = \pm\frac{R_0}{2} \sqrt{1 - x^2}\, (C_0 + C_1 x^2 + C_2 x^4), \qquad x = \rho/R_0 \f]
///
/// @equation{R B.2} z is half of the thickness at the distance rho from the axis. With R_0 = 3.91 um a human cell of
/// 94.09 um^3 and 134.09 um^2, thickest, 2.566 um, at rho = 2.738 um, and 0.81 um thin in the middle. Larger and
/// smaller ones are of the same shape.
struct RedCell {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();   ///< of revolution, a unit vector [-]
  double radius = 3.91e-6;                           ///< R_0 > 0 [m]

  static constexpr double C0 = 0.81 / 3.91;   ///< [-]
  static constexpr double C1 = 7.83 / 3.91;   ///< [-]
  static constexpr double C2 = -4.39 / 3.91;  ///< [-]
};

/// Refuses a cell that is none.
///
/// @param body  the cell
/// @throws std::invalid_argument naming the number, what must hold and what was given
void validate(const RedCell& body);

/// Half of the thickness.
///
/// @equation{R B.2}
/// @param body  a cell
/// @param rho   distance from the axis, 0 to R_0 [m]
/// @return z [m]
double half_thickness(const RedCell& body, double rho);

/// A spheroid that contains the cell: radii 4.054 and 1.921 um for the human one, 1.405 times its volume.
///
/// @equation{R B.2}
/// @param body  a cell
/// @return spheroid about the same centre and axis
Spheroid bounding_spheroid(const RedCell& body);

/// @param body  a cell
/// @return R_0: its rim is farthest from the centre [m]
inline double bounding_radius(const RedCell& body) { return body.radius; }

/// @param body  a cell
/// @return half extents of its bounding spheroid: a little more than its own [m]
inline Eigen::Vector3d half_extents(const RedCell& body) {
  return half_extents(bounding_spheroid(body)).cwiseMin(body.radius);
}

/// First entry of a ray, exactly.
///
/// \f[ P = (1 - u)(C_0 + C_1 u + C_2 u^2)^2 - (2 z/R_0)^2, \qquad u = \rho^2/R_0^2 \le 1 \f]
///
/// @equation{R B.2} Positive inside. Along a ray P is of degree 10, in Bernstein's form over the part of the ray with
/// u <= 1, of which subdivision brackets the first root: where the signs of the coefficients do not change there is
/// none, where they change once there is one, which Newton's iteration within its bracket polishes. Coefficients are
/// formed as mean values alone, so that no digits are lost.
/// @param body       a cell
/// @param from       a place outside of it [m]
/// @param direction  a unit vector
/// @return distance; nowhere: the ray misses the cell [m]
double first_entry(const RedCell& body, const Eigen::Vector3d& from, const Eigen::Vector3d& direction);

/// Next entry of a ray that has been reflected at the surface: cells are not convex, and 1 to 2 % of rays meet the same
/// one again. The root where the ray starts is divided out.
///
/// @equation{R B.2}
/// @param body       a cell
/// @param from       a place of its surface [m]
/// @param direction  a unit vector that leads outwards; of a line that goes on inwards, the entry after that is told
/// @return distance; nowhere: the ray leaves the cell for good [m]
double next_entry(const RedCell& body, const Eigen::Vector3d& from, const Eigen::Vector3d& direction);

/// Minus the gradient of P, over its length: regular at the rim and in the dimples, where z has a slope without end or
/// none.
///
/// @equation{R B.2}
/// @param body   a cell
/// @param place  on its surface [m]
/// @return unit normal, outwards
Eigen::Vector3d outward_normal(const RedCell& body, const Eigen::Vector3d& place);

/// @param body   a cell
/// @param place  any [m]
/// @return whether it lies inside
bool contains(const RedCell& body, const Eigen::Vector3d& place);

/// Whether two cells are apart, by their bounding spheroids: cells that nest in each other's dimples are said to
/// overlap.
///
/// @equation{R B.2}
/// @param one    a cell
/// @param other  another
/// @return false: their bounding spheroids overlap
inline bool are_apart(const RedCell& one, const RedCell& other) {
  return are_apart(bounding_spheroid(one), bounding_spheroid(other));
}

/// Its volume.
///
/// \f[ V = \pi R_0^3 \left(\tfrac23 C_0 + \tfrac{4}{15} C_1 + \tfrac{16}{105} C_2\right) \f]
///
/// @equation{D B.2}
/// @param body  a cell
/// @return V [m^3]
double volume(const RedCell& body);

/// Its surface, by quadrature once for all cells, to some 1e-14.
///
/// @equation{D B.2}
/// @param body  a cell
/// @return area [m^2]
double area(const RedCell& body);

}  // namespace particulate::scattering
