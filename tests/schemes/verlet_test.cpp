#include <particulate/schemes/verlet.hpp>

#include <algorithm>
#include <cmath>

#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>

#include "close.hpp"
#include "order.hpp"
#include "problems.hpp"

namespace tests::verlet_test {

using namespace particulate::schemes;

double error_after(int steps) {
  const double t_end = 1.7;
  State state = Driven::at(0.0);
  const Outcome outcome = run(Driven{}, state, t_end, VelocityVerlet(), FixedStep{.step = t_end / steps});
  BOOST_REQUIRE(outcome.steps == steps);
  return (flat(state) - flat(Driven::at(t_end))).norm();
}

// One accepted step.
template <class P>
State stepped(VelocityVerlet& scheme, const P& problem, const State& from, double dt) {
  State to = predicted(scheme, problem, from, dt);
  scheme.accept(dt);
  return to;
}

void same_bits(const State& a, const State& b) {
  BOOST_TEST(a.t == b.t);
  BOOST_TEST(close(flat(a), flat(b), {}));
}

// What a scheme without history makes of the step: the same as one with history, unless that is stale.
template <class P>
void steps_as_if_new(VelocityVerlet scheme, const P& problem, const State& from) {
  VelocityVerlet fresh;
  same_bits(stepped(scheme, problem, from, 0.25), stepped(fresh, problem, from, 0.25));
}

BOOST_AUTO_TEST_SUITE(VelocityVerlet_)

// r'' = -r from (1, 0), Dt = 1/2: r = 1 - 1/8, v = -(1 + 7/8)/4.
BOOST_AUTO_TEST_CASE(takes_a_step_as_multiplied_out_by_hand) {
  VelocityVerlet scheme;
  const State to = stepped(scheme, Spring{}, displaced(), 0.5);
  BOOST_TEST(to.t == 0.5);
  BOOST_TEST(to.r[0] == 0.875);
  BOOST_TEST(to.v[0] == -0.46875);
}

// r = t^2/2 and r = t^3/6 against r'' = 1 and r'' = t: the second is met by v, not by r.
BOOST_AUTO_TEST_CASE(is_exact_for_constant_acceleration_only) {
  struct Ramp {
    double slope;
    bool acceleration(double t, In, Out a) const {
      a[0] = slope == 0.0 ? 1.0 : slope * t;
      return true;
    }
  };
  VelocityVerlet scheme;
  BOOST_TEST(stepped(scheme, Ramp{0.0}, body(0.0, 0.0), 3.0).r[0] == 4.5);
  scheme.forget();
  const State to = stepped(scheme, Ramp{1.0}, body(0.0, 0.0), 2.0);
  BOOST_TEST(to.v[0] == 2.0);
  BOOST_TEST(to.r[0] == 0.0);
}

BOOST_AUTO_TEST_CASE(has_order_two) {
  BOOST_TEST(std::abs(observed_order(error_after, {40, 60, 90, 135, 200, 300}) - 2.0) <= 0.2);
}

BOOST_AUTO_TEST_CASE(retraces_its_steps_when_velocities_are_turned) {
  struct Autonomous {
    bool acceleration(double, In r, Out a) const {
      a = -(r.array() * (1.0 + r.array().square())).matrix();
      return true;
    }
  } anharmonic;
  const State start = Driven::at(0.3);
  State state = start;
  state.t = 0.0;
  VelocityVerlet scheme;
  FixedStep control{.step = 0.125};
  BOOST_TEST(integrate(anharmonic, state, 5.0, scheme, control).steps == 40);
  BOOST_TEST((state.r - start.r).norm() > 0.01);
  state.v = -state.v;
  BOOST_TEST(integrate(anharmonic, state, 10.0, scheme, control).steps == 40);
  state.v = -state.v;
  BOOST_TEST(close(flat(state), flat(start), {.absolute = 1e-13}));
}

// Dt^2/4 of the energy comes and goes, none is lost: v^2 + r^2 (1 - Dt^2/4) is kept exactly.
BOOST_AUTO_TEST_CASE(keeps_the_energy_of_its_own_oscillator) {
  const Spring problem;
  State state = displaced();
  VelocityVerlet scheme;
  FixedStep control{.step = 0.5};
  const double kept = 1.0 - 0.0625;
  for (int k = 1; k <= 100; ++k) {
    BOOST_REQUIRE(integrate(problem, state, 5.0 * k, scheme, control).steps == 10);
    BOOST_TEST(state.v[0] * state.v[0] + kept * state.r[0] * state.r[0] == kept, tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(is_stable_on_an_oscillator_up_to_its_limit_only) {
  const Spring problem;
  for (const double factor : {0.99, 1.01}) {
    State state = displaced();
    FixedStep control{.step = factor * 2.0};
    BOOST_TEST(run(problem, state, 200.0 * control.step, VelocityVerlet(), control).steps == 200);
    BOOST_TEST((std::abs(state.r[0]) < 2.0) == (factor < 1.0));
  }
}

// At a hair within the limit that spans() gives the amplitude stays below 1/sqrt(1 - z^2/4) = 22; beyond it grows by
// exp(acosh(z^2/2 - 1)) = 1.09 a step.
BOOST_AUTO_TEST_CASE(spans_of_an_oscillation_what_it_can_and_no_more) {
  const Spring problem;
  for (const double factor : {1.0 - 1e-3, 1.0 + 1e-3}) {
    State state = displaced();
    FixedStep control{.step = factor * VelocityVerlet::spans(TimeScale::Kind::oscillates, 0)};
    double largest = 0.0;
    const auto observe = [&](const State&, const State& to, double, const VelocityVerlet&) {
      largest = std::max(largest, std::abs(to.r[0]));
      return true;
    };
    BOOST_TEST(run(problem, state, 2000.0 * control.step, VelocityVerlet(), control, observe).steps == 2000);
    BOOST_TEST((factor < 1.0 ? largest < 30.0 : largest > 1e60));
  }
  BOOST_TEST(std::isinf(VelocityVerlet::spans(TimeScale::Kind::decays, 0)));  // it advances none
}

BOOST_AUTO_TEST_CASE(asks_once_a_step_and_once_more_at_the_start) {
  const Spring problem;
  State state = displaced();
  VelocityVerlet scheme;
  FixedStep control{.step = 0.125};
  BOOST_TEST(integrate(problem, state, 2.0, scheme, control).evaluations == 17);
  BOOST_TEST(integrate(problem, state, 4.0, scheme, control).evaluations == 17);  // the problem may have changed
}

BOOST_AUTO_TEST_CASE(uses_no_stale_acceleration_where_positions_or_time_were_changed) {
  const Driven problem;
  VelocityVerlet scheme;
  const State kept = stepped(scheme, problem, Driven::at(0.0), 0.25);
  steps_as_if_new(scheme, problem, kept);
  State moved = kept;
  moved.r[0] = 3.0;
  steps_as_if_new(scheme, problem, moved);
  State later = kept;
  later.t += 1.0;
  steps_as_if_new(scheme, problem, later);
  State faster = kept;
  faster.v *= 2.0;
  steps_as_if_new(scheme, problem, faster);
  const State longer{.t = kept.t, .r = Eigen::VectorXd::Ones(7), .v = Eigen::VectorXd::Zero(7)};
  steps_as_if_new(scheme, Spring{}, longer);
}

BOOST_AUTO_TEST_CASE(forgets_a_problem_that_was_changed) {
  Spring problem;
  VelocityVerlet scheme;
  const State kept = stepped(scheme, problem, displaced(), 0.25);
  problem.stiffness = 4.0;
  scheme.forget();
  steps_as_if_new(scheme, problem, kept);
}

BOOST_AUTO_TEST_CASE(tries_a_refused_step_again_from_the_same_acceleration) {
  const Spring spring;
  long evaluations = 0;
  const Problem counted(spring, &evaluations);
  VelocityVerlet scheme;
  const State kept = stepped(scheme, counted, displaced(), 0.25);
  State refused;
  BOOST_TEST(scheme.predict(counted, kept, 0.5, refused));
  BOOST_TEST(evaluations == 3);
  const State again = stepped(scheme, counted, kept, 0.25);
  BOOST_TEST(evaluations == 4);
  VelocityVerlet fresh;
  same_bits(again, stepped(fresh, spring, kept, 0.25));
}

BOOST_AUTO_TEST_CASE(says_that_there_is_no_value_at_either_end) {
  for (int n = 1; n <= 3; ++n) {
    Failing problem{n};
    VelocityVerlet scheme;
    State to;
    BOOST_TEST(scheme.predict(problem, displaced(), 0.1, to) == (n == 3));
  }
}

BOOST_AUTO_TEST_CASE(continues_from_a_copy_to_the_same_bits) {
  const Driven problem;
  State whole = Driven::at(0.0), state = whole;
  VelocityVerlet scheme, other;
  FixedStep control{.step = 0.125};
  BOOST_TEST(integrate(problem, whole, 2.0, other, control).steps == 16);
  BOOST_TEST(integrate(problem, state, 1.0, scheme, control).steps == 8);
  State checkpoint = state;
  VelocityVerlet copied = scheme;
  BOOST_TEST(integrate(problem, state, 2.0, scheme, control).evaluations == 9);
  BOOST_TEST(integrate(problem, checkpoint, 2.0, copied, control).evaluations == 9);
  same_bits(checkpoint, state);
  same_bits(whole, state);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::verlet_test
