#include <particulate/report/wrapped.hpp>

#include <string>

#include <boost/test/unit_test.hpp>

namespace tests::wrapped_test {

using particulate::report::screen_width;
using particulate::report::wrapped;

BOOST_AUTO_TEST_SUITE(wrapped_text)

BOOST_AUTO_TEST_CASE(stays_as_it_is_where_it_fits) {
  BOOST_TEST(wrapped("").empty());
  BOOST_TEST(wrapped("  two words", 4) == "  two words");
  const std::string full(screen_width, 'x');
  BOOST_TEST(wrapped(full) == full);
}

BOOST_AUTO_TEST_CASE(breaks_at_the_last_blank_that_fits_and_indents_what_follows) {
  const std::string first(60, 'a'), second(39, 'b'), third(95, 'c');
  BOOST_TEST(wrapped(first + ' ' + second + "  " + third + " d", 4) ==
             first + ' ' + second + "\n    " + third + "\n    d");
  BOOST_TEST(wrapped(first + ' ' + second + "b c", 2) == first + "\n  " + second + "b c");
}

BOOST_AUTO_TEST_CASE(leaves_a_long_word_whole) {
  const std::string path(screen_width + 1, '/');
  BOOST_TEST(wrapped("in " + path + " too") == "in\n" + path + "\ntoo");
  BOOST_TEST(wrapped(path + "  ") == path);
  BOOST_TEST(wrapped("  " + path, 2) == "  " + path);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::wrapped_test
