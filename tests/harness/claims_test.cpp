#include <harness/claims.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <harness/case.hpp>
#include <harness/results.hpp>
#include <harness/rows.hpp>

#include "says.hpp"

namespace tests::claims_test {

using namespace verification;

constexpr double nan_ = std::numeric_limits<double>::quiet_NaN();

BOOST_AUTO_TEST_SUITE(mixed_error_)

// |1.5 - 1| / 1, |4 - 5| / 5, and |0.1 - 0| / 0.5 below the scale.
BOOST_AUTO_TEST_CASE(is_the_largest_of_the_components_relative_to_each_or_to_the_scale) {
  BOOST_TEST(mixed_error(std::array{1.5, 4.0}, std::array{1.0, 5.0}, 0.5) == 0.5);
  BOOST_TEST(mixed_error(std::array{1.0, 4.0}, std::array{1.0, 5.0}, 0.5) == 0.2);
  BOOST_TEST(mixed_error(std::array{0.1}, std::array{0.0}, 0.5) == 0.2);
}

BOOST_AUTO_TEST_CASE(is_nan_as_soon_as_one_component_is) {
  BOOST_TEST(std::isnan(mixed_error(std::array{nan_, 2.0}, std::array{1.0, 1.0}, 1.0)));
  BOOST_TEST(std::isnan(mixed_error(std::array{9.0, nan_}, std::array{1.0, 1.0}, 1.0)));
}

BOOST_AUTO_TEST_CASE(refuses_what_cannot_be_compared) {
  CHECK_REFUSED(mixed_error(std::array{1.0}, std::array{1.0, 2.0}, 1.0), "got 1, 2 and 1");
  BOOST_CHECK_THROW(mixed_error({}, {}, 1.0), std::invalid_argument);
  BOOST_CHECK_THROW(mixed_error(std::array{1.0}, std::array{1.0}, 0.0), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(fitted_order_)

BOOST_AUTO_TEST_CASE(is_exact_for_a_power) {
  BOOST_TEST(fitted_order(std::array{0.5, 0.25, 0.125}, std::array{0.125, 0.015625, 0.001953125}) == 3.0);
}

// log2 of the errors is 0, -2, -2 over log2 of the steps 0, -1, -2: slope 1 by least squares.
BOOST_AUTO_TEST_CASE(is_the_least_squares_slope) {
  BOOST_TEST(fitted_order(std::array{1.0, 0.5, 0.25}, std::array{1.0, 0.25, 0.25}) == 1.0);
}

BOOST_AUTO_TEST_CASE(refuses_numbers_without_a_logarithm) {
  BOOST_CHECK_THROW(fitted_order(std::array{1.0, 0.5}, std::array{1.0, 0.0}), std::invalid_argument);
  BOOST_CHECK_THROW(fitted_order(std::array{1.0, 0.5}, std::array{1.0, nan_}), std::invalid_argument);
  BOOST_CHECK_THROW(fitted_order(std::array{1.0}, std::array{1.0}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(leave_out)

BOOST_AUTO_TEST_CASE(shows_the_numbers_and_judges_nothing) {
  const Case slower({.name = "slower", .claim = "twice as fast", .equation = "R 1.1"}, [](Rows& rows) {
    rows.leave_out("ratio [-]", {.limit = 2.0, .computed = 1.0, .because = "another version"});
    rows.none("failures", 0, "counted by hand");
  });
  const CaseResult result = prove(slower, {});
  BOOST_TEST(result.failed() == 0u);
  const Row& row = result.rows.front();
  BOOST_TEST(row.metric == "left out");
  BOOST_TEST((row.expected.exact() == "2" && row.computed.exact() == "1" && row.because == "another version"));
}

BOOST_AUTO_TEST_CASE(is_no_proof) {
  const Case nothing({.name = "nothing", .claim = "twice as fast", .equation = "R 1.1"}, [](Rows& rows) {
    rows.leave_out("ratio [-]", {.limit = 2.0, .computed = 1.0, .because = "another version"});
  });
  const CaseResult result = prove(nothing, {});
  BOOST_TEST(result.failed() == 1u);
  BOOST_TEST(contains(result.rows.back().failure, "compared nothing"));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(case_seed)

BOOST_AUTO_TEST_CASE(belongs_to_the_case_and_the_run_s_seed) {
  const Rows first("gas", {.seed = 1}), again("gas", {.seed = 1});
  BOOST_TEST(first.case_seed() == again.case_seed());
  BOOST_TEST(first.case_seed() != Rows("gas", {.seed = 2}).case_seed());
  BOOST_TEST(first.case_seed() != Rows("cloud", {.seed = 1}).case_seed());
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::claims_test
