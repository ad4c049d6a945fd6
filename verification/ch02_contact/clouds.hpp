#pragma once

#include <harness/motions.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>

#include "encounters.hpp"

/// @file
/// Sets of particles in which many meet, at one moment or in time.

namespace verification {

/// Spheres at random in a box so small that most overlap several others; velocities and masses at random.
inline particulate::kinematics::Particles cluster(Encounters& drawn, Eigen::Index N, double decades) {
  particulate::kinematics::Particles all{.position = particulate::kinematics::Vectors(N, 3),
                                         .velocity = particulate::kinematics::Vectors(N, 3),
                                         .mass = Eigen::VectorXd(N),
                                         .radius = Eigen::VectorXd(N)};
  const double side = 0.5 * std::cbrt(static_cast<double>(N));
  for (Eigen::Index i = 0; i < N; ++i) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      all.position(i, axis) = side * drawn.uniform();
      all.velocity(i, axis) = drawn.uniform();
    }
    all.mass[i] = std::pow(10.0, decades * drawn.uniform());
    all.radius[i] = 0.4 + 0.1 * drawn.positive();
  }
  return all;
}

/// Spheres near the points of a cubic lattice, apart, that fly towards the middle; 3^3 at most.
inline particulate::kinematics::Particles closing_cloud(std::uint64_t seed, Eigen::Index N, double speed) {
  Encounters drawn({}, seed);
  particulate::kinematics::Particles cloud{.position = particulate::kinematics::Vectors(N, 3),
                                           .velocity = particulate::kinematics::Vectors(N, 3),
                                           .mass = Eigen::VectorXd(N),
                                           .radius = Eigen::VectorXd(N)};
  const Eigen::Index side = N <= 8 ? 2 : 3;
  for (Eigen::Index i = 0; i < N; ++i) {
    const Eigen::Vector3d corner{static_cast<double>(i % side), static_cast<double>(i / side % side),
                                 static_cast<double>(i / (side * side))};
    const Eigen::Vector3d place =
        corner - Eigen::Vector3d::Constant(0.5 * static_cast<double>(side - 1)) + 0.15 * drawn.direction();
    cloud.position.row(i) = place;
    cloud.velocity.row(i) = -speed * place + 0.2 * speed * drawn.direction();
    cloud.mass[i] = 0.75 + 0.5 * drawn.positive();
    cloud.radius[i] = 0.22 + 0.04 * drawn.positive();
  }
  return cloud;
}

/// Moves a state to t_end in equal steps, and says how it went.
///
/// @throws std::runtime_error if it does not get there
template <class S, class P, class Observer = particulate::schemes::Unobserved>
particulate::schemes::Outcome march(P& problem, particulate::schemes::State& state, double t_end, long steps,
                                    Observer&& observer = {}) {
  S scheme;
  particulate::schemes::FixedStep control{.step = (t_end - state.t) / static_cast<double>(steps)};
  const particulate::schemes::Outcome outcome = integrate(problem, state, t_end, scheme, control, observer);
  require_reached(outcome);
  return outcome;
}

/// The near field of the clouds.
inline constexpr particulate::laws::NearField book_near_field{
    .alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.0, .beta2 = 2.0};

}  // namespace verification
