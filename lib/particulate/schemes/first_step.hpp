#pragma once

#include <particulate/schemes/problem.hpp>

namespace particulate::schemes {

/// A step to begin a run with, for a control that was given none: a hundredth of the shortest time in which the start
/// changes as a whole.
///
/// \f[ \Delta t = \tfrac{1}{100} \min\!\left(\frac{l}{u},\; \sqrt{\frac{l}{|a|}},\; \frac{u}{|a|},\;
///     \sqrt[3]{\frac{l}{|a'|}},\; \frac{|y|}{|y'|},\; \sqrt{\frac{|y|}{|y''|}},\; t_{end} - t\right) \f]
///
/// with the length l and the speed u of HasScales or the largest places and velocities, values by their ranges, a' and
/// y'' by the rates after a forward Euler step of so much, and what is zero left out. Nothing has a unit of its own, so
/// a problem in other units begins with the same step. After @cite hairer1993, section II.4, without its tolerance: the
/// control judges the step in any case. Two right-hand sides. What a problem does later on cannot be seen from its
/// start.
///
/// @param problem  with rates, not of staggered fields
/// @param start    the start
/// @param t_end    the end of the run, after the start [s]
/// @return the step, > 0 [s]
double first_step(const Problem& problem, const State& start, double t_end);

}  // namespace particulate::schemes
