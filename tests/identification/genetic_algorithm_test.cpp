#include <particulate/identification/genetic_algorithm.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include "numbers.hpp"
#include "says.hpp"

namespace tests::genetic_algorithm_test {

using namespace particulate::identification;

const Box square{.lower = Eigen::Vector2d(-1.0, 2.0), .upper = Eigen::Vector2d(3.0, 4.0)};
constexpr GeneticAlgorithm small{.S = 8, .K = 2};

Value bowl(const Eigen::VectorXd& x) { return (x - Eigen::Vector2d(0.5, 2.5)).squaredNorm(); }

struct Run {
  Population population;
  Evolution ended;
};
Run run(const Cost& cost, const GeneticAlgorithm& algorithm, const Stops& stops, const Box& box = square) {
  Run one{.population = first_population(box, algorithm, 7), .ended = {}};
  one.ended = evolve(cost, box, algorithm, stops, one.population);
  return one;
}

const std::string problem = problem_of("bowl", square, small);

std::string bits(const Population& population) { return to_bytes(population, problem); }

bool inside(const Eigen::VectorXd& x, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (x.array() >= a.cwiseMin(b).array()).all() && (x.array() <= a.cwiseMax(b).array()).all();
}

BOOST_AUTO_TEST_SUITE(validate_algorithm)

BOOST_AUTO_TEST_CASE(names_the_number_that_cannot_be_meant) {
  BOOST_CHECK_NO_THROW(validate(GeneticAlgorithm{}));
  const auto refuses = [](const GeneticAlgorithm& one, const char* words) { CHECK_REFUSED(validate(one), words); };
  refuses({.K = 0}, "the number K of parents must be even and at least 2, got 0: they mate in pairs");
  refuses({.K = 5}, "must be even and at least 2, got 5");
  refuses({.S = 4, .K = 6}, "the S strings must hold K parents and their K children, got S = 4 and K = 6");
  refuses({.rescaling = 0.0}, "rescaling must be positive, got 0");
  refuses({.rescaling = not_a_number}, "rescaling must be positive, got nan");
  refuses({.restart = Stagnation{.generations = 0}}, "stagnation must be seen over at least one generation, got 0");
  refuses({.restart = Stagnation{.size = -0.1}}, "the share by which a cost must fall must not be negative, got -0.1");
  refuses({.most_tries = 0}, "at least one string must be drawn, most_tries, got 0");
  refuses({.threads = 0}, "there must be at least one thread, got 0");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(first_population_)

BOOST_AUTO_TEST_CASE(fills_the_box_with_what_is_allowed_by_seed) {
  Box half = square;
  half.allows = [](const Eigen::VectorXd& x) { return x[1] > x[0] + 2.0; };
  const Population one = first_population(half, {.S = 200}, 1), other = first_population(half, {.S = 200}, 2);
  for (const auto string : one.strings.colwise()) {
    BOOST_REQUIRE((inside(string, square.lower, square.upper) && half.allows(string)));
  }
  BOOST_TEST((one.strings == first_population(half, {.S = 200}, 1).strings));
  BOOST_TEST((one.strings != other.strings));
  BOOST_TEST(one.values.size() == 0U);
}

BOOST_AUTO_TEST_CASE(refuses_a_box_in_which_nothing_is_allowed_and_one_that_is_none) {
  Box nowhere = square;
  nowhere.allows = [](const Eigen::VectorXd&) { return false; };
  CHECK_REFUSED(first_population(nowhere, {.most_tries = 50}, 1), "of 50 strings drawn in it none was: make the box");
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(1);
  CHECK_REFUSED(first_population({.lower = 2.0 * one, .upper = one}, {}, 1), "bounds of parameter 0");
  CHECK_REFUSED(first_population({.lower = one, .upper = one}, {}, 1), "the lower below the upper; got 1 and 1");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(evolve_)

BOOST_AUTO_TEST_CASE(keeps_the_parents_mates_neighbours_in_rank_and_draws_the_rest_anew) {
  constexpr GeneticAlgorithm algorithm{.S = 10, .K = 4};
  std::vector<Eigen::VectorXd> asked;  // in order
  const Cost cost = [&](const Eigen::VectorXd& x) {
    asked.push_back(x);
    return bowl(x);
  };
  Population population = first_population(square, algorithm, 3);
  evolve(cost, square, algorithm, {.generations = 1}, population);
  const Eigen::MatrixXd parents = population.strings.leftCols(4);
  evolve(cost, square, algorithm, {.generations = 2}, population);
  BOOST_REQUIRE(asked.size() == 16U);
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Index first = k < 2 ? 0 : 2;
    BOOST_TEST(inside(asked[10 + k], parents.col(first), parents.col(first + 1)));
  }
  BOOST_TEST((asked[10] != asked[11]));
  for (std::size_t k = 14; k < 16; ++k) BOOST_TEST(inside(asked[k], square.lower, square.upper));
  // The parents are kept: whoever is not among the next ten is worse than all of them.
  for (const auto parent : parents.colwise()) {
    BOOST_TEST(((population.strings.colwise() - parent).colwise().norm().minCoeff() == 0.0));
  }
}

BOOST_AUTO_TEST_CASE(evaluates_no_parent_again) {
  long calls = 0;
  const Cost cost = [&](const Eigen::VectorXd& x) {
    ++calls;
    return bowl(x);
  };
  const Run one = run(cost, {.S = 20, .K = 6}, {.generations = 11});
  BOOST_TEST(calls == 20 + 10 * 14);
  BOOST_TEST(one.population.evaluations == calls);
  BOOST_TEST(one.population.history.size() == 11U);
  BOOST_TEST(std::is_sorted(one.population.history.rbegin(), one.population.history.rend()));
}

BOOST_AUTO_TEST_CASE(says_what_stopped_it) {
  const auto stop = [](const Cost& cost, const Stops& stops) { return run(cost, small, stops).ended; };
  const Cost flat = [](const Eigen::VectorXd&) { return 1.0; };
  BOOST_TEST((stop(bowl, {.goal = 0.5}).stop == Stop::goal));
  BOOST_TEST(stop(bowl, {.goal = 0.5}).best.cost <= 0.5);
  BOOST_TEST(contains(stop(bowl, {.goal = 0.5}).reason, "is at most the goal, 0.5"));
  BOOST_TEST((stop(flat, {.stagnation = Stagnation{.generations = 3}}).stop == Stop::stagnation));
  BOOST_TEST(contains(stop(flat, {.stagnation = Stagnation{.generations = 3}}).reason, "within 3 generations"));
  BOOST_TEST((stop(bowl, {.generations = 4}).stop == Stop::generations));
  BOOST_TEST(contains(stop(bowl, {.evaluations = 50}).reason, "limit of 50 evaluations"));
  BOOST_TEST((stop(bowl, {.seconds = 0.0}).stop == Stop::seconds));
  Population population = first_population(square, small, 1);
  const auto second = [](const Population& at) { return at.generation < 2; };
  BOOST_TEST((evolve(bowl, square, small, {.generations = 9}, population, second).stop == Stop::observer));
  BOOST_TEST(population.generation == 2);
}

BOOST_AUTO_TEST_CASE(stagnates_where_the_cost_falls_by_less_than_a_share_over_the_window) {
  // Call k gives 1/k: the best of a generation is that of its last call, 1/8, 1/14, 1/20, ...
  long calls = 0;
  const Cost falling = [&](const Eigen::VectorXd&) { return 1.0 / static_cast<double>(++calls); };
  const Run one = run(falling, small, {.stagnation = Stagnation{.generations = 2, .size = 0.25}});
  // 1 - (8 + 6 (g - 3))/(8 + 6 (g - 1)) = 12/(2 + 6 g) falls to 0.25 or less at g = 8.
  BOOST_TEST(one.population.generation == 8);
}

BOOST_AUTO_TEST_CASE(ends_at_the_limit_of_evaluations_within_a_generation_and_goes_on_with_the_same_bits) {
  const std::string whole = bits(run(bowl, small, {.evaluations = 200}).population);
  for (const long limit : {1L, 7L, 8L, 9L, 61L, 199L}) {
    Run one = run(bowl, small, {.evaluations = limit});
    BOOST_TEST(one.population.evaluations == limit);
    Population from = population_from(bits(one.population), "file", problem);
    evolve(bowl, square, small, {.evaluations = 200}, from);
    BOOST_TEST((bits(from) == whole));
  }
}

BOOST_AUTO_TEST_CASE(has_the_same_bits_for_any_number_of_threads) {
  const auto by = [](int threads) {
    return bits(run(bowl, {.S = 21, .K = 6, .threads = threads}, {.evaluations = 333}).population);
  };
  const std::string one = by(1);
  for (const int threads : {2, 3, 8, 50}) BOOST_TEST((by(threads) == one));
}

BOOST_AUTO_TEST_CASE(ranks_what_has_no_value_last_and_counts_it_by_reason) {
  const Cost cost = [](const Eigen::VectorXd& x) -> Value {
    if (x[0] > 1.0) throw std::runtime_error("too far");
    return x[1] > 3.0 ? Value(not_a_number) : bowl(x);
  };
  const Run one = run(cost, {.S = 40, .K = 10}, {.generations = 5});
  long failed = 0;
  for (const auto& [reason, count] : one.population.without_value) failed += count;
  BOOST_TEST(one.population.without_value.size() == 2U);
  BOOST_TEST(one.population.without_value.at("too far") > 10);
  BOOST_TEST(one.population.without_value.at("the cost is not a number") > 10);
  BOOST_TEST(failed < one.population.evaluations);
  BOOST_TEST(one.ended.best.cost < 0.1);
}

BOOST_AUTO_TEST_CASE(refuses_a_box_without_any_value_and_says_how_many_were_tried) {
  const Cost never = [](const Eigen::VectorXd& x) { return Value(x[0] > 2.5 ? "rare" : "frequent"); };
  CHECK_REFUSED(run(never, {}, {.generations = 5}), "none of 20 tried had one; the most frequent reason, ");
  CHECK_REFUSED(run(never, {}, {.generations = 5}), "frequent. Make the box narrower");
  CHECK_REFUSED(run(never, {}, {.evaluations = 5}), "none of 5 tried");
}

BOOST_AUTO_TEST_CASE(notices_a_best_cost_that_rises) {
  Run one = run(bowl, small, {.generations = 2});
  one.population.history.back() = -1.0;
  BOOST_CHECK_EXCEPTION(evolve(bowl, square, small, {.generations = 3}, one.population), std::logic_error,
                        says("the best cost must not rise, and rose from -1"));
}

BOOST_AUTO_TEST_CASE(starts_anew_on_stagnation_and_keeps_the_best_aside) {
  // The first string is the best, and all others are alike.
  long calls = 0;
  const Cost cost = [&](const Eigen::VectorXd&) { return ++calls == 1 ? 1.0 : 2.0; };
  const GeneticAlgorithm algorithm{.S = 8, .K = 2, .restart = Stagnation{.generations = 3}};
  const Eigen::VectorXd first = first_population(square, algorithm, 7).strings.col(0);
  const Run one = run(cost, algorithm, {.generations = 10});
  // Generations 1 to 4, 5 to 8, 9 and 10.
  BOOST_TEST(one.population.restarts == 2);
  BOOST_TEST(calls == (8 + 3 * 6) + (8 + 3 * 6) + (8 + 6));
  BOOST_TEST(one.population.values.front().cost == 2.0);
  BOOST_TEST(one.ended.best.cost == 1.0);
  BOOST_TEST((one.ended.best.parameters == first));
}

BOOST_AUTO_TEST_CASE(draws_rescaled_strings_about_the_best_one) {
  const GeneticAlgorithm algorithm{.S = 12, .K = 4, .rescaling = 0.5};
  std::vector<Eigen::VectorXd> asked;
  const Cost cost = [&](const Eigen::VectorXd& x) {
    asked.push_back(x);
    return bowl(x);
  };
  Population population = first_population(square, algorithm, 3);
  evolve(cost, square, algorithm, {.generations = 1}, population);
  const Eigen::VectorXd best = population.strings.col(0);
  Eigen::VectorXd reach = Eigen::VectorXd::Zero(2);
  for (Eigen::Index k = 1; k < 4; ++k) reach = reach.cwiseMax((population.strings.col(k) - best).cwiseAbs());
  evolve(cost, square, algorithm, {.generations = 2}, population);
  for (std::size_t k = 16; k < 20; ++k) {
    BOOST_TEST(inside(asked[k], best - 0.5 * reach, best + 0.5 * reach));
    BOOST_TEST(inside(asked[k], square.lower, square.upper));
  }
}

BOOST_AUTO_TEST_CASE(solves_one_parameter_a_plateau_and_a_constant) {
  const Box line{.lower = Eigen::VectorXd::Constant(1, -2.0), .upper = Eigen::VectorXd::Constant(1, 5.0)};
  const GeneticAlgorithm algorithm{.S = 20, .K = 6, .rescaling = 1.5};
  BOOST_TEST(std::abs(run([](const auto& x) { return std::abs(x[0] - 1.0); }, algorithm, {.goal = 1e-9}, line)
                          .ended.best.parameters[0] -
                      1.0) <= 1e-9);
  const Cost plateau = [](const Eigen::VectorXd& x) { return std::floor(4.0 * std::abs(x[0])); };
  BOOST_TEST(run(plateau, algorithm, {.goal = 0.0}, line).ended.best.cost == 0.0);
  BOOST_TEST(run([](const auto&) { return 3.0; }, algorithm, {.generations = 50}, line).ended.best.cost == 3.0);
}

BOOST_AUTO_TEST_CASE(refuses_stops_that_cannot_be_meant) {
  const auto refuses = [](const Stops& stops, const char* words) { CHECK_REFUSED(run(bowl, small, stops), words); };
  refuses({}, "something must end it, and no stop was given: give a goal, or a limit");
  refuses({.goal = not_a_number}, "the goal must be a number, got nan");
  refuses({.generations = -1}, "limits of generations and evaluations must not be negative, got -1");
  refuses({.evaluations = -2}, "must not be negative, got -2");
  refuses({.seconds = -1.0}, "the limit of seconds must not be negative, got -1");
  refuses({.seconds = not_a_number}, "must not be negative, got nan");
  refuses({.stagnation = Stagnation{.generations = 0}}, "at least one generation, got 0");
  CHECK_REFUSED(run(bowl, {.restart = Stagnation{}}, {.stagnation = Stagnation{}}),
                "a run that starts anew on stagnation must not end on it");
}

BOOST_AUTO_TEST_CASE(refuses_a_population_of_another_box_or_size) {
  Population population = first_population(square, small, 1);
  CHECK_REFUSED(evolve(bowl, square, {.S = 9, .K = 2}, {.generations = 1}, population),
                "must have 9 strings of 2 parameters, got 8 of 2");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::genetic_algorithm_test
