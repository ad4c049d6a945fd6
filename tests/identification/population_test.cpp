#include <particulate/identification/population.hpp>

#include <cmath>

#include <particulate/scenes/checkpoint.hpp>

#include "numbers.hpp"
#include "says.hpp"

namespace tests::population_test {

using namespace particulate::identification;

// Two of equal cost, two without value.
Population five() {
  Population population;
  population.strings = Eigen::RowVectorXd::LinSpaced(5, 0.0, 4.0);
  population.values = {Value("none"), Value(2.0), Value(1.0), Value("no more"), Value(1.0)};
  population.without_value = {{"none", 1}, {"no more", 3}};
  population.generation = 4;
  population.evaluations = 77;
  population.history = {not_a_number, 1.0};
  population.engine.seed(3);
  return population;
}

BOOST_AUTO_TEST_SUITE(rank_)

BOOST_AUTO_TEST_CASE(keeps_the_order_of_equal_costs_and_puts_strings_without_value_last) {
  Population population = five();
  rank(population);
  BOOST_TEST((population.strings.row(0) == Eigen::RowVectorXd{{2.0, 4.0, 1.0, 0.0, 3.0}}));
  BOOST_TEST(population.values[1].cost == 1.0);
  BOOST_TEST(population.values[3].reason == "none");
  BOOST_TEST(population.values[4].reason == "no more");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(best_of_)

BOOST_AUTO_TEST_CASE(is_the_first_of_the_least_cost_or_what_was_put_aside) {
  Population population = five();
  BOOST_TEST(best_of(population).parameters[0] == 2.0);
  population.aside = Eigen::VectorXd::Constant(1, 9.0);
  population.aside_cost = 0.5;
  BOOST_TEST(best_of(population).parameters[0] == 9.0);
  BOOST_TEST(best_of(Population{}).parameters.size() == 0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(mean_of_best_)

BOOST_AUTO_TEST_CASE(is_over_those_that_have_a_value) {
  BOOST_TEST(mean_of_best(five(), 2) == 1.0);
  BOOST_TEST(mean_of_best(five()) == 4.0 / 3.0);
  BOOST_TEST(std::isnan(mean_of_best(Population{})));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(population_from_)

BOOST_AUTO_TEST_CASE(gives_back_every_bit) {
  Population population = five();
  population.aside = Eigen::VectorXd::Constant(1, 0.1);
  population.aside_cost = 1e-300;
  population.restarts = 2;
  const std::string bytes = to_bytes(population, "cost a\nS 5\n");
  Population back = population_from(bytes, "file", "cost a\nS 5\n");
  BOOST_TEST((to_bytes(back, "cost a\nS 5\n") == bytes));
  BOOST_TEST((back.strings == population.strings));
  BOOST_TEST(back.values[3].reason == "no more");
  BOOST_TEST(back.without_value.at("no more") == 3);
  BOOST_TEST(back.engine() == population.engine());
  const std::string fresh = to_bytes({.strings = Eigen::MatrixXd::Ones(2, 3)}, "a");
  BOOST_TEST(population_from(fresh, "file", "a").values.size() == 0U);
}

BOOST_AUTO_TEST_CASE(refuses_another_problem_and_a_file_that_is_cut_short_or_no_population) {
  const std::string bytes = to_bytes(five(), "cost a\nS 5\n");
  CHECK_REFUSED(population_from(bytes, "old.population", "cost a\nS 6\n"), "line 2 of what it is made of is \"S 5\"");
  BOOST_CHECK_EXCEPTION(population_from(bytes.substr(0, bytes.size() - 9), "old.population", "cost a\nS 5\n"),
                        std::runtime_error, says("old.population: must end with a line with its checksum"));
  BOOST_CHECK_EXCEPTION(population_from(particulate::scenes::to_bytes({.scene = "a"}), "old.population", "a"),
                        std::runtime_error, says("old.population: must hold a population"));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::population_test
