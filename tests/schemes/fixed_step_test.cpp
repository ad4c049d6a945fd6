#include <particulate/schemes/fixed_step.hpp>

#include <limits>
#include <stdexcept>

#include "close.hpp"

using particulate::schemes::Attempt;
using particulate::schemes::Controller;
using particulate::schemes::Decision;
using particulate::schemes::FixedStep;
using particulate::schemes::Iteration;
using particulate::schemes::validate;
using tests::says;

static_assert(Controller<FixedStep>);

BOOST_AUTO_TEST_SUITE(FixedStep_)

BOOST_AUTO_TEST_CASE(always_wishes_its_own_step_and_no_sweep) {
  const FixedStep control{.step = 0.125};
  BOOST_TEST(control.dt() == 0.125);
  BOOST_TEST(!control.goes_on(Iteration{}));
}

BOOST_AUTO_TEST_CASE(accepts_what_has_a_value_whatever_its_size) {
  const Decision decision = FixedStep{.step = 0.125}.judge({.dt = 0.01, .iteration = {.w_K = 1e9, .rate = 2.0}});
  BOOST_TEST(decision.accepted);
  BOOST_TEST(decision.impossible.empty());
}

BOOST_AUTO_TEST_CASE(says_why_it_cannot_go_on_without_a_value) {
  const Decision decision = FixedStep{.step = 0.125}.judge({.dt = 0.0625, .iteration = {.evaluated = false}});
  BOOST_TEST(!decision.accepted);
  BOOST_TEST(decision.impossible.find("no finite value within this step of 0.0625 s") != std::string::npos);
  BOOST_TEST(decision.impossible.find("choose a smaller step") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(names_the_step_and_what_was_given) {
  BOOST_CHECK_NO_THROW(validate(FixedStep{.step = 1e-300}));
  BOOST_CHECK_EXCEPTION(validate(FixedStep{}), std::invalid_argument,
                        says("step must be positive and finite, got 0 s"));
  BOOST_CHECK_EXCEPTION(validate(FixedStep{.step = -1.0}), std::invalid_argument, says("got -1 s"));
  BOOST_CHECK_EXCEPTION(validate(FixedStep{.step = std::numeric_limits<double>::infinity()}), std::invalid_argument,
                        says("got inf s"));
  BOOST_CHECK_EXCEPTION(validate(FixedStep{.step = std::numeric_limits<double>::quiet_NaN()}), std::invalid_argument,
                        says("got nan s"));
}

BOOST_AUTO_TEST_SUITE_END()
