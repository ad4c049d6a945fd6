#pragma once

#include <string>
#include <vector>

#include <harness/breathing.hpp>
#include <harness/rows.hpp>

/// @file
/// Order of a scheme on the breathing pair.

namespace verification {

/// Errors of positions and velocities at t = 1.4 s, six tenths of a period, against Kepler's equation: two rows.
template <class S>
void compare_order(Rows& rows, long coarsest, const std::string& because) {
  constexpr double t_end = 1.4, alpha2 = 0.5;
  const ExactBreathing exact{.force = particulate::kinematics::breathing_pair(1.0, alpha2, 1.0, 1.0), .r_0 = 1.0};
  NearFieldScene scene(pair_at_rest(1.0, 1.0, 1.0), {}, {.alpha1 = 1.0, .alpha2 = alpha2, .beta1 = 2.0, .beta2 = 3.0});
  std::vector<double> steps, positions, velocities;
  for (long n = coarsest; steps.size() < 5; n = n * 3 / 2) {
    particulate::schemes::State state = particulate::scenes::start(scene);
    advance<S>(scene, state, t_end, n);
    BreathingErrors errors;
    compare_with(exact, pair_shape(1.0, 1.0), state, errors);
    steps.push_back(t_end / static_cast<double>(n));
    positions.push_back(errors.position);
    velocities.push_back(errors.velocity);
  }
  constexpr double floor = 1e-15;
  rows.order("positions",
             {.nominal = S::order, .steps = steps, .errors = positions, .floor = floor, .because = because});
  rows.order("velocities",
             {.nominal = S::order, .steps = steps, .errors = velocities, .floor = floor, .because = because});
}

}  // namespace verification
