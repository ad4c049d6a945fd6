// What must be solved and what must be refused: costs, boxes, numbers of the algorithm, saved runs.

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <particulate/identification/search.hpp>

#include "test_functions.hpp"

namespace verification::identification_extremes {

using namespace particulate::identification;

constexpr std::uint64_t seed = 5;

Evolution run(const Cost& cost, const Box& box, const GeneticAlgorithm& algorithm, const Stops& stops) {
  Population population = first_population(box, algorithm, seed);
  return evolve(cost, box, algorithm, stops, population);
}

Ending constant_cost() {
  const Evolution one = run([](const auto&) { return 3.0; }, cube(4, -1.0, 1.0), {},
                            {.stagnation = Stagnation{.generations = 10}, .generations = 1000});
  return Ending::solved({.error = std::abs(one.best.cost - 3.0) + (one.stop == Stop::stagnation ? 0.0 : 1.0),
                         .tolerance = 0.0,
                         .because = "every string has the cost 3, and it ends on stagnation"});
}

Ending one_parameter() {
  const auto cost = [](const Eigen::VectorXd& x) { return std::pow(x[0] - 0.25, 2); };
  const Found found = search(cost, {}, cube(1, -1.0, 1.0), {}, {.goal = 1e-12, .evaluations = 10'000}, seed);
  return Ending::solved(
      {.error = std::abs(found.ended.best.parameters[0] - 0.25), .tolerance = 1e-6, .because = "the root of the goal"});
}

Ending plateau() {
  const TestFunction f = terraces(4);
  const Found found = search(f.cost, {}, f.box, {}, {.goal = 0.0, .evaluations = 10'000}, seed);
  return Ending::solved({.error = found.ended.best.parameters.cwiseAbs().maxCoeff(),
                         .tolerance = 0.25,
                         .because = "the lowest terrace is as wide, and flat"});
}

// Half of the box has no value, the minimum lies at its edge.
Ending half_without_value() {
  const TestFunction f = rastrigin(4);
  const Cost cost = [&](const Eigen::VectorXd& x) { return x[0] < -0.01 ? Value("left half") : f.cost(x); };
  const Residuals residuals = [&](const Eigen::VectorXd& x) {
    return x[0] < -0.01 ? Eigen::VectorXd() : f.residuals(x);
  };
  const Found found = search(cost, residuals, f.box, {}, {.goal = 1e-6, .evaluations = 50'000}, seed);
  return Ending::solved({.error = found.ended.best.parameters.norm(),
                         .tolerance = 1e-4,
                         .because = "the goal over the curvature 1 + 20 pi^2, and half as much to spare"});
}

Ending narrow_constraint() {
  Box box = cube(2, 0.0, 1.0);
  box.allows = [](const Eigen::VectorXd& x) { return x[1] > x[0] && x[1] < x[0] + 0.01; };
  const Cost cost = [](const Eigen::VectorXd& x) { return (x - Eigen::Vector2d(0.7, 0.3)).squaredNorm(); };
  const Found found = search(cost, {}, box, {}, {.goal = 0.0801, .evaluations = 10'000}, seed);
  return Ending::solved(
      {.error = found.ended.best.cost - 0.08,
       .tolerance = 1e-4,
       .because = "on the line x = y the nearest place is (0.5, 0.5), at 0.08; the goal is 1e-4 above"});
}

// All costs throughout the range of doubles: only their order matters.
Ending huge_and_tiny_costs() {
  const auto huge = [](const Eigen::VectorXd& x) { return std::pow(10.0, 300.0 * std::abs(x[0])); };
  const auto tiny = [](const Eigen::VectorXd& x) { return 1e-300 * x.squaredNorm(); };
  const Box box = cube(1, -1.0, 1.0);
  const double one = search(huge, {}, box, {}, {.goal = 1.001, .evaluations = 10'000}, seed).ended.best.parameters[0];
  const double other =
      search(tiny, {}, box, {}, {.goal = 1e-306, .evaluations = 10'000}, seed).ended.best.parameters[0];
  return Ending::solved({.error = std::max(std::abs(one), std::abs(other)),
                         .tolerance = 1e-3,
                         .because = "10^(300 x) <= 1.001 has |x| <= 1.5e-6, and 1e-300 x^2 <= 1e-306 has |x| <= 1e-3"});
}

const Case solved{{.name = "identification_extremes_solved",
                   .claim = "constant costs, plateaus, halves without value and narrow constraints are solved",
                   .equation = "R 5.1",
                   .reference = Reference::closed_form},
                  [](Rows& rows) {
                    rows.must_be_solved("a constant cost", constant_cost);
                    rows.must_be_solved("one parameter", one_parameter);
                    rows.must_be_solved("a plateau", plateau);
                    rows.must_be_solved("half the box without value", half_without_value);
                    rows.must_be_solved("a constraint that leaves a hundredth", narrow_constraint);
                    rows.must_be_solved("costs of 1e300 and of 1e-300", huge_and_tiny_costs);
                  }};

void refuse_numbers(Rows& rows) {
  const auto refuse = [&](const std::string& name, const std::string& key_words, const Box& box,
                          const GeneticAlgorithm& algorithm, const Stops& stops) {
    rows.must_be_refused(name, key_words, [&] {
      run([](const Eigen::VectorXd& x) { return x[0]; }, box, algorithm, stops);
      return accepted();
    });
  };
  const Box box = cube(2, 0.0, 1.0);
  const Stops few{.generations = 3};
  refuse("bounds reversed", "bounds of parameter 0 lower below the upper 1 0", cube(2, 1.0, 0.0), {}, few);
  refuse("bounds equal", "bounds of parameter 0 lower below the upper 1", cube(2, 1.0, 1.0), {}, few);
  refuse("an infinite bound", "bounds of parameter 0 must be finite inf", cube(2, 0.0, infinite), {}, few);
  refuse("a box without parameters", "at least one 0 and 0", {}, {}, few);
  refuse("fewer strings than parents", "K parents S = 4 K = 6 raise S", box, {.S = 4, .K = 6}, few);
  refuse("an odd K", "K must be even got 5 pairs", box, {.K = 5}, few);
  refuse("no parents", "K must be even at least 2 got 0", box, {.K = 0}, few);
  refuse("a goal that is no number", "goal must be a number got nan", box, {}, {.goal = not_a_number});
  refuse("a negative limit", "must not be negative got -1", box, {}, {.evaluations = -1});
  refuse("no stop at all", "something must end it no stop give a goal", box, {}, {});
  Box nowhere = box;
  nowhere.allows = [](const Eigen::VectorXd& x) { return x[0] > 2.0; };
  refuse("a constraint that nothing meets", "allowed 1000 strings none narrower", nowhere, {}, few);
}

void refuse_costs(Rows& rows) {
  rows.must_be_refused("nowhere a value", "none of 40 tried frequent no energy narrower", [] {
    const Cost never = [](const Eigen::VectorXd&) -> Value { throw std::runtime_error("no energy"); };
    search(never, {}, cube(2, 0.0, 1.0), {}, {.generations = 3}, seed);
    return accepted();
  });
  rows.must_be_refused("fewer residuals than parameters", "as many residuals as parameters 1 and 2", [] {
    const Residuals one = [](const Eigen::VectorXd& x) { return Eigen::VectorXd(x.head(1)); };
    polish(one, cube(2, 0.0, 1.0), Eigen::Vector2d(0.5, 0.5));
    return accepted();
  });
}

void refuse_files(Rows& rows) {
  const Box box = cube(2, 0.0, 1.0);
  const std::string problem = problem_of("bowl", box, {});
  const std::string whole = to_bytes(first_population(box, {}, seed), problem);
  const auto refuse = [&](const std::string& name, const std::string& key_words, const std::string& bytes,
                          const std::string& of) {
    rows.must_be_refused(name, key_words, [&] {
      population_from(bytes, "old.population", of);
      return accepted();
    });
  };
  refuse("a saved run of another cost", "old.population bowl bucket", whole, problem_of("bucket", box, {}));
  refuse("a saved run of another box", "old.population parameter 0", whole, problem_of("bowl", cube(2, 0.0, 2.0), {}));
  refuse("a saved run of another K", "old.population K 6 K 4", whole, problem_of("bowl", box, {.K = 4}));
  refuse("a saved run cut short", "old.population cut short", whole.substr(0, whole.size() / 2), problem);
}

const Case refused{{.name = "identification_extremes_refused",
                    .claim = "boxes, numbers, costs and saved runs that cannot be meant are refused, with the reason",
                    .equation = "R 5.1",
                    .reference = Reference::design},
                   [](Rows& rows) {
                     refuse_numbers(rows);
                     refuse_costs(rows);
                     refuse_files(rows);
                   }};

}  // namespace verification::identification_extremes
