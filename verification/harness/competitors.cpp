#include <harness/competitors.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <harness/replay.hpp>

namespace verification {
namespace {

std::vector<double> numbers(const Eigen::VectorXd& all) { return {all.begin(), all.end()}; }

std::vector<double> scaled(const Race& race, const schemes::State& state, const schemes::State& exact) {
  return numbers(
      schemes::flat({.r = state.r / race.length, .v = state.v / race.speed, .y = state.y.cwiseQuotient(exact.y)}));
}

// One competitor's own copy of the race, with what it recorded and what it handed out last.
struct Lane {
  Race race;
  Begin begin;
  double setting;
  Replay tape = {};
  std::vector<schemes::State> handed = {};

  Task task() const {
    schemes::Rates rates;
    if (!race.problem.seen().rates(race.start, rates)) rates.a.setConstant(missing), rates.dy.setConstant(missing);
    return {.start = numbers(schemes::flat(race.start)),
            .rate = numbers(schemes::flat({.r = rates.a, .y = rates.dy})),
            .outputs = race.outputs};
  }

  Counts follow(const schemes::Problem& problem) {
    schemes::State state = race.start;
    const Advance advance = begin(problem, race.start, setting);
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

  void record() {
    const Counts counts = follow(race.problem.seen().with(tape));
    if (counts.evaluations == tape.evaluations()) return;
    throw std::logic_error(fmt::format("an integrator must count every right-hand side: it says {}, the problem {}",
                                       counts.evaluations, tape.evaluations()));
  }

  Counts replay() {
    tape.rewind();
    return follow(race.problem.seen().with(tape));
  }
};

}  // namespace

Errors errors_of(const Race& race, const std::vector<schemes::State>& handed) {
  Errors errors;
  for (const schemes::State& state : handed) {
    const auto judged = [&](const schemes::State& all) { return race.seen ? race.seen(all) : all; };
    const schemes::State exact = judged(race.truth(state.t));
    errors.end = mixed_error(scaled(race, judged(state), exact), scaled(race, exact, exact), 1.0);
    errors.max = std::isnan(errors.end) ? errors.end : std::max(errors.max, errors.end);
  }
  return errors;
}

Competitor competitor(std::string name, const Race& race, std::vector<double> settings, Begin begin) {
  const auto prepare = [race, begin = std::move(begin)](double setting) {
    const auto lane = std::make_shared<Lane>(Lane{.race = race, .begin = begin, .setting = setting});
    lane->record();
    return Prepared{.task = lane->task(),
                    .run = [=] { return lane->follow(lane->race.problem.seen()); },
                    .errors = [=] { return errors_of(lane->race, lane->handed); },
                    .replay = [=] { return lane->replay(); }};
  };
  return {.name = std::move(name), .tuned = false, .slope = {}, .settings = std::move(settings), .prepare = prepare};
}

}  // namespace verification
