#pragma once

#include <concepts>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <particulate/schemes/outcome.hpp>
#include <particulate/schemes/problem.hpp>

/// @file
/// What a scheme and its step control must offer. Nothing here knows a force law or a stage count.

namespace particulate::schemes {

/// Iteration of one attempted step; of the controlling part, where a state has several.
///
/// Sweeps are numbered from 0: w_0 is the change made by the first, w_K by the last, with K contractions between. An
/// explicit scheme makes no sweep: K stays -1. See IterationMeasure for how the numbers come about.
struct Iteration {
  double w_0 = 0.0;             ///< change of the first sweep over the first displacement, 0 where nothing moves [-]
  double w_K = 0.0;             ///< change of the last sweep over the first displacement, 0 where nothing moves [-]
  double change = 0.0;          ///< the last sweep's change, not normalized, in the problem's measure
  double rate = 0.0;            ///< the last change over the one before it: the contraction that was seen [-]
  int K = -1;                   ///< contractions so far; -1: no sweep yet [-]
  int p = 2;                    ///< contraction ~ Dt^p: 2 for second-order problems, 1 for first-order ones [-]
  bool evaluated = true;        ///< false: the problem had no value, or no finite one, at some iterate
  double rounding = 0.0;        ///< what one rounding of the state makes of w: no w below it means anything [-]
  bool rests = false;           ///< whether the first displacement is below 1e-8 of the state, so that rounding will do
  std::string_view field = {};  ///< where a state has several parts, the name of this one; it outlives the run
};

/// A scheme is a value: copying it checkpoints whatever history it keeps.
///
/// `predict(problem, from, dt, to)` gives the first guess of the step, which is an explicit scheme's answer, and
/// returns whether the problem had a value; `accept(dt)` keeps the step's history for the next one; `forget()` drops
/// it, because the state was changed from outside or another run begins. `advances(traits)`, a constant function, says
/// whether the scheme can advance all that a problem has; values that change by jumps alone are carried along for it.
template <class S>
concept Scheme = std::copyable<S> && requires(S& s, const Problem& p, const State& from, double dt, State& to) {
  { S::order } -> std::convertible_to<int>;
  { S::advances(Traits{}) } -> std::same_as<bool>;
  { s.predict(p, from, dt, to) } -> std::same_as<bool>;
  s.accept(dt);
  s.forget();
};

/// A scheme that can advance all that a problem has. Of a problem whose type is erased that is not known before a run
/// starts, which then refuses it.
template <class S, class P>
concept Advances = Scheme<S> &&(std::same_as<std::remove_const_t<P>, Problem> || S::advances(traits_of<P>()));

/// A scheme that improves its guess by sweeps: `sweep(problem, from, dt, to)`. One sweep is the unit, so that the
/// fixed point of the monograph, collocation, Newton and staggered fields fit one loop.
template <class S>
concept Iterative = Scheme<S> && requires(S& s, const Problem& p, const State& from, double dt, State& to) {
  { s.sweep(p, from, dt, to) } -> std::same_as<Iteration>;
};

/// A scheme with dense output: `at(from, dt, theta, there)`, the state at a fraction theta of the step just made.
template <class S>
concept Dense = requires(const S& s, const State& from, double dt, double theta, State& there) {
  s.at(from, dt, theta, there);
};

/// Ability of a scheme: `begin(problem, state)`, told at the start of every run in place of forget(), so that a run in
/// two parts repeats one run to the last bit. History may be kept only where the run goes on exactly where the last
/// step ended, with the same problem (Problem::identity), and where it is still right if that was changed in between.
template <class S>
concept Begins = requires(S& s, const Problem& p, const State& at) {
  s.begin(p, at);
};

/// Ability of a scheme: how many of a problem's time scales one of its steps may span, `spans(kind, sweeps)`: 1/omega
/// or 1/lambda, beyond which it is unstable or its sweeps do not contract. `sweeps` is how many a step makes, or 0
/// where they go on until they have converged. Without the ability there is no such limit.
template <class S>
concept Limited = requires(const S& s, TimeScale::Kind kind, int sweeps) {
  { s.spans(kind, sweeps) } -> std::same_as<double>;
};

/// Ability of a Limited scheme: `adds_limits`, a constant. Waves and decays then share a step:
/// \f$ (\Delta t/\Delta t_w)^2 + \Delta t/\Delta t_d \le 1 \f$ with what each alone allows.
template <class S>
concept AddsLimits = Limited<S> && S::adds_limits;

/// What a scheme thinks of the error that one step left.
struct Truncation {
  double error = std::numeric_limits<double>::quiet_NaN();  ///< in the scheme's own measure; NaN: no estimate
  int order = 0;                                            ///< the estimate falls with the power order + 1 of Dt [-]
};

/// One attempted step, as its controller sees it.
struct Attempt {
  double dt;                               ///< the step that was tried [s]
  Iteration iteration;                     ///< how its iteration went
  Truncation truncation = {};              ///< of the scheme, if it estimates any
  std::span<const Iteration> fields = {};  ///< of every part of the state, where it has several
  bool within_limits = false;              ///< the problem's time scales have bounded the step: see Limited
};

/// Ability of a scheme: one Iteration for each of several parts of the state, each in units of that part's tolerance;
/// none where there is one part alone.
template <class S>
concept Measured = requires(const S& s) {
  { s.iterations() } -> std::convertible_to<std::span<const Iteration>>;
};

/// Ability of a scheme: `truncation(problem, from, dt, to)` estimates the error of the step just made, of the first
/// step too: where it cannot, NaN, the step is refused.
template <class S>
concept EstimatesTruncation = requires(S& s, const Problem& p, const State& from, double dt, const State& to) {
  { s.truncation(p, from, dt, to) } -> std::same_as<Truncation>;
};

/// What the controller made of an attempt.
struct Decision {
  bool accepted = false;            ///< the step stands
  std::string impossible = {};      ///< not empty: no smaller step is left to try, and why
  std::string refusal = {};         ///< why a step that is to be tried again was refused
  Failure failure = Failure::none;  ///< the same, for a program
  double workable =
      std::numeric_limits<double>::quiet_NaN();  ///< step that would have met the tolerance; NaN: unknown [s]
};

/// Chooses step sizes: `dt()` is the step to try next, `goes_on(iteration)` asks for one more sweep, `judge(attempt)`
/// accepts or refuses and sets the next step; `validate(controller)` throws std::invalid_argument when a run starts.
template <class C>
concept Controller = std::copyable<C> && requires(C& c, const C& seen, const Iteration& sweeping, const Attempt& made) {
  { seen.dt() } -> std::convertible_to<double>;
  { seen.goes_on(sweeping) } -> std::same_as<bool>;
  { c.judge(made) } -> std::same_as<Decision>;
  validate(seen);
};

/// Ability of a controller: `fixes_step`, a constant. A step beyond a limit of the problem is then refused, not cut.
template <class C>
concept FixesStep = C::fixes_step;

/// Ability of a controller: `fixes_sweeps`, a constant, beside `sweeps`, how many every step makes.
template <class C>
concept FixesSweeps = C::fixes_sweeps && requires(const C& c) {
  { c.sweeps } -> std::convertible_to<int>;
};

/// Ability of a controller: `needs_truncation`, a constant. A scheme without an estimate does not compile under it.
template <class C>
concept NeedsTruncation = C::needs_truncation;

/// Ability of a controller: `needs_sweeps`, a constant. A scheme that makes none does not compile under it.
template <class C>
concept NeedsSweeps = C::needs_sweeps;

/// Ability of a controller: `bounds_sweeps()`, whether it has a tolerance for sweeps. Under it a scheme that makes none
/// is refused when a run starts.
template <class C>
concept BoundsSweeps = requires(const C& c) {
  { c.bounds_sweeps() } -> std::same_as<bool>;
};

/// Ability of a controller: `waits_for_step()`, whether its first step was left out, and `begin(step)`, which gives it
/// one when a run starts: see first_step().
template <class C>
concept WaitsForStep = requires(C& c, const C& seen, double step) {
  { seen.waits_for_step() } -> std::same_as<bool>;
  c.begin(step);
};

/// Ability of a controller: `ignores_truncation`, a constant. No estimate is then made for it, which may cost
/// right-hand sides.
template <class C>
concept IgnoresTruncation = C::ignores_truncation;

}  // namespace particulate::schemes
