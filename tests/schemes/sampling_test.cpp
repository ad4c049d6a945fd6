#include <particulate/schemes/sampling.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "close.hpp"
#include "order.hpp"
#include "problems.hpp"

namespace tests::sampling_test {

using namespace particulate::schemes;

// The largest error of r_1 = cos t at times that no step ends at, in so many steps to 2 s.
template <class S>
double error_of(S scheme, int steps) {
  double error = 0.0;
  State state = Driven::at(0.0);
  Sampling samples({0.13, 0.77, 1.01, 1.57, 1.93},
                   [&](const State& at) { error = std::max(error, (flat(at) - flat(Driven::at(at.t))).norm()); });
  const Outcome outcome = run(Driven{}, state, 2.0, scheme, equal_steps<S>(2.0 / steps, 1e-12), samples);
  BOOST_REQUIRE(outcome.steps == steps);
  BOOST_REQUIRE(samples.left() == 0);
  return error;
}

template <class S>
void has_order(double order, const S& scheme) {
  const double seen = observed_order([&](int n) { return error_of(scheme, n); }, {37, 53, 79, 113, 167, 241, 353});
  BOOST_TEST(std::abs(seen - order) <= 0.3);
}

// Falls at 2 m/s^2 and is thrown back at the end of the step in which it came through the floor.
struct Bouncing : Falling {
  Jump jump(State& at, double) const {
    if (!(at.r[0] <= 0.0 && at.v[0] < 0.0)) return {};
    at.v = -at.v;
    return {.impacts = 1, .unsettled = {}};
  }
};

BOOST_AUTO_TEST_SUITE(Sampling_)

BOOST_AUTO_TEST_CASE(has_the_order_of_each_scheme) {
  has_order(4.0, RungeKutta4());
  has_order(2.0, VelocityVerlet());
  has_order(2.0, PhiFamily<>(0.5));
  has_order(1.0, BackwardEuler());
  has_order(1.0, ForwardEuler());
  has_order(3.0, Collocation<Gauss<2>>());  // its path inside has two nodes
}

// The same run, step for step, as without.
BOOST_AUTO_TEST_CASE(cuts_no_step_and_asks_for_no_right_hand_side) {
  State state = displaced(), plain = displaced();
  std::vector<double> seen;
  Sampling samples({0.1, 0.2, 0.3, 1.9}, [&](const State& at) { seen.push_back(at.t); });
  const Outcome outcome = run(Spring{}, state, 2.0, VelocityVerlet(), FixedStep{.step = 0.25}, samples);
  const Outcome without = run(Spring{}, plain, 2.0, VelocityVerlet(), FixedStep{.step = 0.25});
  BOOST_TEST(outcome.evaluations == without.evaluations);
  BOOST_TEST(close(flat(state), flat(plain), {}));
  BOOST_TEST(seen == std::vector<double>({0.1, 0.2, 0.3, 1.9}), boost::test_tools::per_element());
}

// The state itself, to the last bit; what lies beyond the end is still to come in the next part of the run.
BOOST_AUTO_TEST_CASE(gives_ends_of_steps_as_they_are_in_one_run_or_several) {
  State state = displaced();
  RungeKutta4 scheme;
  FixedStep control{.step = 0.25};
  std::vector<State> seen;
  Sampling samples({0.0, 0.5, 1.0, 1.25, 7.0}, [&](const State& at) { seen.push_back(at); });
  (void)run(Spring{}, state, 1.0, scheme, control, samples);
  BOOST_TEST(samples.left() == 2);
  BOOST_TEST(close(flat(seen.front()), flat(displaced()), {}));
  BOOST_TEST(close(flat(seen.back()), flat(state), {}));
  (void)run(Spring{}, state, 2.0, scheme, control, samples);
  BOOST_TEST(seen.back().t == 1.25);
  BOOST_TEST(samples.left() == 1);
}

// From 1 m at rest it meets the floor at 1 s with 2 m/s: exact in Verlet's dense output too.
BOOST_AUTO_TEST_CASE(gives_the_state_before_a_jump) {
  State state = displaced();
  std::vector<double> speeds;
  Sampling samples({1.0, 1.125}, [&](const State& at) { speeds.push_back(at.v[0]); });
  (void)run(Bouncing{}, state, 2.0, VelocityVerlet(), FixedStep{.step = 0.25}, samples);
  BOOST_TEST(speeds == std::vector<double>({-2.0, 1.75}), boost::test_tools::per_element());
}

// Late, in the middle of a step that the time can hardly tell: the fraction of the step takes the carry into account.
BOOST_AUTO_TEST_CASE(is_right_at_late_times) {
  const double start = 1e9;
  State state = body(1.0, 0.0, start);
  double off = 0.0;
  Sampling samples({start + 0.5, start + 3.0},
                   [&](const State& at) { off = std::max(off, std::abs(at.r[0] - std::cos(at.t - start))); });
  (void)run(Spring{}, state, start + 4.0, RungeKutta4(), FixedStep{.step = 1e-3}, samples);
  BOOST_TEST(samples.left() == 0);
  BOOST_TEST(off < 1e-11);
}

BOOST_AUTO_TEST_CASE(hands_every_step_on_to_an_observer_of_the_user) {
  State state = displaced();
  std::string order;
  const auto observe = [&](const State&, const State& to, double, const RungeKutta4&) {
    order += 'o';
    return to.t < 0.6;
  };
  Sampling samples(
      {0.1, 0.6, 0.9}, [&](const State&) { order += 's'; }, observe);
  BOOST_TEST((run(Spring{}, state, 2.0, RungeKutta4(), FixedStep{.step = 0.25}, samples).status == Status::stopped));
  BOOST_TEST(order == "sooso");
}

// The observer in std::ref() is the user's own, not a copy.
BOOST_AUTO_TEST_CASE(tells_the_observer_of_the_user_the_jumps) {
  struct Counting {
    long steps = 0, impacts = 0;
    bool operator()(const State&, const State&, double, const VelocityVerlet&) { return ++steps > 0; }
    void jumped(const State&, const Jump& jump) { impacts += jump.impacts; }
  } counting;
  const auto ignore = [](const State&) {};
  Sampling samples({0.5}, ignore, std::ref(counting));
  State state = displaced();
  (void)run(Bouncing{}, state, 2.0, VelocityVerlet(), FixedStep{.step = 0.25}, samples);
  BOOST_TEST(counting.steps == 8);
  BOOST_TEST(counting.impacts == 1);
  static_assert(!SeesJumps<decltype(Sampling({0.5}, ignore))>);
}

BOOST_AUTO_TEST_CASE(refuses_times_out_of_order_and_before_the_run) {
  const auto ignore = [](const State&) {};
  CHECK_REFUSED(Sampling({1.0, 0.5}, ignore), "each later than the one before, got 0.5 s after 1 s");
  CHECK_REFUSED(Sampling({0.0, 0.0}, ignore), "got 0 s after 0 s");
  CHECK_REFUSED(Sampling({0.0, not_a_number}, ignore), "got nan s after 0 s");
  State state = body(1.0, 0.0, 2.0);
  Sampling early({1.0, 2.5}, ignore);
  CHECK_REFUSED(run(Spring{}, state, 3.0, RungeKutta4(), FixedStep{.step = 0.25}, early),
                "must not lie before the start of the run at t = 2 s, got 1 s");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::sampling_test
