#pragma once

#include <concepts>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <harness/claims.hpp>
#include <harness/work_precision.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>

namespace verification {

namespace schemes = particulate::schemes;

/// A problem held by value, its type forgotten: a copy of it answers by itself.
class HeldProblem {
 public:
  /// @param problem  kept
  template <schemes::AnyProblem P>
  requires(!std::same_as<P, schemes::Problem>) HeldProblem(P problem)
      : self_(std::make_shared<P>(std::move(problem))),
        copied_([](const void* p) -> std::shared_ptr<void> { return std::make_shared<P>(*static_cast<const P*>(p)); }),
        seen_([](void* p) { return schemes::Problem(*static_cast<P*>(p)); }) {}
  /// Copies the problem. @param other another
  HeldProblem(const HeldProblem& other)
      : self_(other.copied_(other.self_.get())), copied_(other.copied_), seen_(other.seen_) {}
  /// Copies the problem. @param other another @return this
  HeldProblem& operator=(const HeldProblem& other) {
    self_ = other.copied_(other.self_.get()), copied_ = other.copied_, seen_ = other.seen_;
    return *this;
  }

  /// @return it as schemes see it, as long as this lives
  schemes::Problem seen() const { return seen_(self_.get()); }

 private:
  std::shared_ptr<void> self_;
  std::shared_ptr<void> (*copied_)(const void*);
  schemes::Problem (*seen_)(void*);
};

/// What every competitor is asked to do: the same right-hand side, start and output times, and the same truth.
///
/// Errors of places and velocities are relative above a size of their own, and absolute in units of it below; those of
/// values are relative to each, so that the truth may have no value 0.
struct Race {
  HeldProblem problem;                          ///< copied for each competitor
  schemes::State start;                         ///< where it starts
  std::vector<double> outputs;                  ///< times at which a state is handed out, rising [s]
  std::function<schemes::State(double)> truth;  ///< the reference at a time
  double length = 1.0;                          ///< size of places, > 0 [m]
  double speed = 1.0;                           ///< size of velocities, > 0 [m/s]
  /// What is judged of a state, of the truth as of all others, such as its means; empty: all of it.
  std::function<schemes::State(const schemes::State&)> seen = {};
};

/// @param race    their task
/// @param handed  states that were handed out at its output times
/// @return their errors
Errors errors_of(const Race& race, const std::vector<schemes::State>& handed);

/// A run that has begun: `advance(state, t_end)`.
using Advance = std::function<schemes::Outcome(schemes::State& state, double t_end)>;
/// Begins a run of a problem, which outlives it, at a step or tolerance.
using Begin = std::function<Advance(const schemes::Problem& problem, const schemes::State& start, double setting)>;

/// Makes a competitor of anything that can begin a run.
///
/// @param name      as it stands in the diagram's key
/// @param race      problem, start, outputs and truth
/// @param settings  steps or tolerances, falling
/// @param begin     called with the problem, with its recorder and with its replay
/// @return the competitor: every run starts from scratch, so that setting up counts too
Competitor competitor(std::string name, const Race& race, std::vector<double> settings, Begin begin);

/// A scheme under a step control, for competitor().
///
/// @param scheme   copied for each run
/// @param control  makes a step control of a setting
/// @return begin(problem, start, setting)
template <class Scheme, class Control>
Begin under(Scheme scheme, Control control) {
  return [scheme, control](const schemes::Problem& problem, const schemes::State&, double setting) -> Advance {
    return [&problem, scheme, now = control(setting)](schemes::State& state, double t_end) mutable {
      return schemes::integrate(problem, state, t_end, scheme, now);
    };
  };
}

/// An explicit scheme at fixed steps, for competitor().
///
/// @return begin(problem, start, step)
template <class Scheme>
Begin at_fixed_step() {
  return under(Scheme{}, [](double step) { return schemes::FixedStep{.step = step}; });
}

}  // namespace verification
