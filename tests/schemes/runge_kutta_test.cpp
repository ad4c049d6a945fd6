#include <particulate/schemes/runge_kutta.hpp>

#include <cmath>

#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>

#include "close.hpp"
#include "order.hpp"
#include "problems.hpp"

namespace tests::runge_kutta_test {

using namespace particulate::schemes;

// y_0 = exp(sin t) and y_1 = 1/(1 + t^2).
struct Growing {
  bool rate(double t, In y, Out dy) const {
    dy[0] = y[0] * std::cos(t);
    dy[1] = -2.0 * t * y[1] * y[1];
    return true;
  }
  static State at(double t) { return {.t = t, .y = Eigen::Vector2d(std::exp(std::sin(t)), 1.0 / (1.0 + t * t))}; }
};

// r = exp(-0.3 t) cos t.
struct Damped {
  bool acceleration(double, In r, In v, Out a) const {
    a = -1.09 * r - 0.6 * v;
    return true;
  }
  static State at(double t) {
    const double fading = std::exp(-0.3 * t);
    return body(fading * std::cos(t), -fading * (0.3 * std::cos(t) + std::sin(t)), t);
  }
};

// r'' = (n + 1)(n + 2) t^n: r = t^(n + 2), v = (n + 2) t^(n + 1).
struct Thrown {
  int n;
  bool acceleration(double t, In, Out a) const {
    a[0] = (n + 1) * (n + 2) * std::pow(t, n);
    return true;
  }
};

// y' = (n + 1) t^n: y = t^(n + 1).
struct Polynomial {
  int n;
  bool rate(double t, In, Out dy) const {
    dy[0] = (n + 1) * std::pow(t, n);
    return true;
  }
};

// No value from its n-th call on.
struct FailingValues {
  int n;
  bool rate(double, In y, Out dy) {
    dy = -y;
    return --n > 0;
  }
};

template <class P>
double error_after(const P& problem, int steps) {
  const double t_end = 1.7;
  State state = P::at(0.0);
  const Outcome outcome = run(problem, state, t_end, RungeKutta4(), FixedStep{.step = t_end / steps});
  BOOST_REQUIRE(outcome.steps == steps);
  BOOST_REQUIRE(outcome.evaluations == 4 * steps);
  return (flat(state) - flat(P::at(t_end))).norm();
}

template <class P>
double order_on(const P& problem) {
  return observed_order([&](int steps) { return error_after(problem, steps); }, {20, 30, 45, 68, 100});
}

BOOST_AUTO_TEST_SUITE(RungeKutta4_)

// y' = y, Dt = 1: 1 + 1 + 1/2 + 1/6 + 1/24 = 65/24.
BOOST_AUTO_TEST_CASE(takes_the_first_five_terms_of_the_exponential) {
  const State to = predicted(RungeKutta4(), Decay{-1.0}, one(1.0, 2.0), 1.0);
  BOOST_TEST(to.t == 3.0);
  BOOST_TEST(to.y[0] == 65.0 / 24.0, tolerance(2.0 * eps));
}

// r'' = -r from (1, 0), Dt = 1: r = 1 - 1/2 + 1/24, v = -1 + 1/6.
BOOST_AUTO_TEST_CASE(takes_the_first_five_terms_of_the_circle) {
  const State to = predicted(RungeKutta4(), Spring{}, displaced(), 1.0);
  BOOST_TEST(to.r[0] == 13.0 / 24.0, tolerance(2.0 * eps));
  BOOST_TEST(to.v[0] == -5.0 / 6.0, tolerance(2.0 * eps));
}

BOOST_AUTO_TEST_CASE(is_exact_for_polynomials_up_to_degree_four) {
  for (int n = 0; n <= 3; ++n) {
    const State to = predicted(RungeKutta4(), Polynomial{n}, one(std::pow(0.5, n + 1), 0.5), 1.5);
    BOOST_TEST(to.y[0] == std::pow(2.0, n + 1), tolerance(4.0 * eps));
  }
  for (int n = 0; n <= 2; ++n) {
    const State from = body(std::pow(0.5, n + 2), (n + 2) * std::pow(0.5, n + 1), 0.5);
    const State to = predicted(RungeKutta4(), Thrown{n}, from, 1.5);
    BOOST_TEST(to.r[0] == std::pow(2.0, n + 2), tolerance(4.0 * eps));
    BOOST_TEST(to.v[0] == (n + 2) * std::pow(2.0, n + 1), tolerance(4.0 * eps));
  }
}

// Simpson's rule makes 25/24 of 1 from 5 t^4; two thirds of the middle make 20/24 of 1 from 20 t^3.
BOOST_AUTO_TEST_CASE(is_not_exact_one_degree_higher) {
  const State values = predicted(RungeKutta4(), Polynomial{4}, one(0.0), 1.0);
  BOOST_TEST(values.y[0] == 25.0 / 24.0, tolerance(2.0 * eps));
  const State motion = predicted(RungeKutta4(), Thrown{3}, body(0.0, 0.0), 1.0);
  BOOST_TEST(motion.r[0] == 5.0 / 6.0, tolerance(2.0 * eps));
  BOOST_TEST(motion.v[0] == 5.0, tolerance(2.0 * eps));
}

BOOST_AUTO_TEST_CASE(has_order_four_for_first_order_problems) {
  BOOST_TEST(std::abs(order_on(Growing{}) - 4.0) <= 0.2);
}

BOOST_AUTO_TEST_CASE(has_order_four_for_forces_that_depend_on_position) {
  BOOST_TEST(std::abs(order_on(Driven{}) - 4.0) <= 0.2);
}

BOOST_AUTO_TEST_CASE(has_order_four_for_forces_that_depend_on_velocity) {
  BOOST_TEST(std::abs(order_on(Damped{}) - 4.0) <= 0.2);
}

BOOST_AUTO_TEST_CASE(says_at_every_stage_that_there_is_no_value) {
  RungeKutta4 scheme;
  for (int n = 1; n <= 5; ++n) {
    Failing moving{n};
    FailingValues growing{n};
    State motion, values;
    BOOST_TEST(scheme.predict(moving, body(0.0, 0.0), 0.1, motion) == (n == 5));
    BOOST_TEST(scheme.predict(growing, one(0.0), 0.1, values) == (n == 5));
  }
}

// The same steps in one run and in two, the second from copies of what the first left.
BOOST_AUTO_TEST_CASE(continues_from_a_copy_to_the_same_bits) {
  const Damped problem;
  State whole = Damped::at(0.0), state = whole;
  RungeKutta4 scheme, other;
  FixedStep control{.step = 0.125};
  BOOST_TEST(integrate(problem, whole, 2.0, other, control).steps == 16);
  BOOST_TEST(integrate(problem, state, 1.0, scheme, control).steps == 8);
  State checkpoint = state;
  RungeKutta4 copied = scheme;
  BOOST_TEST(integrate(problem, state, 2.0, scheme, control).steps == 8);
  BOOST_TEST(integrate(problem, checkpoint, 2.0, copied, control).steps == 8);
  BOOST_TEST(close(flat(checkpoint), flat(state), {}));
  BOOST_TEST(close(flat(whole), flat(state), {}));
}

// |R(i z)| = 1 at z = 2 sqrt 2.
BOOST_AUTO_TEST_CASE(is_stable_on_an_oscillator_up_to_its_limit_only) {
  for (const double factor : {0.99, 1.01}) {
    State state = displaced();
    FixedStep control{.step = factor * 2.0 * std::sqrt(2.0)};
    BOOST_TEST(run(Spring{}, state, 200.0 * control.step, RungeKutta4(), control).steps == 200);
    BOOST_TEST((std::hypot(state.r[0], state.v[0]) < 1.0) == (factor < 1.0));
  }
}

// Amplitude after 2000 steps of the multiple of the limit that spans() gives, by a hair within or beyond it.
BOOST_AUTO_TEST_CASE(spans_of_an_oscillation_and_of_a_decay_what_it_can_and_no_more) {
  const auto amplitude = [](const auto& problem, State state, TimeScale::Kind kind, double factor) {
    FixedStep control{.step = factor * RungeKutta4::spans(kind, 0)};
    BOOST_TEST(run(problem, state, 2000.0 * control.step, RungeKutta4(), control).steps == 2000);
    return flat(state).norm();
  };
  BOOST_TEST(amplitude(Spring{}, displaced(), TimeScale::Kind::oscillates, 1.0 - 1e-3) < 1e-4);
  BOOST_TEST(amplitude(Spring{}, displaced(), TimeScale::Kind::oscillates, 1.0 + 1e-3) > 1e4);
  BOOST_TEST(amplitude(Decay{}, one(), TimeScale::Kind::decays, 1.0 - 1e-3) < 1e-3);
  BOOST_TEST(amplitude(Decay{}, one(), TimeScale::Kind::decays, 1.0 + 1e-3) > 1e3);
  using Kind = TimeScale::Kind;
  BOOST_TEST(RungeKutta4::spans(Kind::relaxes, 0) == RungeKutta4::spans(Kind::decays, 0));
  BOOST_TEST(std::isinf(RungeKutta4::spans(Kind::loads, 0)));  // of sweeps, which it does not make
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::runge_kutta_test
