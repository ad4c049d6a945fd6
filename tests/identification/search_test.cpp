#include <particulate/identification/search.hpp>

#include <cmath>

#include "numbers.hpp"
#include "says.hpp"

namespace tests::search_test {

using namespace particulate::identification;

const Box square{.lower = Eigen::Vector2d(-5.0, -5.0), .upper = Eigen::Vector2d(6.0, 6.0)};

// Minima near every pair of whole numbers, the least at 0.
Eigen::VectorXd ripples(const Eigen::VectorXd& x) {
  Eigen::VectorXd all(4);
  all << x, 4.0 * (pi * x.array()).sin().matrix();
  return all;
}
// A cost that is no sum of squares, least at the same place.
Value distance(const Eigen::VectorXd& x) { return ripples(x).lpNorm<1>(); }

BOOST_AUTO_TEST_SUITE(search_)

BOOST_AUTO_TEST_CASE(finds_the_least_of_many_minima_and_reports_cost_and_squares) {
  const Found found = search(distance, ripples, square, {}, {.goal = 1e-6, .evaluations = 20000}, 1);
  BOOST_TEST((found.ended.stop == Stop::goal));
  BOOST_TEST(found.ended.best.cost == distance(found.ended.best.parameters).cost);
  BOOST_TEST(found.squares == ripples(found.ended.best.parameters).squaredNorm());
  BOOST_TEST(found.polishes > 0);
}

BOOST_AUTO_TEST_CASE(counts_every_evaluation_and_makes_none_beyond_its_limit) {
  long costs = 0, residuals = 0;
  const Cost cost = [&](const Eigen::VectorXd& x) {
    ++costs;
    return distance(x);
  };
  const Residuals counted = [&](const Eigen::VectorXd& x) {
    ++residuals;
    return ripples(x);
  };
  for (const long limit : {3L, 40L, 41L, 42L, 150L, 1000L}) {
    costs = residuals = 0;
    const Found found = search(cost, counted, square, {}, {.evaluations = limit}, 1);
    BOOST_TEST(costs + residuals == limit);
    BOOST_TEST(found.population.evaluations == limit);
    BOOST_TEST(found.for_polishing <= limit);
  }
}

BOOST_AUTO_TEST_CASE(polishes_nothing_where_there_are_no_residuals) {
  const Found found = search(distance, {}, square, {}, {.goal = 1e-3, .evaluations = 20000}, 1);
  BOOST_TEST((found.ended.stop == Stop::goal));
  BOOST_TEST(found.polishes == 0);
  BOOST_TEST(std::isnan(found.squares));
}

// Whatever lowers these squares raises this cost.
BOOST_AUTO_TEST_CASE(keeps_a_string_that_costs_less_than_what_polishing_makes_of_it) {
  const Cost far_away = [](const Eigen::VectorXd& x) { return 1.0 / (1.0 + x.squaredNorm()); };
  const Residuals squares = [](const Eigen::VectorXd& x) { return x; };
  double last = 1.0;
  const auto watch = [&](const Population& now) {
    BOOST_TEST(now.values.front().cost <= last);
    last = now.values.front().cost;
    return true;
  };
  const Found found = search(far_away, squares, square, {}, {.generations = 15}, 1, watch);
  BOOST_TEST(found.polishes > 50);
  // The corner at (6, 6).
  BOOST_TEST(found.ended.best.cost == 1.0 / 73.0, boost::test_tools::tolerance(0.1));
  BOOST_TEST(found.squares == found.ended.best.parameters.squaredNorm());
}

BOOST_AUTO_TEST_CASE(ends_at_every_other_stop_as_well) {
  const auto ended = [](const Search& numbers, const Stops& stops) {
    return search(distance, ripples, square, numbers, stops, 1).ended.stop;
  };
  BOOST_TEST((ended({}, {.generations = 3}) == Stop::generations));
  BOOST_TEST((ended({}, {.seconds = 0.0}) == Stop::seconds));
  Search plain;
  plain.algorithm.restart.reset();
  BOOST_TEST((ended(plain, {.stagnation = Stagnation{.generations = 4}}) == Stop::stagnation));
  long generations = 0;
  const auto third = [&](const Population&) { return ++generations < 3; };
  BOOST_TEST((search(distance, ripples, square, {}, {.evaluations = 5000}, 1, third).ended.stop == Stop::observer));
  BOOST_TEST(generations == 3);
}

BOOST_AUTO_TEST_CASE(has_the_same_bits_for_any_number_of_threads) {
  const auto by = [](int threads) {
    Search numbers;
    numbers.algorithm.threads = threads;
    return to_bytes(search(distance, ripples, square, numbers, {.evaluations = 3000}, 1).population, "ripples");
  };
  const std::string one = by(1);
  for (const int threads : {2, 3, 8}) BOOST_TEST((by(threads) == one));
}

BOOST_AUTO_TEST_CASE(refuses_what_cannot_be_meant) {
  CHECK_REFUSED(search(distance, ripples, square, {.polished = -1}, {.generations = 1}, 1),
                "must not be negative, got -1");
  CHECK_REFUSED(search(distance, ripples, square, {.polishing = {.step = 0.0}}, {.generations = 1}, 1), "got 0");
  CHECK_REFUSED(search(distance, ripples, square, {}, {}, 1), "something must end it");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::search_test
