#pragma once

#include <cstdint>

#include <harness/near_field_cloud.hpp>
#include <particulate/kinematics/particles.hpp>

/// @file
/// Where the motions of this chapter's cases start.

namespace verification {

/// A direction without zeros or equal components, of length 1 but for one rounding: 2^2 + 3^2 + 6^2 = 7^2.
inline Eigen::Vector3d slanted() { return Eigen::Vector3d{2.0, 3.0, 6.0} / 7.0; }

/// Places of two bodies about their centre of mass, for the separation 1: body j lies from body i along slanted().
inline particulate::kinematics::Vectors pair_shape(double m_i, double m_j) {
  particulate::kinematics::Vectors shape(2, 3);
  particulate::kinematics::set_vector(shape, 0, -m_j / (m_i + m_j) * slanted());
  particulate::kinematics::set_vector(shape, 1, m_i / (m_i + m_j) * slanted());
  return shape;
}

/// Bodies at rest, at `size` times the places of a shape, without extent.
inline particulate::kinematics::Particles at_rest(const particulate::kinematics::Vectors& shape, double size,
                                                  const Eigen::VectorXd& mass) {
  return {.position = size * shape,
          .velocity = particulate::kinematics::Vectors::Zero(shape.rows(), 3),
          .mass = mass,
          .radius = Eigen::VectorXd::Zero(shape.rows())};
}

/// Two bodies at rest about their centre of mass.
inline particulate::kinematics::Particles pair_at_rest(double m_i, double m_j, double apart) {
  return at_rest(pair_shape(m_i, m_j), apart, Eigen::Vector2d{m_i, m_j});
}

/// The seed of a cloud without a close encounter, for claims about orders and about agreement of integrators: they hold
/// where steps resolve the motion, and a run's own seed must not decide whether they do.
inline constexpr std::uint64_t smooth = 1;

}  // namespace verification
