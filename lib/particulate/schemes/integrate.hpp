#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include <particulate/schemes/events.hpp>
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
  if constexpr (EstimatesTruncation<S, P, State> && !IgnoresTruncation<C>) {
    if (it.evaluated) made.truncation = scheme.truncation(problem, from, dt, to);
  }
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

/// Why an event or a jump within a step could not be reached.
///
/// @param t    the start of the step [s]
/// @param dt   the step that ought to end there [s]
/// @param off  by how much of itself it moved when it was solved anew [-]
/// @return the reason, with what was given and what to do
std::string not_located(double t, double dt, double off);

/// Why events or jumps cannot be followed.
///
/// @param t     the time that they do not get beyond [s]
/// @param most  so many followed one another there [-]
/// @return the reason, with what was given and what to do
std::string accumulating(double t, long most);

namespace detail {

/// A run: what integrate() is given, and where it stands.
template <class P, class State, class S, class C, class W, class Observer>
class Run {
 public:
  Run(P& problem, State& state, double t_end, S& scheme, C& control, W& watch, Observer& observer)
      : counted_{problem},
        state_(state),
        t_end_(t_end),
        scheme_(scheme),
        control_(control),
        watch_(watch),
        observer_(observer),
        to_(state),
        there_(state) {
    static_assert(!locates || Dense<S, State>,
                  "events and located jumps need a scheme with dense output, at(from, dt, theta, there)");
  }

  Outcome go() {
    bool goes_on = true;
    while (goes_on && state_.t < t_end_) goes_on = step();
    out_.t = state_.t;
    out_.evaluations = counted_.evaluations;
    return out_;
  }

 private:
  using Path = StepPath<S, State>;
  static constexpr bool watches = !std::is_same_v<W, Unwatched>;
  static constexpr bool locates = watches || LocatesJumps<Counted<P>, Path>;
  // A located step is solved anew so often at most; three times are enough unless its sweeps are loose.
  static constexpr int most_solves = 20;
  // It stands where solving it anew moves its end by no more than this, of itself.
  static constexpr double stands = 1e-14;
  // It stands as well where its end moves no less than the last time, as rounding or the tolerance of the sweeps has
  // it: by no more than this of itself, or of the whole step,
  static constexpr double jitters = 1e-6, still = 1e-10;
  // or, where it has been solved so often, by this: a function that hardly changes in the step touches zero.
  static constexpr int often = 6;
  static constexpr double hardly = 1e-3;
  // How far beyond its end a step that was shortened is looked at again.
  static constexpr double a_little_beyond = 1.1;
  // A scheme cannot extrapolate from so small a part of a step to the next whole one.
  static constexpr double too_little = 0.5;
  // Steps so many roundings of the time long do not pass time.
  static constexpr double no_time = 1000.0;

  bool end(Status status, std::string reason, Failure failure = Failure::none) {
    out_.status = status;
    out_.reason = std::move(reason);
    out_.failure = failure;
    return false;
  }

  // Tries one step; returns whether the run goes on.
  bool step() {
    const double left = t_end_ - state_.t;
    dt_ = step_towards_end(control_.dt(), left, rounding_of_time(out_.steps, state_.t, t_end_));
    if (!(state_.t + dt_ > state_.t)) {
      return last_.refusal.empty() ? end(Status::failed, too_small(state_.t, dt_), Failure::time_stands_still)
                                   : end(Status::failed, too_small(state_.t, dt_, last_.refusal), last_.failure);
    }
    whole_ = dt_;
    Decision decision = attempt_with(control_);
    landed_at_ = {};
    if constexpr (locates) {
      if (decision.accepted) decision = land();
    }
    if (!decision.impossible.empty()) {
      out_.workable_step = decision.workable;
      return end(Status::failed, std::move(decision.impossible), decision.failure);
    }
    if (!decision.accepted) {
      ++out_.rejections;
      last_ = std::move(decision);
      return true;
    }
    last_ = {};
    if (dt_ == left) to_.t = t_end_;
    return accept();
  }

  Decision attempt_with(C& control) {
    const Attempt made = attempt(scheme_, counted_, state_, dt_, to_, control, out_);
    Decision decision = control.judge(made);
    if (decision.accepted && !made.iteration.evaluated) {
      throw std::logic_error("a controller must refuse a step on which the problem had no value, but it accepted one");
    }
    return decision;
  }

  // Takes the step that stands, and the jump and the events at its end.
  bool accept() {
    scheme_.accept(dt_);
    if (dt_ < too_little * whole_) scheme_.forget();
    bool stops = false;
    if constexpr (watches) stops = landed_at_ && watch_.happen(*landed_at_, to_.t, dt_);
    const bool go_on = observer_(std::as_const(state_), std::as_const(to_), dt_, std::as_const(scheme_));
    if constexpr (Jumps<P>) {
      if (!jump()) return false;
    }
    std::swap(state_, to_);
    ++out_.steps;
    if (accumulates()) return false;
    if constexpr (watches) {
      if (stops) return end(Status::stopped, watch_.last());
    }
    return go_on || end(Status::stopped, "the observer asked for it");
  }

  bool jump() {
    Jump jump = counted_.jump(to_, dt_);
    out_.impacts += jump.impacts;
    out_.energy_change += jump.energy_change;
    out_.overlap = std::max(out_.overlap, jump.overlap);
    counted_.evaluations += jump.evaluations;
    if (jump.impacts > 0 || !jump.unsettled.empty()) scheme_.forget();
    if (jump.unsettled.empty()) return true;
    out_.accumulation = jump.accumulates;
    return end(Status::failed, std::move(jump.unsettled),
               std::isnan(jump.accumulates) ? Failure::unsettled_jump : Failure::accumulating);
  }

  bool accumulates() {
    const double shortest = no_time * std::numeric_limits<double>::epsilon() * std::max(std::abs(state_.t), t_end_);
    at_once_ = landed_at_ && dt_ <= shortest ? at_once_ + 1 : 0;
    if (at_once_ <= watch_.settings().most_at_once) return false;
    out_.accumulation = state_.t;
    return !end(Status::failed, accumulating(state_.t, at_once_), Failure::accumulating);
  }

  // The first fraction of the step made last at which the state jumps or an event happens.
  std::optional<double> first_stop(double until) {
    const Path path{scheme_, state_, dt_};
    std::optional<double> first;
    if constexpr (LocatesJumps<Counted<P>, Path>) first = counted_.first_jump(path, until);
    if constexpr (watches) {
      const std::optional<double> event = watch_.first(path, there_, until);
      if (event && !(first && *first < *event)) first = event;
    }
    return first;
  }

  // Shortens the step until it ends at the first jump or event, if there is one. The controller judges the shortened
  // step, but keeps the step that it has chosen.
  Decision land() {
    double off = std::numeric_limits<double>::infinity();
    for (int solves = 0; solves < most_solves; ++solves) {
      const double before = std::exchange(off, 0.0);
      const std::optional<double> first = first_stop(solves == 0 ? 1.0 : a_little_beyond);
      if (!first) return {.accepted = true};
      off = std::abs(*first - 1.0);
      if (off <= stands || (off >= 0.5 * before && moves_no_more(off, solves))) {
        landed_at_ = first;
        return {.accepted = true};
      }
      // Beyond the whole step: it was not in there after all, but at the start of the next one.
      const bool beyond = dt_ * *first > whole_;
      dt_ = beyond ? whole_ : dt_ * *first;
      C judging = control_;
      Decision decision = attempt_with(judging);
      if (!decision.accepted) control_ = std::move(judging);
      if (!decision.accepted || beyond) return decision;
    }
    return {.impossible = not_located(state_.t, dt_, off), .failure = Failure::not_located};
  }

  bool moves_no_more(double off, int solves) const {
    return (solves > 1 && off * dt_ <= std::max(jitters * dt_, still * whole_)) || (solves >= often && off <= hardly);
  }

  Counted<P> counted_;
  State& state_;
  double t_end_;
  S& scheme_;
  C& control_;
  W& watch_;
  Observer& observer_;
  State to_, there_;
  Outcome out_;
  Decision last_;                    // why the step that is tried again was refused
  double dt_ = 0.0, whole_ = 0.0;    // the step, and as it was before it was shortened [s]
  std::optional<double> landed_at_;  // where in the step that stands it was located once more
  long at_once_ = 0;                 // located steps in a row that passed no time
};

}  // namespace detail

/// Advances a state to t_end: the loop that every scheme, controller and problem share.
///
/// Scheme and control are taken by reference and the state keeps its time, so that a run can be continued, to the same
/// bits, and a checkpoint is three copies. A step cut short to land on t_end does not change the controller's step
/// unless the controller decides so.
///
/// A problem that locates its jumps (LocatesJumps) needs a scheme with dense output. Each step is then shortened to the
/// first jump in it: located on the dense output, which is of lower order than the end of a step, solved anew to end
/// there, and located again until it stands, within 1e-14 of the step or, where the tolerance of the sweeps or rounding
/// moves it by more and no less than the last time, within 1e-6 (after six solutions, within 1e-3). The controller
/// keeps the step that it chose for the whole; a shortened step that it refuses is tried again, from the start, with
/// what it makes of the refusal. After a jump the scheme forgets; so it does after a step of which less than half was
/// left, from which it could not extrapolate. More than WatchSettings::most_at_once located steps in a row that pass no
/// time, of a thousand roundings of it at most, end the run with Failure::accumulating.
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
requires(!std::is_same_v<std::remove_cvref_t<Observer>, Watch>) Outcome
    integrate(P& problem, State& state, double t_end, S& scheme, C& control, Observer&& observer = {}) {
  validate_run(state, t_end);
  validate(control);
  Unwatched unwatched;
  return detail::Run<P, State, S, C, Unwatched, std::remove_reference_t<Observer>>(problem, state, t_end, scheme,
                                                                                   control, unwatched, observer)
      .go();
}

/// Advances a state to t_end, or to the first event before it that stops the run.
///
/// Every event ends a step: the state is the scheme's own there, not one interpolated. See Watch for what counts as an
/// event, and the other integrate() for how its step is found. The observer sees that step when Watch::hits() has the
/// event already. A run that an event has stopped can be continued with the same watch.
///
/// @param problem   the right-hand side, with whatever abilities it has
/// @param state     the start; on return the state at Outcome::t
/// @param t_end     the end time, not before the start [s]
/// @param scheme    the scheme, with dense output
/// @param control   the step control
/// @param watch     the events; remembers those that happened
/// @param observer  gets (from, to, dt, scheme) of each accepted step before its jump, returns whether to go on
/// @return status, reason and counts; stopped by events, the reason names them
/// @throws std::invalid_argument for a start, an end or a controller that cannot be meant, and where an event function
/// is not finite
/// @throws std::logic_error if the controller accepts a step that has no value
template <class P, class State, Scheme<P, State> S, Controller C, class Observer = Unobserved>
Outcome integrate(P& problem, State& state, double t_end, S& scheme, C& control, Watch& watch,
                  Observer&& observer = {}) {
  validate_run(state, t_end);
  validate(control);
  return detail::Run<P, State, S, C, Watch, std::remove_reference_t<Observer>>(problem, state, t_end, scheme, control,
                                                                               watch, observer)
      .go();
}

}  // namespace particulate::schemes
