#pragma once

#include <concepts>
#include <limits>
#include <type_traits>
#include <utility>

#include <particulate/schemes/events.hpp>
#include <particulate/schemes/scheme.hpp>

namespace particulate::schemes {

/// Refuses what no run can start from, naming it.
///
/// @param of     what the problem has
/// @param state  the start; t finite, r, v and y finite, r and v of one length, no part that the problem does not have
/// @param t_end  where to go, finite and not before the start [s]
/// @throws std::invalid_argument saying what must hold and what was given
void validate_run(const Traits& of, const State& state, double t_end);

/// The observer of a run that nobody watches.
struct Unobserved {
  /// @return true: go on
  template <class S>
  bool operator()(const State&, const State&, double, const S&) const {
    return true;
  }
};

/// Ability of an observer: `jumped(after, jump)`, told after each jump of the state at the end of a step, whether or
/// not anything changed in it. What the observer itself is given at that time is the state before.
template <class O>
concept SeesJumps = requires(O& o, const State& after, const Jump& jump) {
  o.jumped(after, jump);
};

/// What rounding can have made of the time of a run.
///
/// \f[ (n + 1)\, \varepsilon \max(|t|, |t_{end}|) \f]
///
/// @param steps  accepted steps so far, n
/// @param t      the time reached [s]
/// @param t_end  the end time [s]
/// @return bound on the error of the sum that the time is, one rounding a step [s]
double rounding_of_time(long steps, double t, double t_end);

/// The step to try: the controller's, or what is left to t_end.
///
/// A remainder that differs from the controller's step by rounding is taken in one step, so that n steps of
/// (t_end - t)/n are n steps. It is never stretched by more than a thousandth.
///
/// @param wished    the controller's step, > 0 [s]
/// @param left      time left to the end, > 0 [s]
/// @param rounding  error of the time so far, >= 0 [s]
/// @return the step, at most left [s]
double step_towards_end(double wished, double left, double rounding);

namespace detail {

// A scheme, a control and an observer with their types erased, as the loop sees them; what one cannot do is null.
struct SchemeTable {
  int order;
  bool (*advances)(const Traits&);
  bool (*predict)(void*, const Problem&, const State&, double, State&);
  Iteration (*sweep)(void*, const Problem&, const State&, double, State&) = nullptr;
  std::span<const Iteration> (*iterations)(const void*) = nullptr;
  Truncation (*truncation)(void*, const Problem&, const State&, double, const State&) = nullptr;
  void (*at)(const void*, const State&, double, double, State&) = nullptr;
  double (*spans)(const void*, TimeScale::Kind, int) = nullptr;
  bool adds_limits = false;
  void (*accept)(void*, double);
  void (*forget)(void*);
  void (*begin)(void*, const Problem&, const State&);
};

template <Scheme S>
constexpr SchemeTable scheme_table() {
  SchemeTable can{.order = S::order,
                  .advances = [](const Traits& of) { return S::advances(of); },
                  .predict = [](void* s, const Problem& p, const State& from, double dt,
                                State& to) { return as<S>(s).predict(p, from, dt, to); },
                  .accept = [](void* s, double dt) { as<S>(s).accept(dt); },
                  .forget = [](void* s) { as<S>(s).forget(); },
                  .begin = [](void* s, const Problem&, const State&) { as<S>(s).forget(); }};
  if constexpr (Begins<S>) {
    can.begin = [](void* s, const Problem& p, const State& at) { as<S>(s).begin(p, at); };
  }
  if constexpr (Iterative<S>) {
    can.sweep = [](void* s, const Problem& p, const State& from, double dt, State& to) {
      return as<S>(s).sweep(p, from, dt, to);
    };
  }
  if constexpr (Measured<S>) {
    can.iterations = [](const void* s) -> std::span<const Iteration> { return as<S>(s).iterations(); };
  }
  if constexpr (EstimatesTruncation<S>) {
    can.truncation = [](void* s, const Problem& p, const State& from, double dt, const State& to) {
      return as<S>(s).truncation(p, from, dt, to);
    };
  }
  if constexpr (Dense<S>) {
    can.at = [](const void* s, const State& from, double dt, double theta, State& there) {
      as<S>(s).at(from, dt, theta, there);
    };
  }
  if constexpr (Limited<S>) {
    can.spans = [](const void* s, TimeScale::Kind kind, int sweeps) { return as<S>(s).spans(kind, sweeps); };
    can.adds_limits = AddsLimits<S>;
  }
  return can;
}

template <Scheme S>
inline constexpr SchemeTable scheme_table_of = scheme_table<S>();

struct ControlTable {
  bool ignores_truncation, fixes_step;
  void (*validate)(const void*);
  double (*dt)(const void*);
  bool (*goes_on)(const void*, const Iteration&);
  Decision (*judge)(void*, const Attempt&);
  Decision (*judge_apart)(void*, const Attempt&);  // by a copy, which is kept only if it refuses
  int (*sweeps)(const void*);                      // of every step; 0: as many as it takes
  bool (*waits_for_step)(const void*);
  void (*begin)(void*, double step);
};

template <Controller C>
inline constexpr ControlTable control_table_of{
    .ignores_truncation = IgnoresTruncation<C>,
    .fixes_step = FixesStep<C>,
    .validate = [](const void* c) { validate(as<C>(c)); },
    .dt = [](const void* c) -> double { return as<C>(c).dt(); },
    .goes_on = [](const void* c, const Iteration& it) { return as<C>(c).goes_on(it); },
    .judge = [](void* c, const Attempt& made) { return as<C>(c).judge(made); },
    .judge_apart =
        [](void* c, const Attempt& made) {
          C judging = as<C>(c);
          Decision decision = judging.judge(made);
          if (!decision.accepted) as<C>(c) = std::move(judging);
          return decision;
        },
    .sweeps = [](const void* c) -> int {
      if constexpr (FixesSweeps<C>) return as<C>(c).sweeps;
      return 0;
    },
    .waits_for_step = [](const void* c) -> bool {
      if constexpr (WaitsForStep<C>) return as<C>(c).waits_for_step();
      return false;
    },
    .begin =
        [](void* c, double step) {
          if constexpr (WaitsForStep<C>) as<C>(c).begin(step);
        }};

// What integrate() is given.
struct Task {
  Problem problem;
  State& state;
  double t_end;
  void* scheme;
  const SchemeTable& scheme_can;
  void* control;
  const ControlTable& control_can;
  Watch* watch;  // none: no events
  void* observer;
  bool (*observe)(void*, const State& from, const State& to, double dt);
  void (*jumped)(void*, const State& after, const Jump& jump);  // null: the observer does not see them
};

template <class S, class Observer>
struct Watching {
  Observer& observer;
  const S& scheme;
};

Outcome run(const Task& task);

[[noreturn]] void refuse_tolerance_of_sweeps();

// Whether a scheme can find the jumps of a problem; of an erased one that is not known before a run starts.
template <class S, class P>
concept LocatesFor = Dense<S> || std::same_as<std::remove_const_t<P>, Problem> || !LocatesJumps<P>;

template <class P, class S, class C, class Observer>
Outcome integrate(P& problem, State& state, double t_end, S& scheme, C& control, Watch* watch, Observer& observer) {
  static_assert(Advances<S, P>,
                "this scheme cannot advance all that the problem has: see advances() of the scheme, traits_of() of the "
                "problem");
  static_assert(LocatesFor<S, P>,
                "events and located jumps need a scheme with dense output, at(from, dt, theta, there)");
  static_assert(
      EstimatesTruncation<S> || !NeedsTruncation<C>,
      "this control goes by an estimate of the error of each step, and the scheme has none: take Collocation, "
      "or FixedStep");
  static_assert(Iterative<S> || !NeedsSweeps<C>,
                "this control goes by the sweeps of a scheme, and this one makes none: take FixedStep, or ErrorControl "
                "for a scheme that estimates its error");
  if constexpr (BoundsSweeps<C> && !Iterative<S>) {
    if (control.bounds_sweeps()) refuse_tolerance_of_sweeps();
  }
  using Seen = Watching<S, Observer>;
  Seen seen{observer, scheme};
  void (*jumped)(void*, const State&, const Jump&) = nullptr;
  if constexpr (SeesJumps<Observer>) {
    jumped = [](void* o, const State& after, const Jump& jump) { as<Seen>(o).observer.jumped(after, jump); };
  }
  return run({.problem = problem,
              .state = state,
              .t_end = t_end,
              .scheme = &scheme,
              .scheme_can = scheme_table_of<S>,
              .control = &control,
              .control_can = control_table_of<C>,
              .watch = watch,
              .observer = &seen,
              .observe = [](void* o, const State& from, const State& to, double dt) -> bool {
                const Seen& by = as<Seen>(o);
                return by.observer(from, to, dt, by.scheme);
              },
              .jumped = jumped});
}

}  // namespace detail

/// Advances a state to t_end: the loop that every scheme, controller and problem share, compiled once.
///
/// Scheme and control are taken by reference and the state keeps its time, so that a run can be continued, to the same
/// bits, and a checkpoint is three copies. Either may be a temporary, `integrate(problem, state, t_end,
/// VelocityVerlet{}, FixedStep{.step = 1e-3})`; what it learnt ends with the run. Any other run begins anew, whatever
/// the scheme was used for before. A step cut short to land on t_end does not change the controller's step unless the
/// controller decides so.
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
/// Where the problem has time scales (HasStepLimits) and the scheme says how many of them a step may span (Limited), an
/// adaptive step is cut to that and Outcome::ruled names the scale; a fixed step beyond it fails with
/// Failure::beyond_limit.
///
/// @param problem   the right-hand side, with whatever abilities it has
/// @param state     the start; on return the state at Outcome::t
/// @param t_end     the end time, not before the start [s]
/// @param scheme    the scheme
/// @param control   the step control
/// @param observer  gets (from, to, dt, scheme) of each accepted step before its jump, returns whether to go on; may
///                  be told the jump too (SeesJumps)
/// @return status, reason and counts
/// @throws std::invalid_argument for a start, an end or a controller that cannot be meant, and for a problem whose type
///         is erased and of which the scheme cannot advance all, or not locate the jumps
/// @throws std::logic_error if the controller accepts a step that has no value
template <AnyProblem P, class S, class C, class Observer = Unobserved>
requires(Scheme<std::remove_reference_t<S>>&& Controller<std::remove_reference_t<C>> &&
         !std::is_same_v<std::remove_cvref_t<Observer>, Watch>) Outcome
    integrate(P& problem, State& state, double t_end, S&& scheme, C&& control, Observer&& observer = {}) {
  return detail::integrate(problem, state, t_end, scheme, control, nullptr, observer);
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
/// @throws std::invalid_argument as the other integrate(), and where an event function is not finite
/// @throws std::logic_error if the controller accepts a step that has no value
template <AnyProblem P, class S, class C, class Observer = Unobserved>
requires(Scheme<std::remove_reference_t<S>>&& Controller<std::remove_reference_t<C>>) Outcome
    integrate(P& problem, State& state, double t_end, S&& scheme, C&& control, Watch& watch, Observer&& observer = {}) {
  static_assert(Dense<std::remove_reference_t<S>>,
                "events and located jumps need a scheme with dense output, at(from, dt, theta, there)");
  return detail::integrate(problem, state, t_end, scheme, control, &watch, observer);
}

}  // namespace particulate::schemes
