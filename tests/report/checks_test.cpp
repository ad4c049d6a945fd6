#include <particulate/report/checks.hpp>

#include <limits>
#include <string>

#include <boost/test/unit_test.hpp>

namespace tests::checks_test {

using particulate::report::Checks;

BOOST_AUTO_TEST_SUITE(checks_)

BOOST_AUTO_TEST_CASE(hold_up_to_what_is_allowed_whatever_the_sign) {
  Checks checks;
  checks.add("exact", 0.0, 0.0);
  checks.add("low", -0.5, 0.5);
  BOOST_TEST(checks.all_hold());
  BOOST_TEST(checks.table().csv() == "claim,error,allowed,verdict\nexact,0,0,holds\nlow,0.5,0.5,holds\n");
}

BOOST_AUTO_TEST_CASE(one_that_fails_is_not_forgotten) {
  Checks checks;
  checks.add("high", 0.75, 0.5);
  checks.add("exact", 0.0, 0.0);
  BOOST_TEST(!checks.all_hold());
  BOOST_TEST(checks.table().csv() == "claim,error,allowed,verdict\nhigh,0.75,0.5,FAILS\nexact,0,0,holds\n");
}

BOOST_AUTO_TEST_CASE(a_nan_fails) {
  Checks checks;
  checks.add("nothing", std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity());
  BOOST_TEST(!checks.all_hold());
}

BOOST_AUTO_TEST_CASE(fit_a_terminal) {
  Checks checks;
  checks.add("short [m]", 1.23456e-7, 0.5);
  checks.add(std::string(70, 'a') + " long", 2.0, 1e-13);
  BOOST_TEST(checks.text() ==
             "verdict     error   allowed  claim\n"
             "holds    1.23e-07       0.5  short [m]\n"
             "FAILS           2     1e-13  " +
                 std::string(70, 'a') + "\n" + std::string(29, ' ') + "long\n");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::checks_test
