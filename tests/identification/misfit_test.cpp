#include <particulate/identification/misfit.hpp>

#include <cmath>

#include "close.hpp"
#include "says.hpp"

namespace tests::misfit_test {

using boost::test_tools::tolerance;
using namespace particulate::identification;
using Eigen::Vector2d, Eigen::Vector3d;

// A model that gives its parameters back.
Eigen::VectorXd same(const Eigen::VectorXd& parameters) { return parameters; }
Eigen::VectorXd nothing(const Eigen::VectorXd&) { return {}; }
Eigen::VectorXd first_alone(const Eigen::VectorXd& parameters) { return parameters.head(1); }

// Weights of 1 : 3, of which the sum is not 1.
const std::vector<Wanted> wanted{{"light [-]", -0.1, 2.0}, {"warmth [K]", 400.0, 6.0}};

BOOST_AUTO_TEST_SUITE(Misfit_)

// A quarter of |-0.13 + 0.1|/0.1 and three quarters of |500 - 400|/400.
BOOST_AUTO_TEST_CASE(is_the_weighted_mean_of_relative_differences) {
  const Misfit misfit(wanted, same);
  BOOST_TEST(misfit(Vector2d(-0.13, 500.0)).cost == 0.25 * 0.3 + 0.75 * 0.25, tolerance(1e-14));
  BOOST_TEST(misfit(Vector2d(-0.1, 400.0)).cost == 0.0);
  BOOST_TEST(misfit(Vector2d(-0.07, 300.0)).cost == 0.25 * 0.3 + 0.75 * 0.25, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(does_not_know_the_unit_of_its_weights) {
  std::vector<Wanted> rescaled = wanted;
  for (Wanted& one : rescaled) one.weight *= 0.125;
  const Vector2d at(-0.13, 500.0);
  BOOST_TEST(Misfit(rescaled, same)(at).cost == Misfit(wanted, same)(at).cost);
}

BOOST_AUTO_TEST_CASE(leaves_out_what_has_no_weight) {
  const Misfit misfit({{"light [-]", -0.1, 0.0}, {"warmth [K]", 400.0}}, same);
  BOOST_TEST(misfit(Vector2d(7.0, 500.0)).cost == 0.25);
  BOOST_TEST(misfit.residuals(Vector2d(7.0, 500.0))[0] == 0.0);
}

// (350 - 300)/100, whatever the size of 300; and 0, which has no size, in units of 4.
BOOST_AUTO_TEST_CASE(counts_differences_in_the_scale_that_is_given) {
  BOOST_TEST(Misfit({{"warmth [K]", 300.0, 1.0, 100.0}}, same)(Eigen::VectorXd::Constant(1, 350.0)).cost == 0.5);
  BOOST_TEST(Misfit({{"balance", 0.0, 1.0, 4.0}}, same)(Eigen::VectorXd::Constant(1, -3.0)).cost == 0.75);
}

// 0.25 * 0.3^2 + 0.75 * 0.25^2.
BOOST_AUTO_TEST_CASE(has_residuals_whose_squares_add_up_to_the_mean_of_squares) {
  const Eigen::VectorXd residuals = Misfit(wanted, same).residuals(Vector2d(-0.07, 300.0));
  BOOST_TEST(close(residuals, Vector2d(0.3 * 0.5, -0.25 * std::sqrt(0.75)), {.relative = 1e-14}));
  BOOST_TEST(residuals.squaredNorm() == 0.069375, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(says_what_came_of_each_number) {
  const std::vector<Reached> reached = Misfit(wanted, same).reached(Vector2d(-0.13, 500.0));
  BOOST_TEST_REQUIRE(reached.size() == 2);
  BOOST_TEST(reached[0].name == "light [-]");
  BOOST_TEST((reached[0].wanted == -0.1 && reached[0].found == -0.13));
  BOOST_TEST(reached[0].misfit == -0.3, tolerance(1e-14));
  BOOST_TEST(reached[1].misfit == 0.25);
}

BOOST_AUTO_TEST_CASE(has_no_value_where_the_model_has_none) {
  const Misfit misfit(wanted, nothing);
  const Vector2d at(-0.1, 400.0);
  BOOST_TEST(misfit(at).reason == "the model has no value");
  BOOST_TEST(misfit.residuals(at).size() == 0);
  BOOST_TEST(misfit.reached(at).empty());
}

BOOST_AUTO_TEST_CASE(refuses_a_model_of_another_length) {
  const Misfit misfit(wanted, first_alone);
  const Vector2d at(-0.1, 400.0);
  const char* words = "the model must give a number for each of 2 that are wanted, or none at all, got 1";
  CHECK_REFUSED(misfit(at), words);
  CHECK_REFUSED(misfit.residuals(at), words);
  CHECK_REFUSED(misfit.reached(at), words);
}

BOOST_AUTO_TEST_CASE(refuses_what_cannot_be_wanted) {
  CHECK_REFUSED(Misfit({}, same), "something must be wanted, with a positive weight; got 0 numbers");
  CHECK_REFUSED(Misfit({{"a", 1.0, 0.0}, {"b", 1.0, 0.0}}, same), "got 2 numbers, whose weights add up to 0");
  CHECK_REFUSED(Misfit({{"a", not_a_number}}, same), "wanted \"a\": its value must be finite, got nan");
  CHECK_REFUSED(Misfit({{"a", 1.0, -1.0}}, same), "wanted \"a\": its weight must be finite and not negative, got -1");
  CHECK_REFUSED(Misfit({{"a", 1.0, infinity}}, same), "its weight must be finite and not negative, got inf");
  CHECK_REFUSED(Misfit({{"a", 1.0, 1.0, -2.0}}, same), "its scale must be finite and not negative, got -2");
  CHECK_REFUSED(Misfit({{"a", 1.0, 1.0, not_a_number}}, same), "its scale must be finite and not negative, got nan");
  CHECK_REFUSED(Misfit({{"a", 0.0}}, same), "which must not be zero: give a scale, got 0");
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(unreached_)

BOOST_AUTO_TEST_CASE(names_what_was_wanted_and_what_came_nearest) {
  const std::vector<Reached> reached = Misfit(wanted, same).reached(Vector2d(-0.13, 500.0));
  BOOST_TEST(unreached(reached, 0.31).empty());
  BOOST_TEST(unreached(reached, 0.27) == "\"light [-]\": -0.1 is wanted, -0.13 came nearest");
  BOOST_TEST(unreached(reached, 0.01) ==
             "\"light [-]\": -0.1 is wanted, -0.13 came nearest; "
             "\"warmth [K]\": 400 is wanted, 500 came nearest");
  BOOST_TEST(unreached({}, 0.01).empty());
}

BOOST_AUTO_TEST_CASE(does_not_take_nan_for_reached) {
  const std::vector<Reached> reached{{.name = "a", .wanted = 1.0, .found = not_a_number, .misfit = not_a_number}};
  BOOST_TEST(contains(unreached(reached, 1.0), "\"a\": 1 is wanted, nan came nearest"));
}

BOOST_AUTO_TEST_CASE(refuses_a_tolerance_that_is_none) {
  CHECK_REFUSED(unreached({}, 0.0), "a tolerance must be positive, got 0");
  CHECK_REFUSED(unreached({}, not_a_number), "a tolerance must be positive, got nan");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::misfit_test
