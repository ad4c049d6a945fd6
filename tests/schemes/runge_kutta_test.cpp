#include <particulate/schemes/runge_kutta.hpp>

#include <cmath>
#include <limits>

#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>

#include "close.hpp"
#include "order.hpp"

namespace tests::runge_kutta_test {

using boost::test_tools::tolerance;
using particulate::schemes::acceleration_of;
using particulate::schemes::FixedStep;
using particulate::schemes::In;
using particulate::schemes::integrate;
using particulate::schemes::State;
using particulate::schemes::Out;
using particulate::schemes::Outcome;
using particulate::schemes::RungeKutta4;
using particulate::schemes::Status;
using particulate::schemes::State;

constexpr double eps = std::numeric_limits<double>::epsilon();

// y_0 = exp(sin t) and y_1 = 1/(1 + t^2).
struct Growing {
  bool rate(double t, In y, Out dy) const {
    dy[0] = y[0] * std::cos(t);
    dy[1] = -2.0 * t * y[1] * y[1];
    return true;
  }
  static Values at(double t) { return {t, Eigen::Vector2d(std::exp(std::sin(t)), 1.0 / (1.0 + t * t))}; }
};

// r_0 = 1/(1 + t) and r_1 = cos t.
struct Driven {
  bool acceleration(double t, In r, Out a) const {
    a[0] = 2.0 * r[0] * r[0] * r[0];
    a[1] = 3.0 * std::cos(t) - 4.0 * r[1];
    return true;
  }
  static Motion at(double t) {
    const double s = 1.0 / (1.0 + t);
    return {t, Eigen::Vector2d(s, std::cos(t)), Eigen::Vector2d(-s * s, -std::sin(t))};
  }
};

// r = exp(-0.3 t) cos t.
struct Damped {
  bool acceleration(double, In r, In v, Out a) const {
    a = -1.09 * r - 0.6 * v;
    return true;
  }
  static Motion at(double t) {
    const double fading = std::exp(-0.3 * t);
    return {t, Eigen::VectorXd::Constant(1, fading * std::cos(t)),
            Eigen::VectorXd::Constant(1, -fading * (0.3 * std::cos(t) + std::sin(t)))};
  }
};

// r'' = (n + 1)(n + 2) t^n and y' = (n + 1) t^n: r = t^(n + 2), v = (n + 2) t^(n + 1), y = t^(n + 1).
struct Polynomial {
  int n;
  bool acceleration(double t, In, Out a) const {
    a[0] = (n + 1) * (n + 2) * std::pow(t, n);
    return true;
  }
  bool rate(double t, In, Out dy) const {
    dy[0] = (n + 1) * std::pow(t, n);
    return true;
  }
};

// Has no value from its n-th call on.
struct Failing {
  int n;
  bool acceleration(double, In r, Out a) {
    a = -r;
    return --n > 0;
  }
  bool rate(double, In y, Out dy) {
    dy = -y;
    return --n > 0;
  }
};

double error(const Values& a, const Values& b) { return (a.y - b.y).norm(); }
double error(const Motion& a, const Motion& b) { return std::hypot((a.r - b.r).norm(), (a.v - b.v).norm()); }

template <class P>
double error_after(const P& problem, int steps) {
  const double t_end = 1.7;
  auto state = P::at(0.0);
  RungeKutta4 scheme;
  FixedStep control{.step = t_end / steps};
  const Outcome outcome = integrate(problem, state, t_end, scheme, control);
  BOOST_REQUIRE(outcome.steps == steps);
  BOOST_REQUIRE(outcome.evaluations == 4 * steps);
  return error(state, P::at(t_end));
}

template <class P>
double order_on(const P& problem) {
  return observed_order([&](int steps) { return error_after(problem, steps); }, {20, 30, 45, 68, 100});
}

Motion still() { return {0.0, Eigen::VectorXd::Zero(1), Eigen::VectorXd::Zero(1)}; }

BOOST_AUTO_TEST_SUITE(acceleration_of_)

BOOST_AUTO_TEST_CASE(gives_velocities_to_the_problems_that_want_them) {
  const Eigen::Vector2d r(1.0, 2.0), v(10.0, 20.0);
  Eigen::VectorXd a(2);
  Driven driven;
  BOOST_TEST(acceleration_of(driven, 0.0, r, v, a));
  BOOST_TEST(close(a, Eigen::Vector2d(2.0, -5.0), {}));
  Damped damped;
  BOOST_TEST(acceleration_of(damped, 0.0, r, v, a));
  BOOST_TEST(close(a, Eigen::Vector2d(-7.09, -14.18), {.relative = 4.0 * eps}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(RungeKutta4_)

// y' = y, Dt = 1: 1 + 1 + 1/2 + 1/6 + 1/24 = 65/24.
BOOST_AUTO_TEST_CASE(takes_the_first_five_terms_of_the_exponential) {
  struct Exponential {
    bool rate(double, In y, Out dy) const {
      dy = y;
      return true;
    }
  } problem;
  RungeKutta4 scheme;
  Values to;
  BOOST_TEST(scheme.predict(problem, Values{2.0, Eigen::VectorXd::Ones(1)}, 1.0, to));
  BOOST_TEST(to.t == 3.0);
  BOOST_TEST(to.y[0] == 65.0 / 24.0, tolerance(2.0 * eps));
}

// r'' = -r from (1, 0), Dt = 1: r = 1 - 1/2 + 1/24, v = -1 + 1/6.
BOOST_AUTO_TEST_CASE(takes_the_first_five_terms_of_the_circle) {
  struct Spring {
    bool acceleration(double, In r, Out a) const {
      a = -r;
      return true;
    }
  } problem;
  RungeKutta4 scheme;
  Motion to;
  BOOST_TEST(scheme.predict(problem, State{0.0, Eigen::VectorXd::Ones(1), Eigen::VectorXd::Zero(1)}, 1.0, to));
  BOOST_TEST(to.r[0] == 13.0 / 24.0, tolerance(2.0 * eps));
  BOOST_TEST(to.v[0] == -5.0 / 6.0, tolerance(2.0 * eps));
}

BOOST_AUTO_TEST_CASE(is_exact_for_polynomials_up_to_degree_four) {
  RungeKutta4 scheme;
  for (int n = 0; n <= 3; ++n) {
    Values to;
    const Polynomial problem{n};
    BOOST_TEST(scheme.predict(problem, Values{0.5, Eigen::VectorXd::Constant(1, std::pow(0.5, n + 1))}, 1.5, to));
    BOOST_TEST(to.y[0] == std::pow(2.0, n + 1), tolerance(4.0 * eps));
  }
  for (int n = 0; n <= 2; ++n) {
    Motion to;
    const Polynomial problem{n};
    const Motion from{0.5, Eigen::VectorXd::Constant(1, std::pow(0.5, n + 2)),
                      Eigen::VectorXd::Constant(1, (n + 2) * std::pow(0.5, n + 1))};
    BOOST_TEST(scheme.predict(problem, from, 1.5, to));
    BOOST_TEST(to.r[0] == std::pow(2.0, n + 2), tolerance(4.0 * eps));
    BOOST_TEST(to.v[0] == (n + 2) * std::pow(2.0, n + 1), tolerance(4.0 * eps));
  }
}

// Simpson's rule makes 25/24 of 1 from 5 t^4; two thirds of the middle make 20/24 of 1 from 20 t^3.
BOOST_AUTO_TEST_CASE(is_not_exact_one_degree_higher) {
  const Polynomial quartic{4}, cubic{3};
  RungeKutta4 scheme;
  Values values;
  Motion motion;
  BOOST_TEST(scheme.predict(quartic, Values{0.0, Eigen::VectorXd::Zero(1)}, 1.0, values));
  BOOST_TEST(values.y[0] == 25.0 / 24.0, tolerance(2.0 * eps));
  BOOST_TEST(scheme.predict(cubic, still(), 1.0, motion));
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
    Failing problem{n};
    Motion motion;
    BOOST_TEST(scheme.predict(problem, still(), 0.1, motion) == (n == 5));
    problem.n = n;
    Values values;
    BOOST_TEST(scheme.predict(problem, Values{0.0, Eigen::VectorXd::Zero(1)}, 0.1, values) == (n == 5));
  }
}

// The same steps in one run and in two, the second from copies of what the first left.
BOOST_AUTO_TEST_CASE(continues_from_a_copy_to_the_same_bits) {
  const Damped problem;
  Motion whole = Damped::at(0.0), state = whole;
  RungeKutta4 scheme, other;
  FixedStep control{.step = 0.125};
  BOOST_TEST(integrate(problem, whole, 2.0, other, control).steps == 16);
  BOOST_TEST(integrate(problem, state, 1.0, scheme, control).steps == 8);
  Motion checkpoint = state;
  RungeKutta4 copied = scheme;
  BOOST_TEST(integrate(problem, state, 2.0, scheme, control).steps == 8);
  BOOST_TEST(integrate(problem, checkpoint, 2.0, copied, control).steps == 8);
  BOOST_TEST(close(checkpoint.r, state.r, {}));
  BOOST_TEST(close(checkpoint.v, state.v, {}));
  BOOST_TEST(close(whole.r, state.r, {}));
  BOOST_TEST(close(whole.v, state.v, {}));
}

// |R(i z)| = 1 at z = 2 sqrt 2.
BOOST_AUTO_TEST_CASE(is_stable_on_an_oscillator_up_to_its_limit_only) {
  struct Spring {
    bool acceleration(double, In r, Out a) const {
      a = -r;
      return true;
    }
  } problem;
  for (const double factor : {0.99, 1.01}) {
    Motion state{0.0, Eigen::VectorXd::Ones(1), Eigen::VectorXd::Zero(1)};
    RungeKutta4 scheme;
    FixedStep control{.step = factor * 2.0 * std::sqrt(2.0)};
    BOOST_TEST(integrate(problem, state, 200.0 * control.step, scheme, control).steps == 200);
    BOOST_TEST((std::hypot(state.r[0], state.v[0]) < 1.0) == (factor < 1.0));
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::runge_kutta_test
