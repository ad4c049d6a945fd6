// Suspensions that must be borne, however extreme, and those that must be refused.

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/contact/located_contact.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/runge_kutta.hpp>

#include "../ch03_schemes/bits.hpp"
#include "suspensions.hpp"

namespace verification::suspension_extremes {

using namespace particulate;
using namespace particulate::fluid;
using schemes::RungeKutta4;
using suspensions::in_turn;

constexpr double pi = std::numbers::pi;

Ending within(double error, double tolerance, const char* because) {
  return Ending::solved({.error = error, .tolerance = tolerance, .because = because});
}

// --- One particle in a small periodic box of a liquid at rest.

struct Alone {
  double size = 1.0, rho = 1000.0, mu = 1.0, Y = 1e5, K = 1e-7;  // of the box and of the liquid
  double mass = 10.0, radius = 0.05, v = 0.01;                   // of the particle, the radius in lengths of the box
  Eigen::Vector3d place = {0.3, 0.4, 0.6}, drift = Eigen::Vector3d::Zero();
  HeatExchange heat = {};
  double theta = 300.0;

  auto suspension(int threads = 1) const {
    const LiquidFlow<3> flow(
        Grid<3>{.cells = {8, 8, 8}, .lengths = Vector<3>::Constant(size)},
        {.state = {.P_R = Y, .Y = Y, .rho_R = rho, .a_th = 0.0}, .viscosity = {.mu = mu}, .c = 1e-3, .K = K}, {},
        threads);
    const kinematics::Particle one{.position = size * place,
                                   .velocity = drift + Eigen::Vector3d(v, 0.5 * v, -0.3 * v),
                                   .mass = mass,
                                   .radius = radius * size,
                                   .temperature = theta,
                                   .heat_capacity = 1000.0};
    return Suspension(flow, kinematics::particles({one}), Spreading{.w = 0.25 * size}, heat);
  }
  Local<3> fluid() const { return {.rho = rho, .v = drift}; }
};

// How far mass, momentum and energy move, in units of 1e-13 of the mass, of 1e-13 of what momentum the particles
// brought, and of 1e-8 of their kinetic energy, which is little beside the heat of the liquid. At rest: of its heat.
template <class S>
double lost(const S& suspension, const schemes::State& from, const schemes::State& to) {
  const Totals a = suspension.totals(from), b = suspension.totals(to);
  const Eigen::VectorXd speed = schemes::velocities(from).rowwise().norm(), mass = suspension.particles().mass;
  const double brought = mass.dot(speed), kinetic = 0.5 * mass.dot(speed.cwiseAbs2());
  const double momentum = (b.momentum - a.momentum).norm(), energy = std::abs(b.energy - a.energy);
  const double of_motion =
      brought > 0.0 ? std::max(1e13 * momentum / brought, 1e8 * energy / kinetic) : 1e13 * energy / a.energy;
  return std::max(1e13 * std::abs(b.mass / a.mass - 1.0), of_motion);
}

// Adaptive staggering for so many relaxation times of the particle: ledgers stay, and the slip falls.
Ending relaxes(const Alone& of, double times, double* steps = nullptr, std::string* ruled = nullptr) {
  const auto suspension = of.suspension();
  schemes::State state = suspension.start([&](const Vector<3>&) { return of.fluid(); });
  const schemes::State from = state;
  const double u = (schemes::velocity(from, 0) - of.drift).norm();
  const double tau = of.mass / drag_rate({.rho = of.rho, .mu = of.mu}, of.radius * of.size, u);
  const double t_end = times * tau;
  const schemes::Outcome outcome =
      integrate(suspension, state, t_end, in_turn(suspension),
                schemes::PhiControl{.TOL = 1.0, .step = 1e-6 * t_end, .limit = 0.1 * t_end, .spare = 2});
  if (steps) *steps = static_cast<double>(outcome.steps);
  if (ruled) *ruled = outcome.ruled;
  if (outcome.status != schemes::Status::reached) return Ending::refused(outcome.reason);
  const auto slip = [&](const schemes::State& at) {
    return (suspension.streams(at)[0].v - schemes::velocity(at, 0)).norm();
  };
  if (u > 0.0 && !(slip(state) < slip(from))) return within(slip(state) / slip(from), 1.0 - 1e-9, "drag slows down");
  return within(lost(suspension, from, state), 1.0, "rounding, over some hundred steps");
}

const Case strange{
    {.name = "extreme_suspensions",
     .claim = "slow and fast particles, light and heavy ones, small boxes and far streams are solved, and keep mass, "
              "momentum and energy to rounding",
     .equation = "R 8.4",
     .reference = Reference::identity},
    [](Rows& rows) {
      const auto solved = [&](const std::string& name, const Alone& of, double times) {
        rows.must_be_solved(name, [&] { return relaxes(of, times); });
      };
      solved("Re = 0, at rest", {.v = 0.0}, 1.0);
      // The speed is 1.157 v; a box of 1 m with b = 0.05 m, 1000 kg/m^3.
      for (const double Re : {1e-8, 1e-3, 1.0, 400.0, 3e5, 2e6, 1e8}) {
        const double v = Re < 100.0 ? 0.01 : 1.0, mu = 2.0 * 0.05 * 1000.0 * 1.1576 * v / Re;
        solved(fmt::format("Re = {:g}", Re), {.mu = mu, .Y = Re < 1.0 ? 1e4 : 1e5, .v = v}, 0.02);
      }
      solved("density ratio 1e4, heavy", {.rho = 1.2, .mu = 1e-3, .Y = 100.0, .mass = 1.2e4 * 4.0 / 3.0 * pi * 1.25e-4},
             1e-4);
      solved("density ratio 1e4, light", {.mass = 0.1 * 4.0 / 3.0 * pi * 1.25e-4, .v = 1.0}, 10.0);
      solved("micrometres", {.size = 1e-5, .mu = 1e-3, .mass = 2000.0 * 4.0 / 3.0 * pi * 1.25e-19, .v = 1.0}, 1.0);
      solved("a stream that carries all at 1 m/s", {.drift = {1.0, -0.5, 0.25}}, 0.01);
    }};

// --- What a mass of particles of a hundred times the gas does to the step.

const Case loaded{
    {.name = "heavily_loaded_gas",
     .claim = "particles that weigh a hundred times the gas around them make the step of sweeps shrink to their own "
              "scale, and the run names it; RK4 does not mind",
     .equation = "D 8.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const GasFlow<2> gas(Grid<2>{.cells = {8, 8}}, {.viscosity = {.mu = 0.5}, .c = 717.5}, {});
      std::vector<kinematics::Particle> list;
      for (int i = 0; i < 64; ++i) {
        list.push_back({.position = {(i % 8 + 0.4) / 8.0, (i / 8 + 0.3) / 8.0, 0.0},
                        .velocity = {0.1 * (i % 3), 0.05, 0.0},
                        .mass = 100.0 * 1.2 / 64.0,
                        .radius = 0.05});
      }
      const Suspension heavy(gas, kinematics::particles(list), Spreading{.w = 0.25});
      const schemes::State from = heavy.start([](const Vector<2>&) { return Local<2>{.rho = 1.2}; });
      double scale = missing;
      for (const schemes::TimeScale& one : heavy.step_limits(from)) {
        if (one.kind == schemes::TimeScale::Kind::loads) scale = one.seconds;
      }
      const double tau = list[0].mass / (6.0 * pi * 0.5 * 0.05);
      rows.compare(
          "time scale of the mass, over tau_p/99",
          {.expected = 1.0,
           .computed = scale * 99.0 / tau,
           .tolerance = relative(1e-12),
           .because = "hats of equal spheres on a lattice add up to the same in each cell, all drag is Stokes's"});
      for (const bool by_sweeps : {true, false}) {
        rows.must_be_solved(by_sweeps ? "loading 100, staggering" : "loading 100, RK4", [&] {
          schemes::State state = from;
          const schemes::Outcome outcome =
              by_sweeps ? integrate(heavy, state, 0.02, in_turn(heavy),
                                    schemes::PhiControl{.TOL = 1.0, .step = 1e-6, .limit = 0.01, .spare = 2})
                        : integrate(heavy, state, 0.02, RungeKutta4(), schemes::FixedStep{.step = 2e-4});
          if (outcome.status != schemes::Status::reached) return Ending::refused(outcome.reason);
          return within(lost(heavy, from, state), 1.0, "rounding, over some hundred steps");
        });
      }
    }};

// --- A particle at 1e5 K that radiates: t = (m c/(4 B eps a_s)) times the integral of theta^-4 without surroundings.

const Case hot{
    {.name = "glowing_particle",
     .claim =
         "a particle at 1e5 K in a liquid radiates its heat away as the closed form says, and the liquid keeps its "
         "own",
     .equation = "R 8.1.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const Alone of{.v = 0.0, .heat = {.emissivity = 1.0, .theta_s = 0.0}, .theta = 1e5};
      const auto suspension = of.suspension();
      const double b = of.radius, rate = 5.670374419e-8 * 4.0 * pi * b * b / (of.mass * 1000.0);
      const double t_end = 1.0, known = std::pow(std::pow(1e5, -3.0) + 3.0 * rate * t_end, -1.0 / 3.0);
      const auto ending = [&](auto scheme, auto control, double tolerance, const char* because) {
        schemes::State state = suspension.start([&](const Vector<3>&) { return of.fluid(); });
        const schemes::State from = state;
        const schemes::Outcome outcome = integrate(suspension, state, t_end, scheme, control);
        if (outcome.status != schemes::Status::reached) return Ending::refused(outcome.reason);
        const double unmoved =
            (state.y.head(5 * 512) - from.y.head(5 * 512)).lpNorm<Eigen::Infinity>() / from.y.maxCoeff();
        return within(std::max(std::abs(state.y.tail(1)[0] / known - 1.0), unmoved), tolerance, because);
      };
      rows.must_be_solved("1e5 K, Gauss 3", [&] {
        return ending(schemes::Collocation<schemes::Gauss<3>>(),
                      schemes::ErrorControl{.TOL = 1e-10, .sweep_TOL = 1e-11, .step = 1e-6}, 1e-7, "1e3 times TOL");
      });
      rows.must_be_solved("1e5 K, one sweep", [&] {
        return ending(in_turn(suspension), schemes::FixedSweeps{.step = 1e-3, .sweeps = 1}, 0.01,
                      "of order 1, the first steps are a hundred times the time in which it cools");
      });
    }};

// --- Places that are special, and nothing.

// The slip of a particle near a place after a short while, over what it was.
double slowed(const Eigen::Vector3d& place, double begin = 0.0) {
  const Alone of{.mass = 0.5, .v = 1e-3, .place = place};
  const auto suspension = of.suspension();
  schemes::State state = suspension.start([&](const Vector<3>&) { return of.fluid(); });
  state.t = begin;
  advance<RungeKutta4>(suspension, state, begin + 0.02, 20);
  return state.v[0] / 1e-3;
}

template <class S>
Ending stays(const S& suspension, double t_end, double step) {
  schemes::State state = suspension.start([](const auto&) { return Local<3>{.rho = 1000.0}; });
  const schemes::State from = state;
  reach(suspension, state, t_end, RungeKutta4(), schemes::FixedStep{.step = step});
  return within(static_cast<double>(differing(state, from) - 1), 0.0, "nothing drives it");
}

const Case places{
    {.name = "special_places",
     .claim = "a particle on a face, an edge or a corner of cells, and on that of the periodic box, slows down as its "
              "neighbours do; without particles a suspension is the flow to the last bit",
     .equation = "D 8.1.2",
     .reference = Reference::identity},
    [](Rows& rows) {
      // Cells of 1/8 m: where a place falls among them is all that counts, not in which cell it is.
      const double near = 1e-9;
      const auto compare = [&](const std::string& name, const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
        rows.compare("velocity after 0.02 s over that at first, " + name, {.expected = slowed(other),
                                                                           .computed = slowed(one),
                                                                           .tolerance = relative(1e-7),
                                                                           .because = "places 1e-9 m apart at most"});
      };
      const Eigen::Vector3d face(0.25, 0.3125, 0.3125), beside = near * Eigen::Vector3d::Ones();
      compare("on a face and beside it", face, face + beside);
      compare("on a corner and beside it", Eigen::Vector3d::Constant(0.375), Eigen::Vector3d::Constant(0.375) - beside);
      compare("on the middle of a cell", Eigen::Vector3d::Constant(0.3125), Eigen::Vector3d::Constant(0.3125) + beside);
      compare("on the box's face and on another", {0.0, 0.3125, 0.3125}, face);
      compare("on the box's far face", {1.0, 0.3125, 0.3125}, face);
      compare("beyond the box, which begins again", {5.25, -1.6875, 0.3125}, face);
      compare("a rounding below the box's face", {-1e-17, 0.3125, 0.3125}, face);
      rows.compare("the same from t = 1e9 s on", {.expected = slowed(face),
                                                  .computed = slowed(face, 1e9),
                                                  .tolerance = relative(1e-6),
                                                  .because = "the end of 0.02 s is rounded to 1.2e-7 s there"});
      rows.must_be_solved("a particle at rest to t = 1e9 s, in steps of 1e6 s", [] {
        // So thick and so soft that a step of RK4 spans them: nothing moves, and nothing is left over.
        return stays(Alone{.rho = 1000.0, .mu = 1e-7, .Y = 1e-16, .K = 0.0, .v = 0.0}.suspension(), 1e9, 1e6);
      });
    }};

template <class Scheme, class Control>
long as_the_flow(Scheme scheme, const Scheme& of_flow, Control control) {
  const auto whirl = [](const Vector<3>& x) {
    const Vector<3> s = (2.0 * pi * x).array().sin();
    return Local<3>{.rho = 1000.0 + s[1], .v = {0.1 * s[2], 0.2, 0.1 * s[0]}, .theta = 300.0 + s[0]};
  };
  const LiquidFlow<3> flow(Grid<3>{.cells = {8, 8, 8}}, {.state = {.Y = 1e5}, .viscosity = {.mu = 1.0}, .K = 100.0},
                           {});
  const Suspension empty(flow, kinematics::Particles{});
  schemes::State one = flow.start(whirl), other = empty.start(whirl);
  reach(flow, one, 0.02, of_flow, control);
  reach(empty, other, 0.02, std::move(scheme), control);
  return differing(one, other);
}

const Case bits{
    {.name = "same_bits_of_suspensions",
     .claim = "no particle: the same bits as the flow; any number of threads, or an object used before: the same bits",
     .equation = "R 8.4",
     .reference = Reference::identity},
    [](Rows& rows) {
      const std::vector<schemes::Field> fields(3, {.name = "field", .p = 2});
      std::vector<schemes::Field> with_particles(4, {.name = "field", .p = 2});
      rows.none("numbers that differ without particles, RK4",
                as_the_flow(RungeKutta4(), RungeKutta4(), schemes::FixedStep{.step = 1e-3}), "no particle");
      rows.none("the same, one sweep",
                as_the_flow(schemes::Staggered(with_particles), schemes::Staggered(fields),
                            schemes::FixedSweeps{.step = 1e-3, .sweeps = 1}),
                "no particle");
      rows.none("the same, three sweeps",
                as_the_flow(schemes::Staggered(with_particles), schemes::Staggered(fields),
                            schemes::FixedSweeps{.step = 1e-3, .sweeps = 3}),
                "no particle");
      rows.none("the same, Gauss 3",
                as_the_flow(schemes::Collocation<schemes::Gauss<3>>(), schemes::Collocation<schemes::Gauss<3>>(),
                            schemes::FixedStep{.step = 1e-3, .TOL = 1e-12}),
                "no particle");
      const auto run = [](const auto& suspension, bool by_sweeps) {
        schemes::State state = suspension.start(suspensions::still_water);
        if (by_sweeps) {
          reach(suspension, state, 0.01, in_turn(suspension),
                schemes::PhiControl{.TOL = 1.0, .step = 1e-4, .limit = 0.01, .spare = 2});
        } else {
          advance<RungeKutta4>(suspension, state, 0.01, 10);
        }
        return state;
      };
      const auto element = [](int threads) {
        return suspensions::VolumeElement(8, 60, smooth, threads).with(suspensions::near_field);
      };
      const auto one = element(1), two = element(2), three = element(3);
      for (const bool by_sweeps : {false, true}) {
        const char* const by = by_sweeps ? "staggering" : "RK4";
        const schemes::State known = run(one, by_sweeps);
        rows.none(fmt::format("numbers that differ with 2 threads, {}", by), differing(run(two, by_sweeps), known),
                  "each cell adds in the order of the particles");
        rows.none(fmt::format("numbers that differ with 3 threads, {}", by), differing(run(three, by_sweeps), known),
                  "each cell adds in the order of the particles");
        rows.none(fmt::format("numbers that differ with an object used before, {}", by),
                  differing(run(one, by_sweeps), known), "it remembers nothing");
      }
    }};

// --- Refusals.

template <class Make>
std::function<Ending()> made(Make make) {
  return [make] { return (void)make(), accepted(); };
}
kinematics::Particle ball(const Eigen::Vector3d& at) {
  return {.position = at, .mass = 1.0, .radius = 0.05, .temperature = 300.0, .heat_capacity = 1000.0};
}
LiquidFlow<3> box(const Boundaries<3>& faces = {}, double mu = 1.0) {
  return {Grid<3>{.cells = {8, 8, 8}}, {.state = {.Y = 1e5}, .viscosity = {.mu = mu}}, faces};
}

const Case refused{
    {.name = "bad_input_of_suspensions",
     .claim = "hats, particles, laws and states that nobody can mean are refused by name, with what to do",
     .equation = "R 8.4",
     .reference = Reference::design},
    [](Rows& rows) {
      const kinematics::Particles one = kinematics::particles({ball({0.5, 0.5, 0.5})});
      Boundaries<3> walls, open;
      walls.fill(Wall<3>{});
      open[0] = open[1] = Outflow{.P = 1e5};
      const auto refuse = [&](const std::string& name, const std::string& words, auto make) {
        rows.must_be_refused(name, words, made(make));
      };
      for (const double w : {0.1, 0.51, not_a_number, infinite}) {
        refuse(fmt::format("w = {}", w), "half-width 0.125 0.5 particle 0 take",
               [=] { return Suspension(box(), one, Spreading{.w = w}); });
      }
      refuse("a particle outside of a box that does not begin again", "particle 0 outside box larger", [=] {
        return Suspension(box(open), kinematics::particles({ball({1.2, 0.5, 0.5})}), Spreading{.w = 0.25});
      });
      refuse("two that overlap", "overlap particle 1 by 0.04 place", [] {
        return Suspension(box(), kinematics::particles({ball({0.5, 0.5, 0.5}), ball({0.56, 0.5, 0.5})}),
                          Spreading{.w = 0.25});
      });
      refuse("one that overlaps a wall", "overlap wall place", [=] {
        return Suspension(box(walls), kinematics::particles({ball({0.02, 0.5, 0.5})}), Spreading{.w = 0.25});
      });
      refuse("a near field without an end in a periodic box", "cutoff", [=] {
        return Suspension(box(), one, Spreading{.w = 0.25}, NoHeat{}, laws::NearField{.alpha1 = 0.5, .alpha2 = 0.1});
      });
      refuse("a near field that ends beyond half of the box", "half", [=] {
        return Suspension(box(), one, Spreading{.w = 0.25}, NoHeat{},
                          laws::NearField{.alpha1 = 0.5, .alpha2 = 0.1, .cutoff = 0.6, .taper = 0.1});
      });
      for (const double a_v : {-0.1, 1.1, not_a_number}) {
        refuse(fmt::format("a_v = {}", a_v), "a_v 0 1",
               [=] { return Suspension(box(), one, Spreading{.w = 0.25}, HeatExchange{.a_v = a_v}); });
      }
      refuse("no viscosity", "viscosity positive", [=] { return Suspension(box({}, 0.0), one, Spreading{.w = 0.25}); });
      refuse("a place that is no number", "particle 0 position", [] {
        return Suspension(box(), kinematics::particles({ball({not_a_number, 0.5, 0.5})}), Spreading{.w = 0.25});
      });
      rows.must_be_refused("a particle that leaves through an outflow", "particle 0 outside box end", [=] {
        kinematics::Particle fast = ball({0.95, 0.5, 0.5});
        fast.velocity = {5.0, 0.0, 0.0};
        const Suspension suspension(box(open), kinematics::particles({fast}), Spreading{.w = 0.25});
        schemes::State state = suspension.start(suspensions::still_water);
        return ending_of(integrate(suspension, state, 1.0, RungeKutta4(), schemes::FixedStep{.step = 1e-3}));
      });
    }};

}  // namespace verification::suspension_extremes
