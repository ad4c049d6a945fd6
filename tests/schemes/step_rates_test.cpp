#include <particulate/schemes/step_rates.hpp>

#include <algorithm>
#include <cmath>

#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "close.hpp"
#include "order.hpp"
#include "problems.hpp"

// What one-step schemes keep of rates, and the errors of steps that they estimate from them.

namespace tests::step_rates_test {

using namespace particulate::schemes;

static_assert(EstimatesTruncation<RungeKutta4> && EstimatesTruncation<VelocityVerlet> &&
              EstimatesTruncation<BackwardEuler> && EstimatesTruncation<PhiFamily<Anderson>>);

// One step, swept to rounding, that stands.
template <class S, class P>
Truncation step(S& scheme, P& problem, const State& from, double dt, State& to) {
  BOOST_REQUIRE(scheme.predict(problem, from, dt, to));
  if constexpr (Iterative<S>) {
    for (int k = 0; k < 40; ++k) scheme.sweep(problem, from, dt, to);
  }
  const Truncation truncation = scheme.truncation(problem, from, dt, to);
  scheme.accept(dt);
  return truncation;
}

// Estimate over error of the n-th step, whose start is taken for exact; over_a_change() undone.
template <class S, class P>
double estimate_over_error(S scheme, P problem, State from, double dt, int n) {
  State to = from;
  Truncation truncation = step(scheme, problem, from, dt, to);
  for (int k = 1; k < n; ++k) {
    from = to;
    truncation = step(scheme, problem, from, dt, to);
  }
  State error = from;
  (void)run(problem, error, from.t + dt, Collocation<Gauss<6>>(), FixedStep{.step = dt / 10.0, .TOL = 1e-15});
  error.r -= to.r;
  error.v -= to.v;
  error.y -= to.y;
  ErrorScales scales;
  scales.look(problem, from, dt, to);
  const double p = truncation.order + 1.0;
  return std::pow(truncation.error, (p + 1.0) / p) / scales.relative(error);
}

// The estimate comes ever nearer to the error, in the first step as in later ones.
template <class S, class P>
void meets_the_error(const S& scheme, const P& problem, const State& from) {
  for (const int n : {1, 2, 3}) {
    double off = 0.35;
    for (const double dt : {0.1, 0.05, 0.025, 0.0125}) {
      const double ratio = estimate_over_error(scheme, problem, from, dt, n);
      BOOST_TEST_CONTEXT("step " << n << " of " << dt << " s, ratio " << ratio) {
        BOOST_TEST(std::abs(ratio - 1.0) <= off);
      }
      off *= 0.6;
    }
  }
}

// The error under ErrorControl over TOL: the same over decades of it, within a factor of two.
template <class S, class P>
void controls_the_error(S fresh, P problem, double factor, double tightest = 1e-9) {
  for (double TOL = 1e-3; TOL > 0.5 * tightest; TOL *= 0.1) {
    S scheme = fresh;
    State state = P::at(0.0);
    ErrorControl control{.TOL = TOL, .sweep_TOL = 1e-3 * TOL, .step = 1e-3, .limit = 1.0};
    BOOST_TEST(integrate(problem, state, 6.0, scheme, control).reason == "");
    const double error = (flat(state) - flat(P::at(6.0))).cwiseAbs().maxCoeff() / TOL;
    BOOST_TEST_CONTEXT("TOL = " << TOL) { BOOST_TEST((error >= 0.5 * factor && error <= 2.0 * factor), error); }
  }
}

struct Circle : Spring {
  static State at(double t) { return body(std::cos(t), -std::sin(t), t); }
};

// One run and two parts of it, in which the control needs what the steps before the cut have shown.
template <class S>
void continues_to_the_same_bits(S scheme, long asked_again) {
  Circle problem;
  S other = scheme;
  ErrorControl whole_control{.TOL = 1e-4, .step = 0.01, .limit = 1.0}, control = whole_control;
  State whole = Circle::at(0.0), parts = whole;
  int steps = 0;
  const auto stop = [&](const State&, const State&, double, const S&) { return ++steps < 9; };
  const Outcome outcome = integrate(problem, whole, 6.0, other, whole_control);
  const Outcome first = integrate(problem, parts, 6.0, scheme, control, stop);
  const Outcome second = integrate(problem, parts, 6.0, scheme, control);
  BOOST_TEST(close(flat(parts), flat(whole), {}));
  BOOST_TEST(first.steps + second.steps == outcome.steps);
  BOOST_TEST(first.evaluations + second.evaluations == outcome.evaluations + asked_again);
}

BOOST_AUTO_TEST_SUITE(StepRates_)

BOOST_AUTO_TEST_CASE(estimate_the_error_of_a_step) {
  meets_the_error(VelocityVerlet(), Driven{}, Driven::at(0.7));
  meets_the_error(VelocityVerlet(), Circle{}, Circle::at(0.7));
  for (const double phi : {0.0, 0.5, 0.7, 1.0}) {
    meets_the_error(PhiFamily<>(phi), Circle{}, Circle::at(0.7));
    meets_the_error(PhiFamily<>(phi), Damped{}, body(1.0, 0.3));
    meets_the_error(PhiFamily<>(phi), Decay{}, one());
    meets_the_error(PhiFamily<>(phi), Sine{}, sine_start());
  }
}

// (lambda dt)^4/72 by either of two ways; where rates know only time, one of them is blind: dt^4 f'''/96.
BOOST_AUTO_TEST_CASE(estimate_of_runge_kutta_the_method_one_order_below) {
  for (const double dt : {0.1, 0.05, 0.025}) {
    RungeKutta4 scheme;
    Decay decay;
    Sine sine;
    State from = one(), to = from;
    const double z = std::pow(dt, 4);
    for (int k = 0; k < 3; ++k, from = to) {
      const double error = step(scheme, decay, from, dt, to).error * 72.0 / z;
      BOOST_TEST((error > 0.8 && error < 3.2), error);
    }
    scheme.forget();
    from = to = sine_start(1.0);
    for (int k = 0; k < 3; ++k, from = to) {
      const double error = step(scheme, sine, from, dt, to).error * to.y[0] * 96.0 / (z * std::sin(from.t));
      BOOST_TEST((error > 0.85 && error < 1.15), error);
    }
  }
}

BOOST_AUTO_TEST_CASE(control_the_error_of_a_run) {
  controls_the_error(RungeKutta4(), Driven{}, 8.0);
  controls_the_error(RungeKutta4(), Circle{}, 2.0);
  controls_the_error(VelocityVerlet(), Driven{}, 32.0, 1e-7);
  controls_the_error(VelocityVerlet(), Circle{}, 0.32, 1e-7);
  controls_the_error(PhiFamily<>(0.5), Circle{}, 1.0, 1e-6);
  controls_the_error(BackwardEuler(), Circle{}, 3.5, 1e-5);
}

// Of a problem in other units, and seen from far away.
BOOST_AUTO_TEST_CASE(estimate_the_same_in_any_unit) {
  State small = body(1e-6, 0.0), large = body(1e6, 0.0), to = small;
  Spring spring;
  VelocityVerlet one_scheme, other;
  const double error = step(one_scheme, spring, small, 0.1, to).error;
  to = large;
  BOOST_TEST(step(other, spring, large, 0.1, to).error == error, tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(go_on_in_a_second_part_of_a_run) {
  continues_to_the_same_bits(RungeKutta4(), 1);
  continues_to_the_same_bits(VelocityVerlet(), 1);
  continues_to_the_same_bits(PhiFamily<>(1.0), 0);
  continues_to_the_same_bits(PhiFamily<Anderson>(0.5), 0);
}

// Four or one a step where nobody asks for errors. Where a control does, the rate at the end is the next start's; one
// more at the first start and one in the first step.
BOOST_AUTO_TEST_CASE(cost_what_a_control_asks_for) {
  const auto evaluations = [](auto scheme, auto control) {
    State state = displaced();
    const Outcome outcome = run(Spring{}, state, 1.0, scheme, control);
    BOOST_TEST(outcome.rejections == 0);
    BOOST_TEST(outcome.steps == 8);
    return outcome.evaluations;
  };
  const FixedStep fixed{.step = 0.125};
  const ErrorControl control{.TOL = 0.1, .step = 0.125, .limit = 0.125};
  BOOST_TEST(evaluations(RungeKutta4(), fixed) == 4 * 8);
  BOOST_TEST(evaluations(RungeKutta4(), control) == 4 * 8 + 2);
  BOOST_TEST(evaluations(VelocityVerlet(), fixed) == 1 + 8);
  BOOST_TEST(evaluations(VelocityVerlet(), control) == 1 + 8 + 1);
}

// A refused step is tried again from the same rates.
BOOST_AUTO_TEST_CASE(know_the_start_of_a_step_that_is_tried_again) {
  Spring spring;
  long evaluations = 0;
  Problem counted(spring, &evaluations);
  RungeKutta4 scheme, fresh;
  State from = displaced(), to = from, again = from;
  BOOST_TEST(scheme.predict(counted, from, 0.5, to));
  (void)scheme.truncation(counted, from, 0.5, to);
  BOOST_TEST(evaluations == 6);
  BOOST_TEST(scheme.predict(counted, from, 0.25, to));
  BOOST_TEST(evaluations == 9);
  BOOST_TEST(fresh.predict(spring, from, 0.25, again));
  BOOST_TEST(close(flat(to), flat(again), {}));
}

// No value, at the end or inside, is no estimate that a step could be accepted with.
BOOST_AUTO_TEST_CASE(have_an_infinite_error_without_a_value) {
  for (const int n : {5, 6}) {  // all four stages have one
    Failing failing{n};
    RungeKutta4 scheme;
    State from = displaced(), to = from;
    BOOST_TEST(std::isinf(step(scheme, failing, from, 0.1, to).error));
  }
  BOOST_TEST(std::isinf(estimated(not_a_number, 2).error));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(second_difference_)

// f = 3 + 2 x + 5 x^2 at 0, 1 and elsewhere: f'' = 10.
BOOST_AUTO_TEST_CASE(is_exact_for_a_parabola_wherever_the_third_place_is) {
  const auto f = [](double x) { return Eigen::VectorXd::Constant(1, 3.0 + 2.0 * x + 5.0 * x * x); };
  Eigen::VectorXd to;
  for (const double place : {-3.0, -1.0, 0.25, 0.5}) {
    second_difference(f(0.0), f(1.0), f(place), place, to);
    BOOST_TEST(to[0] == 10.0, tolerance(1e-14));
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::step_rates_test
