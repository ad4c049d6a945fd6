#include <particulate/schemes/multirate.hpp>

#include <cmath>
#include <vector>

#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/integrate.hpp>

#include "close.hpp"
#include "order.hpp"
#include "problems.hpp"
#include "says.hpp"

namespace tests::multirate_test {

using namespace particulate::schemes;

// A pendulum r_0, slow, that drives a stiff spring r_1, which is fast and pulls back a little.
struct PendulumAndSpring {
  double stiffness = 900.0, back = 0.0;
  bool all_is_fast = false;
  long asked = 0, splits = 0;

  bool acceleration(double, In r, Out a) {
    ++asked;
    a[0] = -std::sin(r[0]) + back * r[1];
    a[1] = -stiffness * r[1] + r[0] * r[0];
    return true;
  }
  bool split(const State&, double) {
    ++splits;
    return true;
  }
  bool acceleration_fast(double, In r, Out a) const {
    a[0] = all_is_fast ? -std::sin(r[0]) + back * r[1] : 0.0;
    a[1] = -stiffness * r[1] + (all_is_fast ? r[0] * r[0] : 0.0);
    return true;
  }
};

// r'' = t^2, of which nothing is fast.
struct Slow {
  bool acceleration(double t, In, Out a) const {
    a.setConstant(t * t);
    return true;
  }
  bool split(const State&, double) const { return true; }
  bool acceleration_fast(double, In, Out a) const {
    a.setZero();
    return true;
  }
};

static_assert(Iterative<Multirate<4>> && Dense<Multirate<4>> && EstimatesTruncation<Multirate<4>>);
static_assert(SplitsMotion<PendulumAndSpring> && !SplitsMotion<Spring>);
static_assert(Advances<Multirate<4>, PendulumAndSpring> && !Advances<Multirate<4>, Damped> &&
              !Advances<Multirate<4>, Decay>);

const State start{.t = 0.0, .r = Eigen::Vector2d(1.0, 0.002), .v = Eigen::Vector2d(0.3, 0.1)};

// By another scheme, in steps that resolve everything.
template <class P>
State reference(P problem, double t_end) {
  State state = start;
  const Outcome outcome = run(problem, state, t_end, Collocation<Gauss<8>>({.size = 1.0, .speed = 1.0, .sizes = {}}),
                              ErrorControl{.TOL = 1e-13, .sweep_TOL = 1e-15, .step = 1e-3, .limit = 0.02});
  BOOST_TEST_REQUIRE((outcome.status == Status::reached));
  return state;
}

template <int S, class P>
State by_multirate(P& problem, double t_end, int steps, int sweeps = 12, double TOL = 1e-13) {
  State state = start;
  const Outcome outcome = run(problem, state, t_end, Multirate<S>({.TOL = TOL, .size = 1.0, .speed = 1.0}),
                              FixedSweeps{.step = t_end / steps, .sweeps = sweeps});
  BOOST_TEST_REQUIRE((outcome.status == Status::reached));
  return state;
}

double error(const State& one, const State& other) {
  return std::max((one.r - other.r).cwiseAbs().maxCoeff(), (one.v - other.v).cwiseAbs().maxCoeff());
}

BOOST_AUTO_TEST_SUITE(Multirate_)

BOOST_AUTO_TEST_CASE(has_the_order_of_its_long_step_however_fast_the_rest_is) {
  const State exact = reference(PendulumAndSpring{}, 1.7);
  const auto order = [&](auto nodes, const std::vector<int>& steps) {
    return observed_order(
        [&](int n) {
          PendulumAndSpring problem;
          return std::abs(by_multirate<nodes.value>(problem, 1.7, n).r[0] - exact.r[0]);
        },
        steps);
  };
  BOOST_TEST(std::abs(order(std::integral_constant<int, 2>{}, {4, 6, 8, 12, 16}) - 4.0) <= 0.2);
  BOOST_TEST(std::abs(order(std::integral_constant<int, 3>{}, {6, 8, 10, 12, 15}) - 6.0) <= 0.2);
}

// A step of 0.34 s is eleven times 1/omega of the spring: the same nodes without a split are not near it.
BOOST_AUTO_TEST_CASE(follows_what_is_too_fast_for_its_step) {
  PendulumAndSpring problem;
  const State exact = reference(problem, 1.7);
  BOOST_TEST(error(by_multirate<6>(problem, 1.7, 5), exact) <= 1e-9);
  State other = start;
  (void)run(problem, other, 1.7, Collocation<Gauss<6>>({.size = 1.0, .speed = 1.0, .sizes = {}}),
            FixedSweeps{.step = 1.7 / 5, .sweeps = 12});
  BOOST_TEST(!(error(other, exact) <= 1e-3));
}

// r = 1 + 2 t + t^4/12: the polynomial of three nodes is the acceleration itself.
BOOST_AUTO_TEST_CASE(integrates_the_polynomial_of_its_nodes_exactly) {
  Slow problem;
  State state = body(1.0, 2.0);
  (void)run(problem, state, 1.5, Multirate<3>(), FixedSweeps{.step = 0.5, .sweeps = 1});
  BOOST_TEST(std::abs(state.r[0] - (4.0 + std::pow(1.5, 4) / 12.0)) <= 2e-15);
  BOOST_TEST(std::abs(state.v[0] - (2.0 + std::pow(1.5, 3) / 3.0)) <= 2e-15);
}

BOOST_AUTO_TEST_CASE(is_right_in_one_step_where_all_is_fast) {
  PendulumAndSpring problem{.stiffness = 30.0, .back = 0.5, .all_is_fast = true};
  BOOST_TEST(error(by_multirate<2>(problem, 1.7, 1, 1), reference(problem, 1.7)) <= 1e-11);
}

BOOST_AUTO_TEST_CASE(asks_for_the_whole_once_a_node_and_sweep) {
  PendulumAndSpring problem;
  (void)by_multirate<5>(problem, 1.7, 10, 2);
  // Once at the start, twice five for the guess of the first step.
  BOOST_TEST(problem.asked == 1 + 2 * 5 + 10 * 2 * 5);
  BOOST_TEST(problem.splits == 10);
}

BOOST_AUTO_TEST_CASE(has_dense_output_as_good_as_its_ends) {
  PendulumAndSpring problem;
  Multirate<6> scheme({.TOL = 1e-12, .size = 1.0, .speed = 1.0});
  const State to = swept(scheme, problem, start, 0.4, 8);
  BOOST_TEST(scheme.inner_steps() > 1U);
  const double at_end = error(to, reference(problem, 0.4));
  BOOST_TEST(at_end <= 1e-8);
  State there;
  scheme.at(start, 0.4, 0.0, there);
  BOOST_TEST(error(there, start) == 0.0);
  scheme.at(start, 0.4, 1.0, there);
  BOOST_TEST(there.t == 0.4);
  BOOST_TEST(error(there, to) <= 1e-14);
  for (const double theta : {0.03, 0.31, 0.77}) {
    scheme.at(start, 0.4, theta, there);
    BOOST_TEST(error(there, reference(problem, 0.4 * theta)) <= 10.0 * at_end);
  }
}

BOOST_AUTO_TEST_CASE(has_the_same_bits_in_two_runs_as_in_one_and_in_a_copy) {
  FixedSweeps control{.step = 0.125, .sweeps = 2};
  PendulumAndSpring problem{.back = 0.01};
  Multirate<4> whole, parts;
  State one = start, two = start;
  (void)run(problem, one, 1.0, whole, control);
  (void)run(problem, two, 0.5, parts, control);
  Multirate<4> copy = parts;
  State three = two;
  (void)run(problem, two, 1.0, parts, control);
  (void)run(problem, three, 1.0, copy, control);
  BOOST_TEST(error(one, two) == 0.0);
  BOOST_TEST(error(one, three) == 0.0);
}

BOOST_AUTO_TEST_CASE(begins_anew_with_a_changed_state_or_problem) {
  FixedSweeps control{.step = 0.125, .sweeps = 2};
  const auto asked_then = [&](const auto& change) {
    PendulumAndSpring problem;
    Multirate<4> scheme;
    State state = start;
    (void)run(problem, state, 0.125, scheme, control);
    change(problem, state);
    problem.asked = 0;
    (void)run(problem, state, 0.25, scheme, control);
    return problem.asked;
  };
  BOOST_TEST(asked_then([](auto&, auto&) {}) == 1 + 2 * 4);  // begin() asks once
  BOOST_TEST(asked_then([](auto&, State& state) { state.v[0] += 0.1; }) == 1 + 2 * 4 + 2 * 4);
  BOOST_TEST(asked_then([](auto& problem, auto&) { problem.back = 0.2; }) == 1 + 1 + 2 * 4 + 2 * 4);
}

// Errors of steps add up, and what the slow part does to the spring falls less fast than the estimate.
BOOST_AUTO_TEST_CASE(estimates_an_error_by_which_steps_are_chosen) {
  PendulumAndSpring problem;
  const State exact = reference(problem, 1.7);
  for (const double TOL : {1e-4, 1e-7, 1e-10}) {
    State state = start;
    const Outcome outcome = run(problem, state, 1.7, Multirate<4>({.TOL = 0.1 * TOL, .size = 1.0, .speed = 1.0}),
                                ErrorControl{.TOL = TOL, .sweep_TOL = TOL, .step = 1.0});
    BOOST_TEST((outcome.status == Status::reached));
    BOOST_TEST(error(state, exact) <= 100.0 * TOL);
  }
}

BOOST_AUTO_TEST_CASE(does_nothing_where_there_is_nothing) {
  struct Empty {
    bool acceleration(double, In, Out) const { return true; }
    bool split(const State&, double) const { return true; }
    bool acceleration_fast(double, In, Out) const { return true; }
  } problem;
  State state;
  const Outcome outcome = run(problem, state, 1.0, Multirate<3>(), ErrorControl{.step = 0.25});
  BOOST_TEST((outcome.status == Status::reached));
  BOOST_TEST(state.t == 1.0);
}

BOOST_AUTO_TEST_CASE(refuses_a_problem_that_it_cannot_split) {
  Spring problem;
  State state = displaced();
  CHECK_REFUSED(run(problem, state, 1.0, Multirate<3>(), FixedSweeps{.step = 0.1, .sweeps = 2}),
                "needs a problem that can split its acceleration");
}

BOOST_AUTO_TEST_CASE(refuses_settings_that_cannot_be_meant) {
  BOOST_CHECK_EXCEPTION(Multirate<3>({.TOL = 0.0}), std::invalid_argument, says("multirate collocation: TOL"));
  BOOST_CHECK_EXCEPTION(Multirate<3>({.size = -1.0}), std::invalid_argument, says("multirate collocation"));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::multirate_test
