#pragma once

#include <cmath>
#include <concepts>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace particulate::kinematics {

/// Where the particles live. It alone knows how to get from one place to another, so laws never subtract positions.
///
/// `separation(domain, from, to)` is found beside the domain's type. Space is the library's own, for which what takes
/// long is compiled once; a domain of one's own is served by templates over all pairs.
template <class D>
concept Domain = requires(const D& domain, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  { separation(domain, from, to) } -> std::same_as<Eigen::Vector3d>;
};

/// A plane that particles cannot pass, with space on the side that its normal points to.
struct Wall {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< any point of the plane [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit vector away from the wall [-]
};

/// How far a place lies above a wall.
///
/// @param wall   the plane
/// @param place  a place [m]
/// @return signed distance, negative behind the wall [m]
inline double height_above(const Wall& wall, const Eigen::Vector3d& place) {
  return (place - wall.point).dot(wall.normal);
}

/// Space: unbounded, between walls, or repeating itself in some directions, in which every body has an image after each
/// period. Places are not wrapped: a body that has gone through ten periods is ten lengths away, so that motion stays
/// smooth. wrapped() brings it home for output.
struct Space {
  std::vector<Wall> walls = {};  ///< planes that bound it, each validated; none: unbounded
  Eigen::Vector3d lengths =
      Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());  ///< after which it repeats itself in each
                                                                           ///< direction; infinite: it does not [m]
};

/// Refuses a wall whose normal is no unit vector, a length that is not positive, and a wall that stands across a
/// direction in which space repeats itself. Called once, where a domain enters a scene.
///
/// @param domain  space
/// @throws std::invalid_argument naming the wall or the direction, what must hold and what was given
void validate(const Space& domain);

/// Refuses periods in which the image of a body that another touches is not plainly its nearest: one shorter than two
/// diameters of the largest body.
///
/// @param domain  space that validate() accepts
/// @param radius  b_i, N [m]
/// @throws std::invalid_argument naming the direction and the body, what must hold and what was given
void validate_periods(const Space& domain, const Eigen::VectorXd& radius);

/// The shortest of a distance in one direction and those of its images.
///
/// @param d       distance [m]
/// @param length  after which space repeats itself in that direction; infinite: it does not [m]
/// @return d less whole lengths, at most half of one [m]
inline double nearest_image(double d, double length) {
  return std::abs(d) > 0.5 * length ? d - length * std::nearbyint(d / length) : d;
}

/// The vector that leads from one place to another, or to the image of that which is nearest in each direction.
///
/// @param domain  with its periods
/// @param from    a place [m]
/// @param to      another [m]
/// @return to - from, less whole periods, so that no component is longer than half a period [m]
inline Eigen::Vector3d separation(const Space& domain, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  Eigen::Vector3d d = to - from;
  for (Eigen::Index axis = 0; axis < 3; ++axis) d[axis] = nearest_image(d[axis], domain.lengths[axis]);
  return d;
}

/// The image of a place in the first period, for output.
///
/// @param domain  with its periods
/// @param place   a place [m]
/// @return the same less whole periods: from 0 up to, without, the length in directions that have one [m]
Eigen::Vector3d wrapped(const Space& domain, const Eigen::Vector3d& place);

/// @param domain  space
/// @return whether it repeats itself in some direction
inline bool has_periods(const Space& domain) { return domain.lengths.minCoeff() < std::numeric_limits<double>::max(); }

/// Length of a separation, whose square may be too small or too large for a double.
///
/// @param separation  from one place to another [m]
/// @return its norm [m]
inline double length(const Eigen::Vector3d& separation) {
  const double square = separation.squaredNorm();
  const bool full = square >= std::numeric_limits<double>::min() && square <= std::numeric_limits<double>::max();
  return full ? std::sqrt(square) : separation.stableNorm();
}

/// @param domain  space
/// @return its walls
inline std::span<const Wall> walls(const Space& domain) { return domain.walls; }

/// A domain that has walls: `walls(domain)`.
template <class D>
concept HasWalls = Domain<D> && requires(const D& domain) {
  { walls(domain) } -> std::convertible_to<std::span<const Wall>>;
};

}  // namespace particulate::kinematics
