// What particles and the fluid around them give to each other: nothing is lost, and what a particle sees of itself.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <Eigen/LU>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <particulate/contact/located_contact.hpp>
#include <particulate/fluid/suspension.hpp>
#include <particulate/laws/gravity.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/thermo/impact_heat.hpp>

#include "change.hpp"
#include "suspensions.hpp"

namespace verification::exchange_ledgers {

using namespace particulate;
using namespace particulate::fluid;
using schemes::RungeKutta4;
using suspensions::in_turn, suspensions::match;

constexpr double pi = std::numbers::pi;

// --- Ledgers.

// Soft fluids, in which sound is some 10 m/s fast; of the gas 17.
constexpr continuum::Barotropic barotropic{.P_R = 1e3, .Y = 1e5, .rho_R = 1000.0};
constexpr continuum::LinearizedState liquid{.P_R = 1e3, .Y = 1e5, .rho_R = 1000.0, .a_th = 1e-4};
constexpr continuum::IdealGas gas{.R = 0.7};
constexpr continuum::ConstantViscosity thick{.mu = 20.0};
constexpr continuum::ExponentialViscosity thinning{.mu_R = 20.0};

template <int Dim, class E, class V = continuum::ConstantViscosity>
Flow<Dim, E, V> flow_of(const E& law, const V& viscosity = thick, const Boundaries<Dim>& faces = {}) {
  Grid<Dim> grid;
  for (std::size_t a = 0; a < Dim; ++a) grid.cells[a] = (Dim < 3 ? 8 : 5) + static_cast<Eigen::Index>(a);
  grid.lengths.setConstant(2.0 * pi);
  return {grid, {.state = law, .viscosity = viscosity, .c = 1.75, .K = 5.0}, faces};
}
template <int Dim>
Local<Dim> stirred(const Vector<Dim>& x) {
  Local<Dim> at{.rho = 1000.0 * (1.0 + 0.1 * std::sin(x.sum())), .theta = 300.0 + 20.0 * std::cos(x[0])};
  for (int a = 0; a < Dim; ++a) at.v[a] = 1.0 + 0.5 * std::sin(x[a] + 2.0 * x[(a + 1) % Dim] + a);
  return at;
}

// Spheres of all sizes, some of them beyond a face that begins again; their hats are no whole number of cells wide.
std::vector<kinematics::Particle> spheres(bool inside = false) {
  std::vector<kinematics::Particle> list;
  for (int k = 0; k < 5; ++k) {
    const double x = inside ? 0.6 + 0.75 * k : 1.3 * k - 0.4, b = 0.27 + 0.06 * k;
    list.push_back({.position = {x, inside ? 3.1 + 0.65 * k : 0.9 * k, inside ? 3.0 : 6.0 + 1.7 * k},
                    .velocity = {3.0 - k, 1.0 * k, -0.5 * k},
                    .mass = 20.0 + 30.0 * k,
                    .radius = b,
                    .temperature = 400.0 + 50.0 * k,
                    .heat_capacity = 1.0 + 0.3 * k});
  }
  return list;
}

// What a run changes of what a suspension holds: of momentum over all mass times the speed of sound.
template <class S>
Change change(const S& both, const schemes::State& from, const schemes::State& to) {
  const Totals a = both.totals(from), b = both.totals(to);
  const double all = a.mass + both.particles().mass.sum();
  return {.mass = std::abs(b.mass - a.mass) / a.mass,
          .momentum = (b.momentum - a.momentum).cwiseAbs().maxCoeff() / (10.0 * all),
          .energy = std::abs(b.energy - a.energy) / std::abs(a.energy)};
}

template <class S, class Scheme, class C>
Change run(const S& both, const schemes::State& start, Scheme scheme, C control, double end = 0.4) {
  schemes::State at = start;
  reach(both, at, end, scheme, control);
  return change(both, start, at);
}

// The worst that sweeps make of it, from one of them on.
template <class S>
Change worst_of_sweeps(const S& both, const schemes::State& start) {
  Change worst;
  const auto see = [&](double TOL, auto control) { worst.see(run(both, start, in_turn(both, TOL), control)); };
  see(1.0, schemes::FixedSweeps{.step = 0.004, .sweeps = 1});
  see(1.0, schemes::FixedSweeps{.step = 0.004, .sweeps = 2});
  see(1e-6, schemes::FixedStep{.step = 0.01, .TOL = 1.0});
  see(1e-3, schemes::PhiControl{.TOL = 1.0, .step = 0.005, .limit = 0.02});
  return worst;
}

void kept(Rows& rows, const std::string& what, double computed) {
  rows.at_most(what, {.limit = 2e-15,
                      .computed = computed,
                      .because = "nine roundings of a sum over all cells, whose own roundings fall either way"});
}

const Case ledgers{
    {.name = "what_a_suspension_keeps",
     .claim = "one sweep, two sweeps and converged sweeps keep mass, momentum and energy of fluid and particles to "
              "rounding; so does collocation, and RK4 mass and momentum",
     .equation = "R 8.1.2",
     .reference = Reference::identity},
    [](Rows& rows) {
      const auto check = [&]<class F, class H>(const std::string& what, const F& flow, const H& heat, bool corrected) {
        constexpr int Dim = F::directions;
        const Suspension<F, H> both(flow, kinematics::particles(spheres()), {.corrected = corrected}, heat);
        const schemes::State start = both.start(stirred<Dim>);
        Change worst = worst_of_sweeps(both, start);
        // Energy is quadratic in this state, and collocation at Gauss's points keeps what is.
        worst.see(run(both, start, schemes::Collocation<schemes::Gauss<2>>(),
                      schemes::FixedStep{.step = 0.02, .TOL = 1e-14}));
        const Change by_rk4 = run(both, start, RungeKutta4(), schemes::FixedStep{.step = 0.02});
        kept(rows, what + ": mass over all", report::worse_of(worst.mass, by_rk4.mass));
        kept(rows, what + ": momentum over that of sound", report::worse_of(worst.momentum, by_rk4.momentum));
        if (F::has_heat) kept(rows, what + ": energy over all", worst.energy);
      };
      const auto heated = [](double a_v) { return HeatExchange{.h_c = 30.0, .a_v = a_v}; };
      check("gas, 1-D, a_v = 0", flow_of<1>(gas), heated(0.0), false);
      check("gas, 3-D, a_v = 0.5", flow_of<3>(gas), heated(0.5), false);
      check("gas, 2-D, corrected", flow_of<2>(gas), heated(0.5), true);
      check("liquid, 2-D, a_v = 1", flow_of<2>(liquid), heated(1.0), false);
      check("thinning liquid, 3-D, a_v = 0.5", flow_of<3>(liquid, thinning), heated(0.5), false);
      check("liquid, 3-D, no exchange of heat", flow_of<3>(liquid), NoHeat{}, false);
      check("barotropic, 3-D", flow_of<3>(barotropic), NoHeat{}, false);
    }};

// --- Closed boxes, contacts, near fields, radiation.

const Case closed{
    {.name = "contacts_in_a_closed_fluid",
     .claim = "between walls, with impacts that heat and a sphere that nothing moves, sweeps keep mass and energy to "
              "rounding",
     .equation = "R 8.1.2",
     .reference = Reference::identity},
    [](Rows& rows) {
      const auto check = [&]<int Dim, class C>(const std::string& what, C contact) {
        Boundaries<Dim> walls;
        for (std::size_t face = 0; face < walls.size(); ++face) walls[face] = Wall<Dim>{.slips = face % 3 == 1};
        std::vector<kinematics::Particle> list = spheres(true);
        list[3].immovable = true, list[3].velocity.setZero();
        long impacts = 0;
        contact.restitution.e = 0.5;
        contact.recorder = [&](const contact::ImpactRecord&) { ++impacts; };
        const Suspension both(flow_of<Dim>(gas, thick, walls), kinematics::particles(list), {.w = 1.4},
                              HeatExchange{.h_c = 30.0, .a_v = 0.5}, contact, thermo::ImpactHeat{});
        const Change worst = worst_of_sweeps(both, both.start(stirred<Dim>));
        kept(rows, what + ": mass over all", worst.mass);
        kept(rows, what + ": energy over all", worst.energy);
        rows.at_least(
            what + ": impacts",
            {.limit = 4.0, .computed = static_cast<double>(impacts), .because = "one at least in each of four runs"});
      };
      check.template operator()<2>("2-D", contact::Contact<>{});
      check.template operator()<3>("3-D", contact::Contact<>{});
      check.template operator()<2>("2-D, located", contact::LocatedContact<>{});
    }};

// Energy with the potential of a near field, of each pair by itself.
template <class S>
double energy(const S& both, const laws::NearField& law, const schemes::State& at) {
  double sum = both.totals(at).energy;
  const Eigen::VectorXd& m = both.particles().mass;
  for (Eigen::Index i = 0; i < m.size(); ++i) {
    for (Eigen::Index j = i + 1; j < m.size(); ++j) {
      const double d = separation(both.domain(), schemes::position(at, i), schemes::position(at, j)).norm();
      sum += laws::potential(law, laws::pair_law(law, m[i], m[j]), d);
    }
  }
  return sum;
}

const Case orders{
    {.name = "energy_of_a_suspension",
     .claim = "RK4 keeps energy at its order, with a near field too, and so do sweeps with a near field",
     .equation = "R 8.1.2",
     .reference = Reference::convergence},
    [](Rows& rows) {
      const auto check = [&](const std::string& what, double strength, double order, std::vector<int> counts,
                             const auto& scheme_of, auto control) {
        const laws::NearField law{.alpha1 = strength, .alpha2 = 0.5 * strength, .cutoff = 3.0, .taper = 1.0};
        const Suspension both(flow_of<2>(gas), kinematics::particles(spheres()), {},
                              HeatExchange{.h_c = 30.0, .a_v = 0.5}, law);
        const schemes::State start = both.start(stirred<2>);
        std::vector<double> steps, errors;
        for (const int n : counts) {
          schemes::State at = start;
          steps.push_back(control.step = 1.0 / n);
          reach(both, at, 1.0, scheme_of(both), control);
          // Over what is kinetic at the start.
          errors.push_back(std::abs(energy(both, law, at) - energy(both, law, start)) / 2e3);
        }
        rows.order(what,
                   {.nominal = order,
                    .steps = steps,
                    .errors = errors,
                    .floor = 1e-12,
                    .because = "the scheme's own; all energy is 1e4 times what is kinetic, and so is its rounding"});
      };
      const auto rk4 = [](const auto&) { return RungeKutta4(); };
      const auto once = [](const auto& both) { return in_turn(both, 1.0); };
      check("RK4", 0.0, 4.0, {60, 80, 106, 140, 190}, rk4, schemes::FixedStep{});
      check("RK4, near field", 0.1, 4.0, {60, 80, 106, 140, 190}, rk4, schemes::FixedStep{});
      check("one sweep, near field", 0.1, 1.0, {160, 200, 260, 340, 440}, once, schemes::FixedSweeps{.sweeps = 1});
    }};

const Case radiation{
    {.name = "radiation_leaves_a_suspension",
     .claim = "what energy misses is what was radiated: of a cooling sphere in closed form, of sweeps step by step",
     .equation = "R 8.1.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const double B = 5.670374419e-8, m = 2.0, c = 10.0, area = 4.0 * pi * 0.01;
      const Suspension one(
          GasFlow<1>(Grid<1>{.cells = {4}}, {.state = gas, .viscosity = {.mu = 0.1}, .c = 1.75, .K = 0.1}, {}),
          kinematics::particles(
              {{.position = {0.3, 0.0, 0.0}, .mass = m, .radius = 0.1, .temperature = 1500.0, .heat_capacity = c}}),
          {}, HeatExchange{.emissivity = 0.8, .theta_s = 0.0});
      const schemes::State still = one.start([](const Vector<1>&) { return Local<1>{.rho = 1.2, .theta = 300.0}; });
      schemes::State at = still;
      const double t = 2.0, k = 0.8 * B * area / (m * c),
                   left = std::pow(std::pow(1500.0, -3) + 3.0 * k * t, -1.0 / 3.0);
      advance<RungeKutta4>(one, at, t, 400);
      match(rows, "a sphere at rest: energy lost [J]", m * c * (1500.0 - left),
            one.totals(still).energy - one.totals(at).energy, 1e-11, "400 steps of order 4");
      const Suspension both(flow_of<3>(gas), kinematics::particles(spheres()), {},
                            HeatExchange{.h_c = 30.0, .emissivity = 0.8, .theta_s = 250.0, .a_v = 0.5});
      const schemes::State start = both.start(stirred<3>);
      double radiated = 0.0;
      at = start;
      schemes::Staggered scheme = in_turn(both, 1e-12);
      schemes::FixedStep control{.step = 0.01, .TOL = 1.0};
      require_reached(schemes::integrate(
          both, at, 0.4, scheme, control, [&](const auto&, const schemes::State& to, double dt, const auto&) {
            const Eigen::ArrayXd theta = to.y.tail(5).array();
            radiated +=
                dt * 0.8 * B *
                (4.0 * pi * both.particles().radius.array().square() * (theta.pow(4) - std::pow(250.0, 4))).sum();
            return true;
          }));
      rows.compare("spheres in a stirred gas, sweeps: energy lost [J]",
                   {.expected = radiated,
                    .computed = both.totals(start).energy - both.totals(at).energy,
                    .tolerance = absolute(1e-14 * both.totals(start).energy),
                    .because = "a rounding of all energy, and converged sweeps"});
    }};

// --- Where a particle stands.

// A state moved by whole cells, its particles by boxes too.
template <class S>
schemes::State moved(const S& both, const schemes::State& at, const std::array<Eigen::Index, 3>& by, double boxes) {
  const auto& [cells, lengths, corner] = both.flow().grid();
  const Eigen::Index N = both.flow().grid().size(), n = both.particles().size();
  schemes::State to = at;
  for (Eigen::Index c = 0; c < N; ++c) {
    const Eigen::Index i = (c % cells[0] + by[0]) % cells[0], j = (c / cells[0] % cells[1] + by[1]) % cells[1],
                       k = (c / cells[0] / cells[1] + by[2]) % cells[2];
    for (Eigen::Index f = 0; f < 5; ++f) to.y[(k * cells[1] + j) * cells[0] + i + f * N] = at.y[c + f * N];
  }
  for (int a = 0; a < 3; ++a) {
    const double h = both.flow().grid().h(a);
    to.r.segment(a * n, n).array() += static_cast<double>(by[static_cast<std::size_t>(a)]) * h + boxes * lengths[a];
  }
  return to;
}

const Case places{
    {.name = "places_of_hats",
     .claim = "across faces of the box, on faces of cells and boxes away, particles and fluid have the rates that they "
              "have in the middle",
     .equation = "D 8.1.2",
     .reference = Reference::identity},
    [](Rows& rows) {
      const GasFlow<3> flow(Grid<3>{.cells = {8, 9, 10}, .lengths = Vector<3>(0.8, 0.9, 1.0)},
                            {.state = gas, .viscosity = {.mu = 0.1}, .c = 1.75, .K = 5.0}, {});
      // On a face, an edge and a corner of cells, in the middle of one, and anywhere.
      std::vector<kinematics::Particle> list;
      for (const Eigen::Vector3d& x : {Eigen::Vector3d(0.4, 0.45, 0.53),
                                       {0.3, 0.5, 0.52},
                                       {0.5, 0.4, 0.6},
                                       {0.35, 0.55, 0.45},
                                       {0.41, 0.47, 0.7}}) {
        list.push_back({.position = x,
                        .velocity = 10.0 * (x - Eigen::Vector3d(0.4, 0.4, 0.4)),
                        .mass = 0.1,
                        .radius = 0.02 + 0.01 * x[0],
                        .temperature = 400.0,
                        .heat_capacity = 1.0});
      }
      const Suspension both(flow, kinematics::particles(list), {.w = 0.234}, HeatExchange{.h_c = 30.0, .a_v = 0.5},
                            laws::NearField{.alpha1 = 1.0, .alpha2 = 0.2, .cutoff = 0.35, .taper = 0.1});
      const schemes::State middle = both.start([](const Vector<3>& x) {
        return Local<3>{.rho = 1.2, .v = Vector<3>(std::sin(8.0 * x[1]), x[2], x[0]), .theta = 300.0 + 20.0 * x[0]};
      });
      const auto rates = [&](const schemes::State& at) {
        schemes::State rate = at;
        if (!both.rates(0.0, at.r, at.v, at.y, rate.v, rate.y)) throw std::runtime_error("there must be rates");
        return rate;
      };
      const schemes::State here = rates(middle);
      const auto check = [&](const std::string& what, const std::array<Eigen::Index, 3>& by, double boxes) {
        schemes::State back = moved(both, here, by, 0.0);
        const schemes::State there = rates(moved(both, middle, by, boxes));
        const auto row = [&](const char* of, const Eigen::VectorXd& expected, const Eigen::VectorXd& computed) {
          rows.at_most(
              fmt::format("{}: rates of {}, off over the largest", what, of),
              {.limit = 1e-13 * (1.0 + std::abs(boxes)),
               .computed = (computed - expected).lpNorm<Eigen::Infinity>() / expected.lpNorm<Eigen::Infinity>(),
               .because = "the rounding of a place, over a cell, and of sums in another order"});
        };
        row("velocities", here.v, there.v);
        row("fluid and temperatures", back.y, there.y);
      };
      check("to the low corner", {4, 5, 5}, 0.0);
      check("to the high corner", {3, 3, 4}, 0.0);
      check("across one face", {0, 4, 0}, 0.0);
      check("a box away", {0, 0, 0}, 1.0);
      check("three boxes back, across an edge", {4, 0, 5}, -3.0);
    }};

// A stirred gas with two spheres at t = 0.5, seen from a frame in which it drifts by (1, -2) boxes.
schemes::State drifted(const Vector<2>& drift, Eigen::Index n) {
  const GasFlow<2> flow(Grid<2>{.cells = {n, n}}, {.state = {.R = 1.0}, .viscosity = {.mu = 0.02}, .c = 2.5, .K = 0.05},
                        {});
  std::vector<kinematics::Particle> pair;
  for (const double side : {-1.0, 1.0}) {
    pair.push_back({.position = {0.5 + 0.21 * side, 0.37, 0.0},
                    .velocity = {drift[0], drift[1] + 0.5 * side, 0.0},
                    .mass = 0.02,
                    .radius = 0.05,
                    .temperature = 1.5 + 0.2 * side,
                    .heat_capacity = 2.0});
  }
  const Suspension both(flow, kinematics::particles(pair), {.w = 0.25}, HeatExchange{.h_c = 1.0, .a_v = 0.5});
  schemes::State at = both.start([&](const Vector<2>& x) {
    const double X = 2.0 * pi * x[0], Y = 2.0 * pi * x[1];
    return Local<2>{.rho = 1.0 + 0.1 * std::sin(X) * std::cos(Y),
                    .v = drift + 0.2 * Vector<2>(std::sin(X) * std::cos(Y), std::cos(X + Y)),
                    .theta = 1.0 + 0.1 * std::cos(X)};
  });
  advance<RungeKutta4>(both, at, 0.5, 5 * n);
  for (Eigen::Index i = 0; i < 2; ++i) {
    schemes::velocities(at).row(i).head<2>() -= drift.transpose();
    schemes::positions(at).row(i).head<2>() -= 0.5 * drift.transpose();
  }
  return at;
}

const Case frames{{.name = "spheres_in_a_drifting_frame",
                   .claim = "what a drift adds to the motion and warmth of spheres falls with the square of the cells",
                   .equation = "D 8.1.2",
                   .reference = Reference::identity},
                  [](Rows& rows) {
                    std::vector<double> steps;
                    std::array<std::vector<double>, 3> errors;
                    for (const Eigen::Index n : {24, 30, 38, 48, 60}) {
                      const schemes::State still = drifted({0.0, 0.0}, n), moving = drifted({2.0, -4.0}, n);
                      steps.push_back(1.0 / static_cast<double>(n));
                      errors[0].push_back((moving.r - still.r).norm());
                      errors[1].push_back((moving.v - still.v).norm());
                      errors[2].push_back((moving.y.tail(2) - still.y.tail(2)).norm());
                    }
                    const std::array names{"places", "velocities", "temperatures"};
                    for (std::size_t k = 0; k < 3; ++k) {
                      rows.order(names[k], {.nominal = 2.0,
                                            .steps = steps,
                                            .errors = errors[k],
                                            .floor = 1e-13,
                                            .because = "central differences, and hats of 6 to 15 cells"});
                    }
                  }};

// --- What a particle sees of the disturbance that it makes itself, in a periodic box of n^3 cells.

// A sphere that is pushed along x through a fluid of rho = mu = 1 in a box of 1 m, so slowly that it stays where it is.
struct Forced {
  Eigen::Index n = 16;
  double cells = 1.0;   // half-width of the hat, over a cell
  double offset = 0.0;  // from the middle of a cell in each direction, over a cell
  double radius = 0.4;  // over a cell
  bool corrected = false;

  double h() const { return 1.0 / static_cast<double>(n); }
  double xi() const { return 6.0 * pi * radius * h(); }
  double run() const;
  double by_sum() const;
};

// Slip against the fluid's mean times xi, over the force that the fluid gets.
double Forced::run() const {
  const BarotropicFlow<3> flow(Grid<3>{.cells = {n, n, n}}, {.state = {.Y = 1e4, .rho_R = 1.0}, .viscosity = {1.0}},
                               {});
  const double m = 4e-3, g = 1e-4;
  const Eigen::Vector3d place = Eigen::Vector3d::Constant((5.5 + offset) * h());
  const Suspension both(flow, kinematics::particles({{.position = place, .mass = m, .radius = radius * h()}}),
                        {.w = cells * h(), .corrected = corrected}, NoHeat{}, laws::Gravity{{g, 0.0, 0.0}});
  schemes::State at = both.start([](const Vector<3>&) { return Local<3>{.rho = 1.0}; });
  // Sound of the longest wave decays slowest, by 26/s.
  advance<RungeKutta4>(both, at, 0.3, corrected ? 720 : 540);
  const double mean = both.totals(at).momentum[0] - m * at.v[0];
  return xi() * (at.v[0] - mean) * (1.0 + m) / (m * g);
}

// The squared Fourier transform of normalized hats in one direction.
std::vector<double> squared_hats(Eigen::Index n, double cells, double offset) {
  const auto whole = static_cast<Eigen::Index>(std::ceil(cells));
  std::vector<double> all;
  for (Eigen::Index k = 0; k < n; ++k) {
    double real = 0.0, imaginary = 0.0, sum = 0.0;
    for (Eigen::Index q = -whole; q <= whole + 1; ++q) {
      const double at = static_cast<double>(q), weight = std::max(0.0, 1.0 - std::abs(at - offset) / cells);
      const double phase = 2.0 * pi * static_cast<double>(k) * at / static_cast<double>(n);
      real += weight * std::cos(phase), imaginary += weight * std::sin(phase), sum += weight;
    }
    all.push_back((real * real + imaginary * imaginary) / (sum * sum));
  }
  return all;
}

// The velocity along x that a unit force along x makes of a wave, of the symbols of central differences: with
// M v + i s p = f and s.v = 0.
double mobility(const Eigen::Vector3d& s, const Eigen::Vector3d& K) {
  Eigen::Matrix3d M = s * s.transpose() / 3.0;
  for (int a = 0; a < 3; ++a) M(a, a) = K.sum() + K[a] / 3.0;
  const Eigen::Matrix3d inverse = M.inverse();
  const Eigen::Vector3d x = inverse.col(0), pushed = inverse * s;
  const double square = s.dot(pushed);
  return s.squaredNorm() > 1e-20 * K.sum() ? x[0] - pushed[0] * s.dot(x) / square : x[0];
}

double Forced::by_sum() const {
  const std::vector<double> hat = squared_hats(n, cells, offset);
  double sum = 0.0;
  const auto symbol = [&](Eigen::Index k) { return 2.0 * pi * static_cast<double>(k) / static_cast<double>(n); };
  for (Eigen::Index c = 0; c < n * n * n; ++c) {
    if (c == 0) continue;
    const std::array<Eigen::Index, 3> k{c % n, c / n % n, c / n / n};
    Eigen::Vector3d s, K;
    double weight = 1.0;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto i = static_cast<Eigen::Index>(a);
      s[i] = 2 * k[a] == n ? 0.0 : std::sin(symbol(k[a])) / h();
      K[i] = (2.0 - 2.0 * std::cos(symbol(k[a]))) / (h() * h());
      weight *= hat[static_cast<std::size_t>(k[a])];
    }
    sum += weight * mobility(s, K);
  }
  return 1.0 + xi() * sum;
}

const Case self{{.name = "disturbance_of_its_own",
                 .claim = "the slip of a sphere that is pushed through a fluid is that of the lattice sum over the "
                          "scheme's symbols, and the correction takes 6 pi b/(g w) off",
                 .equation = "D 8.1.2",
                 .reference = Reference::closed_form},
                [](Rows& rows) {
                  const auto check = [&](const std::string& what, Forced forced, double known, bool both = false) {
                    const double sum = forced.by_sum();
                    if (known > 0.0)
                      match(rows, what + ": lattice sum", known, sum, 5e-7, "the digits of the reference");
                    match(rows, what + ": slip xi/F", sum, forced.run(), 1e-4, "sound that has decayed by exp(-8)");
                    forced.corrected = true;
                    const double off = 6.0 * pi * forced.radius / (13.9586 * forced.cells);
                    if (!both) return;
                    match(rows, what + ": slip xi/F, corrected", sum - off, forced.run(), 1e-4, "the same");
                  };
                  check("on a cell's middle", {}, 2.142937, true);
                  check("a quarter off", {.offset = 0.25}, 1.501396);
                  check("on a corner of cells", {.offset = 0.5}, 1.376117);
                  check("a hat of 3.3 cells", {.cells = 3.3, .offset = 0.2}, 0.0, true);
                }};

const Case wide{{.name = "disturbance_of_a_wide_hat",
                 .claim = "the lattice sum of wide hats comes to 1 + 1.3504 b/w and what the other images add",
                 .equation = "D 8.1.2",
                 .reference = Reference::closed_form},
                [](Rows& rows) {
                  // Of a box: Hasimoto's constant, and what second moments of both hats feel of the images.
                  const double w = 0.125, b = 0.0125;
                  const auto added = [&](double n) {
                    return Forced{.n = static_cast<Eigen::Index>(n), .cells = w * n, .radius = b * n}.by_sum() - 1.0;
                  };
                  const double coarse = added(48.0), fine = added(72.0);
                  match(rows, "what is added to the slip, extrapolated from 6 and 9 cells a half-width",
                        1.3504 * b / w - 2.837297 * b + 2.0 * pi / 3.0 * b * w * w,
                        fine + (fine - coarse) / (1.5 * 1.5 - 1.0), 5e-4,
                        "the fourth power of w over the box, and of a cell over w: 2e-4 each");
                }};

}  // namespace verification::exchange_ledgers
