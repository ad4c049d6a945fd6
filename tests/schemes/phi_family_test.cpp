#include <particulate/schemes/phi_family.hpp>

#include <algorithm>
#include <cmath>

#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/integrate.hpp>

#include "close.hpp"
#include "order.hpp"
#include "problems.hpp"

namespace tests::phi_family_test {

using namespace particulate::schemes;

struct Drag {
  double c = 1.0;
  bool acceleration(double, In, In v, Out a) const {
    a = -c * v;
    return true;
  }
};
// y' = cos t - y^2 + sin^2 t, solved by sin t.
struct Driven {
  bool rate(double t, In y, Out dy) const {
    dy[0] = std::cos(t) - y[0] * y[0] + std::sin(t) * std::sin(t);
    return true;
  }
};
// No value beyond t = 1.
struct Ending {
  bool acceleration(double t, In, Out a) const {
    a.setZero();
    return t <= 1.0;
  }
};

static_assert(Iterative<BackwardEuler> && Iterative<PhiFamily<Anderson>> && Advances<BackwardEuler, Spring> &&
              Advances<BackwardEuler, Drag> && Advances<PhiFamily<Anderson>, Decay>);

// One step to rounding.
template <class S, class P>
State stepped(S scheme, P problem, State state, double dt) {
  const Outcome outcome = run(problem, state, state.t + dt, scheme, FixedStep{.step = dt, .contractions = 100000});
  BOOST_TEST_REQUIRE(outcome.reason == "");
  return state;
}

template <class S>
double error_of_driven(S scheme, int steps) {
  State state = one(0.0);
  BOOST_REQUIRE(run(Driven{}, state, 1.3, scheme, FixedStep{.step = 1.3 / steps}).steps == steps);
  return std::abs(state.y[0] - std::sin(1.3));
}

// y' = i y.
struct Turning {
  bool rate(double, In y, Out dy) const {
    dy << -y[1], y[0];
    return true;
  }
};

// The largest number in the state over so many steps on a time scale of 1 s, or until it is all but zero; infinite if
// the run fails.
template <class C>
double largest_amplitude(double phi, TimeScale::Kind kind, C control, double steps = 3000.0) {
  PhiFamily<> scheme(phi);
  double largest = 0.0;
  const auto observe = [&](const State&, const State& to, double, const PhiFamily<>&) {
    const double now = flat(to).cwiseAbs().maxCoeff();
    largest = std::max(largest, now);
    return now > 1e-100;
  };
  State state = kind == TimeScale::Kind::decays ? one() : body(1.0, 0.0);
  const double t_end = steps * control.step;
  Outcome outcome;
  if (kind == TimeScale::Kind::waves) {
    state = {.y = Eigen::Vector2d(1.0, 0.0)};
    outcome = run(Turning{}, state, t_end, scheme, control, observe);
  } else {
    outcome = kind == TimeScale::Kind::decays ? run(Decay{}, state, t_end, scheme, control, observe)
                                              : run(Spring{}, state, t_end, scheme, control, observe);
  }
  return outcome.status != Status::failed ? largest : infinity;
}

template <class C>
int sweeps_of(const C& control) {
  if constexpr (FixesSweeps<C>) return control.sweeps;
  return 0;
}

// A hair within the limit nothing grows, a hair beyond it the state does or its sweeps are refused for diverging. The
// trapezoidal rule neither damps nor drives an oscillation, whose amplitude then swings as high as 1/sqrt(1 - z^2/4).
template <class C>
void spans_exactly(double phi, TimeScale::Kind kind, C control, double steps = 3000.0) {
  const double limit = PhiFamily<>(phi).spans(kind, sweeps_of(control));
  control.step = (1.0 - 1e-3) * limit;
  BOOST_TEST(largest_amplitude(phi, kind, control, steps) < 30.0);
  control.step = (1.0 + 1e-3) * limit;
  BOOST_TEST(largest_amplitude(phi, kind, control, steps) > 40.0);
}

BOOST_AUTO_TEST_SUITE(PhiFamily_)

// Backward Euler on r'' = -r from (1, 2) with Dt = 1/2: r = (1 + 1)/(1 + 1/4), v = (r - 1)/(1/2).
BOOST_AUTO_TEST_CASE(takes_the_step_of_the_monograph_at_phi_one) {
  const State to = stepped(BackwardEuler{}, Spring{}, body(1.0, 2.0), 0.5);
  BOOST_TEST(to.t == 0.5);
  BOOST_TEST(to.r[0] == 1.6, tolerance(1e-15));
  BOOST_TEST(to.v[0] == 1.2, tolerance(1e-15));
}

// Trapezoidal on r'' = -r, z = Dt/2 = 1/4: r = (r (1 - z^2) + 2 z v)/(1 + z^2), v = (v (1 - z^2) - 2 z r)/(1 + z^2).
BOOST_AUTO_TEST_CASE(takes_the_trapezoidal_step_at_one_half) {
  const State to = stepped(PhiFamily<>(0.5), Spring{}, body(1.0, 2.0), 0.5);
  BOOST_TEST(to.r[0] == (0.9375 + 1.0) / 1.0625, tolerance(1e-15));
  BOOST_TEST(to.v[0] == (1.875 - 0.5) / 1.0625, tolerance(1e-15));
}

// Unknowns R, V of one step with phi = 1/4, Dt = 1: V = 2 - (R + 3)/4, R = 1 + (V + 6)/4: R = 45/17, V = 2 - 24/17.
BOOST_AUTO_TEST_CASE(weighs_start_and_end_by_phi) {
  const State to = stepped(PhiFamily<>(0.25), Spring{}, body(1.0, 2.0), 1.0);
  BOOST_TEST(to.r[0] == 45.0 / 17.0, tolerance(1e-14));
  BOOST_TEST(to.v[0] == 2.0 - 24.0 / 17.0, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(is_forward_euler_at_phi_zero) {
  const State to = stepped(PhiFamily<>(0.0), Spring{}, body(1.0, 2.0), 0.5);
  BOOST_TEST(to.r[0] == 2.0);
  BOOST_TEST(to.v[0] == 1.5);
}

BOOST_AUTO_TEST_CASE(solves_forces_that_depend_on_velocities) {
  const State to = stepped(BackwardEuler{}, Drag{0.5}, body(1.0, 3.0), 0.5);
  BOOST_TEST(to.v[0] == 3.0 / 1.25, tolerance(1e-15));
  BOOST_TEST(to.r[0] == 1.0 + 0.5 * 3.0 / 1.25, tolerance(1e-15));
}

// Far from the origin positions are blind to a change of the velocity that is still going on.
BOOST_AUTO_TEST_CASE(sees_velocities_converge_where_positions_are_blind) {
  const State to = stepped(BackwardEuler{}, Drag{500.0}, body(1e12, 3.0), 1e-3);
  BOOST_TEST(to.v[0] == 3.0 / 1.5, tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(begins_with_free_flight_and_sweeps_force_then_velocity_then_position) {
  const Spring problem;
  BackwardEuler scheme;
  const State from = body(1.0, 2.0);
  State to = predicted(scheme, problem, from, 0.5);
  BOOST_TEST(to.r[0] == 2.0);
  BOOST_TEST(to.v[0] == 2.0);
  const Iteration first = scheme.sweep(problem, from, 0.5, to);
  BOOST_TEST(to.v[0] == 1.0);
  BOOST_TEST(to.r[0] == 1.5);
  BOOST_TEST(first.K == 0);
  BOOST_TEST(first.p == 2);
  BOOST_TEST(first.w_0 == 0.5 / 0.5);
  const Iteration second = scheme.sweep(problem, from, 0.5, to);
  BOOST_TEST(to.r[0] == 2.0 - 0.375);
  BOOST_TEST(second.rate == 0.25);
  BOOST_TEST(second.w_K == 0.125 / 0.5);
}

BOOST_AUTO_TEST_CASE(knows_the_exponent_of_its_contraction) {
  const Drag drag;
  const Decay decay;
  BackwardEuler scheme;
  State moved = predicted(scheme, drag, body(1.0, 2.0), 0.5);
  BOOST_TEST(scheme.sweep(drag, body(1.0, 2.0), 0.5, moved).p == 1);
  State values = predicted(scheme, decay, one(), 0.5);
  BOOST_TEST(scheme.sweep(decay, one(), 0.5, values).p == 1);
}

BOOST_AUTO_TEST_CASE(solves_first_order_problems) {
  for (const double phi : {1.0, 0.5}) {
    State state = one(2.0);
    BOOST_REQUIRE(run(Decay{}, state, 0.5, PhiFamily<>(phi), FixedStep{.step = 0.5}).steps == 1);
    BOOST_TEST(state.y[0] == 2.0 * (1.0 - 0.5 * (1.0 - phi)) / (1.0 + 0.5 * phi), tolerance(1e-15));
  }
}

BOOST_AUTO_TEST_CASE(has_order_one_and_order_two_at_one_half) {
  const std::vector<int> steps{40, 60, 90, 135, 200};
  const auto order_at = [&](double phi) {
    return observed_order([=](int n) { return error_of_driven(PhiFamily<>(phi), n); }, steps);
  };
  BOOST_TEST(std::abs(order_at(1.0) - 1.0) <= 0.2);
  BOOST_TEST(std::abs(order_at(0.7) - 1.0) <= 0.2);
  BOOST_TEST(std::abs(order_at(0.5) - 2.0) <= 0.2);
}

BOOST_AUTO_TEST_CASE(comes_to_the_same_step_by_anderson_and_where_picard_diverges) {
  for (const double phi : {1.0, 0.5}) {
    const State plain = stepped(PhiFamily<>(phi), Spring{}, body(1.0, 2.0), 0.5);
    const State mixed = stepped(PhiFamily<Anderson>(phi), Spring{}, body(1.0, 2.0), 0.5);
    BOOST_TEST(close(flat(mixed), flat(plain), {.relative = 1e-14}));
  }
  const State beyond = stepped(PhiFamily<Anderson>(), Spring{100.0}, body(1.0, 2.0), 0.5);
  BOOST_TEST(beyond.r[0] == 2.0 / 26.0, tolerance(1e-12));
  BOOST_TEST(beyond.v[0] == (beyond.r[0] - 1.0) / 0.5, tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(brings_nothing_of_one_step_into_the_next) {
  const Spring spring{4.0};
  PhiFamily<Anderson> used, fresh;
  swept(used, spring, body(-3.0, 7.0), 0.25, 2);
  State to = predicted(used, spring, body(1.0, 2.0), 0.5), again = predicted(fresh, spring, body(1.0, 2.0), 0.5);
  for (int k = 0; k < 2; ++k) {
    const Iteration one = used.sweep(spring, body(1.0, 2.0), 0.5, to);
    const Iteration other = fresh.sweep(spring, body(1.0, 2.0), 0.5, again);
    BOOST_TEST(to.r[0] == again.r[0]);
    BOOST_TEST(one.w_K == other.w_K);
    BOOST_TEST(one.rate == other.rate);
  }
}

BOOST_AUTO_TEST_CASE(asks_once_a_sweep_and_for_the_start_unless_phi_is_one) {
  for (const double phi : {1.0, 0.5}) {
    const Spring spring;
    long evaluations = 0;
    const Problem counted(spring, &evaluations);
    PhiFamily<> scheme(phi);
    State to = predicted(scheme, counted, body(1.0, 2.0), 0.5);
    BOOST_TEST(evaluations == (phi < 1.0 ? 1 : 0));
    scheme.sweep(counted, body(1.0, 2.0), 0.5, to);
    scheme.sweep(counted, body(1.0, 2.0), 0.5, to);
    BOOST_TEST(evaluations == (phi < 1.0 ? 3 : 2));
  }
}

BOOST_AUTO_TEST_CASE(says_that_there_is_no_value_at_the_start_or_at_an_iterate) {
  const Ending problem;
  State to;
  const State late = body(1.0, 2.0, 2.0);
  PhiFamily<> trapezoidal(0.5), backward;
  BOOST_TEST(!trapezoidal.predict(problem, late, 0.5, to));
  BOOST_TEST(backward.predict(problem, late, 0.5, to));
  BOOST_TEST(!backward.sweep(problem, late, 0.5, to).evaluated);
}

// Of one sweep it is the step that grows, of several and of those to convergence the sweeps that part, or the step.
BOOST_AUTO_TEST_CASE(spans_of_a_time_scale_what_its_sweeps_allow_and_no_more) {
  const FixedStep converged{.step = 1.0, .TOL = 1e-6, .contractions = 20000};
  for (const double phi : {1.0, 0.75, 0.5}) {
    for (const int sweeps : {1, 2, 3, 4}) {
      BOOST_TEST_CONTEXT("phi = " << phi << ", " << sweeps << " sweeps") {
        spans_exactly(phi, TimeScale::Kind::oscillates, FixedSweeps{.step = 1.0, .sweeps = sweeps});
        spans_exactly(phi, TimeScale::Kind::decays, FixedSweeps{.step = 1.0, .sweeps = sweeps});
      }
    }
    BOOST_TEST_CONTEXT("phi = " << phi << ", converged") {
      spans_exactly(phi, TimeScale::Kind::oscillates, converged, 100.0);
      spans_exactly(phi, TimeScale::Kind::decays, converged, 100.0);
    }
  }
}

// |1 + i z - phi z^2| <= 1 for two sweeps; one is forward Euler.
BOOST_AUTO_TEST_CASE(spans_waves_of_values_in_two_sweeps_or_more) {
  for (const double phi : {1.0, 0.75}) {
    BOOST_TEST(PhiFamily<>(phi).spans(TimeScale::Kind::waves, 1) == 0.0);
    BOOST_TEST(PhiFamily<>(phi).spans(TimeScale::Kind::waves, 2) == std::sqrt(2.0 * phi - 1.0) / phi);
    spans_exactly(phi, TimeScale::Kind::waves, FixedSweeps{.step = 1.0, .sweeps = 2}, 12000.0);
  }
  BOOST_TEST(largest_amplitude(1.0, TimeScale::Kind::waves, FixedSweeps{.step = 0.1, .sweeps = 1}) > 1e5);
  BOOST_TEST(largest_amplitude(0.5, TimeScale::Kind::waves, FixedSweeps{.step = 1.0, .sweeps = 2}) > 1e5);
  BOOST_TEST(PhiFamily<>(0.5).spans(TimeScale::Kind::waves, 2) == 0.0);
  BOOST_TEST(PhiFamily<>(0.4).spans(TimeScale::Kind::waves, 0) == 0.0);
}

// Below one half no step on an oscillation is stable, however small; of a decay 2/(1 - 2 phi), where the sweeps
// contract so far, and 2 where an odd number of them falls short of the fixed point.
BOOST_AUTO_TEST_CASE(spans_no_oscillation_below_one_half) {
  for (const int sweeps : {0, 1, 2, 3}) BOOST_TEST(PhiFamily<>(0.4).spans(TimeScale::Kind::oscillates, sweeps) == 0.0);
  BOOST_TEST(largest_amplitude(0.4, TimeScale::Kind::oscillates, FixedStep{.step = 0.3}) > 1e3);
  for (const double phi : {0.4, 0.3, 0.1, 0.0}) {
    for (const int sweeps : {1, 2, 3, 4, 5, 7}) {
      const double within = 0.999 * PhiFamily<>(phi).spans(TimeScale::Kind::decays, sweeps);
      BOOST_TEST_CONTEXT("phi = " << phi << ", " << sweeps << " sweeps") {
        BOOST_TEST(largest_amplitude(phi, TimeScale::Kind::decays, FixedSweeps{.step = within, .sweeps = sweeps}) <=
                   1.0);
      }
    }
  }
  spans_exactly(0.1, TimeScale::Kind::decays, FixedStep{.step = 1.0, .TOL = 1e-6});
  spans_exactly(0.0, TimeScale::Kind::decays, FixedStep{.step = 1.0, .TOL = 1e-6});
}

BOOST_AUTO_TEST_CASE(spans_what_relaxes_as_what_decays_and_minds_no_load) {
  for (const double phi : {1.0, 0.5, 0.1}) {
    const PhiFamily<> scheme(phi);
    for (const int sweeps : {0, 1, 2, 3}) {
      BOOST_TEST(scheme.spans(TimeScale::Kind::relaxes, sweeps) == scheme.spans(TimeScale::Kind::decays, sweeps));
      BOOST_TEST(scheme.spans(TimeScale::Kind::loads, sweeps) == infinity);
    }
  }
}

BOOST_AUTO_TEST_CASE(refuses_a_weight_that_is_none) {
  CHECK_REFUSED(PhiFamily<>(1.5), "phi must be in [0, 1], got 1.5");
  CHECK_REFUSED(PhiFamily<>(not_a_number), "got nan");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::phi_family_test
