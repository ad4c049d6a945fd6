// Particles and the fluid that they move, as one system: against SUNDIALS, how sweeps between them contract, which
// steps they bear, and how often steps are refused.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/reference/integrator.hpp>
#include <particulate/report/table.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/sweeps.hpp>

#include "suspensions.hpp"

namespace verification::fluid_coupling {

using namespace particulate;
using namespace particulate::fluid;
using schemes::RungeKutta4;
using suspensions::in_turn;
using suspensions::still_water;

// --- The whole system against SUNDIALS.

// Particles of which each stays between the middles of the same cells, where weights are polynomials of the place, and
// on one branch of the drag: elsewhere schemes have no order.
template <class S>
struct Known {
  const S& suspension;
  schemes::State start;
  double t_end;
  schemes::State end = start;

  // Two families of which one judges the other, each number in units of the largest of its kind.
  double settle() {
    const reference::ExplicitRungeKutta fehlberg{
        .table = reference::Table::fehlberg_13_7_8, .relative = 1e-14, .absolute = 1e-14};
    require_reached(reference::integrate(suspension, end, t_end, fehlberg));
    schemes::State other = start;
    require_reached(
        reference::integrate(suspension, other, t_end, reference::Adams{.relative = 1e-14, .absolute = 1e-14}));
    return error(other);
  }
  double error(const schemes::State& at) const { return suspensions::error(suspension, at, end); }
  template <class Scheme, class Control>
  void order(Rows& rows, const std::string& name, double nominal, int coarsest, double floor, Scheme scheme,
             Control control) const {
    std::vector<double> steps, errors;
    for (int n = coarsest; steps.size() < 5; n = n * 3 / 2) {
      schemes::State state = start;
      control.step = t_end / n;
      reach(suspension, state, t_end, scheme, control);
      steps.push_back(control.step);
      errors.push_back(error(state));
    }
    rows.order(name, {.nominal = nominal,
                      .steps = steps,
                      .errors = errors,
                      .floor = floor,
                      .because = "no particle crosses the middle of a cell"});
  }
};

struct Coarsest {
  int rk4, gauss, one_sweep, sweeps;
};
template <class S>
void compare_with_sundials(Rows& rows, const std::string& name, const S& suspension, const schemes::State& start,
                           double t_end, const Coarsest& from) {
  Known<S> known{.suspension = suspension, .start = start, .t_end = t_end};
  const double floor = known.settle();
  rows.at_most(name + ", CVODE Adams against ARKODE",
               {.limit = 1e-10, .computed = floor, .because = "their floors, 1e-11 over a long run"});
  const Eigen::VectorXd Re = suspension.reynolds(start), Re_end = suspension.reynolds(known.end);
  rows.at_least(name + ", least Reynolds number",
                {.limit = 1.0, .computed = std::min(Re.minCoeff(), Re_end.minCoeff()), .because = "one branch"});
  rows.at_most(name + ", largest Reynolds number",
               {.limit = 400.0, .computed = std::max(Re.maxCoeff(), Re_end.maxCoeff()), .because = "one branch"});
  const double under = std::max(floor, 1e-15);
  known.order(rows, name + ", RK4", 4.0, from.rk4, under, RungeKutta4(), schemes::FixedStep{});
  known.order(rows, name + ", Gauss 2", 4.0, from.gauss, under, schemes::Collocation<schemes::Gauss<2>>(),
              schemes::FixedStep{});
  known.order(rows, name + ", one sweep", 1.0, from.one_sweep, under, in_turn(suspension),
              schemes::FixedSweeps{.sweeps = 1});
  known.order(rows, name + ", converged sweeps", 1.0, from.sweeps, under, in_turn(suspension),
              schemes::FixedStep{.TOL = 1e-5});
}

kinematics::Particle hot(const Eigen::Vector3d& x, const Eigen::Vector3d& v, double mass, double b, double theta) {
  return {.position = x, .velocity = v, .mass = mass, .radius = b, .temperature = theta, .heat_capacity = 900.0};
}

const Case against_sundials{
    {.name = "suspension_against_sundials",
     .claim = "particles and fluid as one system converge to what CVODE and ARKODE find: RK4 with order 4, Gauss "
              "collocation of two stages with 4, sweeps with 1",
     .equation = "R 8.4",
     .reference = Reference::sundials},
    [](Rows& rows) {
      // A liquid with sound at 1 m/s; hats over four cells, particles a third of a cell from their middles.
      const LiquidFlow<3> liquid(
          Grid<3>{.cells = {6, 6, 6}},
          {.state = {.Y = 1e3, .a_th = 1e-4}, .viscosity = {.mu = 1.0}, .c = 2500.0, .K = 2500.0}, {});
      const double h = 1.0 / 6.0, m = 0.8;
      const Suspension warm(
          liquid,
          kinematics::particles({hot({h, 2.0 * h, 3.0 * h}, {0.3, 0.1, -0.2}, m, 0.04, 600.0),
                                 hot({2.1 * h, 2.0 * h, 4.0 * h}, {-0.2, 0.25, 0.1}, 1.5 * m, 0.05, 450.0),
                                 hot({5.0 * h, 5.9 * h, h}, {0.1, 0.2, 0.3}, m, 0.04, 900.0)}),
          Spreading{.w = 2.0 * h}, HeatExchange{.h_c = 2e4, .emissivity = 0.9, .theta_s = 250.0, .a_v = 0.5});
      compare_with_sundials(rows, "liquid", warm, warm.start([](const Vector<3>& x) {
        const double s = std::sin(2.0 * std::numbers::pi * x[0]);
        return Local<3>{.rho = 1000.0 * (1.0 + 0.01 * s), .v = {0.01, 0.02 * s, 0.0}, .theta = 300.0 + 5.0 * s};
      }),
                            0.2, {.rk4 = 6, .gauss = 4, .one_sweep = 30, .sweeps = 30});
      // A gas with sound at 10 m/s between walls, one of them warm; the particles weigh twice their fluid.
      const GasFlow<2> gas(Grid<2>{.cells = {6, 6}},
                           {.state = {.R = 100.0 / 420.0}, .viscosity = {.mu = 6e-3}, .c = 100.0 / 168.0, .K = 6e-3},
                           {Wall<2>{.theta = 330.0}, Wall<2>{}, Wall<2>{.slips = true}, Wall<2>{}});
      const auto grain = [&](double x, double y, double u, double v, double theta) {
        kinematics::Particle all = hot({x * h, y * h, 0.0}, {u, v, 0.3}, 0.2, 0.03, theta);
        all.heat_capacity = 1.0;
        return all;
      };
      const Suspension dusty(
          gas, kinematics::particles({grain(2.0, 3.0, 0.8, 0.5, 500.0), grain(4.1, 2.9, -0.6, 0.7, 350.0)}),
          Spreading{.w = 2.0 * h}, HeatExchange{.h_c = 5.0, .emissivity = 0.8, .theta_s = 280.0, .a_v = 1.0});
      compare_with_sundials(rows, "gas between walls", dusty, dusty.start([](const Vector<2>& x) {
        const Vector<2> s = (std::numbers::pi * x).array().sin();
        return Local<2>{.rho = 1.2 + 0.1 * s[0], .v = {0.5 * s[0] * s[1], -0.4 * s[0] * s[1]}, .theta = 300.0};
      }),
                            0.1, {.rk4 = 12, .gauss = 8, .one_sweep = 60, .sweeps = 900});
    }};

// --- Sweeps between particles and fluid. So long cells that neither sound nor viscosity crosses one within a step:
// what is left is one slip, and what its force, spread and read again, changes.

constexpr double edge = 1e6, mu = 1.0, c_fluid = 2500.0;

template <int Dim>
struct Loaded {
  double Lambda, into;  // weight against the fluid's; how far from the middle of a cell, in cells
  double share = std::pow((1.0 - into) * (1.0 - into) + into * into, Dim);  // sum of squared weights
  double cell = std::pow(edge, Dim), b = Dim == 1 ? 1.0 : edge;
  double mass = Lambda * cell / share, tau = mass / (6.0 * std::numbers::pi * mu * b);

  BarotropicFlow<Dim> flow() const {
    Grid<Dim> grid;
    grid.cells.fill(4);
    grid.lengths.setConstant(4.0 * edge);
    return {grid, {.state = {.P_R = 0.0, .Y = 1e-9, .rho_R = 1.0}, .viscosity = {.mu = mu}}, {}};
  }
  auto suspension() const {
    Eigen::Vector3d x = Eigen::Vector3d::Zero();
    x.head<Dim>().setConstant((1.5 + into) * edge);
    return Suspension(flow(),
                      kinematics::particles({{.position = x, .velocity = {1e-9, 0, 0}, .mass = mass, .radius = b}}),
                      Spreading{.w = edge});
  }
  // Of what a step leaves out: sound, viscosity and the way of a particle, each against one.
  double neglected(double dt) const {
    const double sound = 3.2e-5 * dt / edge, viscous = 16.0 * mu * dt / (edge * edge);
    return sound * sound + viscous + 1e-9 * dt / edge;
  }
};
Local<1> at_rest(const Vector<1>&) { return {.rho = 1.0}; }
Local<2> at_rest_too(const Vector<2>&) { return {.rho = 1.0}; }

// How much less the sweep before last changed a part of the state than the last one does.
template <class S>
double contraction(const S& suspension, const schemes::State& start, double dt, std::size_t field) {
  const auto seen = schemes::sweep_by_hand(in_turn(suspension), suspension, start, dt, 5).iterates;
  const schemes::Part part = suspension.part(field);
  const auto change = [&](std::size_t k) {
    return (seen[k].y - seen[k - 1].y).segment(part.first, part.size).template lpNorm<1>();
  };
  return change(5) / change(4);
}

template <int Dim, class Rest>
void compare_contractions(Rows& rows, Rest rest) {
  for (const double Lambda : {0.1, 0.7, 2.0, 30.0}) {
    std::vector<double> ratios{0.3, 3.0};
    if (Lambda > 1.0) ratios = {0.3 / (Lambda - 1.0), 0.999 / (Lambda - 1.0), 1.001 / (Lambda - 1.0)};
    for (const double a : ratios) {
      const Loaded<Dim> of{.Lambda = Lambda, .into = Lambda == 2.0 ? 0.25 : 0.1};
      const auto suspension = of.suspension();
      rows.compare(fmt::format("drag, {}-D, Lambda = {}, Dt/tau_p = {:.5g}", Dim, Lambda, a),
                   {.expected = Lambda * a / (1.0 + a),
                    .computed = contraction(suspension, suspension.start(rest), a * of.tau, 2),
                    .tolerance = relative(std::max(1e-6, 3.0 * of.neglected(a * of.tau) * (1.0 + a) / (Lambda * a))),
                    .because = "what sound, viscosity and the particle's way add within the step"});
    }
  }
}

// One particle that is warmer than a liquid at rest around it.
struct Warm {
  double Lambda, h_c = 3e4, b = 0.1;
  double share = std::pow(0.8 * 0.8 + 0.2 * 0.2, 3.0), cell = 1.0 / 64.0;
  double mass = 2.0, c = Lambda * c_fluid * 1000.0 * cell / (share * mass);
  double tau = mass * c / (h_c * 4.0 * std::numbers::pi * b * b);

  auto suspension(double theta = 310.0, HeatExchange heat = {}) const {
    heat.h_c = h_c;
    const LiquidFlow<3> flow(Grid<3>{.cells = {4, 4, 4}},
                             {.state = {.Y = 1e-9, .a_th = 0.0}, .viscosity = {.mu = 1e-12}, .c = c_fluid, .K = 0.0},
                             {});
    const kinematics::Particle one{.position = Eigen::Vector3d::Constant(1.7 / 4.0),
                                   .mass = mass,
                                   .radius = b,
                                   .temperature = theta,
                                   .heat_capacity = c};
    return Suspension(flow, kinematics::particles({one}), Spreading{.w = 0.25}, heat);
  }
};

const Case contractions{
    {.name = "contraction_of_coupled_sweeps",
     .claim = "sweeps between particles and fluid contract by Lambda a/(1 + a), a = Dt/tau: Lambda is the mass of the "
              "particle, or its heat capacity, against that of the fluid as it is read; beyond a (Lambda - 1) = 1 they "
              "diverge",
     .equation = "D 8.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      compare_contractions<1>(rows, at_rest);
      compare_contractions<2>(rows, at_rest_too);
      for (const double Lambda : {0.3, 5.0}) {
        for (const double a : {0.3, 0.999 / std::abs(Lambda - 1.0), 1.001 / std::abs(Lambda - 1.0)}) {
          const Warm of{.Lambda = Lambda};
          const auto suspension = of.suspension();
          rows.compare(fmt::format("heat, Lambda = {}, Dt/tau = {:.5g}", Lambda, a),
                       {.expected = Lambda * a / (1.0 + a),
                        .computed = contraction(suspension, suspension.start(still_water), a * of.tau, 1),
                        .tolerance = relative(1e-9),
                        .because = "ten kelvins, and their rounding after four sweeps"});
        }
      }
    }};

// --- Steps. One sweep: v' = (v + a v_f)/(1 + a), v_f' = v_f - Lambda (v' - v), so that the slip is multiplied by
// 1 - (1 + Lambda) a/(1 + a): below -1 from a (Lambda - 1) = 2 on. RK4 sees the decay (1 + Lambda)/tau.

template <class S>
double growth(const S& suspension, schemes::State from, double dt, long steps, auto step, const auto& slip) {
  const schemes::Problem problem(suspension);
  const double before = slip(from);
  schemes::State to;
  for (long n = 0; n < steps; ++n, std::swap(from, to)) step(problem, from, dt, to);
  return std::pow(std::abs(slip(from) / before), 1.0 / static_cast<double>(steps));
}
template <class S>
auto one_sweep(const S& suspension) {
  return [scheme = in_turn(suspension)](const schemes::Problem& problem, const schemes::State& from, double dt,
                                        schemes::State& to) mutable {
    (void)scheme.predict(problem, from, dt, to);
    (void)scheme.sweep(problem, from, dt, to);
  };
}
auto by_rk4() {
  return [scheme = RungeKutta4()](const schemes::Problem& problem, const schemes::State& from, double dt,
                                  schemes::State& to) mutable { (void)scheme.predict(problem, from, dt, to); };
}
double rk4_growth(double D) { return 1.0 - D + D * D / 2.0 - std::pow(D, 3) / 6.0 + std::pow(D, 4) / 24.0; }
constexpr double rk4_reach = 2.785293563405282;

void compare_growths(Rows& rows, const std::string& of, const auto& suspension, const schemes::State& start,
                     double Lambda, double tau, const auto& slip, double tolerance) {
  const auto compare = [&](const std::string& name, double expected, double computed) {
    rows.compare(fmt::format("growth a step, {}, Lambda = {}, {}", of, Lambda, name),
                 {.expected = expected,
                  .computed = computed,
                  .tolerance = relative(tolerance),
                  .because = "what else a step does to the fluid, or rounding"});
  };
  for (const double share : {0.99, 1.01}) {
    const double a = share * 2.0 / (Lambda - 1.0), D = share * rk4_reach;
    compare(fmt::format("one sweep at {} of its limit", share), std::abs(1.0 - (1.0 + Lambda) * a / (1.0 + a)),
            growth(suspension, start, a * tau, 20, one_sweep(suspension), slip));
    compare(fmt::format("RK4 at {} of its limit", share), rk4_growth(D),
            growth(suspension, start, D * tau / (1.0 + Lambda), 20, by_rk4(), slip));
  }
}

template <class S, class Scheme, class Control>
schemes::Outcome one_step(const S& suspension, schemes::State state, double dt, Scheme scheme, Control control) {
  control.step = dt;
  return schemes::integrate(suspension, state, dt, scheme, control);
}

// A fixed step a thousandth beyond is refused by name, with the step that works, and a thousandth below is made.
template <class S, class Scheme, class Control>
void compare_refusal(Rows& rows, const std::string& by, const std::string& key_words, const S& suspension,
                     const schemes::State& start, double limit, Scheme scheme, Control control) {
  schemes::Outcome outcome;
  rows.must_be_refused("a step beyond, " + by, key_words, [&] {
    outcome = one_step(suspension, start, 1.001 * limit, scheme, control);
    return ending_of(outcome);
  });
  rows.compare("the step that works, " + by + " [s]", {.expected = limit,
                                                       .computed = outcome.workable_step,
                                                       .tolerance = relative(1e-4),
                                                       .because = "sound and viscosity beside it"});
  rows.equal("a step below, " + by,
             {.expected = "reached",
              .computed = std::string(name(one_step(suspension, start, 0.999 * limit, scheme, control).status)),
              .because = "it is within"});
}

void compare_scales(Rows& rows, const std::string& of, const std::vector<schemes::TimeScale>& scales,
                    const std::vector<std::pair<std::string, double>>& expected) {
  for (const auto& [name, seconds] : expected) {
    double computed = missing;
    for (const schemes::TimeScale& scale : scales) computed = scale.name == name ? scale.seconds : computed;
    rows.compare(fmt::format("{}, time scale of {} [s]", of, name),
                 {.expected = seconds, .computed = computed, .tolerance = relative(1e-9), .because = "rounding"});
  }
}

const std::string by_mass = "mass of the particles against their fluid's",
                  by_capacity = "heat capacity of the particles against their fluid's";

const Case steps{
    {.name = "steps_of_suspensions",
     .claim = "drag, heat and the weight of particles limit a step as derived: at the limit slips and differences of "
              "temperature begin to grow, and beyond it a fixed step is refused by name",
     .equation = "D 8.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      constexpr double Lambda = 4.0;
      const Loaded<1> loaded{.Lambda = Lambda, .into = 0.25};
      const auto dusty = loaded.suspension();
      const schemes::State slipping = dusty.start(at_rest);
      compare_growths(
          rows, "slip", dusty, slipping, Lambda, loaded.tau,
          [&](const schemes::State& at) { return dusty.streams(at)[0].v[0] - at.v[0]; }, 1e-5);
      const Warm of{.Lambda = Lambda};
      const auto warm = of.suspension();
      const schemes::State unequal = warm.start(still_water);
      compare_growths(
          rows, "temperatures", warm, unequal, Lambda, of.tau,
          [&](const schemes::State& at) { return warm.streams(at)[0].theta - at.y.tail(1)[0]; }, 1e-8);

      const double tau = loaded.tau;
      compare_refusal(rows, "drag by RK4", "span drag take at most", dusty, slipping, rk4_reach * tau / (1.0 + Lambda),
                      RungeKutta4(), schemes::FixedStep{});
      compare_refusal(rows, "mass by one sweep", "span " + by_mass, dusty, slipping, 2.0 * tau / (Lambda - 1.0),
                      in_turn(dusty), schemes::FixedSweeps{.sweeps = 1});
      compare_refusal(rows, "mass by two sweeps", "span " + by_mass, dusty, slipping, tau / (Lambda - 1.0),
                      in_turn(dusty), schemes::FixedSweeps{.sweeps = 2});
      compare_refusal(rows, "heat by RK4", "span heat of the particles take", warm, unequal,
                      rk4_reach * of.tau / (1.0 + Lambda), RungeKutta4(), schemes::FixedStep{});
      compare_refusal(rows, "heat capacity by one sweep", "span " + by_capacity, warm, unequal,
                      2.0 * of.tau / (Lambda - 1.0), in_turn(warm), schemes::FixedSweeps{.sweeps = 1});
    }};

const Case limits{
    {.name = "time_scales_of_suspensions",
     .claim = "the time scales of a suspension have the names and values of their formulas, particles that share cells "
              "and radiation included; and where particles weigh a hundred times their gas, the adaptive step shrinks "
              "to that scale and says so",
     .equation = "D 8.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      constexpr double pi = std::numbers::pi, dense = 1.2, h = 0.125;
      // Two particles beside each other across a gas of one direction: they share their cells.
      const auto dust = [&](double y, double mass, double b) {
        kinematics::Particle all = hot({0.55, y, 0.0}, {1e-6, 0.0, 0.0}, mass, b, 500.0);
        all.heat_capacity = 800.0;
        return all;
      };
      constexpr double m_0 = 20.0, m_1 = 10.0, b_0 = 0.02, b_1 = 0.01, h_c = 40.0;
      const GasFlow<1> gas(Grid<1>{.cells = {8}}, {.viscosity = {.mu = 1.8e-5}, .c = 717.5}, {});
      const Suspension pair(gas, kinematics::particles({dust(0.0, m_0, b_0), dust(1.0, m_1, b_1)}), Spreading{.w = h},
                            HeatExchange{.h_c = h_c, .emissivity = 0.7});
      const schemes::State start = pair.start([](const Vector<1>&) { return Local<1>{.rho = dense}; });
      // The middle of cell 4 is at 0.5625: a tenth of a cell away.
      const double share = 0.9 * 0.9 + 0.1 * 0.1, cell = dense * h;
      const double xi_0 = 6.0 * pi * 1.8e-5 * b_0, xi_1 = 6.0 * pi * 1.8e-5 * b_1, R = share * (xi_0 + xi_1) / cell;
      const double Lambda = share * (m_0 + m_1) / cell, hot_Lambda = Lambda * 800.0 / 717.5;
      const auto area = [](double b) { return 4.0 * pi * b * b; };
      const double heats = h_c + 4.0 * 0.7 * 5.670374419e-8 * 500.0 * 500.0 * 500.0;
      const double cools = std::max(heats * area(b_0) / (m_0 * 800.0), heats * area(b_1) / (m_1 * 800.0));
      const double warms = share * h_c * (area(b_0) + area(b_1)) / (cell * 717.5);
      compare_scales(rows, "two in the same cells", pair.step_limits(start),
                     {{"drag", 1.0 / (std::max(xi_0 / m_0, xi_1 / m_1) + R)},
                      {by_mass, 1.0 / (R * (1.0 - 1.0 / Lambda))},
                      {"heat of the particles", 1.0 / (cools + warms)},
                      {by_capacity, 1.0 / (warms * (1.0 - 1.0 / hot_Lambda))}});

      // Sound is slow here, and the sweeps are hardly asked to converge.
      const Loaded<1> loaded{.Lambda = 100.0, .into = 0.25};
      const auto heavy = loaded.suspension();
      schemes::State state = heavy.start(at_rest);
      double longest = 0.0;
      const schemes::Outcome outcome = schemes::integrate(
          heavy, state, 0.5 * loaded.tau, in_turn(heavy, 1e3),
          schemes::PhiControl{.TOL = 1.0, .step = 1e-4 * loaded.tau, .limit = loaded.tau},
          [&](const auto&, const auto&, double dt, const auto&) { return longest = std::max(longest, dt), true; });
      require_reached(outcome);
      rows.compare("longest step over tau_p at a loading of 100", {.expected = 1.0 / 99.0,
                                                                   .computed = longest / loaded.tau,
                                                                   .tolerance = relative(1e-4),
                                                                   .because = "sound and viscosity beside it"});
      rows.equal("ruled by", {.expected = by_mass, .computed = outcome.ruled, .because = "nothing else asks"});
    }};

// --- What aiming below K_d contractions saves.

struct Spent {
  long steps, refused, sweeps, evaluations;
  double longest;
};
template <class S>
Spent spend(const S& suspension, int spare, double t_end) {
  schemes::State state = suspension.start(still_water);
  double longest = 0.0;
  const schemes::Outcome outcome = schemes::integrate(
      suspension, state, t_end, in_turn(suspension),
      schemes::PhiControl{.TOL = 1.0, .K_d = 10, .step = 1e-4, .limit = 0.01, .spare = spare},
      [&](const auto&, const auto&, double dt, const auto&) { return longest = std::max(longest, dt), true; });
  require_reached(outcome);
  return {outcome.steps, outcome.rejections, outcome.sweeps, outcome.evaluations, longest};
}

void compare_spare(Rows& rows, report::Table& table, const std::string& near_fields, const auto& suspension) {
  std::array<Spent, 2> spent{};
  for (const int to_spare : {0, 2}) {
    Spent& now = spent[static_cast<std::size_t>(to_spare / 2)];
    now = spend(suspension, to_spare, rows.quick() ? 0.3 : 1.0);
    table.add({near_fields, to_spare, now.steps, now.refused, now.sweeps, now.evaluations, now.longest});
  }
  const auto refused = [](const Spent& of) {
    return static_cast<double>(of.refused) / static_cast<double>(of.steps + of.refused);
  };
  rows.at_least("share of steps refused, spare = 0, near fields " + near_fields,
                {.limit = 0.2,
                 .computed = refused(spent[0]),
                 .because = "what meets TOL asks for more, until it fails: a prototype found a third"});
  rows.at_most("share of steps refused, spare = 2, near fields " + near_fields,
               {.limit = 0.05,
                .computed = refused(spent[1]),
                .because = "two contractions are room for what changes from step to step"});
  rows.at_most("sweeps, spare = 2 over spare = 0, near fields " + near_fields,
               {.limit = 1.0,
                .computed = static_cast<double>(spent[1].sweeps) / static_cast<double>(spent[0].sweeps),
                .because = "refused steps cost more than shorter ones"});
}

const Case spare{
    {.name = "contractions_to_spare",
     .claim = "aiming at exactly K_d contractions refuses a third of the steps of the volume element; aiming at "
              "K_d - 2 hardly any, for less work",
     .equation = "D 3.4",
     .reference = Reference::design},
    [](Rows& rows) {
      report::Table table({"near fields", "spare", "steps", "refused", "sweeps", "fields solved", "longest step [s]"});
      const suspensions::VolumeElement element(rows.quick() ? 8 : 16, rows.quick() ? 60 : 200, smooth, rows.threads());
      compare_spare(rows, table, "absent", element.with());
      compare_spare(rows, table, "used", element.with(suspensions::near_field));
      rows.write("contractions_to_spare", table);
    }};

}  // namespace verification::fluid_coupling
