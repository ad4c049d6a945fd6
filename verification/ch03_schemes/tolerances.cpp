// What a tolerance means: of collocation under error control, and of sweeps alone.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/breathing.hpp>
#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/kinematics/breathing.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/sweeps.hpp>
#include <particulate/schemes/verlet.hpp>

#include "classical_problems.hpp"
#include "linear_problems.hpp"

namespace verification::tolerances {

using namespace particulate;
using namespace particulate::schemes;

// How the attained error follows the tolerance: the slope of its logarithm over that of TOL.

// Errors of one method over its tolerances.
struct Followed {
  std::vector<double> TOL, errors;
};

// Halves of decades; `error(TOL)` runs once.
Followed follow(double loosest, double tightest, const std::function<double(double)>& error) {
  Followed seen;
  for (int k = 0; loosest * std::pow(10.0, -0.5 * k) > 0.99 * tightest; ++k) {
    seen.TOL.push_back(loosest * std::pow(10.0, -0.5 * k));
    seen.errors.push_back(error(seen.TOL.back()));
  }
  return seen;
}

// What the slope must be: two-sided.
struct Slope {
  double least, most;
  std::string because;
};

void write(Rows& rows, const std::string& method, const Followed& seen, const Slope& slope) {
  rows.at_least("decades of TOL, " + method, {.limit = 4.0,
                                              .computed = std::log10(seen.TOL.front() / seen.TOL.back()) + 1e-9,
                                              .because = "the catalogue asks for four"});
  rows.compare("slope of log error over log TOL, " + method,
               {.expected = 0.5 * (slope.least + slope.most),
                .computed = fitted_order(seen.TOL, seen.errors),
                .tolerance = absolute(0.5 * (slope.most - slope.least)),
                .because = slope.because + "; whole steps, ten a curve, scatter the points by half a decade"});
  double largest = 0.0;
  for (std::size_t k = 0; k < seen.TOL.size(); ++k) keep_worst(largest, seen.errors[k] / seen.TOL[k]);
  rows.at_most("largest error over TOL, " + method,
               {.limit = 10.0, .computed = largest, .because = "some tens of steps, each within TOL, add up"});
}

// A pair that breathes and turns, for two radial periods and a bit: distance and its rate against Kepler's equation. It
// never stands still, where the derivatives that the estimates see would vanish together.
template <class Nodes>
double error_of_motion(double TOL) {
  constexpr double l_z = 1.2, t_end = 5.1;  // r^2 dphi/dt [m^2/s], [s]
  const Eigen::Vector3d across{3.0 / 7.0, -6.0 / 7.0, 2.0 / 7.0};
  const kinematics::Breathing exact(kinematics::breathing_pair(1.0, 0.25, 1.0, 1.0, l_z), 1.0);
  kinematics::Particles start = pair_at_rest(1.0, 1.0, 1.0);
  kinematics::set_vector(start.velocity, 0, -0.5 * l_z * across);
  kinematics::set_vector(start.velocity, 1, 0.5 * l_z * across);
  NearFieldScene scene(start, {}, {.alpha1 = 1.0, .alpha2 = 0.25, .beta1 = 2.0, .beta2 = 3.0});
  State state = scenes::start(scene);
  reach(scene, state, t_end, Collocation<Nodes>(),
        ErrorControl{.TOL = TOL, .sweep_TOL = 1e-2 * TOL, .step = 1e-2, .limit = t_end});
  const kinematics::Radial at = exact.at(t_end);
  const double distance = distance_of_pair(state);
  return std::hypot(distance - at.r, parting(state) / distance - at.v);
}

// The Oregonator's third substance, the slowest to forget, over one of its pulses.
template <class Nodes>
double error_of_reactions(double TOL) {
  const Oregonator problem;
  State state = Oregonator::start();
  const ErrorControl control{
      .TOL = TOL, .sweep_TOL = 1e-3 * TOL, .K_d = 3, .step = 1e-6, .limit = 360.0, .growth = 8.0, .worth = 1.2};
  // Concentrations are told apart above 1, as they are scaled.
  reach(problem, state, 360.0, Collocation<Nodes, Newton<>>({.size = 1.0}), control);
  double worst = 0.0;
  const double digits[] = {1.000814870318523, 1228.178521549917, 132.0554942846706};
  for (Eigen::Index k = 0; k < 3; ++k) worst = report::worse_of(worst, std::abs(state.y[k] / digits[k] - 1.0));
  return worst;
}

// With an estimate ~ Dt^(q + 1) a step, the step goes as TOL^(1/(q + 1)), and the error at the end as Dt^p.
template <class Nodes>
void compare_motion(Rows& rows, const std::string& method) {
  constexpr double power = Nodes::order / (Nodes::order + 1.0);
  write(rows, method, follow(1e-4, 1e-9, error_of_motion<Nodes>),
        {power - 0.15, power + 0.15, "p/(p + 1): the estimate has the order p of the method, error per step"});
}

template <class Nodes>
void compare_reactions(Rows& rows, const std::string& method, double loosest, double tightest) {
  constexpr double power = Nodes::order / (Nodes::stages + 1.0);
  write(rows, method, follow(loosest, tightest, error_of_reactions<Nodes>),
        {0.95, power + 0.05,
         "the estimate has order s: p/(s + 1) where the method has its order p = 2 s - 1, 1 where the reactions are so "
         "stiff that no more than that of its stages is left"});
}

const Case tolerance_proportionality{
    {.name = "tolerance_proportionality",
     .claim = "the attained error follows TOL with the power that the orders of method and estimate give",
     .equation = "D 3.4",
     .reference = Reference::convergence},
    [](Rows& rows) {
      compare_motion<Gauss<2>>(rows, "Gauss 2");
      compare_motion<Gauss<4>>(rows, "Gauss 4");
      compare_motion<Gauss<6>>(rows, "Gauss 6");
      compare_motion<Gauss<8>>(rows, "Gauss 8");
      compare_motion<Radau<3>>(rows, "Radau 3, fixed point");
      compare_reactions<Radau<3>>(rows, "Radau 3, Newton", 1e-3, 1e-8);
      compare_reactions<Radau<5>>(rows, "Radau 5, Newton", 1e-3, 1e-7);
    }};

// The breathing pair in other units, of other masses and seen from a moving frame: a tolerance is a plain number, so
// the steps are the same.

struct Units {
  double length, time, mass, frame;  // in m, s, kg; the frame's speed in m/s
};

struct Breathed {
  Outcome outcome;
  State state;  // in units of its length and time
  double distance = 0.0;
};

template <class S, class C>
Breathed breathe(const Units& in, S scheme, C control) {
  const double force = in.mass * in.length / (in.time * in.time);
  kinematics::Particles start = pair_at_rest(in.mass, in.mass, in.length);
  start.velocity.col(1).setConstant(in.frame);
  NearFieldScene scene(start, {},
                       {.alpha1 = force * std::pow(in.length, 2),
                        .alpha2 = 0.05 * force * std::pow(in.length, 3),
                        .beta1 = 2.0,
                        .beta2 = 3.0,
                        .scaling = laws::Scaling::pair});
  Breathed made{.outcome = {}, .state = scenes::start(scene)};
  made.outcome = integrate(scene, made.state, 5.3 * in.time, scheme, control);
  made.distance = distance_of_pair(made.state) / in.length;
  made.state.r /= in.length;
  made.state.v /= in.length / in.time;
  return made;
}

std::string counts_of(const Outcome& o) {
  return fmt::format("{} {} {} {}", o.steps, o.rejections, o.sweeps, o.evaluations);
}

template <class S, class C>
void compare_units(Rows& rows, const std::string& method, double off, const S& scheme, const C& control_of) {
  const Units plain{.length = 1.0, .time = 1.0, .mass = 1.0, .frame = 0.0};
  const Breathed in_metres = breathe(plain, scheme, control_of(plain));
  const kinematics::Breathing exact(kinematics::breathing_pair(1.0, 0.05, 1.0, 1.0), 1.0);
  rows.compare(
      "distance over its first, " + method,
      {.expected = exact.at(5.3).r,
       .computed = in_metres.distance,
       .tolerance = absolute(off),
       .because =
           "hundreds of steps within TOL = 1e-6, or by Phi_K of 1e-3 s, whose errors the near passage amplifies"});
  double worst = 0.0;
  for (const Units& units :
       {Units{0x1p-20, 1.0, 1.0, 0.0}, Units{0x1p-10, 0x1p-15, 0x1p-60, 0.0}, Units{0x1p30, 0x1p40, 0x1p80, 0.0}}) {
    const Breathed scaled = breathe(units, scheme, control_of(units));
    rows.equal(fmt::format("steps, refusals, sweeps, right-hand sides in units of {:.3g} m, {:.3g} s, {:.3g} kg, {}",
                           units.length, units.time, units.mass, method),
               {.expected = counts_of(in_metres.outcome),
                .computed = counts_of(scaled.outcome),
                .because = "the same problem in other units"});
    keep_worst(worst, (flat(scaled.state) - flat(in_metres.state)).lpNorm<Eigen::Infinity>());
  }
  rows.at_most("largest difference of the states in these units, " + method,
               {.limit = 0.0, .computed = worst, .because = "powers of two change no digit"});
  const Units moving{.length = 1.0, .time = 1.0, .mass = 1.0, .frame = 2e4};
  rows.compare("distance over its first, in a frame at 2e4 m/s, " + method,
               {.expected = in_metres.distance,
                .computed = breathe(moving, scheme, control_of(moving)).distance,
                .tolerance = absolute(2.0 * off),
                .because = "steps differ by what rounding of places of 1e5 m makes of the sweeps, 1e-11; the error is "
                           "that of the pair at rest"});
}

const Case tolerances_have_no_unit{
    {.name = "tolerances_have_no_unit",
     .claim = "a run under adaptive control takes the same steps whatever the units, and errs as little in a moving "
              "frame as at rest",
     .equation = "R 3.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const auto by_errors = [](const Units&) { return ErrorControl{.TOL = 1e-6}; };
      const auto by_sweeps = [](const Units& in) { return PhiControl{.TOL = 1e-6, .limit = 1e-3 * in.time}; };
      compare_units(rows, "Gauss 3", 1e-5, Collocation<Gauss<3>>(), by_errors);
      compare_units(rows, "Radau 3, Newton", 1e-3, Collocation<Radau<3>, Newton<>>(), by_errors);
      compare_units(rows, "RK4", 1e-4, RungeKutta4(), by_errors);
      compare_units(rows, "velocity Verlet", 1e-4, VelocityVerlet(), by_errors);
      compare_units(rows, "phi = 1/2, Phi_K control", 2e-3, PhiFamily<>(0.5), by_sweeps);
    }};

// RK4 and Verlet under error control, on an orbit whose near passage asks for steps a tenth of those elsewhere.

// A body around a fixed centre, r'' = -r/|r|^3, from its farthest point: after one period it is back there.
struct Orbit {
  static constexpr double distance = 1.0, speed = 0.6;  // [m], [m/s]: eccentricity 1 - 0.6^2

  bool acceleration(double, In r, Out a) const {
    a = -r / std::pow(r.norm(), 3);
    return r.norm() > 0.0;
  }
  static State start() { return {.r = Eigen::Vector2d(distance, 0.0), .v = Eigen::Vector2d(0.0, speed)}; }
  static double period() { return 2.0 * std::numbers::pi * std::pow(2.0 - speed * speed, -1.5); }
};

// What a run over a period costs, and what it gets for that.
struct Bought {
  double error = 0.0;
  long evaluations = 0;
};

template <class S, class C>
Bought orbit(S scheme, C control) {
  Orbit problem;
  State state = Orbit::start();
  const Outcome outcome = integrate(problem, state, Orbit::period(), scheme, control);
  require_reached(outcome);
  return {(flat(state) - flat(Orbit::start())).norm(), outcome.evaluations};
}

// At every tolerance the same number of right-hand sides is spent on fixed steps as well.
template <class S>
void compare_bought(Rows& rows, const std::string& method, double tightest, double gain) {
  Followed seen;
  double least = std::numeric_limits<double>::infinity();
  for (double TOL = 1e-4; TOL > 0.5 * tightest; TOL *= 0.1) {
    const Bought controlled = orbit(S(), ErrorControl{.TOL = TOL, .step = 1e-3, .limit = 1.0});
    const double stages = S::order == 4 ? 4.0 : 1.0;
    const double steps = std::round(static_cast<double>(controlled.evaluations) / stages);
    const Bought fixed = orbit(S(), FixedStep{.step = Orbit::period() / steps});
    seen.TOL.push_back(TOL);
    seen.errors.push_back(controlled.error);
    least = std::min(least, fixed.error / controlled.error);
  }
  rows.compare("slope of log error over log TOL, " + method,
               {.expected = 1.0,
                .computed = fitted_order(seen.TOL, seen.errors),
                .tolerance = absolute(0.1),
                .because = "p/(q + 1) with q the order of the estimate, p - 1 of both: error as of a run"});
  double largest = 0.0;
  for (std::size_t k = 0; k < seen.TOL.size(); ++k) keep_worst(largest, seen.errors[k] / seen.TOL[k]);
  rows.at_most("largest error over TOL, " + method,
               {.limit = 10.0, .computed = largest, .because = "one orbit, of some changes of the state by itself"});
  rows.at_least(
      "least error of fixed steps over that under control, as many right-hand sides, " + method,
      {.limit = gain,
       .computed = least,
       .because = "the passage, at 0.22 of the distance at first, rules a fixed step: a tenth of what the rest "
                  "of the way needs; half of what was seen, 220 and 33"});
}

const Case explicit_error_control{
    {.name = "explicit_error_control",
     .claim = "under error control RK4 and Verlet err as TOL, and where an orbit comes close less than with as "
              "many fixed steps",
     .equation = "D 3.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      compare_bought<RungeKutta4>(rows, "RK4", 1e-10, 110.0);
      compare_bought<VelocityVerlet>(rows, "velocity Verlet", 1e-7, 16.0);
    }};

// One oscillator: all its accelerations, and all derivatives of these, pass zero together, and with them either the
// leading coefficient or the size that it is taken over, twice a period.
template <class Nodes>
void compare_blind(Rows& rows, const std::string& method, double limit, const std::string& because) {
  double worst = 0.0, least = 1.0;
  for (int k = 0; k <= 10; ++k) {
    const double TOL = 1e-4 * std::pow(10.0, -0.5 * k);
    Oscillators one = oscillator(1.0);
    State state = motion(1.0, 0.0);
    Collocation<Nodes> scheme;
    ErrorControl control{.TOL = TOL, .sweep_TOL = 1e-2 * TOL, .step = 1e-2, .limit = 100.0};
    const auto watch = [&](const State& from, const State& to, double dt, Collocation<Nodes> made) {
      const double estimate = made.truncation(one, from, dt, to).error;
      if (from.t > 1.0) least = std::min(least, estimate / TOL);
      keep_worst(worst, std::hypot(to.r[0] - std::cos(to.t), to.v[0] + std::sin(to.t)) / TOL);
      return true;
    };
    require_reached(integrate(one, state, 25.0, scheme, control, watch));
  }
  rows.at_most("least estimate over TOL, " + method,
               {.limit = 1e-2, .computed = least, .because = "without a step that sees nothing there is no such case"});
  rows.at_most("largest error at any step over TOL, " + method,
               {.limit = limit, .computed = worst, .because = because});
}

const Case estimate_blind{
    {.name = "estimate_blind",
     .claim = "where the leading coefficient passes zero the estimate sees nothing, and the error is still bounded by "
              "what one step can grow",
     .equation = "D 3.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const char* const high = "elsewhere the estimate is hundreds of times too large, which makes up for it";
      compare_blind<Gauss<2>>(rows, "Gauss 2", 243.0, "the step after may be three times as long: 3^5 times TOL");
      compare_blind<Gauss<4>>(rows, "Gauss 4", 1.0, high);
      compare_blind<Gauss<8>>(rows, "Gauss 8", 1.0, high);
    }};

// The controller meets its tolerance in every step, and the answer is wrong: it bounds one error of two.

constexpr double t_end = 2.0, alpha2 = 0.5;
const ExactBreathing exact{.force = kinematics::breathing_pair(1.0, alpha2, 1.0, 1.0), .r_0 = 1.0};

NearFieldScene breathing() {
  return {pair_at_rest(1.0, 1.0, 1.0), {}, {.alpha1 = 1.0, .alpha2 = alpha2, .beta1 = 2.0, .beta2 = 3.0}};
}

// Phi_K control that writes down the largest error it accepted.
struct Honest {
  static constexpr bool ignores_truncation = true;
  PhiControl control;
  double worst = 0.0;

  double dt() const { return control.dt(); }
  bool goes_on(const Iteration& it) const { return control.goes_on(it); }
  Decision judge(const Attempt& made) {
    Decision decision = control.judge(made);
    if (decision.accepted) keep_worst(worst, made.iteration.w_K);
    return decision;
  }
};
void validate(const Honest& honest) { validate(honest.control); }

struct Answer {
  State state;
  double error = 0.0;  // of positions, over the farthest
  double worst_w = 0.0;
};

Answer solve(double TOL, double limit) {
  NearFieldScene scene = breathing();
  Answer answer{.state = scenes::start(scene)};
  BackwardEuler scheme;
  Honest control{.control = {.TOL = TOL, .K_d = 20, .step = limit, .limit = limit}};
  require_reached(integrate(scene, answer.state, t_end, scheme, control));
  BreathingErrors errors;
  compare_with(exact, pair_shape(1.0, 1.0), answer.state, errors);
  answer.error = errors.position;
  answer.worst_w = control.worst;
  return answer;
}

// How far particles moved from one state to another, each by itself, then summed; less what all of them share.
double moved(const State& from, const State& to, const Eigen::RowVector3d& shared = Eigen::RowVector3d::Zero()) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < from.r.size() / 3; ++i) {
    sum += (rows_of(to.r).row(i) - rows_of(from.r).row(i) - shared).norm();
  }
  return sum;
}

// What is compared with TOL: particles that move unequally far tell a sum from a largest and from one norm over all.
void compare_measure(Rows& rows) {
  const NearFieldScene scene(random_cloud({.N = 5}, smooth), {},
                             {.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 2.0, .beta2 = 3.0});
  const State from = scenes::start(scene);
  const auto swept = sweep_by_hand(BackwardEuler{}, scene, from, 1e-2, 3);
  const std::vector<State>& at = swept.iterates;
  const double displacement = moved(from, at[1], 1e-2 * rows_of(from.v).colwise().mean());
  for (std::size_t k = 0; k < 3; ++k) {
    rows.compare(fmt::format("w_{} of five particles", k),
                 {.expected = moved(at[k], at[k + 1]) / displacement,
                  .computed = swept.iterations[k].w_K,
                  .tolerance = absolute(64.0 * eps / displacement),
                  .because = "differences of positions of a few m, five of them, over the displacement"});
  }
}

void compare_wrong(Rows& rows) {
  constexpr double limit = 0.02;
  std::vector<double> errors;
  for (const double TOL : {1e-6, 1e-12}) {
    const Answer answer = solve(TOL, limit);
    rows.at_most(fmt::format("largest w_K of a step over TOL = {}", TOL),
                 {.limit = 1.0, .computed = answer.worst_w / TOL, .because = "the controller keeps its promise"});
    rows.at_least(fmt::format("error of positions, TOL = {}", TOL),
                  {.limit = 0.1,
                   .computed = answer.error,
                   .because = "backward Euler with 100 steps of 0.02 s loses energy that the closed form keeps"});
    errors.push_back(answer.error);
  }
  rows.compare("error of positions at TOL = 1e-12 over that at 1e-6",
               {.expected = 1.0,
                .computed = errors[1] / errors[0],
                .tolerance = relative(1e-4),
                .because = "100 steps, each changed by less than 1e-6 of its displacement"});
}

void compare_limits(Rows& rows) {
  for (const double TOL : {1e-6, 1e-12}) {
    std::vector<double> limits, errors;
    for (double limit = 4e-4; limits.size() < 5; limit /= 2.0) {
      limits.push_back(limit);
      errors.push_back(solve(TOL, limit).error);
    }
    rows.order(fmt::format("error of positions over Dt_lim, TOL = {}", TOL),
               {.nominal = 1.0,
                .steps = limits,
                .errors = errors,
                .floor = 1e-9,
                .because = "every step is Dt_lim; below 1e-9 lies what TOL = 1e-6 leaves"});
  }
}

// The iteration's own share: the difference to sweeps that went on to rounding at the same steps.
void compare_tolerances(Rows& rows) {
  constexpr double step = 5e-3;
  NearFieldScene scene = breathing();
  const auto run = [&](const FixedStep& control) {
    State state = scenes::start(scene);
    reach(scene, state, t_end, BackwardEuler(), control);
    return state;
  };
  const State settled = run({.step = step});
  std::vector<double> tolerances, errors;
  for (double TOL = 1e-2; tolerances.size() < 11; TOL /= std::sqrt(10.0)) {
    tolerances.push_back(TOL);
    errors.push_back((run({.step = step, .TOL = TOL}).r - settled.r).norm() / settled.r.norm());
  }
  rows.order("difference to sweeps that went on to rounding, over TOL",
             {.nominal = 1.0,
              .steps = tolerances,
              .errors = errors,
              .floor = 1e-14,
              .because = "the last change of every step is some share of TOL, a mean over 400 steps"});
}

const Case iteration_error_only{
    {.name = "iteration_error_only",
     .claim = "TOL bounds the iteration's error, to which it is proportional, and nothing else: it is met in every "
              "step of an answer that is 10 % off and that only a smaller Dt_lim mends",
     .equation = "R 3.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      compare_measure(rows);
      compare_wrong(rows);
      compare_limits(rows);
      compare_tolerances(rows);
    }};

}  // namespace verification::tolerances
