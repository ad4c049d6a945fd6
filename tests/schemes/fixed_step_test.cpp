#include <particulate/schemes/fixed_step.hpp>

#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>

#include "close.hpp"
#include "problems.hpp"
#include "says.hpp"

namespace tests::fixed_step_test {

using namespace particulate::schemes;

static_assert(Controller<FixedStep>);

BOOST_AUTO_TEST_SUITE(FixedStep_)

BOOST_AUTO_TEST_CASE(always_wishes_its_own_step) { BOOST_TEST(FixedStep{.step = 0.125}.dt() == 0.125); }

BOOST_AUTO_TEST_CASE(sweeps_until_rounding_or_until_a_tolerance_that_was_set) {
  const FixedStep to_rounding{.step = 0.125, .contractions = 5}, to_tolerance{.step = 0.125, .TOL = 1e-6};
  BOOST_TEST(to_rounding.goes_on({.w_K = 1e-6, .rate = 0.5, .K = 4, .rounding = 1e-15}));
  BOOST_TEST(!to_rounding.goes_on({.w_K = 1e-6, .rate = 0.5, .K = 5, .rounding = 1e-15}));
  BOOST_TEST(!to_rounding.goes_on({.w_K = 1e-15, .rate = 0.5, .K = 4, .rounding = 1e-15}));
  BOOST_TEST(to_tolerance.goes_on({.w_K = 2e-6, .K = 4}));
  BOOST_TEST(!to_tolerance.goes_on({.w_K = 1e-6, .K = 4}));
}

BOOST_AUTO_TEST_CASE(accepts_what_has_a_value_and_made_no_sweep) {
  const Decision decision = FixedStep{.step = 0.125}.judge({.dt = 0.01, .iteration = {}});
  BOOST_TEST(decision.accepted);
  BOOST_TEST(decision.impossible.empty());
}

BOOST_AUTO_TEST_CASE(accepts_sweeps_that_have_settled_and_refuses_others_with_what_was_seen) {
  const FixedStep control{.step = 0.125, .TOL = 1e-6, .contractions = 2};
  const Iteration settled{.w_0 = 1e-2, .w_K = 1e-6, .rate = 1e-2, .K = 2, .p = 2};
  BOOST_TEST(control.judge({.dt = 0.125, .iteration = settled}).accepted);
  const Iteration apart{.w_0 = 1e-2, .w_K = 4e-2, .rate = 2.0, .K = 2, .p = 2};
  const Decision refused = control.judge({.dt = 0.125, .iteration = apart});
  BOOST_TEST(!refused.accepted);
  BOOST_TEST((refused.failure == particulate::schemes::Failure::diverging));
  BOOST_TEST(contains(refused.impossible, "diverge by a factor of 2 each at Dt = 0.125 s"));
  BOOST_TEST(contains(refused.impossible, "a fixed step cannot shrink"));
}

BOOST_AUTO_TEST_CASE(says_why_it_cannot_go_on_without_a_value) {
  const Decision decision = FixedStep{.step = 0.125}.judge({.dt = 0.0625, .iteration = {.evaluated = false}});
  BOOST_TEST(!decision.accepted);
  BOOST_TEST(contains(decision.impossible, "no finite value within this step of 0.0625 s"));
  BOOST_TEST(contains(decision.impossible, "choose a smaller step"));
}

BOOST_AUTO_TEST_CASE(is_refused_with_a_tolerance_that_would_bound_nothing) {
  State spring{.r = Eigen::VectorXd::Ones(1), .v = Eigen::VectorXd::Zero(1)};
  CHECK_REFUSED(run(Spring{}, spring, 1.0, RungeKutta4(), FixedStep{.step = 0.125, .TOL = 1e-6}),
                "run: a TOL bounds what the sweeps of a step leave, and this scheme makes none");
  BOOST_TEST((run(Spring{}, spring, 1.0, PhiFamily<>(), FixedStep{.step = 0.125, .TOL = 1e-6}).reason == ""));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(names_the_step_and_what_was_given) {
  BOOST_CHECK_NO_THROW(validate(FixedStep{.step = 1e-300}));
  CHECK_REFUSED(validate(FixedStep{}), "step must be positive and finite, got 0 s");
  CHECK_REFUSED(validate(FixedStep{.step = 1.0, .TOL = 1e-17}), "fixed step: TOL must be finite and at least 2.22e-16");
  CHECK_REFUSED(validate(FixedStep{.step = 1.0, .contractions = 0}), "contractions must be at least 1, got 0");
  CHECK_REFUSED(validate(FixedStep{.step = -1.0}), "got -1 s");
  CHECK_REFUSED(validate(FixedStep{.step = infinity}), "got inf s");
  CHECK_REFUSED(validate(FixedStep{.step = not_a_number}), "got nan s");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::fixed_step_test
