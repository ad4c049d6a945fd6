#pragma once

#include <vector>

#include <particulate/reference/integrator.hpp>

/// @file
/// Motion with impacts by a reference integrator that stops at each of them.

namespace verification {

/// Moves a state to t_end, stopping at every event, where `change(state, hits)` does what the impact does.
///
/// @return reached, or why not; its counts are those of all legs, its impacts the events
template <class Change>
particulate::schemes::Outcome advance_through_impacts(particulate::reference::Integrator& integrator,
                                                      particulate::schemes::State& state, double t_end,
                                                      const Change& change) {
  using particulate::schemes::Status;
  particulate::schemes::Outcome all;
  do {
    const particulate::schemes::Outcome leg = integrator.advance(state, t_end);
    all.status = leg.status;
    all.reason = leg.reason;
    all.t = leg.t;
    all.steps += leg.steps;
    all.rejections += leg.rejections;
    all.sweeps += leg.sweeps;
    all.evaluations += leg.evaluations;
    if (leg.status != Status::stopped) break;
    all.impacts += static_cast<long>(integrator.hits().size());
    change(state, integrator.hits());
  } while (true);
  return all;
}

}  // namespace verification
