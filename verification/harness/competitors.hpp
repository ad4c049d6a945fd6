#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <harness/claims.hpp>
#include <harness/replay.hpp>
#include <harness/work_precision.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/runge_kutta.hpp>

namespace verification {

/// What every competitor is asked to do: the same right-hand side, start and output times, and the same truth.
template <class P, class State = schemes::State>
struct Race {
  P problem;                           ///< copied for each competitor
  State start;                         ///< where it starts
  std::vector<double> outputs;         ///< times at which a state is handed out, rising [s]
  std::function<State(double)> truth;  ///< the reference at a time; of Values, no entry 0: errors are relative to each
  double length = 1.0;                 ///< errors in position count in it below it, relative above, > 0 [m]
  double speed = 1.0;                  ///< errors in velocity likewise, > 0 [m/s]
};

namespace detail {

inline std::vector<double> flat(const schemes::State& state) {
  std::vector<double> all(state.r.begin(), state.r.end());
  all.insert(all.end(), state.v.begin(), state.v.end());
  return all;
}

inline std::vector<double> flat(const schemes::State& state) { return {state.y.begin(), state.y.end()}; }

template <class P>
bool rate_at(P& problem, const schemes::State& state, Eigen::VectorXd& rate) {
  rate.resize(state.r.size());
  return schemes::acceleration_of(problem, state.t, state.r, state.v, rate);
}
template <class P>
bool rate_at(P& problem, const schemes::State& state, Eigen::VectorXd& rate) {
  rate.resize(state.y.size());
  return problem.rate(state.t, state.y, rate);
}

/// One competitor's own copy of the race, with what it recorded and what it handed out last.
template <class P, class State = schemes::State>
struct Lane {
  Race<P, State> race;
  Recording recording = {};
  std::vector<State> handed = {};

  explicit Lane(const Race<P, State>& all) : race(all) {}

  Task task() {
    Eigen::VectorXd rate;
    if (!rate_at(race.problem, race.start, rate)) rate.setConstant(missing);
    return {.start = flat(race.start), .rate = {rate.begin(), rate.end()}, .outputs = race.outputs};
  }

  template <class Problem, class Begin>
  Counts follow(Problem& problem, const Begin& begin, double setting) {
    State state = race.start;
    auto advance = begin(problem, race.start, setting);
    Counts counts;
    handed.clear();
    for (const double t : race.outputs) {
      const schemes::Outcome outcome = advance(state, t);
      counts.evaluations += outcome.evaluations;
      counts.iterations += outcome.sweeps;
      if (outcome.status != schemes::Status::reached) {
        counts.failure = outcome.reason;
        break;
      }
      handed.push_back(state);
    }
    return counts;
  }

  std::vector<double> scaled(const schemes::State& state, const schemes::State&) const {
    return flat(schemes::State{.t = state.t, .r = state.r / race.length, .v = state.v / race.speed});
  }
  std::vector<double> scaled(const schemes::State& state, const schemes::State& exact) const {
    return flat(schemes::State{.t = state.t, .y = state.y.cwiseQuotient(exact.y)});
  }

  Errors errors() const {
    Errors errors;
    for (const State& state : handed) {
      const State exact = race.truth(state.t);
      errors.end = mixed_error(scaled(state, exact), scaled(exact, exact), 1.0);
      errors.max = std::isnan(errors.end) ? errors.end : std::max(errors.max, errors.end);
    }
    return errors;
  }
};

}  // namespace detail

/// Makes a competitor of anything that can begin a run.
///
/// @param name      as it stands in the diagram's key
/// @param race      problem, start, outputs and truth
/// @param settings  steps or tolerances, falling
/// @param begin     `begin(problem, start, setting)` gives a function `advance(state, t_end)` that returns an Outcome;
///                  it is called with the problem, with its recorder and with its replay
/// @return the competitor: every run starts from scratch, so that setting up counts too
template <class P, class State, class Begin>
Competitor competitor(std::string name, const Race<P, State>& race, std::vector<double> settings, Begin begin) {
  const auto prepare = [race, begin](double setting) {
    const auto lane = std::make_shared<detail::Lane<P, State>>(race);
    Recorded<P> recorded{lane->race.problem};
    const Counts counts = lane->follow(recorded, begin, setting);
    if (counts.evaluations != recorded.evaluations()) {
      throw std::logic_error(fmt::format("an integrator must count every right-hand side: it says {}, the problem {}",
                                         counts.evaluations, recorded.evaluations()));
    }
    lane->recording = std::move(recorded.recording);
    return Prepared{.task = lane->task(),
                    .run = [=] { return lane->follow(lane->race.problem, begin, setting); },
                    .errors = [=] { return lane->errors(); },
                    .replay =
                        [=] {
                          Replayed<P> replayed(lane->race.problem, lane->recording);
                          return lane->follow(replayed, begin, setting);
                        }};
  };
  return {.name = std::move(name), .tuned = false, .slope = {}, .settings = std::move(settings), .prepare = prepare};
}

/// An explicit scheme at fixed steps, for competitor().
///
/// @return begin(problem, start, step)
template <class Scheme>
auto at_fixed_step() {
  return [](auto& problem, const schemes::State&, double step) {
    return [&problem, scheme = Scheme{}, control = schemes::FixedStep{.step = step}](schemes::State& state,
                                                                                     double t_end) mutable {
      return schemes::integrate(problem, state, t_end, scheme, control);
    };
  };
}

}  // namespace verification
