#pragma once

#include <harness/motions.hpp>
#include <particulate/scattering/heat.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>

/// @file
/// How the heated bodies of this chapter's cases come to their temperatures.

namespace verification {

/// Moves heated bodies to a time, by Radau collocation of order 5 and Newton's method.
///
/// @param bodies  the bodies
/// @param state   their temperatures
/// @param t       [s]
/// @param TOL     of a step [-]
/// @return the state then
inline particulate::schemes::State heated(const particulate::scattering::HeatedBodies& bodies,
                                          particulate::schemes::State state, double t, double TOL) {
  namespace schemes = particulate::schemes;
  reach(bodies, state, t, schemes::Collocation<schemes::Radau<3>, schemes::Newton<schemes::SparseStages>>(),
        schemes::ErrorControl{.TOL = TOL, .sweep_TOL = 0.1 * TOL});
  return state;
}

}  // namespace verification
