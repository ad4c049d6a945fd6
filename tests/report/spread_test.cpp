#include <particulate/report/spread.hpp>

#include <cmath>

#include "says.hpp"

namespace tests::spread_test {

using namespace particulate::report;

BOOST_AUTO_TEST_SUITE(spread_of_)

BOOST_AUTO_TEST_CASE(is_the_middle_and_the_ends) {
  const Spread odd = spread_of({3.0, 1.0, 2.0}), even = spread_of({4.0, 1.0, 3.0, 2.0});
  BOOST_TEST((odd.least == 1.0 && odd.median == 2.0 && odd.largest == 3.0));
  BOOST_TEST((even.least == 1.0 && even.median == 3.0 && even.largest == 4.0));
}

BOOST_AUTO_TEST_CASE(has_what_is_no_number_at_the_end) {
  const Spread some = spread_of({NAN, 2.0, NAN, 1.0, 3.0});
  BOOST_TEST((some.least == 1.0 && some.median == 3.0 && std::isnan(some.largest)));
}

BOOST_AUTO_TEST_CASE(refuses_nothing) { CHECK_REFUSED(spread_of({}), "needs one number at least, got none"); }

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(spread_over_)

BOOST_AUTO_TEST_CASE(takes_a_member_or_a_function) {
  struct Run {
    double cost;
  };
  const std::vector<Run> runs{{2.0}, {5.0}, {3.0}};
  BOOST_TEST(spread_over(runs, &Run::cost).median == 3.0);
  BOOST_TEST(spread_over(runs, [](const Run& run) { return -run.cost; }).largest == -2.0);
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(worse_of_)

BOOST_AUTO_TEST_CASE(is_the_larger_one_and_keeps_what_is_no_number) {
  BOOST_TEST((worse_of(1.0, 2.0) == 2.0 && worse_of(2.0, 1.0) == 2.0 && worse_of(1.0, 1.0) == 1.0));
  BOOST_TEST((std::isnan(worse_of(1.0, NAN)) && std::isnan(worse_of(NAN, 1.0)) && std::isnan(worse_of(NAN, NAN))));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(mean_of_)

// Deviations -3, -1, 1, 3: their squares add up to 20, and 20/(4 * 3) = 5/3.
BOOST_AUTO_TEST_CASE(has_the_standard_error_of_the_mean) {
  const Mean mean = mean_of({1.0, 3.0, 5.0, 7.0});
  BOOST_TEST(mean.value == 4.0);
  BOOST_TEST(mean.standard_error == std::sqrt(5.0 / 3.0), boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(does_not_know_the_error_of_a_single_number) {
  BOOST_TEST(mean_of({2.0}).value == 2.0);
  BOOST_TEST(std::isnan(mean_of({2.0}).standard_error));
}

BOOST_AUTO_TEST_CASE(refuses_nothing) { CHECK_REFUSED(mean_of({}), "needs one number at least, got none"); }

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::spread_test
