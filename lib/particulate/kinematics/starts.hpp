#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <particulate/kinematics/domain.hpp>
#include <particulate/kinematics/particles.hpp>

/// @file
/// Where a cloud may start: at random, on a lattice, from a file.

namespace particulate::kinematics {

/// A box with edges along the axes.
struct Box {
  Eigen::Vector3d lengths = Eigen::Vector3d::Ones();  ///< of its edges, > 0 and finite [m]
  Eigen::Vector3d corner = Eigen::Vector3d::Zero();   ///< its least place [m]
};

/// What lies in the box.
enum class Inside {
  centres,  ///< centres alone: spheres may stick out (chapter 4)
  spheres   ///< whole spheres (chapter 9); in directions in which space repeats itself centres, as there is no edge
};

/// What random_addition() is asked for.
struct Addition {
  Box box = {};                     ///< where they are put; not longer than a period
  Inside inside = Inside::centres;  ///< what lies in it
  Space domain = {};                ///< which of the distances between two bodies counts; walls do not
  long most_attempts = 0;           ///< after which it is given up; 0: a thousand a sphere, and a million at least [-]
};

/// Spheres that were put somewhere.
struct Added {
  Vectors position;   ///< r_i, N x 3, none nearer to another than the sum of their radii [m]
  long attempts = 0;  ///< places tried, N at least [-]
};

/// Numbers evenly distributed in [0, 1), with 53 bits each, the same everywhere.
///
/// @param seed  another one, other numbers
/// @return draws the next one
std::function<double()> uniform_from(std::uint64_t seed);

/// The limit of random sequential addition of equal spheres, 4 pi b^3 N/(3 V), without edges: where space repeats
/// itself or is large. Source: @cite zhang2013.
inline constexpr double saturation = 0.3841;

/// Puts spheres into a box one after the other, each at a place drawn anew until it overlaps none before it: random
/// sequential addition.
///
/// @equation{R 4.1} The start of chapters 4 and 9. It is not a gas in equilibrium, and comes to a standstill: at the
/// fraction 0.3841 without edges; with 1000 spheres wholly inside a cube near 0.35, as edges keep them out; with
/// 1000 centres in a cube near 0.47, as half of a sphere may stick out. Near that each further sphere takes many
/// attempts: by default 1000 in a periodic cube reach 0.355. Of several sizes, more fit if the largest come first.
///
///     const Added added = random_addition(b, {.box = {...}}, uniform_from(seed));
///
/// @param radius   b_i >= 0 of each sphere, in the order in which they are put, N [m]
/// @param to       the box, and what counts as inside
/// @param uniform  draws a number in [0, 1), three a try: x, y, z
/// @return places and attempts
/// @throws std::invalid_argument for a box, a radius, a period or a bound that cannot be meant, and where no place was
///         found: with the fraction reached, and the limit
Added random_addition(const Eigen::VectorXd& radius, const Addition& to, const std::function<double()>& uniform);

/// The part of a box that spheres fill.
///
/// \f[ v_f = \frac{4\pi}{3V} \sum_i b_i^3 \f]
///
/// @equation{R 4.1} Of equal spheres \f$ \tfrac43 \pi L^3 \f$, with the length ratio \f$ L = b/(V/N_p)^{1/3} \f$.
/// @param radius  b_i, N [m]
/// @param box     of volume V
/// @return v_f, counting what sticks out [-]
double volume_fraction(const Eigen::VectorXd& radius, const Box& box);

/// Regular arrangements in cubic cells.
enum class Lattice {
  simple_cubic,        ///< one place a cell, its nearest neighbours an edge apart
  face_centred_cubic,  ///< four places a cell, their nearest neighbours an edge over sqrt(2) apart
};

/// Places of a lattice that fill a cube of n cells an edge, the fewest that hold so many, with the origin at its corner
/// and cells of places about their middle: repeated after n edges the lattice goes on.
///
/// @param kind  of lattice
/// @param N     how many places, >= 0 [-]
/// @param edge  of a cell, > 0 [m]
/// @return N x 3, cell by cell: x first, then y, then z; a last layer may be left unfinished [m]
/// @throws std::invalid_argument for an edge or a number that cannot be meant
Vectors lattice(Lattice kind, Eigen::Index N, double edge);

/// Particles from the lines of a file, such as report::parse_csv() reads them: a header, then one particle a line.
///
/// @param lines   the first with the names x, y, z, vx, vy, vz, m, b, and if some are not to move, immovable; then
///                numbers in SI units, and 0 or 1
/// @param origin  the file's name, for messages
/// @return particles, in their order
/// @throws std::invalid_argument with file and line, what must stand there and what does; and as validate() does
Particles particles_from(const std::vector<std::vector<std::string>>& lines, const std::string& origin);

/// Refuses spheres that overlap each other or a wall by more than roundings may add up to, 1e-12 of their places and
/// radii. A scene does not, as stepped contact takes what has come to overlap apart again: for starts that come from
/// elsewhere.
///
/// @param particles  a start; two that are immovable may overlap
/// @param domain     whose distances count, and whose walls
/// @return the deepest overlap, which roundings explain, or 0 [m]
/// @throws std::invalid_argument naming the deepest overlap, and whose it is; and as validate() does
double validate_apart(const Particles& particles, const Space& domain);

/// An order in which bodies that are near each other come after each other, for memory to be read in its order: along a
/// curve that fills space cell by cell (Morton's).
///
/// @param position  r_i, N x 3 [m]
/// @param edge      of the cells, > 0; about the spacing [m]
/// @return numbers of the bodies in that order; equal cells keep their order
/// @throws std::invalid_argument for an edge that is not positive
std::vector<Eigen::Index> order_by_cells(const VectorsIn& position, double edge);

/// @param particles  a set
/// @param order      the number of each particle to come, N of them
/// @return the same particles in that order
/// @throws std::invalid_argument unless each is there once
Particles reordered(const Particles& particles, const std::vector<Eigen::Index>& order);

}  // namespace particulate::kinematics
