#include <particulate/schemes/events.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/phi_control.hpp>

#include "close.hpp"
#include "exact_fall.hpp"
#include "problems.hpp"

namespace tests::events_test {

using namespace particulate::schemes;

// The first place, or without places the first value, less a level.
Events crossing(double level, Direction direction) {
  return {{.function = [level](const State& at) { return (at.r.size() > 0 ? at.r[0] : at.y[0]) - level; },
           .direction = direction}};
}
Events recorded(Events events) {
  for (Event& event : events) event.action = Action::record;
  return events;
}

struct Run {
  Outcome outcome;
  std::vector<Hit> hits;
  State state;
};
Run sine_until(double t_end, const Events& events, double step = 0.7, double start = 0.5) {
  Run made{.outcome = {}, .hits = {}, .state = sine_start(start)};
  Watch watch(events);
  made.outcome = run(Sine{}, made.state, t_end, ExactSine(), FixedStep{.step = step}, watch);
  made.hits = watch.hits();
  return made;
}

void meets(const std::vector<Hit>& hits, const std::vector<double>& times) {
  BOOST_REQUIRE(hits.size() == times.size());
  for (std::size_t k = 0; k < times.size(); ++k) BOOST_TEST(hits[k].t == times[k], tolerance(4e-15));
}

// g = 2 m/s^2 downwards.
State thrown(double height, double speed) {
  return {.t = 0.0, .r = Eigen::VectorXd::Constant(1, height), .v = Eigen::VectorXd::Constant(1, speed)};
}

// Where a stone comes down to a height.
Events landing(double height = 0.0) { return crossing(height, Direction::falling); }

// Thrown back from the ground with a part of its speed. The next impact is known in closed form, however soon it comes.
struct Bouncing : Falling {
  double e = 1.0;
  Jump jump(State& at, double) const {
    if (!(at.r[0] <= 1e-13 && at.v[0] < 0.0)) return {};
    at.v *= -e;
    at.r.setZero();
    return {.impacts = 1, .energy_change = 0.0, .unsettled = {}};
  }
  template <class Path>
  std::optional<double> first_jump(const Path& path, double end) const {
    State there;
    path(0.0, there);
    const double h = std::max(there.r[0], 0.0), v = there.v[0];
    const double theta = 0.5 * (v + std::sqrt(v * v + 4.0 * h)) / path.dt;
    return theta > 0.0 && theta <= end ? std::optional(theta) : std::nullopt;
  }
};

// Impacts after 1, 2, 2.5, 2.75, ... up to 3 s.
Bouncing losing() {
  Bouncing problem;
  problem.e = 0.5;
  return problem;
}

// Halves the step where it is refused.
struct Halving {
  double step;
  double dt() const { return step; }
  bool goes_on(const Iteration&) const { return false; }
  Decision judge(const Attempt& made) {
    if (made.iteration.evaluated) return {.accepted = true};
    step = 0.5 * made.dt;
    return {.accepted = false, .refusal = "no value"};
  }
};
void validate(const Halving&) {}

BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(accepts_no_events_and_events_with_a_function) {
  BOOST_CHECK_NO_THROW(validate(Events{}));
  BOOST_CHECK_NO_THROW(Watch(crossing(0.0, Direction::either), {.graze = 0.0, .most_at_once = 1}));
}

BOOST_AUTO_TEST_CASE(refuses_half_an_event) {
  CHECK_REFUSED(validate(Events{{.direction = Direction::rising}}), "events: event 0 needs a function");
  CHECK_REFUSED((Watch{Events{{.name = "the ground"}}}), "events: the ground needs a function");
  CHECK_REFUSED(validate(crossing(0.0, static_cast<Direction>(2))),
                "the direction of event 0 must be falling, either or rising, got number 2");
}

BOOST_AUTO_TEST_CASE(refuses_settings_that_cannot_be_meant) {
  for (const double bad : {-1e-12, 0.01, not_a_number}) {
    CHECK_REFUSED(validate(WatchSettings{.graze = bad}), "watch: graze must lie in [0, 1e-3], got ");
  }
  CHECK_REFUSED(validate(WatchSettings{.most_at_once = 0}), "watch: most_at_once must be at least 1, got 0");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(describe_)

BOOST_AUTO_TEST_CASE(says_which_event_and_how) {
  Events events = crossing(0.0, Direction::either);
  BOOST_TEST(describe(events, {.event = 0, .crossing = Direction::rising}) == "event 0 rising");
  events[0].name = "the ground";
  BOOST_TEST(describe(events, {.event = 0, .crossing = Direction::falling}) == "the ground falling");
  BOOST_TEST(describe(events, {.event = 0, .crossing = Direction::either}) == "the ground touching zero");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(integrate_with_a_watch)

// From 1 m at rest with g = 2 the ground is met at t = 1 with v = -2.
BOOST_AUTO_TEST_CASE(stops_cleanly_at_a_condition) {
  const Falling problem;
  for (const double blur : {0.0, 0.1, -0.1}) {
    State stone = thrown(1.0, 0.0);
    ExactFall scheme{.blur = blur};
    FixedStep control{.step = 0.3};
    Events events = landing();
    events[0].name = "the ground";
    Watch watch(events);
    const Outcome outcome = integrate(problem, stone, 5.0, scheme, control, watch);
    BOOST_TEST((outcome.status == Status::stopped));
    BOOST_TEST((outcome.failure == Failure::none));
    BOOST_TEST(outcome.reason == "the ground falling");
    BOOST_TEST(outcome.t == 1.0, tolerance(1e-15));
    BOOST_TEST(stone.t == outcome.t);
    BOOST_TEST(std::abs(stone.r[0]) < 1e-15);
    BOOST_TEST(stone.v[0] == -2.0, tolerance(1e-15));
    BOOST_TEST(outcome.steps == 4);
    BOOST_TEST(scheme.accepted == 4);
    BOOST_TEST(control.step == 0.3);
    BOOST_REQUIRE(watch.hits().size() == 1U);
    BOOST_TEST(watch.hits()[0].t == stone.t);
  }
}

// Solved anew only as often as needed: an exact path once, and every time it is counted.
BOOST_AUTO_TEST_CASE(counts_what_a_located_step_costs) {
  const Falling problem;
  const auto evaluations = [&](double blur) {
    State stone = thrown(1.0, 0.0);
    Watch watch(landing());
    return run(problem, stone, 5.0, ExactFall{.blur = blur}, FixedStep{.step = 0.3}, watch).evaluations;
  };
  BOOST_TEST(evaluations(0.0) == 5);
  BOOST_TEST(evaluations(0.1) > 6);
  BOOST_TEST(evaluations(0.1) < 15);
}

BOOST_AUTO_TEST_CASE(tells_directions_apart) {
  meets(sine_until(12.0, recorded(crossing(0.0, Direction::falling))).hits, {pi, 3.0 * pi});
  meets(sine_until(12.0, recorded(crossing(0.0, Direction::rising))).hits, {2.0 * pi});
  const Run either = sine_until(12.0, recorded(crossing(0.0, Direction::either)));
  meets(either.hits, {pi, 2.0 * pi, 3.0 * pi});
  BOOST_TEST((either.hits[0].crossing == Direction::falling));
  BOOST_TEST((either.hits[1].crossing == Direction::rising));
  BOOST_TEST((either.outcome.status == Status::reached));
  BOOST_TEST(either.state.t == 12.0);
}

// One step of 12 s covers all three.
BOOST_AUTO_TEST_CASE(finds_several_in_one_step_in_their_order) {
  meets(sine_until(12.0, recorded(crossing(0.0, Direction::either)), 11.5).hits, {pi, 2.0 * pi, 3.0 * pi});
}

BOOST_AUTO_TEST_CASE(takes_events_of_one_time_together_in_the_order_of_their_functions) {
  const Events three{{.function = [](const State& at) { return at.y[0] - 0.6; }},
                     {.function = [](const State& at) { return at.y[0] - 0.8; }, .direction = Direction::rising},
                     {.function = [](const State& at) { return 1.2 - 2.0 * at.y[0]; }}};
  State state = sine_start();
  Watch watch(three);
  const auto next = [&] { return run(Sine{}, state, 3.0, ExactSine(), FixedStep{.step = 0.7}, watch).reason; };
  BOOST_TEST(next() == "event 0 rising, event 2 falling");
  BOOST_TEST(state.t == std::asin(0.6), tolerance(1e-15));
  BOOST_TEST(next() == "event 1 rising");
  BOOST_TEST(state.t == std::asin(0.8), tolerance(1e-15));
  BOOST_TEST(next() == "event 0 falling, event 2 rising");
  BOOST_TEST(state.t == pi - std::asin(0.6), tolerance(1e-15));
  BOOST_TEST(next().empty());
  BOOST_TEST(watch.hits().size() == 5U);
}

BOOST_AUTO_TEST_CASE(stops_at_the_first_that_stops_and_remembers_the_others) {
  const Events events{{.function = [](const State& at) { return at.y[0] - 0.6; }, .action = Action::record},
                      {.function = [](const State& at) { return at.y[0] - 0.9; }}};
  const Run made = sine_until(10.0, events);
  BOOST_TEST((made.outcome.status == Status::stopped));
  BOOST_TEST(made.outcome.reason == "event 1 rising");
  meets(made.hits, {std::asin(0.6), std::asin(0.9)});
}

BOOST_AUTO_TEST_CASE(shows_the_observer_the_end_of_a_step_that_an_event_made) {
  State state = sine_start();
  Watch watch(recorded(crossing(0.0, Direction::either)));
  std::vector<double> seen;
  const auto observe = [&](const State& from, const State& to, double dt, const ExactSine&) {
    BOOST_TEST(from.t + dt == to.t, tolerance(1e-15));
    if (!watch.hits().empty() && watch.hits().back().t == to.t) seen.push_back(to.t);
    return true;
  };
  const Outcome outcome = run(Sine{}, state, 7.0, ExactSine(), FixedStep{.step = 0.7}, watch, observe);
  BOOST_TEST((outcome.status == Status::reached));
  BOOST_REQUIRE(seen.size() == 2U);
  BOOST_TEST(seen[0] == pi, tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(does_not_find_what_is_zero_at_the_start) {
  const Falling problem;
  State stone = thrown(0.0, 2.0);
  ExactFall scheme;
  FixedStep control{.step = 5.0};
  Watch watch(crossing(0.0, Direction::either));
  BOOST_TEST(integrate(problem, stone, 5.0, scheme, control, watch).reason == "event 0 falling");
  BOOST_TEST(stone.t == 2.0, tolerance(1e-15));
  // Left as it is, below the ground and still falling, it has nothing more to meet.
  BOOST_TEST((integrate(problem, stone, 5.0, scheme, control, watch).status == Status::reached));
  BOOST_TEST(watch.hits().size() == 1U);
}

// Sent back by the caller where it stopped, whichever side of zero rounding has left it on.
BOOST_AUTO_TEST_CASE(does_not_find_again_what_it_has_stopped_at) {
  const Falling problem;
  for (const double off : {0.0, 1e-15, -1e-15}) {
    State stone = thrown(1.0, 0.0);
    ExactFall scheme;
    FixedStep control{.step = 0.3};
    Watch watch(crossing(0.0, Direction::either));
    double t = 1.0;
    for (int bounce = 0; bounce < 5; ++bounce, t += 2.0) {
      BOOST_TEST(integrate(problem, stone, 20.0, scheme, control, watch).reason == "event 0 falling");
      BOOST_TEST(stone.t == t, tolerance(1e-13));
      stone.v = -stone.v;
      stone.r.array() += off;
    }
  }
}

BOOST_AUTO_TEST_CASE(takes_a_graze_for_one_event_and_a_near_miss_for_none) {
  for (const double step : {0.7, 0.31, 3.0}) {
    const Run touch = sine_until(3.0, recorded(crossing(1.0, Direction::rising)), step);
    BOOST_REQUIRE(touch.hits.size() == 1U);
    BOOST_TEST(touch.hits[0].t == pi / 2.0, tolerance(1e-10));
    BOOST_TEST((touch.hits[0].crossing == Direction::either));
    BOOST_TEST(sine_until(3.0, recorded(crossing(1.0, Direction::falling)), step).hits.empty());
    BOOST_TEST(sine_until(3.0, recorded(crossing(1.0 + 1e-9, Direction::either)), step).hits.empty());
    const Run two = sine_until(3.0, recorded(crossing(1.0 - 1e-9, Direction::either)), step);
    BOOST_REQUIRE(two.hits.size() == 2U);
    const double half = std::acos(1.0 - 1e-9);
    BOOST_TEST(two.hits[0].t == pi / 2.0 - half, tolerance(1e-10));
    BOOST_TEST(two.hits[1].t == pi / 2.0 + half, tolerance(1e-10));
    BOOST_TEST((two.hits[1].crossing == Direction::falling));
  }
  BOOST_TEST(sine_until(3.0, crossing(1.0, Direction::either)).outcome.reason == "event 0 touching zero");
}

// Thrown up to 1 m, within 1e-13. A dense output that is off by some 1e-5 m shows it above or below.
BOOST_AUTO_TEST_CASE(tells_a_graze_from_a_miss_by_a_step_solved_anew) {
  const Falling problem;
  for (const double blur : {0.0, 5e-5, -5e-5}) {
    for (const double step : {0.7, 1.3}) {
      const auto hits = [&](double height) {
        State stone = thrown(0.0, 2.0);
        Watch watch(recorded(crossing(height, Direction::either)));
        BOOST_TEST((run(problem, stone, 1.9, ExactFall{.blur = blur}, FixedStep{.step = step}, watch).status ==
                    Status::reached));
        return watch.hits();
      };
      BOOST_REQUIRE(hits(1.0).size() == 1U);
      BOOST_TEST((hits(1.0)[0].crossing == Direction::either));
      BOOST_TEST(hits(1.0)[0].t == 1.0, tolerance(1e-9));
      BOOST_TEST(hits(1.0 + 1e-9).empty());
      BOOST_TEST(hits(1.0 - 1e-6).size() == 2U);
    }
  }
}

BOOST_AUTO_TEST_CASE(counts_an_event_at_the_end_and_none_beyond_it) {
  BOOST_TEST((sine_until(pi - 1e-12, crossing(0.0, Direction::falling)).outcome.status == Status::reached));
  const Events clock{{.function = [](const State& at) { return at.t - 1.2; }}};
  for (const double step : {0.7, 0.35, 0.1}) {
    const Run at_the_end = sine_until(1.2, clock, step);
    BOOST_TEST((at_the_end.outcome.status == Status::stopped));
    BOOST_TEST(at_the_end.state.t == 1.2);
    BOOST_TEST(at_the_end.hits.size() == 1U);
  }
}

// Thrown 1 m high, the stone is seen at 1.005 m by a dense output that is 0.1 m too high: solved anew, it is not.
BOOST_AUTO_TEST_CASE(forgets_an_event_that_a_shorter_step_does_not_show) {
  State stone = thrown(0.0, 2.0);
  Watch watch(crossing(1.005, Direction::either));
  const Outcome outcome = run(Falling{}, stone, 1.9, ExactFall{.blur = 0.1}, FixedStep{.step = 2.0}, watch);
  BOOST_TEST((outcome.status == Status::reached));
  BOOST_TEST(watch.hits().empty());
  BOOST_TEST(outcome.steps > 1);
  BOOST_TEST(stone.r[0] == 2.0 * 1.9 - 1.9 * 1.9, tolerance(1e-13));
}

// The ground is met at 1 s, at 1e-9 s after a step; a path that is too low shows it before.
BOOST_AUTO_TEST_CASE(does_not_overstep_a_step_for_an_event_just_behind_it) {
  const Falling problem;
  for (const double end : {1.0 - 1e-9, 5.0}) {
    State stone = thrown(1.0, 0.0);
    Watch watch(landing());
    const Outcome outcome = run(problem, stone, end, ExactFall{.blur = -0.1}, FixedStep{.step = 1.0 - 1e-9}, watch);
    BOOST_TEST(stone.t == (end < 1.0 ? end : 1.0), tolerance(1e-15));
    BOOST_TEST((outcome.status == (end < 1.0 ? Status::reached : Status::stopped)));
  }
}

BOOST_AUTO_TEST_CASE(says_so_where_no_shorter_step_ends_at_what_it_saw) {
  struct Elusive : ExactSine {
    void at(const State& from, double dt, double theta, State& there) const {
      there.t = from.t + theta * dt;
      there.y = Eigen::VectorXd::Constant(1, 0.5 - theta);
    }
  } scheme;
  State state = sine_start();
  Watch watch(crossing(0.0, Direction::falling));
  const Outcome outcome = run(Sine{}, state, 3.0, scheme, FixedStep{.step = 0.7}, watch);
  BOOST_TEST((outcome.failure == Failure::not_located));
  BOOST_TEST(outcome.reason.find("from t = 0.5 s on a jump or an event was seen in the step, but no shorter step ends "
                                 "there") == 0U);
  BOOST_TEST(contains(outcome.reason, "still moves by 0.5 of itself; take smaller steps"));
  BOOST_TEST(state.t == 0.5);
}

// No value for steps below 0.2 s; the event lies 0.1 s into the step from 0.9 s.
struct NoShortSteps : ExactFall {
  double shortest = 0.2;
  template <class P>
  bool predict(P& problem, const State& from, double dt, State& to) {
    return ExactFall::predict(problem, from, dt, to) && dt >= shortest;
  }
};

BOOST_AUTO_TEST_CASE(ends_with_the_reason_where_the_shorter_step_has_no_value) {
  const Falling problem;
  State stone = thrown(1.0, 0.0);
  Watch watch(landing());
  const Outcome outcome = run(problem, stone, 5.0, NoShortSteps(), FixedStep{.step = 0.3}, watch);
  BOOST_TEST((outcome.status == Status::failed));
  BOOST_TEST((outcome.failure == Failure::no_value));
  BOOST_TEST(contains(outcome.reason, "no finite value within this step"));
  BOOST_TEST(stone.t == 0.9, tolerance(1e-15));
  BOOST_TEST(watch.hits().empty());
}

// Refused at 0.1 s, the step of 0.8 s from 0.8 s is tried again with what the controller makes of it.
BOOST_AUTO_TEST_CASE(tries_again_smaller_where_the_controller_refuses_the_shorter_step) {
  State stone = thrown(1.0, 0.0);
  NoShortSteps scheme;
  scheme.shortest = 0.04;
  Watch watch(landing());
  const Outcome outcome = run(Falling{}, stone, 5.0, scheme, Halving{.step = 0.97}, watch);
  BOOST_TEST(outcome.rejections > 0);
  BOOST_TEST((outcome.status == Status::failed));  // every way to the event ends in too short a step
  BOOST_TEST(contains(outcome.reason, "no value"));
  BOOST_TEST(stone.t < 1.0);
  BOOST_TEST(stone.r[0] == 1.0 - stone.t * stone.t, tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(leaves_the_controllers_step_alone_and_forgets_after_a_short_one) {
  const Sine problem;
  State state = sine_start();
  ExactSine scheme;
  FixedStep control{.step = 2.0};
  // 0.1 s into a step of 2 s: too little to extrapolate from. 1.9 s into one: enough.
  Watch watch(recorded({{.function = [](const State& at) { return at.t - 0.6; }},
                        {.function = [](const State& at) { return at.t - 2.5; }}}));
  BOOST_TEST(integrate(problem, state, 0.65, scheme, control, watch).steps == 2);
  BOOST_TEST(scheme.forgotten == 0);  // the step was 0.15 s long, to the end
  state = sine_start();
  Watch again = Watch(watch.events());
  BOOST_TEST(integrate(problem, state, 6.0, scheme, control, again).steps == 4);
  BOOST_TEST(scheme.forgotten == 1);
  BOOST_TEST(control.step == 2.0);
}

// The ground sends the stone back: its velocity passes zero in a jump, and is zero again at the top of its way.
BOOST_AUTO_TEST_CASE(takes_a_jump_across_zero_for_no_event) {
  State stone = thrown(1.0, 0.0);
  Watch watch(recorded({{.function = [](const State& at) { return at.v[0]; }}}));
  const Outcome outcome = run(Bouncing{}, stone, 6.5, ExactFall(), FixedStep{.step = 0.3}, watch);
  BOOST_TEST(outcome.impacts == 3);
  meets(watch.hits(), {2.0, 4.0, 6.0});
  for (const Hit& hit : watch.hits()) BOOST_TEST((hit.crossing == Direction::falling));
}

BOOST_AUTO_TEST_CASE(is_continued_to_the_same_bits_from_copies) {
  const Sine problem;
  const Events events = recorded({{.function = [](const State& at) { return at.y[0] - 0.3; }},
                                  {.function = [](const State& at) { return at.y[0] - 1.0; }}});
  State state = sine_start();
  ExactSine scheme;
  FixedStep control{.step = 0.7};
  Watch watch(events);
  int steps = 0;
  const auto stop_after_four = [&](const auto&...) { return ++steps < 4; };
  BOOST_TEST((integrate(problem, state, 9.0, scheme, control, watch, stop_after_four).status == Status::stopped));
  const std::vector<Hit> whole = sine_until(9.0, events).hits;
  BOOST_TEST(whole.size() == 4U);
  for (int copy = 0; copy < 2; ++copy) {
    State its_state = state;
    ExactSine its_scheme = scheme;
    FixedStep its_control = control;
    Watch its_watch = watch;
    BOOST_TEST((integrate(problem, its_state, 9.0, its_scheme, its_control, its_watch).status == Status::reached));
    BOOST_REQUIRE(its_watch.hits().size() == whole.size());
    for (std::size_t k = 0; k < whole.size(); ++k) BOOST_TEST(its_watch.hits()[k].t == whole[k].t);
  }
}

BOOST_AUTO_TEST_CASE(refuses_a_function_that_is_not_finite) {
  const Events events{{.function = [](const State&) { return 1.0; }},
                      {.function = [](const State& at) { return at.t > 1.0 ? not_a_number : 1.0; }}};
  CHECK_REFUSED(sine_until(3.0, events), "events: the function of event 1 must be finite, got nan at t = ");
}

BOOST_AUTO_TEST_CASE(passes_on_what_a_function_throws) {
  struct Odd {};
  const Events events{{.function = [](const State&) -> double { throw Odd{}; }}};
  BOOST_CHECK_THROW((void)sine_until(3.0, events), Odd);
}

BOOST_AUTO_TEST_CASE(without_events_is_the_run_without_a_watch) {
  const Run made = sine_until(3.0, Events{});
  BOOST_TEST((made.outcome.status == Status::reached));
  BOOST_TEST(made.outcome.steps == 4);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(located_jumps)

BOOST_AUTO_TEST_CASE(end_steps_and_make_the_scheme_forget) {
  const Bouncing problem = losing();
  State stone = thrown(1.0, 0.0);
  ExactFall scheme;
  FixedStep control{.step = 0.3};
  std::vector<double> impacts;
  const auto observe = [&](const State&, const State& to, double, const ExactFall&) {
    if (std::abs(to.r[0]) < 1e-13) impacts.push_back(to.t);
    return true;
  };
  const Outcome outcome = integrate(problem, stone, 2.9, scheme, control, observe);
  BOOST_TEST((outcome.status == Status::reached));
  BOOST_REQUIRE(impacts.size() == 5U);
  double left = 2.0;
  for (const double t : impacts) {
    BOOST_TEST(t == 3.0 - left, tolerance(1e-15));
    left *= 0.5;
  }
  BOOST_TEST(outcome.impacts == 5);
  BOOST_TEST(scheme.forgotten >= 5);
  BOOST_TEST(control.step == 0.3);
}

BOOST_AUTO_TEST_CASE(that_accumulate_end_the_run_with_the_time) {
  const Bouncing problem = losing();
  State stone = thrown(1.0, 0.0);
  const Outcome outcome = run(problem, stone, 10.0, ExactFall(), FixedStep{.step = 0.3});
  BOOST_TEST((outcome.status == Status::failed));
  BOOST_TEST((outcome.failure == Failure::accumulating));
  BOOST_TEST(outcome.accumulation == 3.0, tolerance(1e-12));
  BOOST_TEST(stone.t == outcome.accumulation);
  BOOST_TEST(outcome.reason.find("101 jumps or events in a row passed no time: they accumulate at t = ") == 0U,
             outcome.reason);
  BOOST_TEST(outcome.impacts < 200);
}

BOOST_AUTO_TEST_CASE(that_accumulate_are_counted_as_a_watch_says) {
  const Bouncing problem = losing();
  State stone = thrown(1.0, 0.0);
  Watch watch(Events{}, {.most_at_once = 5});
  const Outcome outcome = run(problem, stone, 10.0, ExactFall(), FixedStep{.step = 0.3}, watch);
  BOOST_TEST((outcome.failure == Failure::accumulating));
  BOOST_TEST(outcome.reason.find("6 jumps or events in a row") == 0U);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::events_test
