#include <particulate/contact/restitution.hpp>

#include "numbers.hpp"
#include "says.hpp"

namespace tests::restitution_test {

using boost::test_tools::tolerance;
using namespace particulate::contact;

const Restitution falling{.e_o = 0.5, .v_star = 10.0, .e_minus = 0.125};

BOOST_AUTO_TEST_SUITE(restitution_at_)

BOOST_AUTO_TEST_CASE(of_a_gentle_impact_is_e_o) { BOOST_TEST(restitution_at(falling, 0.0) == 0.5); }

// 0.5 (1 - 4/10) = 0.3, and 0.5 (1 - 2.5/10) = 0.375.
BOOST_AUTO_TEST_CASE(falls_linearly_with_the_approach_speed) {
  BOOST_TEST(restitution_at(falling, 4.0) == 0.3, tolerance(1e-15));
  BOOST_TEST(restitution_at(falling, 2.5) == 0.375);
}

// The floor 0.125 = 0.5 (1 - 7.5/10) is met at 7.5 m/s.
BOOST_AUTO_TEST_CASE(stays_on_its_floor) {
  BOOST_TEST(restitution_at(falling, 7.4) == 0.13, tolerance(1e-14));
  BOOST_TEST(restitution_at(falling, 7.6) == 0.125);
  BOOST_TEST(restitution_at(falling, 1e300) == 0.125);
  BOOST_TEST(restitution_at(Restitution{.e_o = 0.5, .v_star = 10.0}, 10.0) == 0.0);
}

BOOST_AUTO_TEST_CASE(does_not_fall_without_a_critical_speed) {
  BOOST_TEST(restitution_at(Restitution{.e_o = 0.75}, 1e300) == 0.75);
  BOOST_TEST(restitution_at(ConstantRestitution{0.75}, 0.0) == 0.75);
  BOOST_TEST(restitution_at(ConstantRestitution{0.75}, 1e300) == 0.75);
}

BOOST_AUTO_TEST_CASE(keeps_everything_by_default) {
  BOOST_TEST(restitution_at(Restitution{}, 3.0) == 1.0);
  BOOST_TEST(restitution_at(ConstantRestitution{}, 3.0) == 1.0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(accepts_every_share_of_the_approach_speed) {
  BOOST_CHECK_NO_THROW(validate(Restitution{}));
  BOOST_CHECK_NO_THROW(validate(Restitution{.e_o = 0.0, .v_star = 1e-300}));
  BOOST_CHECK_NO_THROW(validate(Restitution{.e_o = 0.5, .e_minus = 0.5}));
  for (const double e : {0.0, 0.5, 1.0}) BOOST_CHECK_NO_THROW(validate(ConstantRestitution{e}));
}

BOOST_AUTO_TEST_CASE(names_the_share_that_is_none) {
  const auto refuses = [](const auto& law, const char* words) { CHECK_REFUSED(validate(law), words); };
  refuses(Restitution{.e_o = 1.1}, "restitution: e_o must lie in [0, 1], got 1.1");
  refuses(Restitution{.e_o = -0.1}, "e_o must lie in [0, 1], got -0.1");
  refuses(Restitution{.e_o = not_a_number}, "e_o must lie in [0, 1], got nan");
  refuses(Restitution{.e_o = 0.5, .e_minus = 0.6}, "restitution: e_minus must lie in [0, e_o = 0.5], got 0.6");
  refuses(Restitution{.e_minus = -1e-300}, "e_minus must lie in [0, e_o = 1], got -1e-300");
  refuses(Restitution{.e_minus = not_a_number}, "e_minus must lie in [0, e_o = 1], got nan");
  refuses(Restitution{.v_star = 0.0}, "restitution: v_star must be positive, infinite for a restitution that does not");
  refuses(Restitution{.v_star = not_a_number}, "got nan m/s");
  for (const double e : {-1e-300, 1.0000001, infinity, not_a_number}) {
    refuses(ConstantRestitution{e}, "restitution: e must lie in [0, 1], got ");
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(speeds_to_come_)

// 2 (1 + 1/2 + 1/4 + ...) = 4. With e = 0.5 (1 - w/8) from 2 m/s: 2, 0.75, 0.33984375, ... summed in a loop of its own.
BOOST_AUTO_TEST_CASE(are_summed_over_all_impacts) {
  BOOST_TEST(speeds_to_come(ConstantRestitution{0.5}, 2.0) == 4.0);
  BOOST_TEST(speeds_to_come(ConstantRestitution{0.0}, 2.0) == 2.0);
  BOOST_TEST(speeds_to_come(ConstantRestitution{1.0}, 0.0) == 0.0);
  BOOST_TEST(std::isinf(speeds_to_come(ConstantRestitution{1.0}, 2.0)));
  long double w = 2.0L, sum = 0.0L;
  for (int k = 0; k < 200; ++k) sum += w, w *= 0.5L * (1.0L - w / 8.0L);
  BOOST_TEST(speeds_to_come(Restitution{.e_o = 0.5, .v_star = 8.0}, 2.0) == static_cast<double>(sum), tolerance(1e-15));
  BOOST_TEST(speeds_to_come(Restitution{.e_o = 0.5}, 2.0) == 4.0, tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(have_no_end_where_gentle_impacts_keep_everything) {
  BOOST_TEST(std::isinf(speeds_to_come(Restitution{.v_star = 8.0}, 2.0)));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::restitution_test
