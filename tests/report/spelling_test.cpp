#include <particulate/report/spelling.hpp>

#include <boost/test/unit_test.hpp>

namespace tests::spelling_test {

using namespace particulate::report;

const std::vector<std::string> known{"breathing_pair", "small_oscillation", "similarity", "curl"};

BOOST_AUTO_TEST_SUITE(near_matches_)

BOOST_AUTO_TEST_CASE(finds_what_was_misspelt) {
  BOOST_TEST(either(near_matches("breathing_pear", known)) == "breathing_pair");
  BOOST_TEST(either(near_matches("simliarity", known)) == "similarity");
  // One edit is all that a short word allows: exchanging a letter is one, not two.
  BOOST_TEST(either(near_matches("cirl", known)) == "curl");
}

BOOST_AUTO_TEST_CASE(finds_what_was_shortened) {
  BOOST_TEST(either(near_matches("oscill", known)) == "small_oscillation");
}

BOOST_AUTO_TEST_CASE(finds_nothing_for_another_word) {
  BOOST_TEST(near_matches("viscosity", known).empty());
  BOOST_TEST(near_matches("", known).empty());
}

BOOST_AUTO_TEST_CASE(gives_the_nearest_first_and_at_most_three) {
  const std::vector<std::string> found = near_matches("alpha1", {"alpha4", "alpha1b", "alpha2", "alpha1", "alpha3"});
  BOOST_TEST(found.size() == 3U);
  BOOST_TEST(found.front() == "alpha1");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(either_)

BOOST_AUTO_TEST_CASE(joins_words_as_one_would_say_them) {
  BOOST_TEST(either({}) == "");
  BOOST_TEST(either({"a"}) == "a");
  BOOST_TEST(either({"a", "b", "c"}) == "a, b or c");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::spelling_test
