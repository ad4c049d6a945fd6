// What many steps add up to: rounding, energy and angular momentum.

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/kinematics/breathing.hpp>
#include <particulate/reference/integrator.hpp>
#include <particulate/report/table.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "linear_problems.hpp"

namespace verification::drift {

using namespace particulate::schemes;
using namespace particulate;

// Compensated summation: what rounding takes from the state in one step is given back in the next.

// y' = (y2, -y1), the oscillator as a problem of first order.
struct Rotation {
  bool rate(double, In y, Out dy) const {
    dy[0] = y[1];
    dy[1] = -y[0];
    return true;
  }
};

// A power of two, so that the time is exact; so small that roundings of the state outweigh all else, and so short a run
// that the rounding of the coefficients, a shift in frequency, does not count.
constexpr double tiny_step = 1.0 / 8192.0, orbits_end = 16.0;

// The largest error of position and velocity of (cos, -sin)(t + phase) at the ends of the last hundred steps.
double largest_error(const Problem& problem, double phase, bool compensated) {
  const double r = std::cos(phase), v = -std::sin(phase);
  State state = problem.traits().motion ? motion(r, v) : State{.t = 0.0, .y = Eigen::Vector2d{r, v}};
  using Scheme = Collocation<Gauss<4>>;
  Scheme scheme({.compensated = compensated});
  double worst = 0.0;
  const auto watch = [&](const State&, const State& to, double, const Scheme&) {
    if (to.t < orbits_end - 100.0 * tiny_step) return true;
    const Eigen::VectorXd at = flat(to);
    keep_worst(worst, std::hypot(at[0] - std::cos(to.t + phase), at[1] + std::sin(to.t + phase)));
    return true;
  };
  FixedStep control{.step = tiny_step};
  require_reached(integrate(problem, state, orbits_end, scheme, control, watch));
  return worst;
}

// From six phases: how roundings add up is a matter of luck.
void compare(Rows& rows, const std::string& which, const Problem& problem) {
  double with = 0.0, without = 0.0;
  for (const double phase : {0.0, 0.5, 1.0, 1.5, 2.0, 2.5}) {
    keep_worst(with, largest_error(problem, phase, true));
    keep_worst(without, largest_error(problem, phase, false));
  }
  rows.at_most("largest error after 131072 steps, " + which,
               {.limit = 16.0 * eps,
                .computed = with,
                .because = "t = 16 s with coefficients rounded to half an epsilon, from a start rounded once"});
  rows.at_least("the same without compensation, over it, " + which,
                {.limit = 4.0, .computed = without / with, .because = "a rounding of the state a step shows"});
}

const Case collocation_compensated{
    {.name = "collocation_compensated",
     .claim = "with compensated summation a hundred thousand steps of a closed orbit stay at rounding",
     .equation = "D 3.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const Oscillators spring = oscillator(1.0);
      const Rotation rotation;
      compare(rows, "motion", spring);
      compare(rows, "values", rotation);
    }};

// Energy and angular momentum of a breathing polygon over many steps, by methods that cost the same.

constexpr double alpha2 = 0.5, step = 0.02;
constexpr int samples = 40;

NearFieldScene triangle() {
  return {at_rest(kinematics::regular_polygon(3), 1.0, Eigen::VectorXd::Ones(3)),
          {},
          {.alpha1 = 1.0, .alpha2 = alpha2, .beta1 = 2.0, .beta2 = 3.0}};
}

// Turning as it breathes. A pair alone has an energy of -alpha1^2/(2 alpha2) = -1 J at least; with less than that in
// all no body can leave, and none comes nearer to another than 0.22 m.
State turning(const NearFieldScene& scene, double spin) {
  State start = scenes::start(scene);
  const Eigen::Index n = 3;
  start.v.head(n) = -spin * start.r.segment(n, n);
  start.v.segment(n, n) = spin * start.r.head(n);
  return start;
}

// What the motion must keep, in extended precision: three unit masses.
struct Kept {
  long double energy = 0.0L, spin = 0.0L;
};
Kept kept(const State& at) {
  Kept sum;
  const auto r = [&](Eigen::Index i, Eigen::Index axis) -> long double { return at.r[3 * axis + i]; };
  const auto v = [&](Eigen::Index i, Eigen::Index axis) -> long double { return at.v[3 * axis + i]; };
  for (Eigen::Index i = 0; i < 3; ++i) {
    sum.spin += r(i, 0) * v(i, 1) - r(i, 1) * v(i, 0);
    for (Eigen::Index axis = 0; axis < 3; ++axis) sum.energy += 0.5L * v(i, axis) * v(i, axis);
    for (Eigen::Index j = 0; j < i; ++j) {
      const long double x = r(i, 0) - r(j, 0), y = r(i, 1) - r(j, 1), z = r(i, 2) - r(j, 2);
      const long double d2 = x * x + y * y + z * z;
      sum.energy += alpha2 / (2.0L * d2) - 1.0L / std::sqrt(d2);
    }
  }
  return sum;
}

// Relative changes of energy and angular momentum at equal distances in time.
struct Drift {
  std::vector<double> t, energy, spin;
  long evaluations = 0;
};

double largest(const std::vector<double>& of) {
  double worst = 0.0;
  for (const double x : of) keep_worst(worst, std::abs(x));
  return worst;
}

// The power of time with which the root mean square of several drifts grows.
double growth(const std::vector<Drift>& several, std::vector<double> Drift::*which) {
  std::vector<double> t, size;
  for (std::size_t k = 0; k < several.front().t.size(); ++k) {
    double squares = 0.0;
    for (const Drift& one : several) squares += std::pow((one.*which)[k], 2);
    t.push_back(several.front().t[k]);
    size.push_back(std::sqrt(squares / static_cast<double>(several.size())));
  }
  return fitted_order(t, size);
}

// `advance(state, t)` moves the state on and returns an Outcome.
template <class Advance>
Drift drift_of(State state, double t_end, const Advance& advance) {
  Drift seen;
  const Kept before = kept(state);
  for (int k = 1; k <= samples; ++k) {
    const Outcome outcome = advance(state, t_end * k / samples);
    require_reached(outcome);
    seen.evaluations += outcome.evaluations;
    const Kept now = kept(state);
    seen.t.push_back(state.t);
    seen.energy.push_back(static_cast<double>((now.energy - before.energy) / -before.energy));
    seen.spin.push_back(static_cast<double>((now.spin - before.spin) / before.spin));
  }
  return seen;
}

template <class S, class C>
Drift by_scheme(double spin, double t_end, S scheme, C control) {
  NearFieldScene scene = triangle();
  return drift_of(turning(scene, spin), t_end,
                  [&](State& state, double t) { return integrate(scene, state, t, scheme, control); });
}

Drift by_cvode(double spin, double t_end, double tolerance) {
  NearFieldScene scene = triangle();
  const State start = turning(scene, spin);
  reference::Integrator adams(scene, start,
                              reference::Adams{.relative = tolerance, .absolute = tolerance, .max_steps = 100'000'000});
  return drift_of(start, t_end, [&](State& state, double t) { return adams.advance(state, t); });
}

// All of them over the same time, at the cost of Gauss 6 with sweeps to rounding; but CVODE's tightest tolerance costs
// half of that, and it cannot spend more: Gauss 8 in steps four times as long spends as much as CVODE.
struct Methods {
  Drift gauss, plain, verlet, euler, cvode, cheap;
};
Methods methods(double spin, double t_end) {
  Methods of;
  of.gauss = by_scheme(spin, t_end, Collocation<Gauss<6>>(), FixedStep{.step = step});
  of.plain = by_scheme(spin, t_end, Collocation<Gauss<6>>({.compensated = false}), FixedStep{.step = step});
  const double alone = t_end / static_cast<double>(of.gauss.evaluations);
  of.verlet = by_scheme(spin, t_end, VelocityVerlet(), FixedStep{.step = alone});
  of.euler = by_scheme(spin, t_end, BackwardEuler(), FixedStep{.step = 4.0 * alone, .TOL = 1e-6});
  of.cvode = by_cvode(spin, t_end, 1e-15);
  of.cheap = by_scheme(spin, t_end, Collocation<Gauss<8>>(), FixedStep{.step = 4.0 * step});
  return of;
}

void write_curves(Rows& rows, const Methods& of) {
  report::Table table({"t [s]", "energy, Gauss [-]", "energy, Gauss without compensation [-]", "energy, Verlet [-]",
                       "energy, backward Euler [-]", "energy, CVODE [-]", "spin, Gauss [-]", "spin, CVODE [-]",
                       "energy, Gauss 8 at the cost of CVODE [-]", "spin, Gauss 8 at the cost of CVODE [-]"});
  for (std::size_t k = 0; k < of.gauss.t.size(); ++k) {
    table.add({of.gauss.t[k], of.gauss.energy[k], of.plain.energy[k], of.verlet.energy[k], of.euler.energy[k],
               of.cvode.energy[k], of.gauss.spin[k], of.cvode.spin[k], of.cheap.energy[k], of.cheap.spin[k]});
  }
  rows.write("drift", table);
}

// No claim is made of the powers: those of three motions are too few to tell a random walk, 1/2, from a drift, 1.
void write_growth(Rows& rows, const std::vector<Methods>& motions) {
  report::Table table({"method", "right-hand sides [-]", "energy, largest change [-]", "energy, power of time [-]",
                       "spin, largest change [-]", "spin, power of time [-]"});
  const auto add = [&](const char* name, Drift Methods::*method) {
    std::vector<Drift> several;
    double energy = 0.0, spin = 0.0;
    for (const Methods& motion : motions) {
      several.push_back(motion.*method);
      keep_worst(energy, largest(several.back().energy));
      keep_worst(spin, largest(several.back().spin));
    }
    table.add({name, several.front().evaluations, energy, growth(several, &Drift::energy), spin,
               growth(several, &Drift::spin)});
  };
  add("Gauss 6", &Methods::gauss);
  add("Gauss 6 without compensation", &Methods::plain);
  add("velocity Verlet", &Methods::verlet);
  add("backward Euler", &Methods::euler);
  add("CVODE Adams", &Methods::cvode);
  add("Gauss 8, four times the step", &Methods::cheap);
  rows.write("drift_growth", table);
}

// What a method keeps though it costs no more than CVODE.
void compare_with_cvode(Rows& rows, const std::string& at, const Methods& of, double steps) {
  rows.at_least("angular momentum, drift of CVODE Adams at 1e-15 over that of Gauss 6" + at,
                {.limit = 100.0,
                 .computed = largest(of.cvode.spin) / largest(of.gauss.spin),
                 .because = "nothing but its tolerance keeps it"});
  rows.at_least("angular momentum, drift of CVODE Adams at 1e-15 over that of Gauss 8 at its cost" + at,
                {.limit = 100.0,
                 .computed = largest(of.cvode.spin) / largest(of.cheap.spin),
                 .because = "a method that keeps what is quadratic does so at any step"});
  rows.compare("right-hand sides of CVODE over those of Gauss 8 in steps of 0.08 s" + at,
               {.expected = 1.0,
                .computed = static_cast<double>(of.cvode.evaluations) / static_cast<double>(of.cheap.evaluations),
                .tolerance = relative(0.15),
                .because = "the same cost, for that step was chosen; one that lands on it to a seventh"});
  rows.at_most("angular momentum, Gauss 8 at the cost of CVODE, relative drift" + at,
               {.limit = std::sqrt(steps) * eps,
                .computed = largest(of.cheap.spin),
                .because = "as for Gauss 6, in a quarter of the steps, which are four times as long"});
  rows.at_most("energy, Gauss 8 at the cost of CVODE, relative drift" + at,
               {.limit = 1e-8,
                .computed = largest(of.cheap.energy),
                .because = "what steps so long leave at the nearest passages, 3e-9 as seen; it does not add up"});
}

void compare_gauss(Rows& rows, const std::string& at, const Methods& of, double steps) {
  const double walk = std::sqrt(steps) * eps;
  rows.at_most("energy, Gauss 6, relative drift" + at,
               {.limit = walk,
                .computed = largest(of.gauss.energy),
                .because = "rounding adds up like the steps of a random walk, of which compensation leaves a part"});
  rows.at_most("angular momentum, Gauss 6, relative drift" + at,
               {.limit = walk,
                .computed = largest(of.gauss.spin),
                .because = "Gauss keeps what is quadratic; the rest as for the energy"});
  rows.at_most("angular momentum, Gauss 6 without compensation, relative drift" + at,
               {.limit = 5.0 * walk,
                .computed = largest(of.plain.spin),
                .because = "one rounding of each of six numbers in every step, at random: no more than the root of "
                           "their number"});
}

void compare_others(Rows& rows, const std::string& at, const Methods& of) {
  const double verlet_steps = static_cast<double>(of.gauss.evaluations);
  rows.at_most("energy, Verlet, relative drift" + at,
               {.limit = 3e-4,
                .computed = largest(of.verlet.energy),
                .because = "bounded: at the nearest, 0.22 m, where omega = 29/s, it is off by (omega h)^2/8 = 2e-4 of "
                           "what the potential is there"});
  rows.at_most("angular momentum, Verlet, relative drift" + at, {.limit = 5.0 * std::sqrt(verlet_steps) * eps,
                                                                 .computed = largest(of.verlet.spin),
                                                                 .because = "kept but for rounding at random"});
  int rose = 0;
  for (std::size_t k = 1; k < of.euler.energy.size(); ++k) {
    rose += static_cast<int>(!(of.euler.energy[k] <= of.euler.energy[k - 1] + 1e-4));
  }
  rows.none("moments at which backward Euler has more energy than before" + at, rose, "it damps");
  rows.at_most("energy that backward Euler leaves, relative change" + at,
               {.limit = -0.8,
                .computed = of.euler.energy.back(),
                .because = "the lowest potential is -3 J, all distances 0.5 m: a change of about -1.05 from -1.47 J"});
}

const Case drift{
    {.name = "drift",
     .claim = "over 1e5 steps of a breathing polygon Gauss collocation keeps energy and angular momentum to rounding "
              "that adds up at random, and less of it with compensated sums; Verlet keeps them nearby, backward Euler "
              "damps, and CVODE drifts",
     .equation = "D 3.4",
     .reference = Reference::identity},
    [](Rows& rows) {
      const double steps = rows.quick() ? 1e4 : 1e5, t_end = steps * step;
      double with = 0.0, without = 0.0, number = 0.0;
      std::vector<Methods> all;
      for (const double spin : {0.15, 0.2, 0.25}) {
        const Methods of = methods(spin, t_end);
        const std::string at = fmt::format(", {:g} steps, spin {}", steps, spin);
        compare_gauss(rows, at, of, steps);
        compare_others(rows, at, of);
        for (const double x : of.gauss.spin) with += x * x;
        for (const double x : of.plain.spin) without += x * x, number += 1.0;
        compare_with_cvode(rows, at, of, steps);
        if (spin == 0.2) write_curves(rows, of);
        all.push_back(of);
      }
      write_growth(rows, all);
      rows.at_least("angular momentum, root mean square without compensation over that with it",
                    {.limit = 4.0,
                     .computed = std::sqrt(without / with),
                     .because = "what rounding takes from the state is kept and added again"});
      rows.at_least("moments compared", {.limit = 3.0 * samples, .computed = number, .because = "three motions"});
    }};

// The largest error of the time after k steps of 0.1 s, over k times that, in epsilons.
template <class S>
void compare_time(Rows& rows, const std::string& method, S scheme) {
  constexpr double tenth = 0.1;
  constexpr long steps = 100000;
  const Oscillators spring = oscillator(1e-3);
  State state = motion(1.0, 0.0);
  FixedStep control{.step = tenth};
  double worst = 0.0;
  long k = 0;
  const auto watch = [&](const State&, const State& to, double, const S&) {
    const long double exact = static_cast<long double>(++k) * tenth;
    keep_worst(worst, static_cast<double>(std::abs(to.t - exact) / (eps * exact)));
    return k < steps;
  };
  (void)integrate(spring, state, 1e9, scheme, control, watch);
  rows.equal("steps of 0.1 s, " + method, {.expected = steps, .computed = k, .because = "as many as were asked for"});
  rows.at_most("largest error of the time after k of them, over eps k 0.1 s, " + method,
               {.limit = 1.0,
                .computed = worst,
                .because = "half a rounding of the time, and half a rounding of the step k times"});
}

const Case time_compensated{
    {.name = "time_compensated",
     .claim = "the time of any scheme after a hundred thousand steps of a tenth of a second is right to one rounding",
     .equation = "D 3.4",
     .reference = Reference::identity},
    [](Rows& rows) {
      compare_time(rows, "forward Euler", ForwardEuler{});
      compare_time(rows, "backward Euler", BackwardEuler{});
      compare_time(rows, "Verlet", VelocityVerlet{});
      compare_time(rows, "RK4", RungeKutta4{});
      compare_time(rows, "Gauss 2", Collocation<Gauss<2>>{});
    }};

}  // namespace verification::drift
