#pragma once

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/kinematics/momentum.hpp>
#include <particulate/schemes/runge_kutta.hpp>

#include "fixed_centre.hpp"

/// @file
/// A fine motion with its forces, of which the sums over work and impulse take every second, fourth, ... moment.

namespace verification {

/// A cloud about a fixed centre, at equal times; for the sums it counts as exact.
struct SampledMotion {
  double t_end = 1.3;                                                       ///< [s]
  Eigen::VectorXd mass;                                                     ///< [kg]
  std::vector<particulate::kinematics::Vectors> position, velocity, force;  ///< at each moment
};

/// The motion of a cloud of 20 by RK4.
inline SampledMotion sampled_motion(std::uint64_t seed, long steps) {
  using namespace particulate;
  scenes::Scene scene(
      random_cloud({.N = 20}, seed), kinematics::Space{}, laws::NearField{.alpha1 = 0.1, .alpha2 = 0.05},
      FixedCentre{.place{0.4, 2.0, -1.0}, .law{.alpha1 = 2.0, .alpha2 = 0.1, .beta1 = 0.5, .beta2 = 1.5}});
  SampledMotion fine;
  fine.mass = scene.particles().mass;
  Eigen::VectorXd flat(3 * fine.mass.size());
  for (const schemes::State& at : path<schemes::RungeKutta4>(scene, scenes::start(scene), fine.t_end, steps)) {
    if (!scene.total_force(at, flat)) throw std::runtime_error("the cloud has no forces");
    fine.position.emplace_back(rows_of(at.r));
    fine.velocity.emplace_back(rows_of(at.v));
    fine.force.emplace_back(rows_of(flat));
  }
  return fine;
}

/// Relative errors of sums over pieces of a motion, from coarse to fine.
struct SumErrors {
  std::vector<double> steps;   ///< [s]
  std::vector<double> errors;  ///< [-]
};

/// Errors where every 64th, 32nd, ... 2nd moment is taken; `error(stride)` gives one.
template <class F>
SumErrors errors_of_sums(const SampledMotion& fine, const F& error) {
  SumErrors seen;
  for (std::size_t stride = 64; stride >= 2; stride /= 2) {
    seen.steps.push_back(fine.t_end * static_cast<double>(stride) / static_cast<double>(fine.force.size() - 1));
    seen.errors.push_back(error(stride));
  }
  return seen;
}

}  // namespace verification
