#include <particulate/contact/impulse_windows.hpp>

#include <limits>

#include "says.hpp"

namespace tests::impulse_windows_test {

using boost::test_tools::tolerance;
using namespace particulate::contact;

BOOST_AUTO_TEST_SUITE(ImpulseWindows_)

// Windows of 0.5 s; a step that ends at 0.5 s belongs to the first, one after it to the second; the fourth is empty.
BOOST_AUTO_TEST_CASE(gathers_the_impulses_on_one_body) {
  ImpulseWindows on(3, 0.5);
  on.until(0.1);
  on({.i = 3, .j = 1, .push = 2.0, .tangential = {0.0, 0.3, 0.4}});
  on({.i = 2, .j = 1, .push = 100.0});
  on.until(0.1 + 0.2 + 0.2);
  on({.i = 0, .j = 3, .push = 1.0});
  on.until(0.6);
  on({.i = 3, .push = 4.0});
  on.until(1.7);
  BOOST_TEST_REQUIRE(on.windows().size() == 4U);
  BOOST_TEST(on.windows()[0].normal == 3.0);
  BOOST_TEST(on.windows()[0].tangential == 0.5, tolerance(1e-15));
  BOOST_TEST(on.windows()[0].largest == 2.0);
  BOOST_TEST(on.windows()[1].normal == 4.0);
  BOOST_TEST(on.windows()[3].normal == 0.0);
  BOOST_TEST(on.whole().normal == 7.0);
  BOOST_TEST(on.whole().largest == 4.0);
  BOOST_TEST(on.largest_force() == 8.0);
}

BOOST_AUTO_TEST_CASE(refuses_lengths_and_times_that_cannot_be_meant) {
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    CHECK_REFUSED(ImpulseWindows(0, bad), "length must be positive and finite");
  }
  ImpulseWindows on(0, 1.0);
  on.until(2.0);
  CHECK_REFUSED(on.until(1.5), "must follow one another from 0 on, up to 10000000 windows of 1 s, got 1.5 s after 2 s");
  CHECK_REFUSED(on.until(1e8), "got 100000000 s after 2 s");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::impulse_windows_test
