#include <particulate/reference/events.hpp>

#include <cmath>
#include <string>
#include <vector>

#include <particulate/reference/integrator.hpp>

#include "close.hpp"

namespace tests::events_test {

using namespace particulate::reference;
using namespace particulate::schemes;

// y' = cos t, y = sin t from t = 1/2.
struct Sine {
  long evaluations = 0;
  bool rate(double t, In, Out dy) {
    ++evaluations;
    dy[0] = std::cos(t);
    return true;
  }
};

constexpr double g = 9.81;
struct Falling {
  static bool acceleration(double, In, Out a) {
    a.setConstant(-g);
    return true;
  }
};
State at_height(double h) { return {.t = 0.0, .r = Eigen::VectorXd::Constant(1, h), .v = Eigen::VectorXd::Zero(1)}; }

// The first place, or without places the first value, less a level.
Events crossing(double level, Direction direction) {
  return {{.function = [level](const State& at) { return (at.r.size() > 0 ? at.r[0] : at.y[0]) - level; },
           .direction = direction}};
}

// Times of the events that the sine meets up to t_end.
std::vector<double> times_of(const Events& events, double t_end) {
  Sine problem;
  State state = sine_start();
  Integrator integrator(problem, state, Adams{.relative = 1e-12, .absolute = 1e-14, .largest_step = 0.5}, events);
  std::vector<double> times;
  while (integrator.advance(state, t_end).status == Status::stopped && times.size() < 100) times.push_back(state.t);
  BOOST_TEST(state.t == t_end, tolerance(0.0));
  return times;
}

void meets(const std::vector<double>& times, const std::vector<double>& expected) {
  BOOST_TEST_REQUIRE(times.size() == expected.size());
  for (std::size_t k = 0; k < times.size(); ++k) { BOOST_TEST(times[k] == expected[k], tolerance(1e-11)); }
}

BOOST_AUTO_TEST_SUITE(events)

// Dropped from h: impacts at sqrt(2h/g) (1 + 2e + ... + 2e^k), each at e times the speed of the one before.
BOOST_AUTO_TEST_CASE(impacts_of_a_bouncing_ball_meet_their_closed_form) {
  constexpr double h = 0.4, e = 0.8;
  for (const Direction direction : {Direction::falling, Direction::either}) {
    Falling problem;
    State ball = at_height(h);
    Integrator integrator(problem, ball, Adams{.relative = 1e-12, .absolute = 1e-14}, crossing(0.0, direction));
    const double fall = std::sqrt(2.0 * h / g);
    double t = fall, speed = g * fall;
    for (int impact = 0; impact < 12; ++impact) {
      const Outcome out = integrator.advance(ball, 100.0);
      BOOST_TEST_REQUIRE((out.status == Status::stopped));
      BOOST_TEST(out.reason == "event 0 falling");
      BOOST_TEST((out.t == ball.t && integrator.hits().size() == 1));
      BOOST_TEST(ball.t == t, tolerance(1e-11));
      BOOST_TEST(ball.v[0] == -speed, tolerance(1e-11));
      BOOST_TEST(std::abs(ball.r[0]) < 1e-12);
      ball.v *= -e;
      speed *= e;
      t += 2.0 * speed / g;
    }
  }
}

BOOST_AUTO_TEST_CASE(only_the_asked_direction_stops) {
  meets(times_of(crossing(0.0, Direction::falling), 12.0), {pi, 3.0 * pi});
  meets(times_of(crossing(0.0, Direction::rising), 12.0), {2.0 * pi});
  meets(times_of(crossing(0.0, Direction::either), 12.0), {pi, 2.0 * pi, 3.0 * pi});
}

BOOST_AUTO_TEST_CASE(several_events_are_told_apart) {
  // Two functions with one zero, and one that is zero elsewhere, between and again at the same time the other way.
  const Events three{{.function = [](const State& at) { return at.y[0] - 0.6; }},
                     {.function = [](const State& at) { return (at.y[0] - 0.8) * (at.t < 1.0 ? 1.0 : 2.0); },
                      .direction = Direction::rising},
                     {.function = [](const State& at) { return 1.2 - 2.0 * at.y[0]; }}};
  Sine problem;
  State state = sine_start();
  Integrator integrator(problem, state, Adams{.relative = 1e-12, .absolute = 1e-14, .largest_step = 0.25}, three);
  BOOST_TEST(integrator.hits().empty());

  BOOST_TEST(integrator.advance(state, 3.0).reason == "event 0 rising, event 2 falling");
  BOOST_TEST(state.t == std::asin(0.6), tolerance(1e-11));
  BOOST_TEST_REQUIRE(integrator.hits().size() == 2U);
  BOOST_TEST((integrator.hits()[0].event == 0 && integrator.hits()[0].crossing == Direction::rising));
  BOOST_TEST((integrator.hits()[1].event == 2 && integrator.hits()[1].crossing == Direction::falling));

  BOOST_TEST(integrator.advance(state, 3.0).reason == "event 1 rising");
  BOOST_TEST(state.t == std::asin(0.8), tolerance(1e-11));
  BOOST_TEST(integrator.advance(state, 3.0).reason == "event 0 falling, event 2 rising");
  BOOST_TEST(state.t == pi - std::asin(0.6), tolerance(1e-11));
  BOOST_TEST((integrator.advance(state, 3.0).status == Status::reached));
  BOOST_TEST(integrator.hits().empty());
}

BOOST_AUTO_TEST_CASE(an_event_does_not_stop_where_it_starts) {
  // Exactly zero at the start.
  Falling problem;
  State ball{.t = 0.0, .r = Eigen::VectorXd::Zero(1), .v = Eigen::VectorXd::Constant(1, g)};
  Integrator up(problem, ball, Adams{}, crossing(0.0, Direction::either));
  BOOST_TEST((up.advance(ball, 10.0).status == Status::stopped));
  BOOST_TEST(ball.t == 2.0, tolerance(1e-9));
  // Left as it is: below the ground and still falling, it never comes back.
  BOOST_TEST((up.advance(ball, 10.0).status == Status::reached));
}

// The second event lies within the rounding in which the first is still disregarded: it stops, and the first does not
// stop again after it.
BOOST_AUTO_TEST_CASE(an_event_that_has_stopped_does_not_stop_again_after_another_one_close_by) {
  Falling problem;
  State ball = at_height(0.4);
  const Events events{{.function = [](const State& at) { return at.r[0]; }},
                      {.function = [](const State& at) { return at.r[0] - 1e-14; }, .direction = Direction::rising}};
  Integrator integrator(problem, ball, Adams{.relative = 1e-12, .absolute = 1e-14}, events);
  std::vector<std::string> seen;
  for (int leg = 0; leg < 8; ++leg) {
    const Outcome out = integrator.advance(ball, 3.0);
    if (out.status != Status::stopped) break;
    seen.push_back(out.reason);
    if (integrator.hits()[0].event == 0) ball.v = -ball.v;
  }
  BOOST_TEST_REQUIRE(seen.size() == 8U);
  BOOST_TEST((seen[0] == "event 0 falling" && seen[1] == "event 1 rising" && seen[2] == "event 0 falling"));
  for (const std::string& one : seen) BOOST_TEST(one != "event 0 rising");
}

BOOST_AUTO_TEST_CASE(an_event_at_the_end_counts_and_one_beyond_it_does_not) {
  Sine problem;
  State state = sine_start();
  Integrator integrator(problem, state, Adams{.relative = 1e-12, .absolute = 1e-14}, crossing(0.0, Direction::falling));
  BOOST_TEST((integrator.advance(state, pi - 1e-6).status == Status::reached));
  BOOST_TEST(integrator.hits().empty());
  BOOST_TEST((integrator.advance(state, pi + 1e-6).status == Status::stopped));
  BOOST_TEST(state.t == pi, tolerance(1e-11));
  const Outcome rest = integrator.advance(state, 3.5);
  BOOST_TEST((rest.status == Status::reached && rest.t == 3.5));
  BOOST_TEST(state.y[0] == std::sin(3.5), tolerance(1e-10));

  // Where an advance ends exactly on a zero it has stopped there.
  state = sine_start();
  Integrator clocked(problem, state, Adams{}, {{.function = [](const State& at) { return at.t - 1.0; }}});
  BOOST_TEST(clocked.advance(state, 1.0).reason == "event 0 rising");
  BOOST_TEST((state.t == 1.0 && clocked.hits().size() == 1));
  BOOST_TEST((clocked.advance(state, 1.0).status == Status::reached));
  BOOST_TEST(clocked.hits().empty());
}

BOOST_AUTO_TEST_CASE(every_leg_counts_its_own_work) {
  Sine problem;
  State state = sine_start();
  Integrator integrator(problem, state, Adams{}, crossing(0.0, Direction::either));
  long evaluations = 0, steps = 0;
  for (int leg = 0; leg < 4; ++leg) {
    const Outcome out = integrator.advance(state, 12.0);
    BOOST_TEST((out.steps > 0 && out.evaluations >= out.steps));
    evaluations += out.evaluations, steps += out.steps;
  }
  BOOST_TEST(state.t == 12.0, tolerance(0.0));
  BOOST_TEST((evaluations == problem.evaluations && steps < evaluations));
}

BOOST_AUTO_TEST_CASE(what_an_event_function_throws_comes_out_as_it_was_thrown) {
  struct Odd {
    int number;
  };
  bool armed = true;
  const Events events{{.function = [&armed](const State& at) {
    if (armed && at.t > 1.0) throw Odd{.number = 7};
    return at.y[0];
  }}};
  Sine problem;
  State state = sine_start();
  Integrator integrator(problem, state, Adams{}, events);
  BOOST_CHECK_EXCEPTION((void)integrator.advance(state, 4.0), Odd, [](const Odd& odd) { return odd.number == 7; });
  BOOST_TEST(state.t == 0.5, tolerance(0.0));
  armed = false;
  BOOST_TEST((integrator.advance(state, 4.0).status == Status::stopped));
  BOOST_TEST(state.t == pi, tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(an_event_function_without_a_value_ends_the_run_and_says_where) {
  const Events events{{.function = [](const State&) { return 1.0; }},
                      {.function = [](const State& at) { return at.t > 1.0 ? not_a_number : 1.0; }}};
  Sine problem;
  State state = sine_start();
  Integrator integrator(problem, state, Adams{}, events);
  const Outcome out = integrator.advance(state, 4.0);
  BOOST_TEST((out.status == Status::failed && integrator.hits().empty()));
  BOOST_TEST(contains(out.reason, "CV_RTFUNC_FAIL: an event function has no finite value; write one"), out.reason);
  BOOST_TEST(contains(out.reason, "; an event function had no finite value at t = 1"), out.reason);
  BOOST_TEST(state.t < 2.0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(mistakes_in_events)

BOOST_AUTO_TEST_CASE(half_an_event_is_refused) {
  Sine problem;
  const State state = sine_start();
  CHECK_REFUSED(Integrator(problem, state, Adams{}, {{.direction = Direction::rising}}), "event 0 needs a function");
  CHECK_REFUSED(Integrator(problem, state, Adams{}, crossing(0.0, static_cast<Direction>(2))),
                "the direction of event 0 must be falling, either or rising, got number 2");
}

BOOST_AUTO_TEST_CASE(a_method_that_finds_no_events_refuses_them) {
  struct Nobody {
    static bool rate(double, In, Out) { return true; }
  } nobody;
  Sine problem;
  const Events events = crossing(0.0, Direction::either);
  CHECK_REFUSED(Integrator(problem, sine_start(), ExplicitRungeKutta{}, events),
                "events need the Adams or BDF methods and at least one unknown, got explicit "
                "Runge-Kutta and 1");
  CHECK_REFUSED(Integrator(nobody, State{.t = 0.0, .y = Eigen::VectorXd(0)}, Adams{}, events),
                "got Adams and 0 unknowns");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::events_test
