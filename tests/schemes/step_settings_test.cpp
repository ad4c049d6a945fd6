#include <particulate/schemes/step_settings.hpp>

#include <initializer_list>

#include "numbers.hpp"
#include "says.hpp"

namespace tests::step_settings_test {

using namespace particulate::schemes;
using particulate::schemes::detail::retried;
using particulate::schemes::detail::StepSettings;
using particulate::schemes::detail::validate;
using particulate::schemes::detail::validate_step;

constexpr StepSettings good{.step = 0.5, .limit = 1.0, .smallest = 0.0, .growth = 2.0, .retry = 0.9, .shrink = 0.1};

void refuses(double StepSettings::*setting, std::initializer_list<double> bad, const char* words) {
  for (const double value : bad) {
    StepSettings settings = good;
    settings.*setting = value;
    CHECK_REFUSED(validate("a control", settings), words);
  }
}

BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(refuses_each_setting_that_cannot_be_meant) {
  BOOST_CHECK_NO_THROW(validate("a control", good));
  refuses(&StepSettings::step, {-1.0, 1.5, not_a_number},
          "a control: step must be positive and at most limit, or left out, in s, got ");
  refuses(&StepSettings::limit, {0.0, -1.0, not_a_number}, "a control: limit must be positive, in s, got ");
  refuses(&StepSettings::smallest, {-1.0, 0.6, not_a_number}, "a control: smallest must be in [0, step], in s, got ");
  refuses(&StepSettings::growth, {1.0, infinity, not_a_number}, "a control: growth must be finite and above 1, got ");
  refuses(&StepSettings::retry, {0.0, 1.0, not_a_number}, "a control: retry must be in (0, 1), got ");
  refuses(&StepSettings::shrink, {0.0, 0.9, not_a_number}, "a control: shrink must be in (0, retry), got ");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(validate_step_)

BOOST_AUTO_TEST_CASE(refuses_what_is_no_step) {
  BOOST_CHECK_NO_THROW(validate_step("a control", 1e-300));
  for (const double bad : {0.0, -1.0, infinity, not_a_number}) {
    CHECK_REFUSED(validate_step("a control", bad), "a control: step must be positive and finite, got ");
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(retried_)

BOOST_AUTO_TEST_CASE(makes_a_refusal_of_what_was_unmet) {
  const Decision decision = retried({.impossible = "so it is", .failure = Failure::slow}, 0.1, 0.1);
  BOOST_TEST(!decision.accepted);
  BOOST_TEST(decision.impossible.empty());
  BOOST_TEST(decision.refusal == "so it is");
}

BOOST_AUTO_TEST_CASE(gives_up_below_the_smallest_step_and_where_rounding_rules) {
  const Decision small = retried({.impossible = "so it is", .failure = Failure::slow}, 0.1, 0.2);
  BOOST_TEST(small.impossible == "so it is; the next to try is 0.1 s, below the smallest allowed 0.2 s");
  BOOST_TEST(small.refusal.empty());
  BOOST_TEST(retried({.impossible = "below it", .failure = Failure::rounding}, 0.1, 0.0).impossible == "below it");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::step_settings_test
