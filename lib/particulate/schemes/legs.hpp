#pragma once

#include <utility>
#include <vector>

#include <particulate/schemes/integrate.hpp>

/// @file
/// Runs in legs, so that one that was cut short can go on from the end of a leg.

namespace particulate::schemes {

/// The first whole multiple of a period that lies after a time: the same bits, from wherever it is asked for.
///
/// @param period  > 0 and finite, not lost in the rounding of t [s]
/// @param t       a time [s]
/// @return k period with the smallest whole k for which that is above t [s]
/// @throws std::invalid_argument for another period
double next_multiple(double period, double t);

/// The times of something that happens every so many seconds.
///
/// @param period  > 0 and finite [s]
/// @param first   where they begin [s]
/// @param last    where they end [s]
/// @return the whole multiples of the period in [first, last], in order [s]
/// @throws std::invalid_argument for another period, or times that are not finite
std::vector<double> multiples(double period, double first, double last);

/// Ability of a controller: `forget()`, drops what judge() has learnt but for the step. One that goes by no more than
/// its step needs none.
template <class C>
concept Forgets = requires(C& c) {
  c.forget();
};

namespace detail {

// Of the leg that starts at t: the next multiple, or where none is left before it, the end.
double end_of_leg(double period, double t, double t_end);

}  // namespace detail

/// Advances a state to t_end in legs, which end at the whole multiples of a period. At the end of each the scheme and
/// the control forget all but the step, whether or not the run is cut short there: so state, time and step are all that
/// a run needs to go on, with the same bits as if it had not been cut. Of what an observer and a random engine know,
/// the caller takes care.
///
///     const auto save = [&](const State& at, const ErrorControl& control, const Outcome& so_far) { ... };
///     integrate_in_legs(problem, state, t_end, scheme, control, 0.1, save);
///
/// A leg ends with a step that is cut to land there, so that the legs change the run by what such a step changes: the
/// same multiples, the same bits. The end of the run counts if it is a multiple to the last bit.
///
/// @param problem   the right-hand side, with whatever abilities it has
/// @param state     the start; on return the state at Outcome::t
/// @param t_end     the end time, not before the start [s]
/// @param scheme    the scheme
/// @param control   the step control; to go on, it is given the step that it had at the end of the leg
/// @param period    between the ends of legs, > 0 and finite [s]
/// @param save      is told (state, control, outcome so far) at each multiple that is reached
/// @param observer  as that of integrate()
/// @param so_far    to go on: what the run had done at the end of the leg
/// @return what all legs did together
/// @throws std::invalid_argument as integrate(), and for a period that cannot be meant
template <AnyProblem P, Scheme S, Controller C, class Save, class Observer = Unobserved>
Outcome integrate_in_legs(P& problem, State& state, double t_end, S& scheme, C& control, double period, Save&& save,
                          Observer&& observer = {}, Outcome so_far = {}) {
  do {
    const double start = state.t, end = detail::end_of_leg(period, start, t_end);
    so_far += integrate(problem, state, end, scheme, control, observer);
    scheme.forget();
    if constexpr (Forgets<C>) control.forget();
    if (so_far.status != Status::reached) break;
    if (end == next_multiple(period, start)) save(std::as_const(state), std::as_const(control), std::as_const(so_far));
  } while (state.t < t_end);
  return so_far;
}

}  // namespace particulate::schemes
