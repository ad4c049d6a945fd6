#pragma once

#include <cmath>
#include <cstdint>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <particulate/contact/near_field.hpp>
#include <particulate/kinematics/domain.hpp>
#include <particulate/kinematics/particles.hpp>
#include <particulate/scenes/scene.hpp>

/// @file
/// Where the motions of this chapter's cases start.

namespace verification {

using NearFieldScene = particulate::scenes::Scene<particulate::kinematics::Open, particulate::contact::NearField>;

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

/// What a cloud is made of.
struct Cloud {
  Eigen::Index N = 20;   ///< particles [-]
  double spacing = 1.0;  ///< of the lattice from which they are moved by up to a quarter [m]
  double speed = 0.2;    ///< largest velocity component [m/s]
  double decades = 0.3;  ///< masses are 10^x, x uniform in [-decades, decades] [-]
};

/// Particles near the points of a cubic lattice, no two nearer than half a spacing, everything else at random.
inline particulate::kinematics::Particles random_cloud(const Cloud& of, std::uint64_t seed) {
  boost::random::mt19937_64 engine(seed);
  boost::random::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto side = static_cast<Eigen::Index>(std::ceil(std::cbrt(static_cast<double>(of.N)) - 1e-9));
  using particulate::kinematics::Vectors;
  particulate::kinematics::Particles cloud{.position = Vectors(of.N, 3),
                                           .velocity = Vectors(of.N, 3),
                                           .mass = Eigen::VectorXd(of.N),
                                           .radius = Eigen::VectorXd(of.N)};
  for (Eigen::Index i = 0; i < of.N; ++i) {
    const Eigen::Index corner[3] = {i % side, i / side % side, i / (side * side)};
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      cloud.position(i, axis) = of.spacing * (static_cast<double>(corner[axis]) + 0.25 * uniform(engine));
      cloud.velocity(i, axis) = of.speed * uniform(engine);
    }
    cloud.mass[i] = std::pow(10.0, of.decades * uniform(engine));
    cloud.radius[i] = of.spacing * (0.1 + 0.05 * uniform(engine));
  }
  return cloud;
}

/// The seed of a cloud without a close encounter, for claims about orders and about agreement of integrators: they hold
/// where steps resolve the motion, and a run's own seed must not decide whether they do.
inline constexpr std::uint64_t smooth = 1;

}  // namespace verification
