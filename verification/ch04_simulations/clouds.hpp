#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include <harness/uniform.hpp>
#include <particulate/kinematics/starts.hpp>
#include <particulate/laws/near_field.hpp>

/// @file
/// The clouds of chapter 4, and random places.

namespace verification {

/// Places of independent points in a box with a corner at the origin.
inline particulate::kinematics::Vectors random_places(Uniform& uniform, Eigen::Index N,
                                                      const Eigen::Vector3d& box = Eigen::Vector3d::Ones()) {
  particulate::kinematics::Vectors places(N, 3);
  for (Eigen::Index i = 0; i < N; ++i) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) places(i, axis) = box[axis] * uniform();
  }
  return places;
}

/// Chapter 4's start: N equal spheres whose centres lie in the unit cube, L = 0.25, 2000 kg/m^3, at (1, 0.1, 0.1) m/s
/// plus as much again, evenly distributed, to either side.
inline particulate::kinematics::Particles book_cloud(Eigen::Index N, std::uint64_t seed,
                                                     const particulate::kinematics::Space& domain = {}) {
  Uniform uniform(seed);
  const double b = 0.25 / std::cbrt(static_cast<double>(N));
  particulate::kinematics::Particles cloud{
      .position = {},
      .velocity = random_places(uniform, N, {2.0, 0.2, 0.2}),
      .mass = Eigen::VectorXd::Constant(N, 2000.0 * 4.0 / 3.0 * std::numbers::pi * b * b * b),
      .radius = Eigen::VectorXd::Constant(N, b)};
  cloud.position =
      particulate::kinematics::random_addition(cloud.radius, {.domain = domain}, [&] { return uniform(); }).position;
  return cloud;
}

/// Its near field of case (2).
inline constexpr particulate::laws::NearField weak_near_field{.alpha1 = 0.1, .alpha2 = 0.05};

}  // namespace verification
