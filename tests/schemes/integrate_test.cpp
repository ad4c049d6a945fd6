#include <particulate/schemes/integrate.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "close.hpp"
#include "problems.hpp"

namespace tests::integrate_test {

using namespace particulate::schemes;

// y' = y^2 leaves every bound at t = 1.
struct Explosion {
  bool rate(double, In y, Out dy) const {
    dy = y.cwiseAbs2();
    return true;
  }
};

// No value anywhere.
struct Hole {
  bool acceleration(double, In, Out) const { return false; }
};

// y' = 1 as long as t is not beyond a limit.
struct Limited {
  double limit;
  bool rate(double t, In, Out dy) const {
    dy.setOnes();
    return t <= limit;
  }
};

// A stone above a floor at 0, g = 2 m/s^2; the floor sends it back as fast as it came.
struct Bouncing {
  std::string unsettled;
  bool acceleration(double, In, Out a) const {
    a.setConstant(-2.0);
    return true;
  }
  Jump jump(State& at, double) const {
    if (!(at.r[0] <= 0.0 && at.v[0] < 0.0)) return {};
    at.v = -at.v;
    return {.impacts = 1, .energy_change = 0.0, .unsettled = unsettled};
  }
};

struct CountsForgetting : VelocityVerlet {
  int accepted = 0, forgotten = 0;
  void accept(double dt) {
    ++accepted;
    VelocityVerlet::accept(dt);
  }
  void forget() {
    ++forgotten;
    VelocityVerlet::forget();
  }
};

// Halves the step, to whatever it takes, where there is no value; says no where it is too small.
struct Halving {
  double step, smallest;
  std::vector<double> tried{};
  double dt() const { return step; }
  bool goes_on(const Iteration& it) const { return it.K < 2; }
  Decision judge(const Attempt& made) {
    tried.push_back(made.dt);
    if (made.iteration.evaluated) return {.accepted = true, .impossible = {}};
    step = 0.5 * made.dt;
    return {.accepted = false, .impossible = step < smallest ? "no smaller step is left" : ""};
  }
};
void validate(const Halving& control) {
  if (!(control.step > 0.0)) throw std::invalid_argument("halving: step must be positive");
}

// A controller with a mistake: it accepts whatever it is shown.
struct Gullible {
  double dt() const { return 0.5; }
  bool goes_on(const Iteration&) const { return false; }
  Decision judge(const Attempt&) { return {.accepted = true, .impossible = {}}; }
};
void validate(const Gullible&) {}

// Predicts by Euler's rule and sweeps without changing anything; contracts by 1/2 in the first step, 1/4 in later ones.
struct Sweeping {
  static constexpr int order = 1;
  int K = -1;
  static constexpr bool advances(const Traits& of) { return of.values; }
  bool predict(const Problem& problem, const State& from, double dt, State& to) {
    Rates rates;
    K = -1;
    if (!problem.rates(from.t + dt, from.r, from.v, from.y, rates)) return false;
    to = {.t = from.t + dt, .y = from.y + dt * rates.dy};
    return true;
  }
  Iteration sweep(const Problem& problem, const State& from, double, State& to) {
    Rates rates;
    const bool evaluated = problem.rates(to, rates);
    ++K;
    return {.rate = from.t == 0.0 ? 0.5 : 0.25, .K = K, .evaluated = evaluated};
  }
  void accept(double) {}
  void forget() {}
};

constexpr Traits motions{.motion = true}, values{.values = true};

BOOST_AUTO_TEST_SUITE(validate_run_)

BOOST_AUTO_TEST_CASE(accepts_a_run_of_no_length_and_a_state_of_no_length) {
  BOOST_CHECK_NO_THROW(validate_run(motions, displaced(), 0.0));
  BOOST_CHECK_NO_THROW(validate_run(motions, State{}, 1.0));
  BOOST_CHECK_NO_THROW(validate_run(values, State{}, 1.0));
}

BOOST_AUTO_TEST_CASE(refuses_times_that_cannot_be_meant) {
  for (const double bad : {not_a_number, infinity, -infinity}) {
    State motion = displaced();
    motion.t = bad;
    CHECK_REFUSED(validate_run(motions, motion, 1.0), "the start time must be finite, got ");
    CHECK_REFUSED(validate_run(values, one(1.0, bad), 1.0), "the start time must be finite");
    CHECK_REFUSED(validate_run(values, one(), bad), "the end time must be finite");
  }
  CHECK_REFUSED(validate_run(values, one(1.0, 2.0), 1.5), "not before the start at 2 s, got 1.5 s");
}

BOOST_AUTO_TEST_CASE(refuses_positions_and_velocities_of_different_lengths) {
  State motion = displaced();
  motion.v.resize(3);
  CHECK_REFUSED(validate_run(motions, motion, 1.0), "must have one length, got 1 and 3");
}

BOOST_AUTO_TEST_CASE(names_the_entry_that_is_not_finite) {
  const Eigen::Vector3d bad(0.0, 1.0, not_a_number), good = Eigen::Vector3d::Zero();
  CHECK_REFUSED(validate_run(motions, {.r = bad, .v = good}, 1.0), "positions must start finite, got nan in entry 2");
  CHECK_REFUSED(validate_run(motions, {.r = good, .v = bad}, 1.0), "velocities must start finite, got nan in entry 2");
  CHECK_REFUSED(validate_run(values, {.y = bad}, 1.0), "values must start finite, got nan in entry 2");
}

// What the problem would leave where it stands, without a word.
BOOST_AUTO_TEST_CASE(refuses_a_part_of_the_state_that_the_problem_does_not_have) {
  State both = displaced();
  both.y = Eigen::Vector2d(1.0, 2.0);
  CHECK_REFUSED(validate_run(motions, both, 1.0),
                "the problem has no rate for values, so the state must have none, got 2: give it rates(t, "
                "r, v, y, a, dy), or the constant values_by_jumps");
  CHECK_REFUSED(validate_run(values, both, 1.0),
                "a rate of values alone, so the state must have no places, got 1: they go into y");
  BOOST_CHECK_NO_THROW(validate_run({.motion = true, .values = true}, both, 1.0));
  BOOST_CHECK_NO_THROW(validate_run({.motion = true, .carries = true}, both, 1.0));
  BOOST_CHECK_NO_THROW(validate_run({.staggered = true}, both, 1.0));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(controller_)

BOOST_AUTO_TEST_CASE(must_not_accept_a_step_without_a_value) {
  State state = one();
  BOOST_CHECK_THROW((void)run(Limited{1.0}, state, 10.0, RungeKutta4(), Gullible{}), std::logic_error);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(attempt_)

// Keeps the attempts that it is shown, and makes two contractions of each where there are sweeps.
struct Keeping {
  int K = 0;
  std::vector<Attempt> made = {};
  double dt() const { return 0.5; }
  bool goes_on(const Iteration& it) const { return it.K < K; }
  Decision judge(const Attempt& attempt) {
    made.push_back(attempt);
    return attempt.iteration.evaluated ? Decision{.accepted = true} : Decision{.impossible = "no value"};
  }
};
void validate(const Keeping&) {}

BOOST_AUTO_TEST_CASE(makes_no_sweep_with_an_explicit_scheme) {
  State state = one();
  Keeping control;
  BOOST_TEST(run(Limited{1.0}, state, 0.5, RungeKutta4(), control).sweeps == 0);
  BOOST_TEST_REQUIRE(control.made.size() == 1U);
  const Attempt& made = control.made[0];
  BOOST_TEST(made.dt == 0.5);
  BOOST_TEST(made.fields.empty());
  BOOST_TEST(made.iteration.evaluated);
  BOOST_TEST(made.iteration.K == -1);
  BOOST_TEST(state.y[0] == 1.5);
}

BOOST_AUTO_TEST_CASE(sweeps_once_and_then_for_as_long_as_the_controller_asks) {
  const Limited problem{1.0};
  long sweeps = 0;
  for (const int K : {0, 2}) {
    State state = one();
    Keeping control{.K = K};
    sweeps += run(problem, state, 0.5, Sweeping(), control).sweeps;
    BOOST_TEST_REQUIRE(control.made.size() == 1U);
    BOOST_TEST(control.made[0].iteration.K == K);
  }
  BOOST_TEST(sweeps == 4);
}

BOOST_AUTO_TEST_CASE(does_not_take_an_infinite_state_for_a_value) {
  State state{.y = Eigen::VectorXd::Constant(1, 1e200)};
  Keeping control;
  BOOST_TEST(run(Explosion{}, state, 0.5, RungeKutta4(), control).reason == "no value");
  BOOST_TEST_REQUIRE(control.made.size() == 1U);
  BOOST_TEST(!control.made[0].iteration.evaluated);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(rounding_of_time_)

BOOST_AUTO_TEST_CASE(grows_with_the_steps_and_with_the_larger_time) {
  BOOST_TEST(rounding_of_time(0, 0.0, 2.0) == 2.0 * eps);
  BOOST_TEST(rounding_of_time(9, -8.0, 2.0) == 80.0 * eps);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(step_towards_end_)

BOOST_AUTO_TEST_CASE(is_the_wished_step_while_more_is_left) {
  BOOST_TEST(step_towards_end(0.25, 1.0, 0.0) == 0.25);
  BOOST_TEST(step_towards_end(0.25, 0.2500001, 0.0) == 0.25);
}

BOOST_AUTO_TEST_CASE(is_what_is_left_at_the_end) {
  BOOST_TEST(step_towards_end(0.25, 0.25, 0.0) == 0.25);
  BOOST_TEST(step_towards_end(0.25, 0.1, 0.0) == 0.1);
}

BOOST_AUTO_TEST_CASE(takes_a_remainder_within_rounding_with_it) {
  BOOST_TEST(step_towards_end(0.25, 0.25 + 1e-10, 0.0) == 0.25 + 1e-10);
  BOOST_TEST(step_towards_end(0.25, 0.25 + 1e-6, 1e-5) == 0.25 + 1e-6);
}

BOOST_AUTO_TEST_CASE(is_never_stretched_by_more_than_a_thousandth) {
  BOOST_TEST(step_towards_end(0.25, 0.2503, 1.0) == 0.25);
  BOOST_TEST(step_towards_end(0.25, 0.2502, 1.0) == 0.2502);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(too_small_)

BOOST_AUTO_TEST_CASE(names_the_time_the_step_and_what_to_do) {
  State state = one(1.0, 1e16);
  const std::string reason = run(Limited{infinity}, state, 2e16, RungeKutta4(), FixedStep{.step = 0.5}).reason;
  BOOST_TEST(contains(reason, "t = 1e+16 s and Dt = 0.5 s"));
  BOOST_TEST(contains(reason, "choose a larger step"));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(integrate_)

BOOST_AUTO_TEST_CASE(counts_what_it_does_and_lands_on_the_end) {
  State state = displaced();
  FixedStep control{.step = 0.3};
  const Outcome outcome = run(Spring{}, state, 1.0, RungeKutta4(), control);
  BOOST_TEST((outcome.status == Status::reached));
  BOOST_TEST(outcome.reason.empty());
  BOOST_TEST(outcome.steps == 4);
  BOOST_TEST(outcome.evaluations == 16);
  BOOST_TEST(outcome.rejections + outcome.sweeps + outcome.impacts == 0);
  BOOST_TEST(outcome.t == 1.0);
  BOOST_TEST(state.t == 1.0);
  BOOST_TEST(control.step == 0.3);
  BOOST_TEST(state.r[0] == std::cos(1.0), tolerance(1e-3));
}

// -1 + (0.1 + 1) is 0.1 + 8e-17 in doubles.
BOOST_AUTO_TEST_CASE(lands_on_the_end_where_the_sum_of_its_steps_does_not) {
  State state = one(1.0, -1.0);
  BOOST_TEST(run(Limited{infinity}, state, 0.1, RungeKutta4(), FixedStep{.step = 2.0}).steps == 1);
  BOOST_TEST(-1.0 + (0.1 + 1.0) != 0.1);
  BOOST_TEST(state.t == 0.1);
}

// Rounding of the time once made 9974 steps of pi/9973.
BOOST_AUTO_TEST_CASE(makes_n_steps_of_the_nth_part) {
  const Limited problem{infinity};
  for (const double start : {0.0, 100.0}) {
    for (const double length : {1.0, 0.3, std::numbers::pi, 7.1}) {
      for (const int n : {1, 3, 7, 10, 49, 1000, 3001, 9973, 30011}) {
        State state = one(1.0, start);
        const Outcome outcome = run(problem, state, start + length, Sweeping(), FixedStep{.step = length / n});
        BOOST_TEST_CONTEXT(n << " steps over " << length << " s from " << start) { BOOST_TEST(outcome.steps == n); }
        BOOST_TEST(state.t == start + length);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(shows_the_observer_consecutive_states) {
  State state = displaced();
  State last = state;
  std::vector<double> steps;
  const auto observe = [&](const State& from, const State& to, double dt, const VelocityVerlet&) {
    BOOST_TEST(from.t == last.t);
    BOOST_TEST(from.r[0] == last.r[0]);
    BOOST_TEST(to.t == from.t + dt, tolerance(1e-15));
    last = to;
    steps.push_back(dt);
    return true;
  };
  BOOST_TEST(run(Spring{}, state, 1.0, VelocityVerlet(), FixedStep{.step = 0.3}, observe).steps == 4);
  BOOST_REQUIRE(steps.size() == 4U);
  BOOST_TEST(steps[0] == 0.3);
  BOOST_TEST(steps[3] == 0.1, tolerance(1e-14));
  BOOST_TEST(last.t == 1.0);
  BOOST_TEST(last.r[0] == state.r[0]);
}

BOOST_AUTO_TEST_CASE(stops_where_the_observer_says_so) {
  State state = displaced();
  const auto observe = [](const State&, const State& to, double, const VelocityVerlet&) { return to.t < 0.5; };
  const Outcome outcome = run(Spring{}, state, 2.0, VelocityVerlet(), FixedStep{.step = 0.25}, observe);
  BOOST_TEST((outcome.status == Status::stopped));
  BOOST_TEST(outcome.reason == "the observer asked for it");
  BOOST_TEST(outcome.steps == 2);
  BOOST_TEST(outcome.t == 0.5);
  BOOST_TEST(state.t == 0.5);
}

BOOST_AUTO_TEST_CASE(fails_where_the_problem_has_no_value_and_leaves_the_last_state) {
  State state = one();
  const Outcome outcome = run(Limited{0.6}, state, 2.0, RungeKutta4(), FixedStep{.step = 0.25});
  BOOST_TEST((outcome.status == Status::failed));
  BOOST_TEST(contains(outcome.reason, "no finite value within this step of 0.25 s"));
  BOOST_TEST(outcome.steps == 2);
  BOOST_TEST(outcome.t == 0.5);
  BOOST_TEST(state.t == 0.5);
  BOOST_TEST(state.y[0] == 1.5);
}

BOOST_AUTO_TEST_CASE(refuses_a_state_that_overflows) {
  State state = one();
  const Outcome outcome = run(Explosion{}, state, 100.0, RungeKutta4(), FixedStep{.step = 0.5});
  BOOST_TEST((outcome.status == Status::failed));
  BOOST_TEST(contains(outcome.reason, "no finite value"));
  BOOST_TEST(state.t < 100.0);
  BOOST_TEST(outcome.t == state.t);
  BOOST_TEST(is_finite(state));
}

BOOST_AUTO_TEST_CASE(tries_again_with_what_the_controller_makes_of_a_refusal) {
  State state = one();
  Halving control{.step = 0.5, .smallest = 0.1};
  const Outcome outcome = run(Limited{0.8}, state, 1.0, RungeKutta4(), control);
  BOOST_TEST((outcome.status == Status::failed));
  BOOST_TEST(outcome.reason == "no smaller step is left");
  BOOST_TEST(outcome.steps == 2);
  BOOST_TEST(outcome.rejections == 2);
  BOOST_TEST(outcome.t == 0.75);
  BOOST_TEST(state.y[0] == 1.75);
  const std::vector<double> tried{0.5, 0.5, 0.25, 0.25, 0.125};
  BOOST_TEST(control.tried == tried, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(says_for_a_program_too_why_it_failed) {
  const auto failure_of = [](auto scheme, auto problem, auto state, double step) {
    return run(problem, state, 2.0 * state.t + 10.0, scheme, FixedStep{.step = step, .contractions = 20});
  };
  const Outcome diverged = failure_of(BackwardEuler{}, Spring{}, displaced(), 2.0);
  BOOST_TEST((diverged.status == Status::failed));
  BOOST_TEST((diverged.failure == Failure::diverging));
  BOOST_TEST(diverged.workable_step < 1.0);
  BOOST_TEST((failure_of(BackwardEuler{}, Spring{}, displaced(), 0.9).failure == Failure::slow));
  BOOST_TEST((failure_of(RungeKutta4{}, Limited{1.0}, one(), 0.75).failure == Failure::no_value));
  BOOST_TEST(
      (failure_of(RungeKutta4{}, Limited{infinity}, one(1.0, 1e20), 0.75).failure == Failure::time_stands_still));
  const Bouncing stuck{.unsettled = "it is stuck"};
  const Outcome jumped = failure_of(VelocityVerlet{}, stuck, displaced(), 0.25);
  BOOST_TEST((jumped.failure == Failure::unsettled_jump));
  BOOST_TEST(std::isnan(jumped.workable_step));
  BOOST_TEST((Outcome{}.failure == Failure::none));
}

BOOST_AUTO_TEST_CASE(keeps_the_reason_of_the_last_refusal_until_no_step_is_left) {
  State state = displaced();
  const Hole problem;
  state.t = 1.0;
  const Outcome outcome = run(problem, state, 2.0, BackwardEuler(), PhiControl{.step = 0.5, .limit = 0.5});
  BOOST_TEST((outcome.failure == Failure::no_value));
  BOOST_TEST(outcome.rejections > 40);
  BOOST_TEST(contains(outcome.reason, "no step is small enough"));
  BOOST_TEST(contains(outcome.reason, "the problem has no finite value within this step"));
}

BOOST_AUTO_TEST_CASE(counts_sweeps_and_the_largest_contraction) {
  State state = one();
  const Outcome outcome = run(Limited{1.0}, state, 1.0, Sweeping(), Halving{.step = 0.5, .smallest = 0.1});
  BOOST_TEST(outcome.steps == 2);
  BOOST_TEST(outcome.sweeps == 6);
  BOOST_TEST(outcome.evaluations == 8);
  BOOST_TEST(outcome.contraction == 0.5);
}

BOOST_AUTO_TEST_CASE(does_nothing_over_no_time) {
  State state = one(1.0, 3.0);
  const Outcome outcome = run(Limited{infinity}, state, 3.0, RungeKutta4(), FixedStep{.step = 0.5});
  BOOST_TEST((outcome.status == Status::reached));
  BOOST_TEST(outcome.steps + outcome.evaluations == 0);
  BOOST_TEST(outcome.t == 3.0);
  BOOST_TEST(state.y[0] == 1.0);
}

BOOST_AUTO_TEST_CASE(fails_where_a_step_does_not_change_the_time) {
  State state = one(1.0, 1e16);
  const Outcome outcome = run(Limited{infinity}, state, 2e16, RungeKutta4(), FixedStep{.step = 0.5});
  BOOST_TEST((outcome.status == Status::failed));
  BOOST_TEST(contains(outcome.reason, "the step must change the time"));
  BOOST_TEST(outcome.steps == 0);
  BOOST_TEST(state.t == 1e16);
}

BOOST_AUTO_TEST_CASE(takes_a_scheme_and_a_control_that_nobody_keeps) {
  const Spring problem;
  State named = displaced(), nobodys = displaced(), watched = displaced();
  VelocityVerlet scheme;
  FixedStep control{.step = 0.3};
  Watch none{Events{}};
  BOOST_TEST((integrate(problem, named, 1.0, scheme, control).status == Status::reached));
  BOOST_TEST((integrate(problem, nobodys, 1.0, VelocityVerlet(), FixedStep{.step = 0.3}).status == Status::reached));
  BOOST_TEST(
      (integrate(problem, watched, 1.0, VelocityVerlet(), FixedStep{.step = 0.3}, none).status == Status::reached));
  BOOST_TEST((nobodys.r == named.r && nobodys.v == named.v && watched.r == named.r));
}

BOOST_AUTO_TEST_CASE(refuses_what_cannot_be_meant) {
  const Limited problem{infinity};
  RungeKutta4 scheme;
  FixedStep control{.step = 0.5}, none;
  State state = one(), bad{.y = Eigen::VectorXd::Constant(1, not_a_number)};
  CHECK_REFUSED(integrate(problem, state, -1.0, scheme, control), "not before the start at 0 s, got -1 s");
  CHECK_REFUSED(integrate(problem, bad, 1.0, scheme, control), "values must start finite");
  CHECK_REFUSED(integrate(problem, state, 1.0, scheme, none), "step must be positive and finite");
  BOOST_TEST(state.t == 0.0);
}

BOOST_AUTO_TEST_CASE(passes_a_callers_mistake_on_with_the_last_state) {
  struct Throwing {
    bool rate(double t, In, Out dy) const {
      dy.setZero();
      if (t > 0.6) throw std::invalid_argument("thrown by the problem");
      return true;
    }
  } problem;
  State state = one();
  CHECK_REFUSED(run(problem, state, 1.0, RungeKutta4(), FixedStep{.step = 0.25}), "thrown by the problem");
  BOOST_TEST(state.t == 0.5);
}

// From 1 m at rest with g = 2: r = 1 - t^2, so the floor is met at t = 1 exactly, with v = -2, and again 2 s later.
BOOST_AUTO_TEST_CASE(lets_the_state_jump_after_a_step_and_tells_the_scheme) {
  State state = displaced();
  CountsForgetting scheme;
  std::vector<double> before;
  const auto observe = [&](const State&, const State& to, double, const CountsForgetting&) {
    before.push_back(to.v[0]);
    return true;
  };
  const Outcome outcome = run(Bouncing{}, state, 4.0, scheme, FixedStep{.step = 0.25}, observe);
  BOOST_TEST((outcome.status == Status::reached));
  BOOST_TEST(outcome.impacts == 2);
  BOOST_TEST(scheme.forgotten == 2);
  BOOST_TEST(scheme.accepted == 16);
  BOOST_TEST(outcome.evaluations == 19);  // one a step, one at the start, one after each impact
  BOOST_TEST(before[3] == -2.0);          // observed before the jump
  BOOST_TEST(state.r[0] == 1.0);
  BOOST_TEST(state.v[0] == 0.0);
}

// The same stone, seen from both sides of every jump: sixteen, of which two change anything.
BOOST_AUTO_TEST_CASE(tells_an_observer_each_jump_with_the_state_after_it) {
  struct Both {
    std::vector<double> before = {}, after = {};
    long impacts = 0;
    bool operator()(const State&, const State& to, double, const VelocityVerlet&) {
      before.push_back(to.v[0]);
      return true;
    }
    void jumped(const State& at, const Jump& jump) {
      BOOST_TEST(before.size() == after.size() + 1);
      after.push_back(at.v[0]);
      impacts += jump.impacts;
    }
  } both;
  static_assert(SeesJumps<Both>);
  State state = displaced();
  (void)run(Bouncing{}, state, 4.0, VelocityVerlet(), FixedStep{.step = 0.25}, both);
  BOOST_TEST(both.after.size() == 16);
  BOOST_TEST(both.before[3] == -2.0);
  BOOST_TEST(both.after[3] == 2.0);
  BOOST_TEST(both.after[2] == both.before[2]);
  BOOST_TEST(both.impacts == 2);
  both.after.clear();
  both.before.clear();
  state = displaced();
  (void)run(Spring{}, state, 1.0, VelocityVerlet(), FixedStep{.step = 0.25}, both);
  BOOST_TEST(both.before.size() == 4);
  BOOST_TEST(both.after.empty());  // what does not jump tells nothing
}

// The floor lies at 0.75 and takes half of the speed: steps of 0.25 end at v = -0.5, -1, -1.5, ... and r = 1 - t^2. At
// t = 0.5 the stone just touches it at -1 and leaves with 0.5: at r = 0.8125, v = 0, then at 0.75 with -0.5, which
// makes 0.25: at 0.75 with -0.25 and 0.125: 0.71875, -0.375, 0.03125 below.
BOOST_AUTO_TEST_CASE(sums_the_energy_and_the_evaluations_of_jumps_and_keeps_the_deepest_overlap) {
  struct Halved {
    bool acceleration(double, In, Out a) const {
      a.setConstant(-2.0);
      return true;
    }
    Jump jump(State& at, double) const {
      const double depth = 0.75 - at.r[0];
      if (!(depth >= 0.0 && at.v[0] < 0.0)) return {.overlap = std::max(depth, 0.0), .unsettled = {}};
      const double before = at.v[0];
      at.v *= -0.5;
      return {.impacts = 1,
              .energy_change = 0.5 * (at.v[0] * at.v[0] - before * before),
              .overlap = depth,
              .evaluations = 2,
              .unsettled = {}};
    }
  } problem;
  State state = displaced();
  const Outcome outcome = run(problem, state, 1.5, VelocityVerlet(), FixedStep{.step = 0.25});
  BOOST_TEST(outcome.impacts == 4);
  // -3/8 (1 + 1/4 + 1/16 + 9/64) of the squares of 1, 0.5, 0.25 and 0.375.
  BOOST_TEST(outcome.energy_change == -0.375 * (1.0 + 0.25 + 0.0625 + 0.140625));
  BOOST_TEST(outcome.overlap == 0.03125);
  // Six steps, the start, the three impacts after which a step follows, and two a jump with an impact.
  BOOST_TEST(outcome.evaluations == 6 + 1 + 3 + 8);
}

BOOST_AUTO_TEST_CASE(reports_nothing_of_jumps_without_any) {
  State state = displaced();
  const Outcome outcome = run(Spring{}, state, 1.0, VelocityVerlet(), FixedStep{.step = 0.25});
  BOOST_TEST(outcome.impacts == 0);
  BOOST_TEST(outcome.energy_change == 0.0);
  BOOST_TEST(outcome.overlap == 0.0);
}

BOOST_AUTO_TEST_CASE(fails_where_a_jump_is_not_settled_and_leaves_the_state_before_the_step) {
  State state = displaced();
  const Outcome outcome = run(Bouncing{"the stone sticks"}, state, 4.0, VelocityVerlet(), FixedStep{.step = 0.25});
  BOOST_TEST((outcome.status == Status::failed));
  BOOST_TEST(outcome.reason == "the stone sticks");
  BOOST_TEST(outcome.t == 0.75);
  BOOST_TEST(state.t == 0.75);
  BOOST_TEST(state.r[0] == 1.0 - 0.5625);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(step_limits_)

// A spring with two time scales of its own, as it says: the second becomes shorter from t = 1 on.
struct Scaled : Spring {
  double spring, drag;
  explicit Scaled(double of_spring = 0.1, double of_drag = 1.0) : spring(of_spring), drag(of_drag) {}
  std::vector<TimeScale> step_limits(const State& at) const {
    return {{.name = "the spring", .kind = TimeScale::Kind::oscillates, .seconds = spring},
            {.name = "drag", .kind = TimeScale::Kind::decays, .seconds = at.t < 1.0 ? drag : 0.1 * drag}};
  }
};

BOOST_AUTO_TEST_CASE(refuse_a_fixed_step_beyond_them_and_say_which_would_do) {
  const Scaled problem;
  VelocityVerlet scheme;
  FixedStep control{.step = 0.25};
  State state = displaced();
  const Outcome outcome = integrate(problem, state, 1.0, scheme, control);
  BOOST_TEST((outcome.status == Status::failed));
  BOOST_TEST((outcome.failure == Failure::beyond_limit));
  BOOST_TEST(outcome.workable_step == 0.2);
  BOOST_TEST(contains(outcome.reason,
                      "a step must span at most 2 of the time scale of the spring, which is 0.1 s, but the "
                      "fixed step is 0.25 s: take at most 0.2 s"));
  BOOST_TEST(outcome.ruled.empty());
  BOOST_TEST((outcome.steps == 0 && outcome.evaluations == 0 && state.t == 0.0));
  control.step = outcome.workable_step;
  BOOST_TEST((integrate(problem, state, 1.0, scheme, control).status == Status::reached));
}

BOOST_AUTO_TEST_CASE(cut_an_adaptive_step_and_name_what_ruled) {
  const Scaled problem;
  RungeKutta4 scheme;
  Halving control{.step = 0.5, .smallest = 0.1};
  State state = displaced();
  std::vector<double> steps;
  const auto observe = [&](const State&, const State&, double dt, const RungeKutta4&) {
    steps.push_back(dt);
    return true;
  };
  const Outcome until_1 = integrate(problem, state, 1.0, scheme, control, observe);
  BOOST_TEST((until_1.status == Status::reached));
  BOOST_TEST(until_1.ruled == "the spring");
  BOOST_TEST(steps[0] == 0.28284271247461903, tolerance(1e-15));
  BOOST_TEST(until_1.rejections == 0);
  steps.clear();
  const Outcome until_2 = integrate(problem, state, 2.0, scheme, control, observe);
  BOOST_TEST(until_2.ruled == "drag");
  BOOST_TEST(steps[0] == 0.2785293563405282, tolerance(1e-15));
  BOOST_TEST(control.step == 0.5);
}

BOOST_AUTO_TEST_CASE(leave_a_step_within_them_alone) {
  const Scaled wide(10.0, 100.0);
  const Spring none;
  const auto end_of = [](const auto& problem) {
    State state = displaced();
    const Outcome outcome = run(problem, state, 2.0, VelocityVerlet(), Halving{.step = 0.3, .smallest = 0.1});
    BOOST_TEST(outcome.ruled.empty());
    return std::pair(outcome.steps, state.r[0]);
  };
  BOOST_TEST((end_of(wide) == end_of(none)));
}

// Sweeps that converge bound the step by their contraction, one sweep by its own stability.
BOOST_AUTO_TEST_CASE(know_how_many_sweeps_the_control_makes) {
  const Scaled problem(1.0, 100.0);
  BackwardEuler scheme;
  State state = displaced();
  FixedSweeps once{.step = 1.1, .sweeps = 1}, twice{.step = 1.1, .sweeps = 2};
  BOOST_TEST((integrate(problem, state, 2.2, scheme, once).status == Status::reached));
  state = displaced();
  const Outcome two = integrate(problem, state, 2.2, scheme, twice);
  BOOST_TEST((two.failure == Failure::beyond_limit));
  BOOST_TEST(two.workable_step == 1.0);
  BOOST_TEST((run(problem, state, 2.2, scheme, FixedStep{.step = 1.1}).failure == Failure::beyond_limit));
}

// Values that turn as y' = i y, beside a decay. With w = 2 sqrt 2 * 0.1 s and d = 2.785 * 0.1 s the step is what solves
// (Dt/w)^2 + Dt/d = 1.
struct Turning {
  bool rate(double, In y, Out dy) const {
    dy << -y[1], y[0];
    return true;
  }
  std::vector<TimeScale> step_limits(const State&) const {
    return {{.name = "sound", .kind = TimeScale::Kind::waves, .seconds = 0.1},
            {.name = "diffusion", .kind = TimeScale::Kind::decays, .seconds = 0.1},
            {.name = "advection", .kind = TimeScale::Kind::drifts, .seconds = 1e-3}};
  }
};

struct Sharing : RungeKutta4 {
  static constexpr bool adds_limits = true;
};

BOOST_AUTO_TEST_CASE(are_shared_by_waves_and_decays) {
  const Turning problem;
  const double w = 0.28284271247461903, d = 0.2785293563405282;
  const double together = w * (std::sqrt(w * w / (4.0 * d * d) + 1.0) - w / (2.0 * d));
  State state{.y = Eigen::Vector2d(1.0, 0.0)};
  const Outcome outcome = run(problem, state, 1.0, Sharing(), FixedStep{.step = 0.25});
  BOOST_TEST((outcome.failure == Failure::beyond_limit));
  BOOST_TEST(outcome.workable_step == together, tolerance(1e-14));
  BOOST_TEST(contains(outcome.reason,
                      "of the time scale of diffusion, which is 0.1 s (with sound beside it, 0.1 s, "
                      "fewer), but the fixed step is 0.25 s: take at most 0.173"));
  BOOST_TEST((run(problem, state, 1.0, Sharing(), FixedStep{.step = together}).status == Status::reached));
  BOOST_TEST(run(problem, state, 2.0, RungeKutta4(), FixedStep{.step = 0.3}).workable_step == d, tolerance(1e-14));
}

// The same, of a body that weighs on what it relaxes to. What relaxes bounds Runge-Kutta alone, and shares nothing: its
// scheme has no part for it. Loads bound what bears them, and share with waves as decays do.
struct Loaded : Turning {
  std::vector<TimeScale> step_limits(const State&) const {
    return {{.name = "sound", .kind = TimeScale::Kind::waves, .seconds = 0.1},
            {.name = "drag", .kind = TimeScale::Kind::relaxes, .seconds = 1e-3},
            {.name = "weight", .kind = TimeScale::Kind::loads, .seconds = 0.1}};
  }
};
struct Sweeping : RungeKutta4 {
  static constexpr bool adds_limits = true;
  static double spans(TimeScale::Kind kind, int) { return kind == TimeScale::Kind::relaxes ? infinity : 1.0; }
};

// Dt^2/w^2 + Dt/d = 1 with w = d = 0.1: (sqrt(5) - 1)/2 of it.
BOOST_AUTO_TEST_CASE(count_loads_with_what_decays_and_what_relaxes_where_it_is_minded) {
  const Loaded problem;
  State state{.y = Eigen::Vector2d(1.0, 0.0)};
  const Outcome swept = run(problem, state, 1.0, Sweeping(), FixedStep{.step = 0.25});
  BOOST_TEST(swept.workable_step == 0.05 * (std::sqrt(5.0) - 1.0), tolerance(1e-14));
  BOOST_TEST(contains(swept.reason, "time scale of weight, which is 0.1 s (with sound beside it, 0.1 s, fewer)"));
  const Outcome stepped = run(problem, state, 1.0, RungeKutta4(), FixedStep{.step = 0.25});
  BOOST_TEST(stepped.workable_step == 2.785293563405282e-3, tolerance(1e-14));
  BOOST_TEST(contains(stepped.reason, "time scale of drag, which is 0.001 s, but"));
}

BOOST_AUTO_TEST_CASE(let_no_forward_euler_step_advance_a_wave) {
  State state{.y = Eigen::Vector2d(1.0, 0.0)};
  BOOST_TEST(run(Turning{}, state, 1.0, ForwardEuler(), FixedStep{.step = 1e-6}).workable_step == 0.0);
}

BOOST_AUTO_TEST_CASE(that_no_step_can_meet_fail_the_adaptive_one_too) {
  State state = displaced();
  const Outcome outcome = run(Scaled{}, state, 1.0, PhiFamily<>(0.25), PhiControl{.step = 0.1, .limit = 0.1});
  BOOST_TEST((outcome.failure == Failure::beyond_limit));
  BOOST_TEST(outcome.workable_step == 0.0);
}

// A scheme that says nothing of its stability is not held to them.
BOOST_AUTO_TEST_CASE(do_not_bind_a_scheme_that_has_no_such_limit) {
  Collocation<Gauss<3>> scheme;
  State state = displaced();
  BOOST_TEST((run(Scaled{}, state, 2.0, scheme, FixedStep{.step = 0.5}).status == Status::reached));
}

BOOST_AUTO_TEST_CASE(must_be_positive) {
  for (const double bad : {0.0, -1.0, not_a_number}) {
    const Scaled problem(0.1, bad);
    State state = displaced();
    CHECK_REFUSED(run(problem, state, 1.0, VelocityVerlet(), FixedStep{.step = 0.1}),
                  "problem: the time scale of drag must be positive, got ");
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::integrate_test
