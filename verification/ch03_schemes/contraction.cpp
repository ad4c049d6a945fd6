// What steps and sweeps make of drag, springs and near fields: amplification, contraction, and its limit.

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/sweeps.hpp>
#include <particulate/schemes/verlet.hpp>

#include "linear_problems.hpp"

namespace verification::contraction {

using namespace particulate::schemes;
using namespace particulate;

// What one step makes of drag and of a spring, against the factors that theory gives.

// A power of two, so that the times of a run are exact and every step is the same to the last bit.
constexpr double unit_step = 1.0 / 64.0;

template <class S>
State after(S scheme, const Problem& problem, State state, long steps) {
  reach(problem, state, state.t + static_cast<double>(steps) * unit_step, scheme, FixedStep{.step = unit_step});
  return state;
}

// Mass 4 and speed 3: neither drops out by being one. State and motions go through different code.
template <class S>
void compare_drag_factor(Rows& rows, const std::string& method, const S& scheme,
                         const std::function<double(double)>& factor) {
  for (const double z : {0.01, 0.1, 0.5, 0.9}) {
    const Drag drag{.c = 4.0 * z / unit_step, .m = 4.0};
    const DragRate rate{.c = drag.c, .m = drag.m};
    const Comparison expected{.expected = factor(z),
                              .tolerance = relative(32.0 * eps / (1.0 - z)),
                              .because =
                                  "one step; sweeps end within a rounding of each other, 1/(1 - c Dt/m) from "
                                  "their limit"};
    const auto compare = [&](const char* form, double v) {
      Comparison row = expected;
      row.computed = v / 3.0;
      rows.compare(fmt::format("{}, c Dt/m = {}, {}", method, z, form), row);
    };
    compare("first order", after(scheme, rate, State{.t = 0.0, .y = Eigen::VectorXd::Constant(1, 3.0)}, 1).y[0]);
    compare("second order", after(scheme, drag, motion(0.0, 3.0), 1).v[0]);
  }
}

// Forward Euler decays below 2 m/c and grows above.
void compare_euler_limit(Rows& rows) {
  constexpr long steps = 10000;
  for (const double z : {2.0 - 2e-3, 2.0 + 2e-3}) {
    const DragRate drag{.c = z / unit_step, .m = 1.0};
    const double v = after(ForwardEuler{}, drag, State{.t = 0.0, .y = Eigen::VectorXd::Ones(1)}, steps).y[0];
    rows.compare(fmt::format("ln |v| after {} steps of forward Euler, Dt = {} m/c", steps, z),
                 {.expected = static_cast<double>(steps) * std::log(std::abs(1.0 - z)),
                  .computed = std::log(std::abs(v)),
                  .tolerance = absolute(static_cast<double>(steps) * 3.0 * eps),
                  .because = "three roundings a step"});
  }
}

const Case amplification_drag{
    {.name = "amplification_drag",
     .claim = "on m v' = -c v each scheme has its own factor, and forward Euler is stable exactly for Dt < 2 m/c",
     .equation = "R 3.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      compare_drag_factor(rows, "forward Euler", ForwardEuler{}, [](double z) { return 1.0 - z; });
      compare_drag_factor(rows, "backward Euler", BackwardEuler{}, [](double z) { return 1.0 / (1.0 + z); });
      compare_drag_factor(rows, "phi = 1/2", BackwardEuler(0.5),
                          [](double z) { return (1.0 - z / 2.0) / (1.0 + z / 2.0); });
      compare_drag_factor(rows, "phi = 0.7", BackwardEuler(0.7),
                          [](double z) { return (1.0 - 0.3 * z) / (1.0 + 0.7 * z); });
      compare_drag_factor(rows, "RK4", RungeKutta4{},
                          [](double z) { return 1.0 - z + z * z / 2.0 - z * z * z / 6.0 + z * z * z * z / 24.0; });
      compare_euler_limit(rows);
    }};

// The energy's factor of one step, from energies many steps apart.
template <class S>
void compare_energy(Rows& rows, const std::string& method, const S& scheme,
                    const std::function<double(double)>& factor) {
  constexpr long steps = 256;
  for (const double x : {0.01, 0.3, 0.9}) {
    const State start = motion(0.6, 0.8 * x / unit_step);
    const Oscillators spring = oscillator(x / unit_step);
    const State end = after(scheme, spring, start, steps);
    rows.compare(fmt::format("ln of the energy's growth in {} steps, {}, omega Dt = {}", steps, method, x),
                 {.expected = static_cast<double>(steps) * std::log(factor(x)),
                  .computed = std::log(energy(x / unit_step, end) / energy(x / unit_step, start)),
                  .tolerance = absolute(static_cast<double>(steps) * 8.0 * eps / (1.0 - x * x)),
                  .because = "a few roundings a step; sweeps end within a rounding of each other, 1/(1 - (omega Dt)^2) "
                             "from their limit"});
  }
}

// Not the energy, but an ellipse close by is what Verlet keeps: v^2 + omega^2 (1 - (omega Dt)^2/4) r^2.
void compare_verlet(Rows& rows) {
  constexpr long steps = 10000;
  for (const double x : {0.01, 0.3, 0.9, 1.9}) {
    const double omega = x / unit_step, flattened = omega * std::sqrt(1.0 - x * x / 4.0);
    const State start = motion(0.6, 0.8 * omega);
    const Oscillators spring = oscillator(omega);
    const State end = after(VelocityVerlet{}, spring, start, steps);
    rows.compare(fmt::format("ln of the growth of Verlet's ellipse in {} steps, omega Dt = {}", steps, x),
                 {.expected = 0.0,
                  .computed = std::log(energy(flattened, end) / energy(flattened, start)),
                  .tolerance = absolute(static_cast<double>(steps) * 4.0 * eps / (1.0 - x * x / 4.0)),
                  .because = "a few roundings a step, the more as the ellipse is flat"});
  }
}

const Case amplification_spring{
    {.name = "amplification_spring",
     .claim = "on a spring forward Euler gains energy and backward Euler loses it by their own factors in every step; "
              "phi = 1/2 keeps it, and Verlet keeps an ellipse close to it",
     .equation = "R 3.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      compare_energy(rows, "forward Euler", ForwardEuler{}, [](double x) { return 1.0 + x * x; });
      compare_energy(rows, "backward Euler", BackwardEuler{}, [](double x) { return 1.0 / (1.0 + x * x); });
      compare_energy(rows, "phi = 1/2", BackwardEuler(0.5), [](double) { return 1.0; });
      compare_energy(rows, "phi = 0.7", BackwardEuler(0.7),
                     [](double x) { return (1.0 + 0.09 * x * x) / (1.0 + 0.49 * x * x); });
      compare_energy(rows, "RK4", RungeKutta4{},
                     [](double x) { return 1.0 - std::pow(x, 6) / 72.0 + std::pow(x, 8) / 576.0; });
      compare_verlet(rows);
    }};

// How much nearer every sweep comes, against theory to five digits.

// Changes are differences of numbers near 1: at 1e-10 they are good to 4 eps/1e-10.
constexpr double above_rounding = 1e-10, tolerance_of_ratio = 4.0 * eps / above_rounding;
constexpr auto ratios_rounded = "ratios of changes that are above 1e-10 of numbers near 1, four roundings each";

// The ratio over `stride` sweeps, as a factor per sweep, that is farthest from what is expected.
struct Ratio {
  double expected;
  double farthest = missing;
  double reported = missing;  // what the scheme itself says, where one sweep shows the factor
  int seen = 0;
};

void keep_farthest(double& farthest, double expected, double ratio) {
  if (std::isnan(farthest) || std::abs(ratio - expected) > std::abs(farthest - expected)) farthest = ratio;
}

Ratio ratio_of(const Sweeps& swept, std::size_t stride, double expected) {
  const std::vector<double> change = changes(swept.iterates);
  Ratio ratio{.expected = expected};
  for (std::size_t k = stride; k < change.size() && change[k] > above_rounding; ++k) {
    keep_farthest(ratio.farthest, expected,
                  std::pow(change[k] / change[k - stride], 1.0 / static_cast<double>(stride)));
    if (stride == 1) keep_farthest(ratio.reported, expected, swept.iterations[k].rate);
    ++ratio.seen;
  }
  return ratio;
}

void write(Rows& rows, const std::string& which, const Ratio& ratio, int& fewest) {
  rows.compare(which, {.expected = ratio.expected,
                       .computed = ratio.farthest,
                       .tolerance = relative(tolerance_of_ratio),
                       .because = ratios_rounded});
  fewest = std::min(fewest, ratio.seen);
}

constexpr double phis[] = {1.0, 0.5, 0.7};
constexpr double steps_over_limit[] = {0.2, 0.5, 0.9};

// Positions alone are carried from sweep to sweep.
void compare_positions(Rows& rows, double phi, double x, int& fewest) {
  const double omega = 20.0, dt = x / (phi * omega);
  const Oscillators spring = oscillator(omega);
  const Sweeps swept = sweep_by_hand(BackwardEuler(phi), spring, motion(0.6, 0.4 / dt), dt, 40);
  const Ratio ratio = ratio_of(swept, 1, x * x);
  const std::string which = fmt::format("factor of a sweep, phi = {}, phi omega Dt = {}", phi, x);
  write(rows, which, ratio, fewest);
  rows.compare(which + ", as the scheme reports it", {.expected = x * x,
                                                      .computed = ratio.reported,
                                                      .tolerance = relative(tolerance_of_ratio),
                                                      .because = ratios_rounded});
}

// A spring as y = (r, v).
struct AsValues {
  Oscillators spring;

  bool rate(double t, In y, Out dy) const {
    dy[0] = y[1];
    return spring.acceleration(t, y.head(1), dy.tail(1));
  }
};

// The velocity of the old sweep moves the position. The factor has two imaginary
// eigenvalues, so that the changes go down by its square over two sweeps, and by no law in one.
void compare_lagging(Rows& rows, double phi, double x, int& fewest) {
  const double omega = 20.0, dt = x / (phi * omega);
  const AsValues spring{.spring = oscillator(omega)};
  const State start{.t = 0.0, .y = Eigen::Vector2d(0.6, 0.4 * omega)};
  const Sweeps swept = sweep_by_hand(BackwardEuler(phi), spring, start, dt, 40);
  write(rows, fmt::format("factor of a sweep if velocities lag, phi = {}, phi omega Dt = {}", phi, x),
        ratio_of(swept, 2, x), fewest);
}

void compare_drag(Rows& rows, double phi, double z, int& fewest) {
  const DragRate drag{.c = 4.0, .m = 2.0};
  const double dt = z / (phi * 2.0);
  const State start{.t = 0.0, .y = Eigen::VectorXd::Constant(1, 0.8)};
  write(rows, fmt::format("factor of a sweep on drag, phi = {}, phi c Dt/m = {}", phi, z),
        ratio_of(sweep_by_hand(BackwardEuler(phi), drag, start, dt, 40), 1, z), fewest);
}

const Case contraction_spring{
    {.name = "contraction_spring",
     .claim = "a sweep contracts by (phi omega dt)^2 on a spring, by phi omega dt if velocities lag, and by phi c dt/m "
              "on drag",
     .equation = "R 3.3",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      int fewest = 1000;
      for (const double phi : phis) {
        for (const double x : steps_over_limit) {
          compare_positions(rows, phi, x, fewest);
          compare_lagging(rows, phi, x, fewest);
          compare_drag(rows, phi, x, fewest);
        }
      }
      rows.at_least("sweeps compared, the fewest of all",
                    {.limit = 4, .computed = static_cast<double>(fewest), .because = "one ratio alone shows no law"});
    }};

// Every oscillator contracts on its own; of the sum of all only the slowest to converge is left.
void prove_contraction_many(Rows& rows) {
  const double dt = 0.01;
  const Eigen::Vector3d x{0.3, 0.9, 0.1};
  const Oscillators springs{.omega = x / dt};
  const State start{.t = 0.0, .r = Eigen::Vector3d{0.5, 0.2, 0.7}, .v = Eigen::Vector3d::Zero()};
  for (const double phi : phis) {
    const auto swept = sweep_by_hand(BackwardEuler(phi), springs, start, dt, 12);
    const std::vector<double> change = changes(swept.iterates);
    const double slowest = std::pow(phi * 0.9, 2);
    const std::size_t last = phi == 1.0 ? 11 : 7;
    rows.compare(fmt::format("last factor of a sweep over three springs, phi = {}", phi),
                 {.expected = slowest,
                  .computed = change[last] / change[last - 1],
                  .tolerance = relative(1e-5),
                  .because = "after seven sweeps the next spring is down to 9^-7 = 2e-7 of the slowest, and "
                             "changes are above 1e-10"});
    const std::vector<double> one = changes(sweep_by_hand(BackwardEuler(phi), springs, start, dt, 2).iterates);
    rows.at_most(fmt::format("first factor over the slowest's, phi = {}", phi),
                 {.limit = 0.9,
                  .computed = one[1] / one[0] / slowest,
                  .because = "at first the springs that converge at once have a share: the mean over all is "
                             "smaller than the largest"});
  }
}

const Case contraction_many{{.name = "contraction_many",
                             .claim = "of several oscillators the one with the largest omega dt rules the contraction",
                             .equation = "R 3.3",
                             .reference = Reference::closed_form},
                            prove_contraction_many};

// On both sides of the step at which sweeps stop contracting, and far beyond it.

constexpr double omega = 8.0;
constexpr int plenty = 20000;  // contractions: 0.998^14000 = 1e-12

const State start = motion(0.6, 3.2);

// Three steps of a spring, or the reason why not; the answer against Cramer's rule.
template <class S, class C>
Ending spring(S scheme, C control, double phi, double t_end, double tolerance, const std::string& because) {
  Oscillators problem = oscillator(omega);
  State state = start, exact = start;
  const auto follow = [&](const State&, const State&, double dt, const S&) {
    exact = phi_step(phi, omega, dt, exact);
    return true;
  };
  const Outcome outcome = integrate(problem, state, t_end, scheme, control, follow);
  if (outcome.status != Status::reached) return Ending::refused(outcome.reason);
  return Ending::solved({.error = apart(omega, state, exact), .tolerance = tolerance, .because = because});
}

Ending at_fixed_step(double phi, double x) {
  return spring(BackwardEuler(phi), FixedStep{.step = x / omega, .TOL = 1e-12, .contractions = plenty}, phi,
                3.0 * x / omega, 3.0 * 500.0 * 1e-12,
                "three steps, each of whose sweeps stop within TOL of each other, at most 1/(1 - 0.998) = 500 times "
                "nearer than their limit");
}

// The limit of the sweeps from both sides.
void compare_limit(Rows& rows, double phi, double limit) {
  const double below = limit * (1.0 - 1e-3), above = limit * (1.0 + 1e-3);
  rows.must_be_solved(fmt::format("omega dt = {}, phi = {}", below, phi), [=] { return at_fixed_step(phi, below); });
  rows.must_be_refused(fmt::format("omega dt = {}, phi = {}", above, phi), "diverge 1.002 Dt",
                       [=] { return at_fixed_step(phi, above); });

  Oscillators problem = oscillator(omega);
  State state = start;
  BackwardEuler scheme(phi);
  FixedStep control{.step = above / omega, .TOL = 1e-6, .contractions = 100};
  const Outcome outcome = integrate(problem, state, 1.0, scheme, control);
  rows.none(fmt::format("state left after the refusal, phi = {}, components that moved", phi),
            static_cast<int>(state.r[0] != start.r[0]) + static_cast<int>(state.v[0] != start.v[0]) +
                static_cast<int>(state.t != 0.0) + static_cast<int>(outcome.t != 0.0),
            "a refused step leaves no trace");
  rows.compare(fmt::format("contraction reported at omega dt = {}, phi = {}", above, phi),
               {.expected = 1.001 * 1.001,
                .computed = outcome.contraction,
                .tolerance = relative(1e-12),
                .because = "ratios of changes that grow, a few roundings each"});
  // The step whose sweeps take (phi omega dt)^(2 K) from w_0 to TOL; w_0 is that of the refused step.
  const State flight = motion(start.r[0] + above / omega * start.v[0], start.v[0]);
  const double a_end = -omega * omega * flight.r[0], a_start = -omega * omega * start.r[0];
  const double kick = phi * std::pow(above / omega, 2) * (phi * a_end + (1.0 - phi) * a_start);
  const double w_0 = std::abs(kick) / std::abs(flight.r[0] + kick - start.r[0]);
  rows.compare(fmt::format("workable step, phi = {}, over that of the limit", phi),
               {.expected = std::pow(1e-6 / w_0, 1.0 / 200.0),
                .computed = outcome.workable_step * omega / limit,
                .tolerance = relative(1e-12),
                .because = "roots of ratios near 1, some roundings"});
}

const Case contraction_limit{
    {.name = "contraction_limit",
     .claim = "phi = 1 needs omega dt < 1 and phi = 1/2 needs omega dt < 2; beyond, the sweeps are refused with the "
              "contraction that was seen and the step that would have worked",
     .equation = "R 3.3",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      compare_limit(rows, 1.0, 1.0);
      compare_limit(rows, 0.5, 2.0);
      rows.must_be_solved("omega dt = 1.001, phi = 1, Anderson", [] {
        return spring(PhiFamily<Anderson>(1.0), FixedStep{.step = 1.001 / omega}, 1.0, 3.003 / omega, 1e-14,
                      "one unknown: the secant of a linear map ends at rounding, three steps");
      });
      rows.must_be_solved("omega dt = 50, phi = 1/2, Anderson", [] {
        return spring(PhiFamily<Anderson>(0.5), FixedStep{.step = 50.0 / omega}, 0.5, 150.0 / omega, 625.0 * 64.0 * eps,
                      "one unknown: the secant of a linear map ends at rounding, which a map with a slope of 625 "
                      "magnifies");
      });
    }};

// With r = 1, v = 0 Verlet's positions are cos(n theta), 2 cos(theta) = 2 - x^2; beyond x = 2 a growing cosh.
double verlet(double x, long steps, double& largest) {
  Oscillators problem = oscillator(x * 64.0);
  State state = motion(1.0, 0.0);
  VelocityVerlet scheme;
  FixedStep control{.step = 1.0 / 64.0};
  const auto watch = [&](const State&, const State& to, double, const VelocityVerlet&) {
    keep_worst(largest, std::abs(to.r[0]));
    return true;
  };
  require_reached(integrate(problem, state, static_cast<double>(steps) / 64.0, scheme, control, watch));
  return state.r[0];
}

const Case verlet_limit{
    {.name = "verlet_limit",
     .claim = "the explicit Verlet scheme is stable for omega dt < 2 too: no step that phi = 1/2 can take by its "
              "sweeps is too large for it",
     .equation = "R 3.3",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      constexpr double below = 2.0 - 2e-3, above = 2.0 + 2e-3;
      double largest = 0.0, grown = 0.0;
      verlet(below, 10000, largest);
      rows.at_most("largest |r| over 10000 steps at omega dt = 1.998, released from 1",
                   {.limit = 1.0 + 1e-9,
                    .computed = largest,
                    .because = "cos(n theta); roundings add up over a step to 1/(1 - x^2/4)^(1/2) = 22 of them"});
      const double r = verlet(above, 200, grown);
      rows.compare("ln |r| after 200 steps at omega dt = 2.002, released from 1",
                   {.expected = std::log(std::cosh(200.0 * std::acosh(above * above / 2.0 - 1.0))),
                    .computed = std::log(std::abs(r)),
                    .tolerance = absolute(200.0 * 8.0 * eps / (above * above / 4.0 - 1.0)),
                    .because = "some roundings a step, and arcosh near 1 magnifies those of its argument"});
    }};

// Steps a thousand times too large; sweeps that would have to go on below rounding; nothing to sweep on.
template <class C>
Ending near_field(const kinematics::Particles& particles, C control, double t_end) {
  NearFieldScene scene(particles, {}, {.alpha1 = 0.5, .alpha2 = 0.25});
  State state = scenes::start(scene);
  BackwardEuler scheme;
  return ending_of(integrate(scene, state, t_end, scheme, control));
}

// Two bodies whose free flight ends where they meet.
kinematics::Particles meeting() {
  kinematics::Particles pair = pair_at_rest(1.0, 1.0, 2.0);
  pair.velocity = -pair.position;
  return pair;
}

// A spring whose rest lies far from the origin: positions are rounded to 1e-10.
struct FarSpring {
  bool acceleration(double, In r, Out a) const {
    a = -omega * omega * (r.array() - 1e6);
    return true;
  }
};

void refuse(Rows& rows) {
  rows.must_be_refused("omega dt = 1000 at a fixed step", "diverge 1e+06 Dt", [] { return at_fixed_step(1.0, 1e3); });
  rows.must_be_refused("omega dt = 1000, Phi_K control that may not go below 900", "diverge Dt smallest", [] {
    return spring(BackwardEuler{}, PhiControl{.step = 125.0, .limit = 125.0, .smallest = 112.5}, 1.0, 250.0, 0.0,
                  "it should not come to this");
  });
  const auto with_tolerance = [](double TOL) {
    return spring(BackwardEuler{}, FixedStep{.step = 0.1 / omega, .TOL = TOL}, 1.0, 0.1 / omega, 0.0,
                  "it should not come to this");
  };
  rows.must_be_refused("TOL = 1e-17", "TOL 2.22e-16 1e-17", [=] { return with_tolerance(1e-17); });
  rows.must_be_refused("TOL = NaN", "TOL nan", [=] { return with_tolerance(missing); });
  const auto far_away = [](auto control) {
    FarSpring problem;
    State state = motion(1e6, 3.2);
    BackwardEuler scheme;
    return ending_of(integrate(problem, state, 5.0, scheme, control));
  };
  rows.must_be_refused("TOL = 1e-12 of a displacement of 1e-7 positions, fixed step", "TOL rounding larger",
                       [=] { return far_away(FixedStep{.step = 0.98 / omega, .TOL = 1e-12}); });
  rows.must_be_refused("TOL = 1e-12 of a displacement of 1e-7 positions, Phi_K control", "TOL rounding larger", [=] {
    return far_away(PhiControl{.TOL = 1e-12, .K_d = 500, .step = 0.98 / omega, .limit = 0.98 / omega});
  });
}

void refuse_near_fields(Rows& rows) {
  rows.must_be_refused("coincident particles, fixed step", "no finite value smaller step",
                       [] { return near_field(pair_at_rest(1.0, 1.0, 0.0), FixedStep{.step = 0.1}, 1.0); });
  rows.must_be_refused("coincident particles, Phi_K control", "no finite value smallest", [] {
    return near_field(pair_at_rest(1.0, 1.0, 0.0), PhiControl{.step = 0.1, .limit = 0.1, .smallest = 1e-6}, 1.0);
  });
  rows.must_be_refused("first guess where particles coincide, fixed step", "no finite value smaller step",
                       [] { return near_field(meeting(), FixedStep{.step = 1.0}, 2.0); });
  kinematics::Particles lost = pair_at_rest(1.0, 1.0, 1.0);
  lost.position(1, 2) = missing;
  rows.must_be_refused("particle at NaN", "position finite nan",
                       [=] { return near_field(lost, FixedStep{.step = 0.1}, 1.0); });
  rows.must_be_refused("motion that starts at NaN", "positions must start finite nan", [] {
    Oscillators problem = oscillator(1.0);
    State state = motion(missing, 0.0);
    BackwardEuler scheme;
    PhiControl control{.step = 0.1, .limit = 0.1};
    return ending_of(integrate(problem, state, 1.0, scheme, control));
  });
}

// A vessel that drains, y' = -sqrt(y): its level has a rate as long as it is not negative. Backward Euler asks for
// s^2 + Dt s = y with s the root of the new level.
struct Draining {
  bool rate(double, In y, Out dy) const {
    dy = -y.array().sqrt();
    return y[0] >= 0.0;
  }
};

template <class C>
Ending drain(C control) {
  Draining problem;
  State state{.t = 0.0, .y = Eigen::VectorXd::Ones(1)};
  double exact = 1.0;
  BackwardEuler scheme;
  const auto follow = [&](const State&, const State&, double dt, const BackwardEuler&) {
    exact = std::pow((std::sqrt(dt * dt + 4.0 * exact) - dt) / 2.0, 2);
    return true;
  };
  const Outcome outcome = integrate(problem, state, 1.5, scheme, control, follow);
  if (outcome.status != Status::reached) return Ending::refused(outcome.reason);
  return Ending::solved({.error = std::abs(state.y[0] / exact - 1.0),
                         .tolerance = 1e-10,
                         .because = "less than a hundred steps, each within TOL = 1e-12 of its backward Euler step"});
}

const Case extremes_of_sweeps{
    {.name = "extremes_of_sweeps",
     .claim = "steps a thousand times too large shrink until they are solved, or are refused with the contraction; a "
              "tolerance below rounding and a start without a value are refused",
     .equation = "R 3.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      rows.must_be_solved("omega dt = 1000 at first, Phi_K control", [] {
        return spring(BackwardEuler{}, PhiControl{.TOL = 1e-12, .K_d = 20, .step = 125.0, .limit = 125.0}, 1.0, 2.0,
                      100.0 * 1e-12, "less than a hundred steps, each within TOL of its backward Euler step");
      });
      rows.must_be_solved("first guess where particles coincide, Phi_K control", [] {
        NearFieldScene scene(meeting(), {}, {.alpha1 = 0.5, .alpha2 = 0.25});
        State state = scenes::start(scene);
        BackwardEuler scheme;
        PhiControl control{.TOL = 1e-12, .K_d = 20, .step = 1.0, .limit = 1.0};
        double worst = 0.0;
        const auto check = [&](const State& from, const State& to, double dt, const BackwardEuler&) {
          keep_worst(worst, defect(scene, from, to, dt) / (to.r - from.r).lpNorm<Eigen::Infinity>());
          return true;
        };
        const Outcome outcome = integrate(scene, state, 2.0, scheme, control, check);
        if (outcome.status != Status::reached) return Ending::refused(outcome.reason);
        return Ending::solved({.error = worst,
                               .tolerance = 1e-11,
                               .because = "the equation of backward Euler holds within a few TOL of every step's "
                                          "displacement"});
      });
      // The second iterate is 1 - 1.5.
      rows.must_be_solved("second iterate where the rate has no value, Phi_K control",
                          [] { return drain(PhiControl{.TOL = 1e-12, .K_d = 20, .step = 1.5, .limit = 1.5}); });
      rows.must_be_refused("second iterate where the rate has no value, fixed step", "no finite value smaller step",
                           [] { return drain(FixedStep{.step = 1.5}); });
      refuse(rows);
      refuse_near_fields(rows);
    }};

}  // namespace verification::contraction
