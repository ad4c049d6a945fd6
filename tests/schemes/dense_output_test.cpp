#include <algorithm>
#include <cmath>

#include <particulate/schemes/coupled_pair.hpp>
#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/scheme.hpp>
#include <particulate/schemes/staggering.hpp>
#include <particulate/schemes/verlet.hpp>

#include "close.hpp"
#include "order.hpp"
#include "problems.hpp"

namespace tests::dense_output_test {

using namespace particulate::schemes;

// r = cos t and y = exp(sin t), each of which looks at the other, and at velocities and time.
struct Coupled {
  bool rates(double t, In r, In v, In y, Out a, Out dy) const {
    a = -r + (y * std::exp(-std::sin(t)) - Eigen::VectorXd::Ones(1)) - 0.3 * (v.array() + std::sin(t)).matrix();
    dy = y.cwiseProduct(r);
    return true;
  }
  static State at(double t) {
    State state = body(std::cos(t), -std::sin(t), t);
    state.y = Eigen::VectorXd::Constant(1, std::exp(std::sin(t)));
    return state;
  }
};

// r'' = t, beside values that nothing but a jump changes.
struct Ramp {
  static constexpr bool values_by_jumps = true;
  bool acceleration(double t, In, Out a) const {
    a.setConstant(t);
    return true;
  }
};

// One step from the exact state, swept to rounding.
template <class S, class P>
State step(S& scheme, const P& problem, const State& from, double dt) {
  State to = from;
  BOOST_REQUIRE(scheme.predict(problem, from, dt, to));
  if constexpr (Iterative<S>) {
    for (int k = 0; k < 60; ++k) scheme.sweep(problem, from, dt, to);
  }
  return to;
}

// The largest error inside one step of 1/n and a little beyond it.
template <class S, class P>
double error_inside(S scheme, const P& problem, int n) {
  const double dt = 1.0 / n;
  const State from = P::at(0.7);
  step(scheme, problem, from, dt);
  State there;
  double error = 0.0;
  for (const double theta : {0.2, 0.4, 0.6, 0.8, 1.1}) {
    scheme.at(from, dt, theta, there);
    error = std::max(error, (flat(there) - flat(P::at(there.t))).norm());
  }
  return error;
}

template <class S, class P>
void has_error_of_order(double order, const S& scheme, const P& problem) {
  const double seen =
      observed_order([&](int n) { return error_inside(scheme, problem, n); }, {10, 15, 22, 33, 50, 75, 110});
  BOOST_TEST(std::abs(seen - order) <= 0.15);
}

// The start to the last bit, the end to some roundings; before accept() as after it; the time with its carry.
template <class S, class P>
void joins_the_ends(S scheme, const P& problem, State from) {
  from.t_carry = 3e-17;
  const double dt = 0.125;
  const State to = step(scheme, problem, from, dt);
  State there;
  for (int k = 0; k < 2; ++k) {
    scheme.at(from, dt, 0.0, there);
    BOOST_TEST(close(flat(there), flat(from), {}));
    scheme.at(from, dt, 1.0, there);
    BOOST_TEST(close(flat(there), flat(to), {.relative = 4.0 * eps}));
    BOOST_TEST(there.t == to.t);
    BOOST_TEST(there.t_carry == to.t_carry);
    scheme.accept(dt);
  }
}

BOOST_AUTO_TEST_SUITE(dense_output)

BOOST_AUTO_TEST_CASE(has_one_order_more_than_the_scheme_and_of_runge_kutta_four) {
  has_error_of_order(4.0, RungeKutta4(), Coupled{});
  has_error_of_order(3.0, VelocityVerlet(), Driven{});
  has_error_of_order(3.0, PhiFamily<>(0.5), Coupled{});
  has_error_of_order(2.0, PhiFamily<Anderson>(0.7), Coupled{});
  has_error_of_order(2.0, BackwardEuler(), Coupled{});
  has_error_of_order(2.0, ForwardEuler(), Coupled{});
}

BOOST_AUTO_TEST_CASE(joins_both_ends_of_the_step) {
  joins_the_ends(RungeKutta4(), Coupled{}, Coupled::at(0.7));
  joins_the_ends(VelocityVerlet(), Driven{}, Driven::at(0.7));
  for (const double phi : {0.0, 0.5, 0.7, 1.0}) joins_the_ends(PhiFamily<>(phi), Coupled{}, Coupled::at(0.7));
  joins_the_ends(ForwardEuler(), Coupled{}, Coupled::at(0.7));
  FirstOrderPair pair;
  pair.a << 1.0, 3.0, -2.0, 1.0;
  joins_the_ends(Staggered({{.name = "one"}, {.name = "other"}}), pair, {.t = 0.7, .y = Eigen::Vector2d(1.0, 2.0)});
}

// Values alone, and motion alone, of a scheme that has both in hand from the run before.
BOOST_AUTO_TEST_CASE(leaves_out_what_the_problem_does_not_have) {
  RungeKutta4 scheme;
  State there;
  step(scheme, Coupled{}, Coupled::at(0.0), 0.5);
  const State motion = step(scheme, Spring{}, displaced(), 0.5);
  scheme.at(displaced(), 0.5, 1.0, there);
  BOOST_TEST(close(flat(there), flat(motion), {.relative = 4.0 * eps}));
  const State values = step(scheme, Decay{}, one(), 0.5);
  scheme.at(one(), 0.5, 1.0, there);
  BOOST_TEST(close(flat(there), flat(values), {.relative = 4.0 * eps}));
}

// A carried value stays; r = t^3/6 under a = t is met inside by the velocity alone: t^2/2.
BOOST_AUTO_TEST_CASE(of_verlet_is_the_parabola_of_the_velocity_and_carries_values) {
  VelocityVerlet scheme;
  State from = body(0.0, 0.0), there;
  from.y = Eigen::Vector2d(5.0, 6.0);
  step(scheme, Ramp{}, from, 2.0);
  scheme.at(from, 2.0, 0.25, there);
  BOOST_TEST(there.v[0] == 0.125);
  BOOST_TEST(there.y == from.y);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::dense_output_test
