#include <particulate/schemes/events.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "close.hpp"
#include "exact_fall.hpp"
#include "problems.hpp"
#include "says.hpp"

// Where events went unseen, came early or late, or were refused.
namespace tests::event_examples_test {

using namespace particulate::schemes;

using Function = std::function<double(const State&)>;

State at_rest(double height) { return {.r = Eigen::VectorXd::Constant(1, height), .v = Eigen::VectorXd::Zero(1)}; }

double height(const State& at) { return at.r[0]; }

struct Still {
  bool rate(double, In, Out dy) const {
    dy.setZero();
    return true;
  }
};

// The times at which a function of the time alone passes zero, in steps of one length from t0.
std::vector<double> passages(const Function& g, double t_end, double step, double t0 = 0.0) {
  State state{.t = t0, .y = Eigen::VectorXd::Zero(1)};
  Watch watch({{.function = g, .action = Action::record}});
  BOOST_TEST(
      (run(Still{}, state, t0 + t_end, RungeKutta4(), FixedStep{.step = step}, watch).status == Status::reached));
  std::vector<double> times;
  for (const Hit& hit : watch.hits()) times.push_back(hit.t);
  return times;
}

// A ball from 1 m with g = 2 m/s^2, thrown back with e of its speed: by a change at the event, or by hand.
struct Bounced {
  State ball = at_rest(1.0);
  Outcome outcome;
  double lowest = 0.0;
  std::size_t hits = 0;
};
Bounced bounced(double e, double t_end, bool by_hand) {
  Bounced made;
  const auto look = [&](const State&, const State& to, double, const auto&) {
    made.lowest = std::min(made.lowest, to.r[0]);
    return true;
  };
  Event ground{.function = height, .direction = Direction::falling};
  if (!by_hand) {
    ground.action = Action::record;
    ground.change = [e](State& at) {
      at.v *= -e;
      return Jump{.impacts = 1};
    };
  }
  Watch watch({ground});
  ExactFall scheme;
  FixedStep control{.step = 0.3};
  Falling problem;
  do {
    made.outcome = integrate(problem, made.ball, t_end, scheme, control, watch, look);
    if (made.outcome.status == Status::stopped) made.ball.v *= -e;
  } while (made.outcome.status == Status::stopped && watch.hits().size() < 1000);
  made.hits = watch.hits().size();
  return made;
}

BOOST_AUTO_TEST_SUITE(event)

BOOST_AUTO_TEST_CASE(is_seen_however_small_it_is_beside_the_start) {
  for (const double start : {1e10, 1e13, 1e100, 1e-200}) {
    const double level = start > 1.0 ? 1.0 : 1e-13 * start;
    for (int k = 0; k < 7; ++k) {
      State state{.y = Eigen::VectorXd::Constant(1, start)};
      Watch watch({{.function = [=](const State& at) { return at.y[0] - level; }, .direction = Direction::falling}});
      FixedStep control{.step = 0.02 + 0.07 * k / 6.0};
      const Outcome outcome = run(Decay{}, state, 300.0, Collocation<Gauss<4>>(), control, watch);
      BOOST_TEST((outcome.status == Status::stopped));
      BOOST_TEST(state.t == std::log(start / level), tolerance(1e-13));
    }
  }
}

template <class S>
void comes_down_in_time() {
  for (const double power : {1.0, 3.0, 5.0, 9.0}) {
    for (const double step : {0.07, 0.3, 0.999, 1.0, 4.0}) {
      State ball = at_rest(1.0);
      Watch watch({{.function = [=](const State& at) { return std::pow(height(at), power); },
                    .direction = Direction::falling}});
      BOOST_TEST((run(Falling{}, ball, 4.0, S(), FixedStep{.step = step}, watch).status == Status::stopped));
      BOOST_TEST(ball.t == 1.0, tolerance(1e-13));
    }
  }
}

BOOST_AUTO_TEST_CASE(of_a_flat_function_is_that_of_a_steep_one) {
  comes_down_in_time<ExactFall>();
  comes_down_in_time<Collocation<Gauss<3>>>();
  comes_down_in_time<RungeKutta4>();
  comes_down_in_time<VelocityVerlet>();
}

BOOST_AUTO_TEST_CASE(is_where_a_function_comes_to_a_stretch_of_zero_or_jumps) {
  for (const double step : {0.07, 0.1, 0.3, 1.0 / 3.0, 0.5, 2.0}) {
    const auto ends = passages([](const State& at) { return std::max(0.0, 1.0 - at.t); }, 3.0, step);
    BOOST_REQUIRE(ends.size() == 1U);
    BOOST_TEST(ends[0] == 1.0, tolerance(1e-14));
    const auto jumps = passages([](const State& at) { return at.t < 0.7 ? -1.0 : 1e-30; }, 3.0, step);
    BOOST_REQUIRE(jumps.size() == 1U);
    BOOST_TEST(jumps[0] == 0.7, tolerance(1e-14));
  }
}

BOOST_AUTO_TEST_CASE(comes_once_for_each_of_three_roots_in_one_step_in_any_unit) {
  for (const double unit : {1e-30, 1.0, 1e30}) {
    const auto roots =
        passages([=](const State& at) { return unit * (at.t - 0.2) * (at.t - 0.5) * (at.t - 0.8); }, 1.0, 1.0);
    BOOST_REQUIRE(roots.size() == 3U);
    for (const std::size_t k : {0U, 1U, 2U}) {
      BOOST_TEST(roots[k] == 0.2 + 0.3 * static_cast<double>(k), tolerance(1e-14));
    }
  }
}

// 1e6 + 1/30 s holds nine digits of the second; what rounding took from the time is in t_carry.
BOOST_AUTO_TEST_CASE(far_from_the_start_of_time_is_right_to_the_rounding_of_the_time) {
  const double t0 = 1e6, wait = 1.0 / 30.0;
  const auto times = passages([=](const State& at) { return (at.t - t0) + at.t_carry - wait; }, 1.0, 1e-4, t0);
  BOOST_REQUIRE(times.size() == 1U);
  BOOST_TEST(std::abs(times[0] - (t0 + wait)) <= 1.2e-10);
}

BOOST_AUTO_TEST_CASE(sends_a_ball_back_that_never_falls_through_the_ground) {
  for (const bool by_hand : {true, false}) {
    const Bounced losing = bounced(0.5, 10.0, by_hand);
    BOOST_TEST((losing.outcome.failure == Failure::accumulating));
    BOOST_TEST(losing.outcome.accumulation == 3.0, tolerance(1e-12));
    BOOST_TEST(losing.lowest >= -1e-15);
    const Bounced elastic = bounced(1.0, 9.5, by_hand);
    BOOST_TEST((elastic.outcome.status == Status::reached));
    BOOST_TEST(elastic.hits == 5U);
    BOOST_TEST(elastic.ball.r[0] == 0.75, tolerance(1e-12));
    const Bounced dead = bounced(0.0, 5.0, by_hand);
    BOOST_TEST((dead.outcome.failure == Failure::accumulating));
    // A hundred impacts of some roundings of a step each come before it is told.
    BOOST_TEST(dead.outcome.accumulation == 1.0, tolerance(1e-12));
  }
  BOOST_TEST(bounced(1.0, 9.5, false).outcome.impacts == 5);
}

BOOST_AUTO_TEST_CASE(may_not_leave_a_state_that_is_none) {
  const auto changed_by = [](const std::function<void(State&)>& change) {
    State ball = at_rest(1.0);
    const auto apply = [=](State& at) {
      change(at);
      return Jump{};
    };
    Watch watch({{.function = height, .change = apply, .name = "ground"}});
    return run(Falling{}, ball, 4.0, ExactFall(), FixedStep{.step = 0.3}, watch);
  };
  const std::string refused = "events: the change of ground must leave the time and the number of places";
  CHECK_REFUSED(changed_by([](State& at) { at.v[0] = std::numeric_limits<double>::quiet_NaN(); }), refused);
  CHECK_REFUSED(changed_by([](State& at) { at.r.resize(2); }), refused);
  CHECK_REFUSED(changed_by([](State& at) { at.t += 1.0; }), refused);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(time)

BOOST_AUTO_TEST_CASE(moves_by_what_the_physics_moves_by) {
  State spring{.t = 1.7e9, .r = Eigen::VectorXd::Ones(1), .v = Eigen::VectorXd::Zero(1)};
  const double omega = 2.0 * std::acos(-1.0);
  const Outcome outcome = run(Spring{omega * omega}, spring, 1.7e9 + 0.25, RungeKutta4(), FixedStep{.step = 1e-5});
  BOOST_TEST(outcome.steps == 25000);
  BOOST_TEST(std::abs(spring.r[0]) <= 1e-13);
}

BOOST_AUTO_TEST_CASE(is_made_of_as_many_steps_as_it_holds) {
  State still{.y = Eigen::VectorXd::Zero(1)};
  BOOST_TEST(run(Still{}, still, 1e5, RungeKutta4(), FixedStep{.step = 0.1}).steps == 1000000);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::event_examples_test
