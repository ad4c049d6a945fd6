// Drag of one sphere: its coefficient, terminal speeds, decays in closed form, and its part in impacts.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <particulate/contact/located_contact.hpp>
#include <particulate/fluid/suspension.hpp>
#include <particulate/laws/gravity.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/runge_kutta.hpp>

#include "suspensions.hpp"

namespace verification::drag_of_spheres {

using namespace particulate;
using namespace particulate::fluid;
using kinematics::Space;
using schemes::RungeKutta4;
using suspensions::in_turn, suspensions::match;

constexpr double pi = std::numbers::pi;
const Stream air{.rho = 1.2, .mu = 1.8e-5}, water{.rho = 1000.0, .mu = 1e-3};

const Case coefficient{
    {.name = "drag_coefficient",
     .claim = "C_D has Chow's values and jumps up to Re = 1e8, and at rest drag is that of Stokes",
     .equation = "R 8.1.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const auto row = [&](const std::string& what, double expected, double computed, double tolerance = 1e-14) {
        match(rows, what, expected, computed, tolerance, "a power, rounded, against 25 digits");
      };
      row("C_D at Re = 0.5", 48.0, drag_coefficient(0.5));
      row("C_D at Re = 20", 3.465340102941153, drag_coefficient(20.0));
      row("C_D at Re = 1e4", 0.5, drag_coefficient(1e4));
      row("C_D at Re = 1e6", 0.1344253219822990, drag_coefficient(1e6));
      row("C_D at Re = 1e8", 0.18, drag_coefficient(1e8));
      const auto jump = [](double Re) { return drag_coefficient(Re * (1.0 + 1e-15)) / drag_coefficient(Re) - 1.0; };
      row("C_D at Re = 1, from above", 24.0, drag_coefficient(1.0 + 1e-15));
      row("jump at Re = 400", -7.146579863833686e-4, jump(400.0), 1e-11);
      row("jump at Re = 3e5", -0.8393131203114518, jump(drag_crisis));
      row("jump at Re = 2e6", -4.362841781680669e-3, jump(2e6), 1e-11);
      const double stokes = 6.0 * pi * water.mu * 1e-3;
      for (const double u : {0.0, 1e-320, 1e-300, 0.5e-3}) {
        row(fmt::format("xi at {} m/s over that of Stokes", u), 1.0, drag_rate(water, 1e-3, u) / stokes);
      }
      row("drag at Re = 1e8 [N]", 0.09 * 1000.0 * 2.5e9 * pi * 1e-6, drag(water, 1e-3, {-5e4, 0.0, 0.0}).norm());
    }};

kinematics::Particles sphere(double diameter, double density, const Eigen::Vector3d& v = Eigen::Vector3d::Zero()) {
  return kinematics::particles({{.position = Eigen::Vector3d::Zero(),
                                 .velocity = v,
                                 .mass = pi / 6.0 * std::pow(diameter, 3) * density,
                                 .radius = 0.5 * diameter}});
}

// How fast a sphere that starts downwards at some speed falls in the end.
double fallen(const Stream& fluid, double diameter, double density, double from, double terminal) {
  const kinematics::Particles one = sphere(diameter, density, {0.0, 0.0, -from});
  const scenes::Scene scene(one, Space{}, Drag{fluid}, laws::Gravity{}, Buoyancy{fluid});
  schemes::State at = scenes::start(scene);
  const double relaxes = one.mass[0] / drag_rate(fluid, one.radius[0], terminal);
  advance<RungeKutta4>(scene, at, 60.0 * relaxes, 1200);
  return -at.v[2];
}

const Case terminal{
    {.name = "terminal_speeds",
     .claim = "a sphere falls at the speed at which drag bears its weight, on every branch; where there are two, at "
              "the one on its side of the jump",
     .equation = "D 8.1.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const auto check = [&](const std::string& what, const Stream& fluid, double diameter, double density,
                             const std::vector<double>& expected, const std::vector<double>& from, double digits) {
        const double force = pi / 6.0 * std::pow(diameter, 3) * (density - fluid.rho) * 9.81;
        const std::vector<double> speeds = steady_speeds(fluid, 0.5 * diameter, force);
        rows.equal(what + ": speeds", {.expected = expected.size(),
                                       .computed = speeds.size(),
                                       .because = "the branches on which drag meets the weight"});
        for (std::size_t k = 0; k < std::min(expected.size(), speeds.size()); ++k) {
          match(rows, fmt::format("{}: speed {} [m/s]", what, k), expected[k], speeds[k], digits,
                "the digits of the reference");
        }
        for (const double start : from) {
          const double end = expected.size() > 1 && start > 3.0 ? expected[1] : expected[0];
          match(rows, fmt::format("{}: end of a fall from {} m/s [m/s]", what, start), end,
                fallen(fluid, diameter, density, start, end), std::max(digits, 1e-13),
                "60 relaxation times: what is left of the start is rounding");
        }
      };
      check("0.02 mm in air", air, 2e-5, 2000.0, {(2000.0 - 1.2) * 9.81 * 4e-10 / (18.0 * 1.8e-5)}, {0.0}, 1e-14);
      check("0.1 mm in air", air, 1e-4, 2000.0, {0.420250134294}, {0.0, 1.0}, 2e-12);
      check("1 mm in air", air, 1e-3, 2500.0, {7.38063953868}, {0.0, 20.0}, 1e-12);
      check("1 mm in water", water, 1e-3, 2650.0, {0.151913231804}, {0.0, 1.0}, 3e-12);
      // The jump is at 3 m/s, and repels.
      check("0.1 m in water", water, 0.1, 2500.0, {1.98090888230630, 4.52587485121284}, {0.0, 2.999, 3.001, 10.0},
            3e-15);
      check("0.4 m in water", water, 0.4, 3000.0, {7.62452184293109}, {6.0, 20.0}, 3e-15);
    }};

const Case window{
    {.name = "two_terminal_speeds",
     .claim = "there are two steady speeds for 7.231e9 < C_D Re^2 < 4.5e10, and at each speed drag is the force",
     .equation = "D 8.1.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const auto force = [](double G) { return pi * water.mu * water.mu * G / (8.0 * water.rho); };
      const auto count = [&](double G) { return steady_speeds(water, 0.05, force(G)).size(); };
      const auto row = [&](const char* what, std::size_t expected, double G) {
        rows.equal(what, {.expected = expected, .computed = count(G), .because = "the two sides of the jump at 3e5"});
      };
      row("speeds just below the window", 1, 7230909585.98467 * (1.0 - 1e-12));
      row("speeds just inside, below", 2, 7230909585.98467 * (1.0 + 1e-12));
      row("speeds just inside, above", 2, 4.5e10 * (1.0 - 1e-12));
      row("speeds just above the window", 1, 4.5e10 * (1.0 + 1e-12));
      double off = 0.0;
      for (double G = 1e-6; G < 1e17; G *= 1.3) {
        const std::vector<double> speeds = steady_speeds(water, 0.05, force(G));
        if (speeds.empty()) off = missing;
        for (const double u : speeds) {
          off = report::worse_of(off, std::abs(drag(water, 0.05, {u, 0.0, 0.0}).norm() / force(G) - 1.0));
        }
      }
      rows.at_most("drag at a steady speed off the force, over it, for C_D Re^2 from 1e-6 to 1e17",
                   {.limit = 1e-13, .computed = off, .because = "two powers, rounded"});
    }};

// A sphere of 0.1 m that is pushed, over one step of 0.1 s in soft water, which is 3 m/s from the jump.
struct Pushed {
  schemes::State from = {}, to = {};
  RootsTaken roots = {};
  double off = 0.0;  // from what backward Euler asks, over the speed
};
Pushed push(double speed, double acceleration) {
  const BarotropicFlow<3> flow(Grid<3>{.cells = {8, 8, 8}, .lengths = Vector<3>::Constant(2.0)},
                               {.state = {.Y = 1e3}, .viscosity = {.mu = water.mu}}, {});
  const kinematics::Particles one = sphere(0.1, 2500.0, {speed, 0.0, 0.0});
  const Suspension both(flow, one, {}, NoHeat{}, laws::Gravity{{acceleration, 0.0, 0.0}});
  Pushed all{.from = both.start([](const Vector<3>&) { return Local<3>{.rho = 1000.0}; })};
  all.to = all.from;
  const double dt = 0.1;
  schemes::Staggered scheme = in_turn(both, 1e-9);
  require_reached(schemes::integrate(both, all.to, dt, scheme, schemes::FixedStep{.step = dt, .TOL = 1.0}));
  all.roots = both.roots_taken();
  const Eigen::Vector3d v = schemes::velocity(all.to, 0),
                        gained = (v - schemes::velocity(all.from, 0)) / dt - Eigen::Vector3d(acceleration, 0.0, 0.0);
  all.off = (gained - drag(both.streams(all.to)[0], 0.05, v) / one.mass[0]).norm() * dt / v.norm();
  return all;
}

const Case roots{
    {.name = "roots_of_implicit_drag",
     .claim = "an implicit step that has two roots beside the jump comes to the one on whose side its first iterate "
              "is, and says which",
     .equation = "D 8.4",
     .reference = Reference::identity},
    [](Rows& rows) {
      const auto check = [&](const std::string& what, const Pushed& seen, int slow, int fast) {
        const auto row = [&](const char* which, int expected, long computed) {
          rows.equal(what + ": " + which,
                     {.expected = expected, .computed = computed, .because = "u (1 + dt xi(u)/m) falls at the jump"});
        };
        row("slow roots", slow, seen.roots.slow);
        row("fast roots", fast, seen.roots.fast);
        rows.equal(what + ": whether it is beyond the jump",
                   {.expected = fast, .computed = seen.to.v[0] > 3.0, .because = "as it says"});
        rows.at_most(what + ": velocity off what backward Euler asks, over it",
                     {.limit = 1e-11, .computed = seen.off, .because = "sweeps to 1e-9 of the step"});
      };
      check("from 2 m/s, pushed to 3.7 m/s", push(2.0, 17.0), 1, 0);
      check("from 3.7 m/s", push(3.7, 0.0), 0, 1);
      // The drag of so slow a start lets the first iterate get to 3.4 m/s.
      check("from 0.5 m/s, pushed to 3.7 m/s", push(0.5, 32.0), 0, 1);
      check("from 2 m/s", push(2.0, 0.0), 0, 0);
    }};

const Case chow{{.name = "decay_of_a_grain",
                 .claim = "a grain of 1 mm in water slows down from 0.2 to 0.05 m/s in 40.38 ms over 4.133 mm",
                 .equation = "R 8.1.1",
                 .reference = Reference::closed_form},
                [](Rows& rows) {
                  const scenes::Scene scene(sphere(1e-3, 2650.0, {0.2, 0.0, 0.0}), Space{}, Drag{water});
                  const auto check = [&](const std::string& name, auto scheme, schemes::FixedStep control) {
                    schemes::State at = scenes::start(scene);
                    schemes::Watch watch({{.function = [](const schemes::State& state) { return state.v[0] - 0.05; }}});
                    const schemes::Outcome ends = schemes::integrate(scene, at, 1.0, scheme, control, watch);
                    const auto row = [&](const char* what, double expected, double computed) {
                      match(rows, name + what, expected, computed, 1e-10,
                            "200 steps of order 4, each a hundredth of what drag relaxes in");
                    };
                    rows.equal(name + ": how it ends",
                               {.expected = std::string(schemes::name(schemes::Status::stopped)),
                                .computed = std::string(schemes::name(ends.status)),
                                .because = "it reaches 0.05 m/s"});
                    row(": time [s]", 0.0403811000235219, at.t);
                    row(": way [m]", 4.13281319147197e-3, at.r[0]);
                  };
                  check("RK4", RungeKutta4(), {.step = 2e-4});
                  check("Gauss 2", schemes::Collocation<schemes::Gauss<2>>(), {.step = 2e-4, .TOL = 1e-13});
                }};

const Case constant{
    {.name = "fall_at_constant_drag",
     .claim = "at constant C_D a fall is a hyperbolic tangent in time, its way a logarithm",
     .equation = "R 8.1.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const kinematics::Particles ball = sphere(0.1, 2500.0, {0.0, 0.0, -1.0});
      const scenes::Scene scene(ball, Space{}, Drag{air}, laws::Gravity{});
      schemes::State at = scenes::start(scene);
      const double t = 4.0, g = 9.81, K = 0.25 * air.rho * pi * 0.0025 / ball.mass[0];
      advance<RungeKutta4>(scene, at, t, 200);
      const double limit = std::sqrt(g / K), before = std::atanh(1.0 / limit), after = before + t * std::sqrt(g * K);
      match(rows, "speed after 4 s [m/s]", limit * std::tanh(after), -at.v[2], 1e-12, "200 steps of order 4");
      match(rows, "way [m]", std::log(std::cosh(after) / std::cosh(before)) / K, -at.r[2], 1e-12, "the same");
    }};

// One sphere in each cell, all at the same place in it: so the gas stays uniform, and each has the mass of a cell.
struct Lattice {
  static constexpr double m = 0.05, b = 0.02, c_p = 20.0, M = 1.2 / 16.0, c_f = 1.75;
  double mu = 1e-5, w_0 = 0.0, theta_p = 300.0;
  HeatExchange heat = {};

  // The state at time t of the first of them, and of its cell.
  struct End {
    double past, momentum, theta_p, theta_f;
  };
  End at(double t, long steps) const {
    const GasFlow<2> gas(Grid<2>{.cells = {4, 4}}, {.state = {.R = 0.7}, .viscosity = {.mu = mu}, .c = c_f, .K = 1.0},
                         {});
    std::vector<kinematics::Particle> list;
    for (int k = 0; k < 16; ++k) {
      list.push_back({.position = {0.25 * (k % 4) + 0.07, 0.25 * (k / 4) + 0.11, 0.0},
                      .velocity = {w_0, 0.0, 0.0},
                      .mass = m,
                      .radius = b,
                      .temperature = theta_p,
                      .heat_capacity = c_p});
    }
    const Suspension both(gas, kinematics::particles(list), {.w = 0.3}, heat);
    schemes::State state = both.start([](const Vector<2>&) { return Local<2>{.rho = 1.2, .theta = 300.0}; });
    advance<RungeKutta4>(both, state, t, steps);
    const Local<2> there = both.local(state, 0);
    return {.past = state.v[0] - there.v[0],
            .momentum = m * state.v[0] + M * there.v[0],
            .theta_p = state.y[state.y.size() - 16],
            .theta_f = there.theta};
  }
};

const Case exchange{
    {.name = "exchange_with_a_uniform_fluid",
     .claim = "spheres and a fluid that stays uniform come together in velocity and temperature as two bodies do, and "
              "share what drag dissipates as a_v says",
     .equation = "R 8.1.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const auto row = [&](const std::string& what, double expected, double computed) {
        rows.compare(what, {.expected = expected,
                            .computed = computed,
                            .tolerance = mixed(1e-10, 1e-11),
                            .because = "some hundred steps of RK4, and the rounding of 300 K in as many"});
      };
      using L = Lattice;
      const double both = 1.0 / L::m + 1.0 / L::M, area = 4.0 * pi * L::b * L::b;
      for (const double a_v : {0.0, 0.3, 1.0}) {
        const double w_0 = 10.0, t = 5.0, B = 0.25 * 1.2 * pi * L::b * L::b * both, w = w_0 / (1.0 + B * w_0 * t);
        const double D = 0.5 / both * (w_0 * w_0 - w * w);
        const L::End end = L{.w_0 = w_0, .heat = {.a_v = a_v}}.at(t, 500);
        row(fmt::format("C_D = 0.5, a_v = {}: velocity past each other [m/s]", a_v), w, end.past);
        row(fmt::format("C_D = 0.5, a_v = {}: momentum [kg m/s]", a_v), L::m * w_0, end.momentum);
        row(fmt::format("C_D = 0.5, a_v = {}: warming of a sphere [K]", a_v), a_v * D / (L::m * L::c_p),
            end.theta_p - 300.0);
        row(fmt::format("C_D = 0.5, a_v = {}: warming of the fluid [K]", a_v), (1.0 - a_v) * D / (L::M * L::c_f),
            end.theta_f - 300.0);
      }
      const double t = 0.1, stokes = 6.0 * pi * L::b;
      row("Stokes: velocity past each other [m/s]", std::exp(-stokes * both * t),
          L{.mu = 1.0, .w_0 = 1.0}.at(t, 200).past);
      const double rate = 1000.0 * area * (1.0 / (L::m * L::c_p) + 1.0 / (L::M * L::c_f)), later = 0.05;
      const L::End warm = L{.theta_p = 400.0, .heat = {.h_c = 1000.0}}.at(later, 400);
      row("warmer than the fluid [K]", 100.0 * std::exp(-rate * later), warm.theta_p - warm.theta_f);
      row("heat of both [J]", L::m * L::c_p * 400.0 + L::M * L::c_f * 300.0,
          L::m * L::c_p * warm.theta_p + L::M * L::c_f * warm.theta_f);
    }};

// A grain so light that nothing moves the gas around it.
const Case step_share{
    {.name = "share_of_a_sweep",
     .claim = "whatever the number of sweeps and however long the step, a grain in a gas at rest warms by a_v of the "
              "kinetic energy that it loses",
     .equation = "R 8.1.2",
     .reference = Reference::identity},
    [](Rows& rows) {
      const double m = 1e-9, c = 20.0, a_v = 0.3;
      const GasFlow<2> gas(Grid<2>{.cells = {4, 4}},
                           {.state = {.R = 7e-3}, .viscosity = {.mu = 1e-5}, .c = 1.75, .K = 0.1}, {});
      const Suspension both(gas,
                            kinematics::particles({{.position = {0.3, 0.4, 0.0},
                                                    .velocity = {0.04, 0.0, 0.0},
                                                    .mass = m,
                                                    .radius = 1e-4,
                                                    .temperature = 300.0,
                                                    .heat_capacity = c}}),
                            {.w = 0.3}, HeatExchange{.a_v = a_v});
      const schemes::State start = both.start([](const Vector<2>&) { return Local<2>{.rho = 1.2, .theta = 300.0}; });
      for (const int sweeps : {1, 2, 3}) {
        schemes::State at = start;
        reach(both, at, 0.05, in_turn(both, 1.0), schemes::FixedSweeps{.step = 0.05, .sweeps = sweeps});
        match(rows, fmt::format("{} sweeps of a step as long as it relaxes: heat over what it loses", sweeps), a_v,
              c * (at.y.tail(1)[0] - 300.0) / (0.5 * (0.04 * 0.04 - at.v[0] * at.v[0])), 1e-6,
              "a grain of 1e-8 of a cell's mass, and a warming of 1e8 roundings of 300 K");
      }
    }};

// A Stokes stream at rest around spheres of 0.1 m that relax within a second.
const Stream honey{.rho = 1.0, .mu = 1.0, .theta = 300.0};
constexpr double honey_mass = 6.0 * pi * 0.05;

const Case one_way_heat{
    {.name = "heat_from_a_stream",
     .claim = "a sphere in a stream warms by convection and by its share of what drag dissipates",
     .equation = "R 8.1.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const double c = 10.0, w_0 = 4.0, a_v = 0.6, t = 0.7;
      const scenes::Scene scene(kinematics::particles({{.position = {0.0, 0.0, 0.0},
                                                        .velocity = {w_0, 0.0, 0.0},
                                                        .mass = honey_mass,
                                                        .radius = 0.05,
                                                        .temperature = 350.0,
                                                        .heat_capacity = c}}),
                                Space{}, Drag{honey}, HeatFromFluid{honey, HeatExchange{.h_c = 400.0, .a_v = a_v}});
      schemes::State at = scenes::start(scene);
      advance<RungeKutta4>(scene, at, t, 400);
      const double k = 400.0 * 4.0 * pi * 0.0025 / (honey_mass * c);
      const double dragged = a_v * w_0 * w_0 / c * (std::exp(-2.0 * t) - std::exp(-k * t)) / (k - 2.0);
      match(rows, "temperature over that of the stream [K]", 50.0 * std::exp(-k * t) + dragged, at.y[0] - 300.0, 1e-10,
            "400 steps of order 4, and the digits that 300 K takes");
    }};

// Two spheres that touch, in a stream of 3 m/s and constant C_D.
const Stream fast{.v = {3.0, 1.0, 0.0}, .rho = 50.0, .mu = 1e-3};
kinematics::Particles touching() {
  return kinematics::particles(
      {{.position = {0.4375, 0.5, 0.5}, .velocity = {1.5, 0.0, 0.1}, .mass = 0.2, .radius = 0.0625},
       {.position = {0.53125, 0.5, 0.5}, .velocity = {-0.5, 0.2, 0.0}, .mass = 0.1, .radius = 0.03125}});
}

const Case impact{
    {.name = "drag_in_an_impact",
     .claim = "drag counts among the forces of an impact that lasts, in a stream and in a fluid that it moves",
     .equation = "M 2.15",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const double e = 0.6, gamma = 0.1, dt = 0.05;
      const kinematics::Particles pair = touching();
      const auto acceleration = [&](int i) {
        const Eigen::Vector3d past = fast.v - pair.velocity.row(i).transpose();
        return 0.25 * fast.rho * past.norm() * past[0] * pi * pair.radius[i] * pair.radius[i] / pair.mass[i];
      };
      const double met = 2.0 + (acceleration(0) - acceleration(1)) * gamma * dt / (1.0 + e);
      const double J = -(1.0 + e) * met / (1.0 / 0.2 + 1.0 / 0.1);
      const auto check = [&](const std::string& where, const auto& problem, schemes::State at) {
        problem.jump(at, dt);
        const char* const because = "a dozen operations on numbers near 1";
        match(rows, where + ": first sphere after [m/s]", 1.5 + J / 0.2, at.v[0], 1e-13, because);
        match(rows, where + ": second sphere after [m/s]", -0.5 - J / 0.1, at.v[1], 1e-13, because);
      };
      const contact::Contact<> law{.restitution = {.e = e}, .gamma = gamma};
      const scenes::Scene scene(pair, Space{}, Drag{fast}, law);
      check("a stream", scene, scenes::start(scene));
      const BarotropicFlow<3> flow(Grid<3>{.cells = {5, 5, 5}}, {.state = {.rho_R = 50.0}, .viscosity = {fast.mu}}, {});
      const Suspension both(flow, pair, {.w = 0.25}, NoHeat{}, law);
      check("a fluid", both, both.start([](const Vector<3>&) { return Local<3>{.rho = 50.0, .v = fast.v}; }));
    }};

const Case located_impact{
    {.name = "drag_between_located_impacts",
     .claim = "where an impact takes no time drag has no part in it, and the motion keeps the order of its scheme",
     .equation = "R 2.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      // Head on in honey: x = x_0 -+ v_0 (1 - e^-t), so v = v_0 - way.
      const double e = 0.6;
      const double v_0 = 1.5, gap = 0.8, t = 1.0, v = v_0 - 0.5 * gap, left = v / v_0 * std::exp(t);
      const scenes::Scene located(
          kinematics::particles(
              {{.position = {-0.45, 0.0, 0.0}, .velocity = {v_0, 0.0, 0.0}, .mass = honey_mass, .radius = 0.05},
               {.position = {0.45, 0.0, 0.0}, .velocity = {-v_0, 0.0, 0.0}, .mass = honey_mass, .radius = 0.05}}),
          Space{}, Drag{honey}, contact::LocatedContact<>{.restitution = {.e = e}});
      schemes::State at = scenes::start(located);
      const schemes::Outcome ends = reached(located, at, t, RungeKutta4(), schemes::FixedStep{.step = 2e-3});
      rows.equal("impacts", {.expected = 1, .computed = ends.impacts, .because = "they meet once"});
      match(rows, "velocity at the end [m/s]", -e * v / left, at.v[0], 1e-11, "500 steps of order 4");
      match(rows, "place at the end [m]", -0.05 - e * v * (1.0 - 1.0 / left), at.r[0], 1e-11, "the same");
    }};

}  // namespace verification::drag_of_spheres
