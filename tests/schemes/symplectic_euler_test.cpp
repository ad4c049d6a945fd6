#include <particulate/schemes/symplectic_euler.hpp>

#include <cmath>

#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/scheme.hpp>

#include "close.hpp"
#include "order.hpp"
#include "problems.hpp"

namespace tests::symplectic_euler_test {

using namespace particulate::schemes;

static_assert(Dense<SymplecticEuler> && Advances<SymplecticEuler, Damped> && !Advances<SymplecticEuler, Decay>);

// A spring whose bodies carry a value that decays.
struct SpringAndDecay {
  bool rates(double, In r, In, In y, Out a, Out dy) const {
    a = -r;
    dy = -3.0 * y;
    return true;
  }
};

double energy(const State& state) { return 0.5 * (state.r.squaredNorm() + state.v.squaredNorm()); }

// The amplitude that so many steps at omega Dt leave of the oscillator at r = 1.
double amplitude_after(double dt, int steps) {
  State state = displaced();
  const Outcome outcome = run(Spring{}, state, steps * dt, SymplecticEuler(), FixedStep{.step = dt});
  BOOST_REQUIRE(outcome.steps == steps);
  return std::abs(state.r[0]);
}

BOOST_AUTO_TEST_SUITE(SymplecticEuler_)

// a = -1 - 4 = -5 at (1, 4): v = 4 - 5/4, r = 1 + v/4.
BOOST_AUTO_TEST_CASE(takes_velocities_first_for_forces_of_velocities_too) {
  const State to = predicted(SymplecticEuler(), Damped{}, body(1.0, 4.0, 1.0), 0.25);
  BOOST_TEST(to.t == 1.25);
  BOOST_TEST(to.v[0] == 2.75);
  BOOST_TEST(to.r[0] == 1.6875);
}

// y = 8 - 3 8/4; r and v as without it.
BOOST_AUTO_TEST_CASE(carries_values_by_forward_euler) {
  const State to = predicted(SymplecticEuler(), SpringAndDecay{}, displaced(Eigen::VectorXd::Constant(1, 8.0)), 0.25);
  BOOST_TEST(to.y[0] == 2.0);
  BOOST_TEST(to.v[0] == -0.25);
  BOOST_TEST(to.r[0] == 0.9375);
}

BOOST_AUTO_TEST_CASE(has_order_one) {
  const auto error_after = [](int steps) {
    State state = Driven::at(0.0);
    const Outcome outcome = run(Driven{}, state, 1.7, SymplecticEuler(), FixedStep{.step = 1.7 / steps});
    BOOST_REQUIRE(outcome.steps == steps);
    return (flat(state) - flat(Driven::at(1.7))).norm();
  };
  BOOST_TEST(std::abs(observed_order(error_after, {1600, 2400, 3600, 5400, 8100}) - 1.0) <= 0.1);
}

// (r^2 + v^2 - Dt r v)/2 is what it keeps, so that the energy stays within Dt/(2 - Dt) of itself; forward Euler
// multiplies it by 1 + Dt^2 each step.
BOOST_AUTO_TEST_CASE(keeps_the_energy_of_an_oscillator_within_a_bound_for_ever) {
  const double dt = 0.1;
  State state = displaced();
  double least = 1.0, most = 0.0, kept = 0.0;
  const auto observe = [&](const State&, const State& to, double, const auto&) {
    least = std::min(least, energy(to)), most = std::max(most, energy(to));
    kept = std::max(kept, std::abs(2.0 * energy(to) - dt * to.r[0] * to.v[0] - 1.0));
    return true;
  };
  const Outcome outcome = run(Spring{}, state, 1e4, SymplecticEuler(), FixedStep{.step = dt}, observe);
  BOOST_TEST(outcome.steps == 100000);
  BOOST_TEST(most <= 0.5 * (1.0 + dt / (2.0 - dt)) + 1e-10);
  BOOST_TEST(least >= 0.5 * (1.0 - dt / (2.0 + dt)) - 1e-10);
  BOOST_TEST(most - least >= 0.9 * 0.5 * dt);  // it does swing so far: the bound is no loose one
  BOOST_TEST(kept <= 1e-10);
}

BOOST_AUTO_TEST_CASE(is_stable_on_an_oscillator_up_to_two_over_its_frequency) {
  BOOST_TEST(amplitude_after(1.999, 2000) < 100.0);
  BOOST_TEST(amplitude_after(2.001, 2000) > 1e10);
  BOOST_TEST(SymplecticEuler::spans(TimeScale::Kind{}, 0) == 2.0);
}

// v = (1 - c Dt)^n: at c Dt = 2 it turns for ever.
BOOST_AUTO_TEST_CASE(is_stable_under_drag_up_to_twice_its_time) {
  struct Drag {
    bool acceleration(double, In, In v, Out a) const {
      a = -v;
      return true;
    }
  };
  for (const double dt : {1.99, 2.01}) {
    State state = body(0.0, 1.0);
    const Outcome outcome = run(Drag{}, state, 1000 * dt, SymplecticEuler(), FixedStep{.step = dt});
    BOOST_REQUIRE(outcome.steps == 1000);
    BOOST_TEST(std::abs(state.v[0]) == std::pow(dt - 1.0, 1000), tolerance(1e-9));
  }
}

// Values take a step of forward Euler, which no step makes stable on a wave; what drifts it bears as that does.
BOOST_AUTO_TEST_CASE(spans_no_wave_of_values_and_minds_no_load) {
  using Kind = TimeScale::Kind;
  BOOST_TEST((SymplecticEuler::spans(Kind::waves, 0) == 0.0 && SymplecticEuler::spans(Kind::drifts, 0) == 1.0));
  BOOST_TEST((SymplecticEuler::spans(Kind::decays, 0) == 2.0 && SymplecticEuler::spans(Kind::relaxes, 0) == 2.0));
  BOOST_TEST(SymplecticEuler::spans(Kind::loads, 0) == std::numeric_limits<double>::infinity());
}

BOOST_AUTO_TEST_CASE(has_dense_output_that_is_a_shorter_step) {
  const State from = body(1.0, 4.0, 1.0);
  SymplecticEuler scheme;
  const State to = predicted(scheme, Damped{}, from, 0.5);
  State there;
  scheme.at(from, 0.5, 0.5, there);
  const State half = predicted(SymplecticEuler(), Damped{}, from, 0.25);
  BOOST_TEST(there.t == 1.25);
  BOOST_TEST(close(flat(there), flat(half), {}));
  scheme.at(from, 0.5, 0.0, there);
  BOOST_TEST(close(flat(there), flat(from), {}));
  scheme.at(from, 0.5, 1.0, there);
  BOOST_TEST(close(flat(there), flat(to), {}));
}

BOOST_AUTO_TEST_CASE(says_that_there_is_no_value) {
  Failing failing{1};
  SymplecticEuler scheme;
  State to;
  BOOST_TEST(!scheme.predict(failing, displaced(), 0.1, to));
}

BOOST_AUTO_TEST_CASE(asks_for_the_rates_once_a_step) {
  State state = displaced();
  BOOST_TEST(run(Spring{}, state, 1.0, SymplecticEuler(), FixedStep{.step = 0.1}).evaluations == 10);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::symplectic_euler_test
