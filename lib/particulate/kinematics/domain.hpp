#pragma once

#include <concepts>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace particulate::kinematics {

/// Where the particles live. It alone knows how to get from one place to another, so laws never subtract positions.
///
/// `separation(domain, from, to)` is found beside the domain's type.
template <class D>
concept Domain = requires(const D& domain, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  { separation(domain, from, to) } -> std::same_as<Eigen::Vector3d>;
};

/// Unbounded space.
struct Open {};

/// The vector that leads from one place to another in unbounded space.
///
/// @param from  a place [m]
/// @param to    another [m]
/// @return to - from [m]
inline Eigen::Vector3d separation(const Open&, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return to - from;
}

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

/// Unbounded space but for some walls.
struct Walled {
  std::vector<Wall> planes;  ///< the walls, each validated
};

/// Refuses a wall whose normal is no unit vector. Called once, where a domain enters a scene.
///
/// @param domain  space with walls
/// @throws std::invalid_argument naming the wall, what must hold and what was given
void validate(const Walled& domain);

/// The vector that leads from one place to another between walls.
///
/// @param from  a place [m]
/// @param to    another [m]
/// @return to - from [m]
inline Eigen::Vector3d separation(const Walled&, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return to - from;
}

/// @param domain  space with walls
/// @return its walls
inline std::span<const Wall> walls(const Walled& domain) { return domain.planes; }

/// A domain that has walls: `walls(domain)`.
template <class D>
concept HasWalls = Domain<D> && requires(const D& domain) {
  { walls(domain) } -> std::convertible_to<std::span<const Wall>>;
};

}  // namespace particulate::kinematics
