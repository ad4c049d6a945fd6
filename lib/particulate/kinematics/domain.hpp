#pragma once

#include <concepts>

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

}  // namespace particulate::kinematics
