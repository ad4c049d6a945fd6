#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include <particulate/schemes/iteration.hpp>
#include <particulate/schemes/scheme.hpp>

namespace particulate::schemes {

/// Refuses what no run can start from, naming it.
///
/// @param state  the start; t finite, r and v finite and of one length
/// @param t_end  where to go, finite and not before the start [s]
/// @throws std::invalid_argument saying what must hold and what was given
void validate_run(const Motion& state, double t_end);

/// Refuses what no run can start from, naming it.
///
/// @param state  the start; t and y finite
/// @param t_end  where to go, finite and not before the start [s]
/// @throws std::invalid_argument saying what must hold and what was given
void validate_run(const Values& state, double t_end);

/// Whether a computed state can be handed on: no NaN, no infinity.
///
/// @param state  a state
/// @return true if every number in it is finite
bool is_finite(const Motion& state);
/// @copydoc is_finite(const Motion&)
bool is_finite(const Values& state);

/// The observer of a run that nobody watches.
struct Unobserved {
  /// @return true: go on
  template <class State, class S>
  bool operator()(const State&, const State&, double, const S&) const {
    return true;
  }
};

/// One attempt: the guess, then sweeps for as long as the controller asks for them.
///
/// @param scheme   the scheme; it keeps the attempt until accept()
/// @param problem  the right-hand side
/// @param from     the state at the start of the step
/// @param dt       the step [s]
/// @param to       receives the state at its end
/// @param control  asked whether to sweep on
/// @param out      gets the sweeps, and the largest contraction among them
/// @return the attempt and how its iteration went; not evaluated if the problem had no value or the new state is not
///         finite
template <class S, class P, class State, Controller C>
Attempt attempt(S& scheme, P& problem, const State& from, double dt, State& to, const C& control, Outcome& out) {
  Attempt made{.dt = dt, .iteration = {}};
  Iteration& it = made.iteration;
  it.evaluated = scheme.predict(problem, from, dt, to);
  if constexpr (Iterative<S, P, State>) {
    while (it.evaluated && (it.K < 0 || control.goes_on(it))) {
      it = scheme.sweep(problem, from, dt, to);
      ++out.sweeps;
      if (shows_contraction(it)) out.contraction = std::max(out.contraction, it.rate);
    }
  }
  if constexpr (Staggers<S>) made.fields = scheme.iterations();
  it.evaluated = it.evaluated && is_finite(to);
  return made;
}

/// What rounding can have made of the time of a run.
///
/// \f[ (n + 1)\, \varepsilon \max(|t|, |t_{end}|) \f]
///
/// @param steps  accepted steps so far, n
/// @param t      the time reached [s]
/// @param t_end  the end time [s]
/// @return bound on the error of the sum that the time is, one rounding a step [s]
inline double rounding_of_time(long steps, double t, double t_end) {
  return static_cast<double>(steps + 1) * std::numeric_limits<double>::epsilon() *
         std::max(std::abs(t), std::abs(t_end));
}

/// The step to try: the controller's, or what is left to t_end.
///
/// A remainder that differs from the controller's step by rounding is taken in one step, so that n steps of
/// (t_end - t)/n are n steps. It is never stretched by more than a thousandth.
///
/// @param wished    the controller's step, > 0 [s]
/// @param left      time left to the end, > 0 [s]
/// @param rounding  error of the time so far, >= 0 [s]
/// @return the step, at most left [s]
inline double step_towards_end(double wished, double left, double rounding) {
  const double slack = std::min(1e-9 * wished + rounding, 1e-3 * wished);
  return wished + slack < left ? wished : left;
}

/// Why a run cannot go on from here with this step.
///
/// @param t        the time reached [s]
/// @param dt       the step [s]
/// @param refusal  why larger steps were refused; empty: they were not
/// @return the reason, with what was given and what to do
std::string too_small(double t, double dt, const std::string& refusal = {});

/// Advances a state to t_end: the loop that every scheme, controller and problem share.
///
/// Scheme and control are taken by reference and the state keeps its time, so that a run can be continued, to the same
/// bits, and a checkpoint is three copies. A step cut short to land on t_end does not change the controller's step
/// unless the controller decides so.
///
/// @param problem   the right-hand side, with whatever abilities it has
/// @param state     the start; on return the state at Outcome::t
/// @param t_end     the end time, not before the start [s]
/// @param scheme    the scheme
/// @param control   the step control
/// @param observer  gets (from, to, dt, scheme) of each accepted step before its jump, returns whether to go on
/// @return status, reason and counts
/// @throws std::invalid_argument for a start, an end or a controller that cannot be meant
/// @throws std::logic_error if the controller accepts a step that has no value
template <class P, class State, Scheme<P, State> S, Controller C, class Observer = Unobserved>
Outcome integrate(P& problem, State& state, double t_end, S& scheme, C& control, Observer&& observer = {}) {
  validate_run(state, t_end);
  validate(control);
  Outcome out;
  Counted<P> counted{problem};
  State to = state;
  const auto end = [&](Status status, std::string reason, Failure failure = Failure::none) {
    out.status = status;
    out.reason = std::move(reason);
    out.failure = failure;
    out.t = state.t;
    out.evaluations = counted.evaluations;
    return out;
  };
  Decision last;  // why the step that is tried again was refused
  while (state.t < t_end) {
    const double left = t_end - state.t;
    const double dt = step_towards_end(control.dt(), left, rounding_of_time(out.steps, state.t, t_end));
    if (!(state.t + dt > state.t)) {
      return last.refusal.empty() ? end(Status::failed, too_small(state.t, dt), Failure::time_stands_still)
                                  : end(Status::failed, too_small(state.t, dt, last.refusal), last.failure);
    }
    const Attempt made = attempt(scheme, counted, state, dt, to, control, out);
    Decision decision = control.judge(made);
    if (!decision.impossible.empty()) {
      out.workable_step = decision.workable;
      return end(Status::failed, std::move(decision.impossible), decision.failure);
    }
    if (decision.accepted && !made.iteration.evaluated) {
      throw std::logic_error("a controller must refuse a step on which the problem had no value, but it accepted one");
    }
    if (!decision.accepted) {
      ++out.rejections;
      last = std::move(decision);
      continue;
    }
    last = {};
    if (dt == left) to.t = t_end;
    scheme.accept(dt);
    const bool go_on = observer(std::as_const(state), std::as_const(to), dt, std::as_const(scheme));
    if constexpr (Jumps<P>) {
      Jump jump = counted.jump(to, dt);
      out.impacts += jump.impacts;
      out.energy_change += jump.energy_change;
      out.overlap = std::max(out.overlap, jump.overlap);
      counted.evaluations += jump.evaluations;
      if (jump.impacts > 0 || !jump.unsettled.empty()) scheme.forget();
      if (!jump.unsettled.empty()) { return end(Status::failed, std::move(jump.unsettled), Failure::unsettled_jump); }
    }
    std::swap(state, to);
    ++out.steps;
    if (!go_on) return end(Status::stopped, "the observer asked for it");
  }
  return end(Status::reached, {});
}

}  // namespace particulate::schemes
