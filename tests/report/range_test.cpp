#include <particulate/report/range.hpp>

#include <limits>

#include "says.hpp"

namespace tests::range_test {

using namespace particulate::report;

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan_ = std::numeric_limits<double>::quiet_NaN();

BOOST_AUTO_TEST_SUITE(range_holds)

BOOST_AUTO_TEST_CASE(nan_lies_in_no_range) {
  for (const Range& range : {any(), at_least(0), more_than(0), at_most(0), between(0, 1), at_least(0).or_infinite()}) {
    BOOST_TEST(!range.holds(nan_));
  }
}

BOOST_AUTO_TEST_CASE(infinity_lies_only_in_a_range_that_says_so) {
  BOOST_TEST(!any().holds(inf));
  BOOST_TEST(!at_least(0).holds(inf));
  BOOST_TEST(more_than(0).or_infinite().holds(inf));
  BOOST_TEST(!any().or_infinite().holds(-inf));
}

BOOST_AUTO_TEST_CASE(closed_ends_belong_to_the_range_and_open_ones_do_not) {
  BOOST_TEST(at_least(0).holds(0.0));
  BOOST_TEST(at_least(0).holds(-0.0));
  BOOST_TEST(!at_least(0).holds(-5e-324));
  BOOST_TEST(!more_than(0).holds(0.0));
  BOOST_TEST(more_than(0).holds(5e-324));
  BOOST_TEST(at_most(2).holds(2.0));
  BOOST_TEST(between(0, 1).holds(0.0));
  BOOST_TEST(between(0, 1).holds(1.0));
  BOOST_TEST(!between(0, 1).holds(1.0000000000000002));
}

BOOST_AUTO_TEST_CASE(a_text_must_be_one_of_the_choices) {
  BOOST_TEST(one_of({"a", "b"}).holds(std::string("b")));
  BOOST_TEST(!one_of({"a", "b"}).holds(std::string("c")));
  BOOST_TEST(any().holds(std::string("anything")));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(range_text)

BOOST_AUTO_TEST_CASE(says_what_must_hold) {
  BOOST_TEST(any().text() == "be a finite number");
  BOOST_TEST(at_least(0).text() == "be at least 0");
  BOOST_TEST(more_than(0).or_infinite().text() == "be greater than 0 or inf");
  BOOST_TEST(at_most(0.5).text() == "be at most 0.5");
  BOOST_TEST(between(0, 1).text() == "lie in [0, 1]");
  BOOST_TEST(one_of({"a", "b"}).text() == "be one of a, b");
}

BOOST_AUTO_TEST_CASE(an_empty_range_cannot_be_made) {
  CHECK_REFUSED(between(1, 0), "must not be above the upper one, got 1 and 0");
  CHECK_REFUSED(between(nan_, 0), "got nan and 0");
  CHECK_REFUSED(one_of({}), "at least one choice");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::range_test
