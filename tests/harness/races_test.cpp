#include <harness/races.hpp>

#include <boost/test/unit_test.hpp>

namespace tests::races_test {

using namespace verification;

BOOST_AUTO_TEST_SUITE(race_settings)

BOOST_AUTO_TEST_CASE(steps_divide_a_leg_evenly_and_fall) {
  // 4, 6 and 9 steps in a leg of 36 s; twice as many for a multiple of 2.
  const std::vector<double> sizes = step_sizes(36.0, {4, 1.5, 2}), halves = step_sizes(36.0, {4, 1.5, 2}, 2);
  BOOST_TEST(sizes == (std::vector<double>{9.0, 6.0, 4.0}), boost::test_tools::per_element());
  BOOST_TEST(halves == (std::vector<double>{4.5, 3.0, 2.0}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(tolerances_come_two_a_decade_down_to_the_tightest) {
  const std::vector<double> all = tolerances(1e-6);
  BOOST_TEST_REQUIRE(all.size() == 5u);
  BOOST_TEST(all.front() == 1e-4, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(all[1] / all[2] == std::sqrt(10.0), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(all.back() == 1e-6, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(sweeps_end_at_a_share_of_the_steps_own_error) {
  // share (Dt/T)^(p - 1): a tenth at order 1; a tenth of a quarter at order 2.
  BOOST_TEST((SweepTolerance{.order = 1, .share = 0.1, .T = 2.0}(0.5) == 0.1));
  const double TOL = SweepTolerance{.order = 2, .share = 0.1, .T = 2.0}(0.5);
  BOOST_TEST(TOL == 0.025, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(a_competitor_keeps_its_slope_and_its_mark) {
  const Competitor who = tuned(with_slope(4.0, {.name = "RK4", .settings = {0.1}, .prepare = {}}, "of a symmetry"));
  BOOST_TEST(who.tuned);
  BOOST_TEST(who.slope.value() == 4.0);
  BOOST_TEST(who.steeper == "of a symmetry");
  BOOST_TEST(who.name == "RK4");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::races_test
