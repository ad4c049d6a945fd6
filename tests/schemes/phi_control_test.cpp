#include <particulate/schemes/phi_control.hpp>

#include <array>

#include "close.hpp"
#include "numbers.hpp"

namespace tests::phi_control_test {

using namespace particulate::schemes;

static_assert(Controller<PhiControl>);

PhiControl control() { return {.TOL = 1e-4, .K_d = 2, .step = 0.5, .limit = 0.75, .smallest = 1e-3}; }

// Two contractions by `factor`, from w_0 = 1e-2.
Iteration contracting(double factor) {
  return {.w_0 = 1e-2, .w_K = 1e-2 * factor * factor, .rate = factor, .K = 2, .p = 2};
}

BOOST_AUTO_TEST_SUITE(PhiControl_)

BOOST_AUTO_TEST_CASE(sweeps_until_the_tolerance_is_met_or_no_contraction_is_left) {
  BOOST_TEST(control().goes_on({.w_K = 2e-4, .K = 1}));
  BOOST_TEST(!control().goes_on({.w_K = 1e-4, .K = 1}));
  BOOST_TEST(!control().goes_on({.w_K = 2e-4, .K = 2}));
}

// w_2/w_0 = 1/160^2... the step that contracts by 1/10 twice meets 1e-4 exactly: Phi = sqrt(0.1/factor).
BOOST_AUTO_TEST_CASE(grows_by_phi_after_a_success) {
  PhiControl now = control();
  BOOST_TEST(now.judge({.dt = 0.5, .iteration = contracting(0.08)}).accepted);
  BOOST_TEST(now.dt() == 0.5 * std::sqrt(0.1 / 0.08), tolerance(1e-14));
}

// Of K_d = 4 the next step is to need 2, so two that contract by `factor` ask for the step that K_d = 2 does, sqrt(0.1/
// factor). None of the sweeps is taken away, and a step that needs all four is kept, not made longer: by 4 it would
// grow.
BOOST_AUTO_TEST_CASE(aims_at_fewer_contractions_than_it_allows_where_some_are_to_spare) {
  PhiControl now = control();
  now.K_d = 4, now.spare = 2;
  BOOST_TEST((now.goes_on({.w_K = 2e-4, .K = 3}) && !now.goes_on({.w_K = 2e-4, .K = 4})));
  BOOST_TEST(now.judge({.dt = 0.5, .iteration = contracting(0.08)}).accepted);
  BOOST_TEST(now.dt() == 0.5 * std::sqrt(0.1 / 0.08), tolerance(1e-14));
  const Iteration all_four{.w_0 = 1e-2, .w_K = 0.5e-4, .rate = 0.3, .K = 4, .p = 2};
  for (const int spare : {2, 0}) {
    now.step = 0.5, now.spare = spare;
    BOOST_TEST(now.judge({.dt = 0.5, .iteration = all_four}).accepted);
    BOOST_TEST(now.dt() == (spare == 2 ? 0.5 : 0.5 * std::pow(2.0, 0.125)), tolerance(1e-14));
  }
  // A step that fails is made again for two: w_4 = 4e-4 asks for (1e-2)^(1/4)/(4e-2)^(1/8) of it.
  now.step = 0.5, now.spare = 2;
  BOOST_TEST(!now.judge({.dt = 0.5, .iteration = {.w_0 = 1e-2, .w_K = 4e-4, .rate = 0.45, .K = 4, .p = 2}}).accepted);
  BOOST_TEST(now.dt() == 0.5 * std::pow(1e-2, 0.25) / std::pow(4e-2, 0.125), tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(shrinks_by_phi_after_a_failure_and_asks_for_the_step_again) {
  PhiControl now = control();
  const Decision refused = now.judge({.dt = 0.5, .iteration = contracting(0.4)});
  BOOST_TEST(!refused.accepted);
  BOOST_TEST(refused.impossible.empty());
  BOOST_TEST(contains(refused.refusal, "contract by a factor of 0.4"));
  BOOST_TEST(now.dt() == 0.25, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(keeps_within_the_limit_and_within_the_growth_bound) {
  PhiControl now = control();
  now.judge({.dt = 0.5, .iteration = contracting(1e-3)});
  BOOST_TEST(now.dt() == 0.75);
  now.limit = 100.0;
  now.judge({.dt = 0.75, .iteration = contracting(1e-3)});
  BOOST_TEST(now.dt() == 1.5);
  now.judge({.dt = 1.5, .iteration = {.w_0 = 1e-5, .w_K = 1e-5, .K = 0}});
  BOOST_TEST(now.dt() == 3.0);
  now.judge({.dt = 3.0, .iteration = {}});
  BOOST_TEST(now.dt() == 6.0);
}

BOOST_AUTO_TEST_CASE(keeps_a_retry_within_its_bounds) {
  PhiControl now = control();
  now.judge({.dt = 0.5, .iteration = contracting(0.1001)});
  BOOST_TEST(now.dt() == 0.45, tolerance(1e-14));
  now.judge({.dt = 0.45, .iteration = contracting(1e4)});
  BOOST_TEST(now.dt() == 0.045, tolerance(1e-14));
  now.judge({.dt = 0.045, .iteration = {.evaluated = false}});
  BOOST_TEST(now.dt() == 0.0225, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(leaves_its_step_alone_where_one_was_cut_short) {
  PhiControl now = control();
  BOOST_TEST(now.judge({.dt = 0.01, .iteration = contracting(1e-3)}).accepted);
  BOOST_TEST(now.dt() == 0.5);
}

BOOST_AUTO_TEST_CASE(gives_up_below_the_smallest_step_and_says_what_was_seen) {
  PhiControl now = control();
  now.smallest = 0.3;
  const Decision refused = now.judge({.dt = 0.5, .iteration = contracting(0.4)});
  BOOST_TEST(!refused.accepted);
  BOOST_TEST((refused.failure == Failure::slow));
  BOOST_TEST(refused.workable == 0.25, tolerance(1e-14));
  BOOST_TEST(contains(refused.impossible, "contract by a factor of 0.4"));
  BOOST_TEST(contains(refused.impossible, "below the smallest allowed 0.3 s"));
  BOOST_TEST(now.dt() == 0.5);
}

BOOST_AUTO_TEST_CASE(does_not_shrink_a_step_that_rounding_keeps_from_its_tolerance) {
  PhiControl now = control();
  const Iteration stuck{.w_0 = 0.5, .w_K = 2e-4, .rate = 1.0, .K = 2, .rounding = 2e-4};
  const Decision refused = now.judge({.dt = 0.5, .iteration = stuck});
  BOOST_TEST((refused.failure == Failure::rounding));
  BOOST_TEST(!refused.impossible.empty());
  BOOST_TEST(now.dt() == 0.5);
}

BOOST_AUTO_TEST_CASE(follows_the_field_that_asks_for_the_smallest_step) {
  PhiControl now = control();
  now.TOL = 1.0;
  const std::array<Iteration, 3> fields{Iteration{.w_0 = 4.0, .w_K = 0.25, .K = 2, .p = 1, .field = "motion"},
                                        Iteration{.w_0 = 4.0, .w_K = 0.5625, .K = 2, .p = 2, .field = "heat"},
                                        Iteration{.field = "light"}};
  BOOST_TEST(now.judge({.dt = 0.5, .iteration = fields[1], .fields = fields}).accepted);
  // Phi = (1/2) / sqrt(w_K/w_0) = 2 for motion, and the square root of 4/3 for heat.
  BOOST_TEST(now.controlling == "heat");
  BOOST_TEST(now.dt() == 0.5 * std::sqrt(4.0 / 3.0), tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(retries_staggered_fields_that_show_nothing_as_it_does_a_single_one) {
  PhiControl now = control();
  const std::array<Iteration, 2> fields{Iteration{.evaluated = false, .field = "motion"}, Iteration{.field = "heat"}};
  BOOST_TEST(!now.judge({.dt = 0.5, .iteration = fields[0], .fields = fields}).accepted);
  BOOST_TEST(now.controlling == "motion");
  BOOST_TEST(now.dt() == 0.25, tolerance(1e-14));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(names_the_setting_and_what_was_given) {
  BOOST_CHECK_NO_THROW(validate(control()));
  const auto refuses = [](auto change, const char* words) {
    PhiControl bad = control();
    change(bad);
    CHECK_REFUSED(validate(bad), words);
  };
  refuses([](PhiControl& c) { c.TOL = 1e-16; }, "TOL must be finite and at least 2.22e-16, below which is rounding");
  refuses([](PhiControl& c) { c.TOL = not_a_number; }, "got nan");
  refuses([](PhiControl& c) { c.K_d = 0; }, "K_d must be at least 1, got 0");
  refuses([](PhiControl& c) { c.spare = 2; }, "spare must lie between 0 and K_d - 1, got 2");
  refuses([](PhiControl& c) { c.spare = -1; }, "spare must lie between 0 and K_d - 1, got -1");
  refuses([](PhiControl& c) { c.limit = 0.0; }, "limit must be positive and finite, in s, got 0");
  refuses([](PhiControl& c) { c.step = 1.0; }, "step must be positive and at most limit, or left out, in s, got 1");
  refuses([](PhiControl& c) { c.limit = infinity; }, "limit must be positive and finite, in s, got inf");
  refuses([](PhiControl& c) { c.smallest = 0.6; }, "smallest must be in [0, step], in s, got 0.6");
  refuses([](PhiControl& c) { c.growth = 1.0; }, "growth must be finite and above 1, got 1");
  refuses([](PhiControl& c) { c.retry = 1.0; }, "retry must be in (0, 1), got 1");
  refuses([](PhiControl& c) { c.shrink = 0.95; }, "shrink must be in (0, retry), got 0.95");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::phi_control_test
