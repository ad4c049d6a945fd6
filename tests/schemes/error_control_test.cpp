#include <particulate/schemes/error_control.hpp>

#include <cmath>

#include "close.hpp"

namespace tests::error_control_test {

using namespace particulate::schemes;

static_assert(Controller<ErrorControl>);

ErrorControl control() {
  return {.TOL = 1e-6, .sweep_TOL = 1e-4, .K_d = 2, .step = 0.5, .limit = 2.0, .smallest = 1e-3};
}

// Two contractions by `factor`, from w_0 = 1e-2.
Iteration contracting(double factor) {
  return {.w_0 = 1e-2, .w_K = 1e-2 * factor * factor, .rate = factor, .K = 2, .p = 2};
}

// Sweeps that found their fixed point at once, so that the estimate alone decides.
const Iteration solved{.w_0 = 1e-2, .w_K = 0.0, .K = 2};

BOOST_AUTO_TEST_SUITE(ErrorControl_)

BOOST_AUTO_TEST_CASE(sweeps_until_the_tolerance_is_met_or_too_often_or_in_vain) {
  BOOST_TEST(control().goes_on({.w_0 = 1.0, .w_K = 0.5, .rate = 0.5, .K = 1}));
  BOOST_TEST(!control().goes_on({.w_0 = 1.0, .w_K = 0.0, .K = 1}));
  BOOST_TEST(!control().goes_on({.w_0 = 1.0, .w_K = 0.5, .rate = 0.5, .K = 8}));
  BOOST_TEST(!control().goes_on({.w_0 = 1.0, .w_K = 2.0, .rate = 1.5, .K = 2}));
  BOOST_TEST(control().goes_on({.w_0 = 1.0, .w_K = 2.0, .rate = 1.5, .K = 1}));
}

// 0.9 (1e-6/6.4e-8)^(1/3) = 0.9 * 2.5 = 2.25 for an estimate of order 2.
BOOST_AUTO_TEST_CASE(grows_by_the_root_of_what_the_estimate_leaves) {
  ErrorControl now = control();
  BOOST_TEST(now.judge({.dt = 0.5, .iteration = solved, .truncation = {.error = 6.4e-8, .order = 2}}).accepted);
  BOOST_TEST(now.dt() == 1.125, tolerance(1e-14));
}

// sqrt(0.1/0.08) as for the monograph's controller, while the estimate would allow 2.25.
BOOST_AUTO_TEST_CASE(grows_by_the_sweeps_where_they_ask_for_less) {
  ErrorControl now = control();
  BOOST_TEST(
      now.judge({.dt = 0.5, .iteration = contracting(0.08), .truncation = {.error = 6.4e-8, .order = 2}}).accepted);
  BOOST_TEST(now.dt() == std::max(1.0, std::sqrt(0.1 / 0.08)) * 0.5, tolerance(1e-14));
}

// The last step, twice as long, had an error 8 times smaller: times 1/2 (1/8)^(1/3) = 1/4 of 0.9 * 2.5 = 0.5625.
BOOST_AUTO_TEST_CASE(foresees_that_an_error_that_grew_goes_on_growing) {
  ErrorControl now = control();
  now.last_error = 0.8e-8;
  now.last_step = 1.0;
  BOOST_TEST(now.judge({.dt = 0.5, .iteration = solved, .truncation = {.error = 6.4e-8, .order = 2}}).accepted);
  BOOST_TEST(now.dt() == 0.5 * 0.5625, tolerance(1e-14));
  BOOST_TEST(now.last_error == 6.4e-8);
  BOOST_TEST(now.last_step == 0.5);
}

BOOST_AUTO_TEST_CASE(does_not_hope_that_an_error_that_fell_goes_on_falling) {
  ErrorControl now = control();
  now.last_error = 1e-6;
  now.last_step = 0.5;
  now.judge({.dt = 0.5, .iteration = solved, .truncation = {.error = 6.4e-8, .order = 2}});
  BOOST_TEST(now.dt() == 1.125, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(refuses_a_step_whose_error_is_too_large_and_says_so) {
  ErrorControl now = control();
  const Decision refused = now.judge({.dt = 0.5, .iteration = solved, .truncation = {.error = 2.7e-5, .order = 2}});
  BOOST_TEST(!refused.accepted);
  BOOST_TEST(refused.impossible.empty());
  BOOST_TEST((refused.failure == Failure::inaccurate));
  BOOST_TEST(contains(refused.refusal, "the step of 0.5 s leaves an error estimated at 2.7e-05, above TOL = 1e-06"));
  BOOST_TEST(now.dt() == 0.5 * 0.9 / 3.0, tolerance(1e-14));
}

// After a refusal the next step is no longer than the one that then succeeded; after that it may grow again.
BOOST_AUTO_TEST_CASE(does_not_grow_right_after_a_refusal) {
  ErrorControl now = control();
  const Truncation small{.error = 1e-12, .order = 2};
  now.judge({.dt = 0.5, .iteration = solved, .truncation = {.error = 2.7e-5, .order = 2}});
  const double retried = now.dt();
  BOOST_TEST(now.judge({.dt = retried, .iteration = solved, .truncation = small}).accepted);
  BOOST_TEST(now.dt() == retried);
  BOOST_TEST(now.judge({.dt = retried, .iteration = solved, .truncation = small}).accepted);
  BOOST_TEST(now.dt() == 3.0 * retried, tolerance(1e-14));
}

// 0.9 (1e-6/error)^(1/3) = 1.09 is not worth a change; 0.95 is a shrinking that is made.
BOOST_AUTO_TEST_CASE(leaves_a_step_alone_that_would_grow_by_little) {
  ErrorControl now = control();
  const auto judge = [&](double factor) {
    now.last_error = 0.0;
    return now.judge(
        {.dt = 0.5, .iteration = solved, .truncation = {.error = 1e-6 * std::pow(0.9 / factor, 3), .order = 2}});
  };
  BOOST_TEST(judge(1.09).accepted);
  BOOST_TEST(now.dt() == 0.5);
  BOOST_TEST(judge(0.95).accepted);
  BOOST_TEST(now.dt() == 0.475, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(keeps_within_the_limit_and_within_the_growth_bound) {
  ErrorControl now = control();
  now.judge({.dt = 0.5, .iteration = solved, .truncation = {.error = 0.0, .order = 2}});
  BOOST_TEST(now.dt() == 1.5);
  now.judge({.dt = 1.5, .iteration = solved, .truncation = {.error = 0.0, .order = 2}});
  BOOST_TEST(now.dt() == 2.0);
}

BOOST_AUTO_TEST_CASE(refuses_a_step_of_which_there_is_no_estimate) {
  ErrorControl now = control();
  const Decision refused = now.judge({.dt = 0.5, .iteration = solved, .truncation = {}});
  BOOST_TEST(!refused.accepted);
  BOOST_TEST(contains(refused.refusal, "of the step of 0.5 s the scheme estimates no error"));
}

BOOST_AUTO_TEST_CASE(keeps_a_retry_within_its_bounds) {
  ErrorControl now = control();
  now.judge({.dt = 0.5, .iteration = solved, .truncation = {.error = 1.0001e-6, .order = 200}});
  BOOST_TEST(now.dt() == 0.5 * 0.9 * std::pow(1.0 / 1.0001, 1.0 / 201.0), tolerance(1e-12));
  now.judge({.dt = 0.4, .iteration = solved, .truncation = {.error = 1e9, .order = 2}});
  BOOST_TEST(now.dt() == 0.04, tolerance(1e-14));
  now.judge({.dt = 0.04, .iteration = {.evaluated = false}});
  BOOST_TEST(now.dt() == 0.02, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(leaves_its_step_alone_where_one_was_cut_short) {
  ErrorControl now = control();
  BOOST_TEST(now.judge({.dt = 0.01, .iteration = solved, .truncation = {.error = 1e-12, .order = 2}}).accepted);
  BOOST_TEST(now.dt() == 0.5);
}

BOOST_AUTO_TEST_CASE(refuses_sweeps_that_do_not_contract) {
  ErrorControl now = control();
  const Decision refused = now.judge({.dt = 0.5, .iteration = contracting(2.0)});
  BOOST_TEST(!refused.accepted);
  BOOST_TEST(contains(refused.refusal, "the sweeps diverge by a factor of 2"));
  BOOST_TEST(now.refused);
}

BOOST_AUTO_TEST_CASE(gives_up_below_the_smallest_step_and_says_what_was_seen) {
  ErrorControl now = control();
  now.smallest = 0.3;
  const Decision refused = now.judge({.dt = 0.5, .iteration = solved, .truncation = {.error = 2.7e-5, .order = 2}});
  BOOST_TEST((refused.failure == Failure::inaccurate));
  BOOST_TEST(refused.workable == 0.15, tolerance(1e-14));
  BOOST_TEST(contains(refused.impossible, "leaves an error estimated at 2.7e-05"));
  BOOST_TEST(contains(refused.impossible, "the next to try is 0.15 s, below the smallest allowed 0.3 s"));
  BOOST_TEST(now.dt() == 0.5);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(names_the_bound_and_what_was_given) {
  BOOST_CHECK_NO_THROW(validate(control()));
  const auto refuses = [](auto change, const char* words) {
    ErrorControl bad = control();
    change(bad);
    CHECK_REFUSED(validate(bad), words);
  };
  refuses([](ErrorControl& c) { c.TOL = 1e-16; }, "error control: TOL must be finite and at least 2.22e-16");
  refuses([](ErrorControl& c) { c.TOL = not_a_number; }, "got nan");
  refuses([](ErrorControl& c) { c.sweep_TOL = 0.0; },
          "error control, sweeps: TOL must be finite and at least 2.22e-16");
  refuses([](ErrorControl& c) { c.K_d = 0; }, "K_d must be at least 1, got 0");
  refuses([](ErrorControl& c) { c.allowed = 1; }, "allowed must be at least K_d, got 1");
  refuses([](ErrorControl& c) { c.limit = 0.0; }, "limit must be positive, in s, got 0");
  refuses([](ErrorControl& c) { c.step = 3.0; }, "step must be positive and at most limit, or left out, in s, got 3");
  refuses([](ErrorControl& c) { c.smallest = 0.6; }, "smallest must be in [0, step], in s, got 0.6");
  refuses([](ErrorControl& c) { c.safety = 0.0; }, "safety must be in (0, 1], got 0");
  refuses([](ErrorControl& c) { c.growth = 1.0; }, "growth must be finite and above 1, got 1");
  refuses([](ErrorControl& c) { c.worth = 0.9; }, "worth must be finite and at least 1, got 0.9");
  refuses([](ErrorControl& c) { c.retry = 1.0; }, "retry must be in (0, 1), got 1");
  refuses([](ErrorControl& c) { c.shrink = 0.95; }, "shrink must be in (0, retry), got 0.95");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::error_control_test
