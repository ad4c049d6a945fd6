#include <particulate/report/guarded.hpp>

#include <stdexcept>

#include <boost/test/unit_test.hpp>

namespace tests::guarded_test {

using particulate::report::guarded;

BOOST_AUTO_TEST_SUITE(guarded_)

BOOST_AUTO_TEST_CASE(turns_an_exception_into_status_2_and_passes_a_status_on) {
  BOOST_TEST(guarded("p", [] { return 1; }) == 1);
  BOOST_TEST(guarded("p", []() -> int { throw std::invalid_argument("wrong"); }) == 2);
}

// What it does with a full disk, a closed stream, a reader that has gone, is tried on every program: tests/programs.sh.

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::guarded_test
