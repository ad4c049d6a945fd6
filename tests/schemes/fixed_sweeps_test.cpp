#include <particulate/schemes/fixed_sweeps.hpp>

#include "close.hpp"

namespace tests::fixed_sweeps_test {

using namespace particulate::schemes;

static_assert(Controller<FixedSweeps>);

BOOST_AUTO_TEST_SUITE(FixedSweeps_)

BOOST_AUTO_TEST_CASE(sweeps_as_often_as_told) {
  const FixedSweeps control{.step = 0.5, .sweeps = 3};
  BOOST_TEST(control.dt() == 0.5);
  BOOST_TEST(control.goes_on({.w_K = 0.1, .K = 0}));
  BOOST_TEST(control.goes_on({.w_K = 0.1, .K = 1}));
  BOOST_TEST(!control.goes_on({.w_K = 0.1, .K = 2}));
}

BOOST_AUTO_TEST_CASE(stops_where_nothing_changes_any_more) {
  BOOST_TEST(!FixedSweeps({.step = 0.5, .sweeps = 3}).goes_on({.w_K = 0.0, .K = 0}));
}

BOOST_AUTO_TEST_CASE(accepts_whatever_does_not_diverge) {
  const FixedSweeps control{.step = 0.5};
  BOOST_TEST(control.judge({.dt = 0.5, .iteration = {.w_0 = 1.0, .w_K = 0.9, .rate = 0.9, .K = 1}}).accepted);
  BOOST_TEST(control.judge({.dt = 0.5, .iteration = {.w_0 = 1.0, .w_K = 1.0, .K = 0}}).accepted);
  BOOST_TEST(control.judge({.dt = 0.5, .iteration = {}}).accepted);
}

// Of fields that drive each other the first sweep may move little and the second much.
BOOST_AUTO_TEST_CASE(does_not_take_two_sweeps_for_divergence_where_time_scales_bound_the_step) {
  const FixedSweeps control{.step = 0.5};
  Attempt made{.dt = 0.5, .iteration = {.w_0 = 1.0, .w_K = 1.5, .rate = 1.5, .K = 1}, .within_limits = true};
  BOOST_TEST(control.judge(made).accepted);
  made.iteration.K = 2;
  BOOST_TEST((control.judge(made).failure == Failure::diverging));
  made.iteration.rounding = 0.01;
  BOOST_TEST(control.judge(made).accepted);
}

BOOST_AUTO_TEST_CASE(fails_where_sweeps_diverge_or_there_is_no_value) {
  const FixedSweeps control{.step = 0.5};
  const Decision diverging =
      control.judge({.dt = 0.5, .iteration = {.w_0 = 1.0, .w_K = 1.5, .change = 1.0, .rate = 1.5, .K = 1}});
  BOOST_TEST(!diverging.accepted);
  BOOST_TEST((diverging.failure == Failure::diverging));
  BOOST_TEST(contains(diverging.impossible, "diverge by a factor of 1.5"));
  BOOST_TEST(contains(diverging.impossible, "a fixed step cannot shrink"));
  const Decision none = control.judge({.dt = 0.5, .iteration = {.evaluated = false}});
  BOOST_TEST((none.failure == Failure::no_value));
  BOOST_TEST(contains(none.impossible, "no finite value"));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(names_step_or_sweeps_and_what_was_given) {
  BOOST_CHECK_NO_THROW(validate(FixedSweeps{.step = 0.5, .sweeps = 1}));
  const auto refuses = [](const FixedSweeps& bad, const char* words) { CHECK_REFUSED(validate(bad), words); };
  refuses({.step = 0.0}, "fixed sweeps: step must be positive and finite, got 0 s");
  refuses({.step = not_a_number}, "got nan");
  refuses({.step = 0.5, .sweeps = 0}, "fixed sweeps: sweeps must be at least 1, got 0");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::fixed_sweeps_test
