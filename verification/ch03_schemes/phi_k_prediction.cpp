// What the controller proposes, where the model behind it is exact.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <particulate/schemes/iteration.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/sweeps.hpp>

#include "linear_problems.hpp"

namespace verification::phi_k_prediction {

using namespace particulate::schemes;

constexpr double omega = 3.0;
constexpr double decay_rate = 2.0;

// w_0 of a spring's step: the first change over the first displacement, both by hand.
double first_error(double phi, double dt, const State& from) {
  const double flight = from.r[0] + dt * from.v[0];
  const double kick = -phi * std::pow(omega * dt, 2) * (phi * flight + (1.0 - phi) * from.r[0]);
  return std::abs(kick) / std::abs(flight + kick - from.r[0]);
}

// Of every sweep whose error is above a hundred roundings: deviation of Dt Phi_K over what rounding allows. The error
// w_K is good to a rounding over itself, of which the p K-th root is taken.
double deviation(const Sweeps& swept, double dt, double expected, double TOL, int K_d, int& compared) {
  double worst = 0.0;
  for (const Iteration& it : swept.iterations) {
    if (it.K < 1 || !(it.w_K > 100.0 * std::max(eps, it.rounding))) continue;
    const double allowed = 16.0 * eps + 4.0 * std::max(eps, it.rounding) / it.w_K / (it.p * it.K);
    const double off = std::abs(dt * phi_K(it, TOL, K_d) / expected - 1.0) / allowed;
    keep_worst(worst, off);
    ++compared;
  }
  return worst;
}

constexpr std::array contractions{1, 2, 3, 5, 10, 25};
constexpr std::array tolerances{1e-2, 1e-6, 1e-12};
constexpr auto because = "in units of 16 eps and of four roundings of w_K under the p K-th root";

void compare_spring(Rows& rows, double phi) {
  const Oscillators spring = oscillator(omega);
  double worst = 0.0;
  int compared = 0;
  for (const double x : {0.03, 0.3, 0.8, 1.4}) {
    const double dt = x / (phi * omega);
    const State from = motion(0.6, 0.5 / dt);
    const Sweeps swept = sweep_by_hand(BackwardEuler(phi), spring, from, dt, 30);
    for (const int K_d : contractions) {
      for (const double TOL : tolerances) {
        const double expected = std::pow(TOL / first_error(phi, dt, from), 1.0 / (2.0 * K_d)) / (phi * omega);
        keep_worst(worst, deviation(swept, dt, expected, TOL, K_d, compared));
      }
    }
  }
  rows.at_most(fmt::format("Dt Phi_K on a spring, phi = {}, deviation from (TOL/w_0)^(1/(2 K_d))/(phi omega)", phi),
               {.limit = 1.0, .computed = worst, .because = because});
  rows.at_least(fmt::format("sweeps compared, phi = {}", phi),
                {.limit = 18.0 * 40.0,
                 .computed = static_cast<double>(compared),
                 .because = "30 beyond the limit, 30 below it at 0.8, some where rounding comes soon, each with 18 "
                            "settings"});
}

void compare_decay(Rows& rows) {
  const DragRate drag{.c = decay_rate, .m = 1.0};
  double worst = 0.0;
  int compared = 0;
  for (const double z : {0.01, 0.3, 0.8, 2.0}) {
    const double dt = z / decay_rate;
    const State from{.t = 0.0, .y = Eigen::VectorXd::Constant(1, 0.7)};
    const Sweeps swept = sweep_by_hand(BackwardEuler{}, drag, from, dt, 30);
    for (const int K_d : contractions) {
      for (const double TOL : tolerances) {
        keep_worst(worst, deviation(swept, dt, std::pow(TOL, 1.0 / K_d) / decay_rate, TOL, K_d, compared));
      }
    }
  }
  rows.at_most("Dt Phi_K on drag, deviation from TOL^(1/K_d) m/c",
               {.limit = 1.0, .computed = worst, .because = because});
  rows.at_least("sweeps compared on drag",
                {.limit = 18.0 * 60.0,
                 .computed = static_cast<double>(compared),
                 .because = "30 beyond the limit, 30 below it at 0.8, each with 18 settings"});
}

// A step whose w_0 is what it should be, whatever the step: with dt v = x^2 (1 + 1/w_0) and the flight ending at 1 the
// first change is x^2 and the first displacement x^2/w_0.
State with_first_error(double w_0, double dt) {
  const double flown = std::pow(omega * dt, 2) * (1.0 + 1.0 / w_0);
  return motion(1.0 - flown, flown / dt);
}

double proposed_by_run(double dt, double w_0, double TOL, int K_d) {
  Oscillators spring = oscillator(omega);
  State state = with_first_error(w_0, dt);
  BackwardEuler scheme;
  PhiControl control{.TOL = TOL, .K_d = K_d, .step = dt, .limit = 1e6, .growth = 1e6};
  require_reached(integrate(spring, state, dt, scheme, control));
  return control.step;
}

void compare_present_steps(Rows& rows) {
  constexpr double w_0 = 0.25, TOL = 1e-6;
  constexpr int K_d = 12;
  const double expected = std::pow(TOL / w_0, 1.0 / 24.0) / omega;
  for (const double x : {0.05, 0.2, 0.5}) {
    const double K = std::ceil(std::log(TOL / w_0) / (2.0 * std::log(x)));
    const double last_change = std::pow(x, 2.0 * K + 2.0);
    rows.compare(fmt::format("step proposed after a step of omega dt = {}, w_0 = {} [s]", x, w_0),
                 {.expected = expected,
                  .computed = proposed_by_run(x / omega, w_0, TOL, K_d),
                  .tolerance = relative(8.0 * eps / last_change / (2.0 * K)),
                  .because = "eight roundings of numbers near 1 in the last change, under the 2 K-th root"});
  }
}

const Case phi_k_prediction{
    {.name = "phi_k_prediction",
     .claim = "on a spring and on drag Phi_K proposes the same step whatever step it is measured at, and it is the one "
              "of the closed form",
     .equation = "R 3.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      for (const double phi : {1.0, 0.5, 0.7}) compare_spring(rows, phi);
      compare_decay(rows);
      compare_present_steps(rows);
    }};

// What four roundings of the positions are of the last change.
double rounding_of(const Sweeps& swept) {
  return 4.0 * eps * swept.iterates.back().r.lpNorm<1>() / changes(swept.iterates).back();
}

// A step made again with Phi_K Dt: its K_d-th error is TOL, but for the change of w_0 from one step to the other.
void compare_redo(Rows& rows, const std::string& what, const State& from) {
  constexpr double TOL = 1e-6;
  const Oscillators spring = oscillator(omega);
  double worst = 0.0;
  for (const int K_d : {2, 3, 5, 10}) {
    for (const double dt : {0.6 / omega, 0.95 / omega, 1.3 / omega}) {
      const Sweeps first = sweep_by_hand(BackwardEuler{}, spring, from, dt, K_d + 1);
      const double again = phi_K(first.iterations.back(), TOL, K_d) * dt;
      const Sweeps redo = sweep_by_hand(BackwardEuler{}, spring, from, again, K_d + 1);
      const double expected = TOL * first_error(1.0, again, from) / first_error(1.0, dt, from);
      const double allowed = 64.0 * eps + rounding_of(first) + rounding_of(redo);
      const double off = std::abs(redo.iterations.back().w_K / expected - 1.0) / allowed;
      keep_worst(worst, off);
    }
  }
  rows.at_most("w after K_d contractions of a redone step over TOL w_0'/w_0, " + what,
               {.limit = 1.0,
                .computed = worst,
                .because = "in units of four roundings of positions over the last change of either step"});
}

// The drag problem has w_0 = 1 at any step, so that a redone step meets TOL exactly, neither sooner nor later.
void compare_redone_run(Rows& rows) {
  constexpr int K_d = 8;
  const DragRate drag{.c = decay_rate, .m = 1.0};
  State state{.t = 0.0, .y = Eigen::VectorXd::Ones(1)};
  BackwardEuler scheme;
  const double z = 0.5, TOL = 1e-6;
  PhiControl control{.TOL = TOL, .K_d = K_d, .step = z / decay_rate, .limit = 1.0, .retry = 1.0 - 1e-12};
  std::vector<double> made;
  const auto watch = [&](const State&, const State&, double dt, const BackwardEuler&) {
    made.push_back(dt);
    return false;
  };
  const Outcome outcome = integrate(drag, state, 10.0, scheme, control, watch);
  rows.compare("step that was made again, TOL^(1/K_d) m/c [s]",
               {.expected = std::pow(TOL, 1.0 / K_d) / decay_rate,
                .computed = made.at(0),
                .tolerance = relative(1e-9),
                .because = "a rounding is 1e-9 of the last change, 1e-6 of a displacement of 0.2, under the eighth "
                           "root, in up to three tries"});
  rows.at_least("steps refused on the way",
                {.limit = 1, .computed = static_cast<double>(outcome.rejections), .because = "0.5^8 is above TOL"});
  rows.at_most("steps refused on the way, at most",
               {.limit = 3,
                .computed = static_cast<double>(outcome.rejections),
                .because = "one by the model; rounding may miss TOL by a hair once or twice"});
}

const Case phi_k_redo{
    {.name = "phi_k_redo",
     .claim = "a step made again with Phi_K Dt meets TOL in exactly K_d contractions, up to the change of w_0",
     .equation = "R 3.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      compare_redo(rows, "spring released at rest", motion(0.6, 0.0));
      compare_redo(rows, "moving spring", motion(0.3, 2.0));
      compare_redone_run(rows);
    }};

// The step that the controller sets after an iteration that is made up: K contractions from w_0 to w_K.
PhiControl judged(const PhiControl& before, double dt, double w_0, double w_K, int K, bool& accepted) {
  PhiControl control = before;
  accepted = control.judge({.dt = dt, .iteration = {.w_0 = w_0, .w_K = w_K, .change = w_K, .K = K, .p = 2}}).accepted;
  return control;
}

void compare_bound(Rows& rows, const std::string& which, double dt, double w_K, bool met, double expected) {
  const PhiControl before{
      .TOL = 1e-4, .K_d = 4, .step = 0.5, .limit = 0.9, .growth = 1.5, .retry = 0.8, .shrink = 0.25};
  bool accepted = !met;
  const PhiControl control = judged(before, dt, 1.0, w_K, 4, accepted);
  rows.compare("next step, " + which + " [s]", {.expected = expected,
                                                .computed = control.step,
                                                .tolerance = relative(8.0 * eps),
                                                .because = "two roots and a product"});
  rows.equal("accepted, " + which, {.expected = met, .computed = accepted, .because = "w_K <= 1e-4 or not"});
}

// With TOL = 1e-4, w_0 = 1, K = K_d = 4, p = 2: Phi_K = (1e-4/w_K)^(1/8).
void compare_bounds(Rows& rows) {
  compare_bound(rows, "met with Phi_K = 1.2", 0.5, 1e-4 / std::pow(1.2, 8), true, 0.6);
  compare_bound(rows, "met with Phi_K = 1", 0.5, 1e-4, true, 0.5);
  compare_bound(rows, "met with Phi_K = 3: growth", 0.5, 1e-4 / std::pow(3.0, 8), true, 0.75);
  compare_bound(rows, "met exactly, Phi_K infinite: growth", 0.5, 0.0, true, 0.75);
  compare_bound(rows, "met with Phi_K = 1.4 at 0.7: limit", 0.7, 1e-4 / std::pow(1.4, 8), true, 0.9);
  compare_bound(rows, "missed with Phi_K = 0.5", 0.5, 1e-4 * 256.0, false, 0.25);
  compare_bound(rows, "missed with Phi_K = 0.95: retry", 0.5, 1e-4 / std::pow(0.95, 8), false, 0.4);
  compare_bound(rows, "missed with Phi_K = 0.1: shrink", 0.5, 1e4, false, 0.125);
  compare_bound(rows, "a step cut short that met TOL", 0.2, 1e-4 / std::pow(1.2, 8), true, 0.5);
  compare_bound(rows, "a step cut short that missed TOL, Phi_K = 0.5", 0.2, 1e-4 * 256.0, false, 0.1);
}

// Steps of a run that starts with nothing moving: 0/0 is no reason to stay small.
void compare_rest(Rows& rows) {
  Oscillators spring = oscillator(omega);
  State state = motion(0.0, 0.0);
  BackwardEuler scheme;
  PhiControl control{.step = 1.0 / 64.0, .limit = 0.1};
  std::vector<double> steps;
  const auto watch = [&](const State&, const State&, double dt, const BackwardEuler&) {
    steps.push_back(dt);
    return steps.size() < 6;
  };
  const Outcome outcome = integrate(spring, state, 10.0, scheme, control, watch);
  const std::array expected{1.0 / 64.0, 1.0 / 32.0, 1.0 / 16.0, 0.1, 0.1, 0.1};
  rows.compare("steps where nothing moves, largest deviation from doubling up to the limit",
               {.expected = 0.0,
                .computed = mixed_error(steps, expected, 1.0),
                .tolerance = absolute(0.0),
                .because = "doubling is exact"});
  rows.equal("sweeps where nothing moves",
             {.expected = 6, .computed = outcome.sweeps, .because = "the first shows that there is nothing to do"});
}

// To land on the end the last step is cut short; the controller keeps the longer one for the next run.
void compare_landing(Rows& rows) {
  const DragRate drag{.c = 1e-3, .m = 1.0};
  State state{.t = 0.0, .y = Eigen::VectorXd::Ones(1)};
  BackwardEuler scheme;
  PhiControl control{.step = 0.25, .limit = 0.25};
  require_reached(integrate(drag, state, 0.3, scheme, control));
  rows.compare("step kept after a last one of 0.05 s [s]", {.expected = 0.25,
                                                            .computed = control.step,
                                                            .tolerance = absolute(0.0),
                                                            .because = "a short step says nothing against a long one"});
  rows.compare("time reached [s]",
               {.expected = 0.3, .computed = state.t, .tolerance = absolute(0.0), .because = "it is set, not summed"});
  state.t = 0.3;
  FixedStep single{.step = 1.0};
  require_reached(integrate(drag, state, 0.9, scheme, single));
  rows.compare("time reached from 0.3 s in one step [s]", {.expected = 0.9,
                                                           .computed = state.t,
                                                           .tolerance = absolute(0.0),
                                                           .because = "0.3 + (0.9 - 0.3) is beyond it by a rounding"});
}

const Case phi_k_bounds{
    {.name = "phi_k_bounds",
     .claim = "the next step is Phi_K times the last one within growth, retry and shrink, never above the limit; a "
              "step cut short leaves a longer one alone, and where nothing moves the step grows to the limit",
     .equation = "R 3.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      compare_bounds(rows);
      compare_rest(rows);
      compare_landing(rows);
    }};

}  // namespace verification::phi_k_prediction
