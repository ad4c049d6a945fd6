// What a fluid keeps: mass, momentum and energy, its kinetic energy in convection, and its bits.

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <particulate/fluid/flow.hpp>
#include <particulate/reference/integrator.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/staggering.hpp>

#include "../ch03_schemes/bits.hpp"
#include "change.hpp"

namespace verification::fluid_conservation {

using namespace particulate;

constexpr double two_pi = 2.0 * std::numbers::pi;

// Soft fluids, so that a stream of a few metres a second stirs them; c_s is some 10 m/s, of the gas 17.
constexpr continuum::Barotropic barotropic{.P_R = 1e3, .Y = 1e5, .rho_R = 1000.0};
constexpr continuum::LinearizedState liquid{.P_R = 1e3, .Y = 1e5, .rho_R = 1000.0, .a_th = 1e-4};
constexpr continuum::IdealGas gas{.R = 0.7};

template <class E, class V = continuum::ConstantViscosity>
fluid::Fluid<E, V> made_of(const E& law, const V& viscosity) {
  return {.state = law, .viscosity = viscosity, .c = 1.75, .K = 5.0};
}
template <int Dim>
fluid::Grid<Dim> box(Eigen::Index cells) {
  fluid::Grid<Dim> grid;
  for (std::size_t a = 0; a < Dim; ++a) grid.cells[a] = cells + static_cast<Eigen::Index>(a);
  grid.lengths.setConstant(two_pi);
  return grid;
}

// Uneven in everything.
template <int Dim>
fluid::Local<Dim> stirred(const fluid::Vector<Dim>& x) {
  fluid::Local<Dim> at{.rho = 1000.0 * (1.0 + 0.1 * std::sin(x.sum())), .theta = 300.0 + 20.0 * std::cos(x[0])};
  for (int a = 0; a < Dim; ++a) at.v[a] = 1.0 + 0.5 * std::sin(x[a] + 2.0 * x[(a + 1) % Dim] + a);
  return at;
}

// What a box holds, each over the cells and over what one step moves through a cell's faces.
template <class Flow>
struct Content {
  Eigen::VectorXd sums;  // of mass, momentum and energy, each component apart
  Content(const Flow& flow, const schemes::State& at) : sums(Flow::numbers) {
    const Eigen::Index N = flow.grid().size();
    for (int f = 0; f < Flow::numbers; ++f) sums[f] = at.y.segment(f * N, N).sum() / static_cast<double>(N);
  }
};

// Of a cell, over the largest that stands in one, and over rho c_s of momentum.
template <class Flow>
Change change(const Flow& flow, const schemes::State& from, const schemes::State& to) {
  const Eigen::VectorXd apart = (Content<Flow>(flow, to).sums - Content<Flow>(flow, from).sums).cwiseAbs();
  const Eigen::Index N = flow.grid().size();
  Change all{.mass = apart[0] / from.y.head(N).maxCoeff()};
  constexpr auto Dim = Flow::numbers - (Flow::has_heat ? 2 : 1);
  all.momentum = apart.segment(1, Dim).maxCoeff() / (10.0 * from.y.head(N).maxCoeff());
  if (Flow::has_heat) all.energy = apart[1 + Dim] / from.y.tail(N).maxCoeff();
  return all;
}

schemes::Staggered in_turn(bool has_heat, double TOL) {
  std::vector<schemes::Field> fields{{.name = "density", .TOL = TOL}, {.name = "momentum", .TOL = TOL}};
  if (has_heat) fields.push_back({.name = "energy", .TOL = TOL});
  return schemes::Staggered(fields);
}

// The worst that four schemes make of a periodic box.
template <class Flow, class Start>
Change worst_of_schemes(const Flow& flow, const Start& start) {
  Change worst;
  const schemes::State from = flow.start(start);
  const auto see = [&](auto scheme, auto control) {
    schemes::State to = from;
    reach(flow, to, 0.4, scheme, control);
    worst.see(change(flow, from, to));
  };
  see(schemes::RungeKutta4(), schemes::FixedStep{.step = 0.02});
  see(in_turn(flow.has_heat, 1.0), schemes::FixedSweeps{.step = 0.002, .sweeps = 1});
  see(in_turn(flow.has_heat, 1e-6), schemes::FixedStep{.step = 0.01, .TOL = 1.0});
  see(schemes::Collocation<schemes::Gauss<2>>(), schemes::FixedStep{.step = 0.02, .TOL = 1e-6});
  return worst;
}

void compare_change(Rows& rows, const std::string& name, const Change& worst, bool has_heat) {
  const auto check = [&](const char* of, double seen) {
    rows.at_most(name + ", change of " + of,
                 {.limit = 1e-14,
                  .computed = seen,
                  .because = "rounding of some hundred steps at most, in the mean of all cells"});
  };
  check("mass over that of a cell", worst.mass);
  check("momentum over rho c of a cell", worst.momentum);
  if (has_heat) check("energy over that of a cell", worst.energy);
}

const Case periodic{
    {.name = "conservation_in_periodic_boxes",
     .claim =
         "RK4, one sweep, converged sweeps and collocation keep mass, momentum and energy to rounding, whatever the "
         "law and the number of dimensions",
     .equation = "D 8.2",
     .reference = Reference::identity},
    [](Rows& rows) {
      const auto check = [&]<int Dim, class E, class V>(const std::string& name, const E& law, const V& viscosity) {
        const fluid::Flow<Dim, E, V> flow(box<Dim>(Dim < 3 || rows.full() ? 8 : 5), made_of(law, viscosity), {});
        compare_change(rows, fmt::format("{}, {}-D", name, Dim), worst_of_schemes(flow, stirred<Dim>), flow.has_heat);
      };
      const continuum::ConstantViscosity thick{.mu = 20.0};
      const continuum::ExponentialViscosity thinning{.mu_R = 20.0};
      const auto in_all = [&](const std::string& name, const auto& law) {
        check.template operator()<1>(name, law, thick);
        check.template operator()<2>(name, law, thick);
        check.template operator()<3>(name, law, thick);
      };
      in_all("barotropic", barotropic);
      in_all("liquid", liquid);
      in_all("gas", gas);
      check.template operator()<2>("thinning liquid", liquid, thinning);
      check.template operator()<3>("thinning liquid", liquid, thinning);
    }};

// No-slip and slip walls in turn, adiabatic and at rest.
template <int Dim>
fluid::Boundaries<Dim> walls() {
  fluid::Boundaries<Dim> all;
  for (std::size_t face = 0; face < all.size(); ++face) all[face] = fluid::Wall<Dim>{.slips = face % 3 == 1};
  return all;
}

const Case closed{
    {.name = "conservation_in_closed_boxes",
     .claim = "walls keep mass, and those that are adiabatic and at rest keep energy, to rounding",
     .equation = "D 8.2",
     .reference = Reference::identity},
    [](Rows& rows) {
      const auto check = [&]<int Dim>(const std::string& name, const auto& law) {
        const fluid::Flow flow(box<Dim>(Dim < 3 || rows.full() ? 8 : 5),
                               made_of(law, continuum::ConstantViscosity{.mu = 20.0}), walls<Dim>());
        const Change worst = worst_of_schemes(flow, stirred<Dim>);
        rows.at_most(fmt::format("{}, {}-D, change of mass over that of a cell", name, Dim),
                     {.limit = 1e-14, .computed = worst.mass, .because = "rounding of some hundred steps at most"});
        if (!flow.has_heat) return;
        rows.at_most(fmt::format("{}, {}-D, change of energy over that of a cell", name, Dim),
                     {.limit = 1e-14, .computed = worst.energy, .because = "rounding of some hundred steps at most"});
      };
      const auto in_all = [&](const std::string& name, const auto& law) {
        check.template operator()<1>(name, law);
        check.template operator()<2>(name, law);
        check.template operator()<3>(name, law);
      };
      in_all("barotropic", barotropic);
      in_all("liquid", liquid);
      in_all("gas", gas);
    }};

// A box under a lid that moves, which keeps book of the work of the lid in a number of its own: force times velocity,
// the force after Newton from the distance of the last cells' middles.
struct UnderLid {
  fluid::GasFlow<2> flow;
  double U, mu;

  bool rate(double t, schemes::In y, schemes::Out dy) const {
    const auto& [cells, lengths, corner] = flow.grid();
    const Eigen::Index N = flow.grid().size(), top = N - cells[0];
    double power = 0.0;
    for (Eigen::Index i = top; i < N; ++i) {
      const double slower = U - y[N + i] / y[i];
      power += mu * slower / (0.5 * flow.grid().h(1)) * U * flow.grid().h(0);
    }
    dy[4 * N] = power;
    return flow.rate(t, y.head(4 * N), dy.head(4 * N));
  }
};

const Case lid{
    {.name = "work_of_a_moving_wall",
     .claim = "a closed box gains the work of a wall that moves along itself, to rounding, and no mass",
     .equation = "D 8.2",
     .reference = Reference::identity},
    [](Rows& rows) {
      fluid::Boundaries<2> faces;
      faces.fill(fluid::Wall<2>{});
      const double U = 5.0, mu = 200.0;
      faces[3] = fluid::Wall<2>{.velocity = {U, 0.0}};
      const UnderLid box{
          .flow = {fluid_conservation::box<2>(8), made_of(gas, continuum::ConstantViscosity{.mu = mu}), faces},
          .U = U,
          .mu = mu};
      schemes::State state = box.flow.start(stirred<2>);
      const Eigen::Index N = box.flow.grid().size();
      const double cell = box.flow.grid().h(0) * box.flow.grid().h(1);
      const auto energy = [&] { return cell * state.y.segment(3 * N, N).sum(); };
      const auto mass = [&] { return cell * state.y.head(N).sum(); };
      const double energy_before = energy(), mass_before = mass();
      state.y.conservativeResize(4 * N + 1);
      state.y[4 * N] = 0.0;
      advance<schemes::RungeKutta4>(box, state, 2.0, 200);
      rows.compare("energy gained [J]", {.expected = state.y[4 * N],
                                         .computed = energy() - energy_before,
                                         .tolerance = absolute(1e-13 * energy_before),
                                         .because = "rounding of the energy in 200 steps"});
      rows.at_least("of it over the rounding of the energy", {.limit = 1e8,
                                                              .computed = state.y[4 * N] / (1e-13 * energy_before),
                                                              .because = "else nothing would be compared"});
      rows.compare("mass [kg]", {.expected = mass_before,
                                 .computed = mass(),
                                 .tolerance = relative(1e-14),
                                 .because = "rounding in 200 steps"});
    }};

// Taylor and Green's vortex, U = 1 m/s in a box of 2 pi m, with the pressure that it has where nothing is compressed;
// sound at 10 m/s.
fluid::Local<3> vortex(const fluid::Vector<3>& x) {
  const double P = (std::cos(2.0 * x[0]) + std::cos(2.0 * x[1])) * (std::cos(2.0 * x[2]) + 2.0) / 16.0;
  return {
      .rho = 1.0 + P / 100.0,
      .v = {std::sin(x[0]) * std::cos(x[1]) * std::cos(x[2]), -std::cos(x[0]) * std::sin(x[1]) * std::cos(x[2]), 0.0}};
}
constexpr continuum::Barotropic ten_times_faster{.P_R = 0.0, .Y = 100.0, .rho_R = 1.0};

// The same fluid in the plain divergence form: central differences of what is carried.
struct DivergenceForm {
  Eigen::Index n;

  bool rate(double, schemes::In y, schemes::Out dy) const {
    const Eigen::Index N = n * n * n;
    const double over_2h = 0.5 * static_cast<double>(n) / two_pi;
    bool good = true;
    const Eigen::Index strides[] = {1, n, n * n};
    dy.setZero();
    for (Eigen::Index cell = 0; cell < N; ++cell) {
      good = good && y[cell] > 0.0;
      for (Eigen::Index a = 0; a < 3; ++a) {
        const Eigen::Index along = cell / strides[a] % n;
        const Eigen::Index after = cell + ((along + 1) % n - along) * strides[a],
                           before = cell + ((along + n - 1) % n - along) * strides[a];
        // What is carried here leaves the cell before, and comes to the one after.
        const double m = y[cell + (1 + a) * N], u = m / y[cell];
        const auto carry = [&](Eigen::Index field, double flux) {
          dy[after + field * N] += flux * over_2h;
          dy[before + field * N] -= flux * over_2h;
        };
        carry(0, m);
        for (Eigen::Index i = 0; i < 3; ++i) carry(1 + i, u * y[cell + (1 + i) * N]);
        carry(1 + a, 100.0 * (y[cell] - 1.0));
      }
    }
    return good && dy.allFinite();
  }
};

double kinetic_energy(const schemes::State& at) {
  const Eigen::Index N = at.y.size() / 4;
  double sum = 0.0;
  for (Eigen::Index i = 0; i < 3 * N; ++i) sum += 0.5 * at.y[N + i] * at.y[N + i] / at.y[i % N];
  return sum / static_cast<double>(N);
}

const Case convection{
    {.name = "kinetic_energy_of_an_inviscid_vortex",
     .claim = "convection makes no kinetic energy: an inviscid Taylor-Green vortex runs on to t = 20, where the plain "
              "divergence form blows up",
     .equation = "D 8.2",
     .reference = Reference::identity},
    [](Rows& rows) {
      const Eigen::Index n = rows.full() ? 32 : 16;
      fluid::Grid<3> grid;
      grid.cells.fill(n);
      grid.lengths.setConstant(two_pi);
      const fluid::BarotropicFlow<3> flow(grid, {.state = ten_times_faster, .viscosity = {.mu = 0.0}}, {},
                                          rows.threads());
      schemes::State state = flow.start(vortex);
      const double before = kinetic_energy(state);
      const double step = 0.8 / static_cast<double>(n);
      double furthest = 0.0;
      schemes::RungeKutta4 scheme;
      schemes::FixedStep control{.step = step};
      require_reached(
          schemes::integrate(flow, state, 20.0, scheme, control, [&](const auto&, const auto& to, double, const auto&) {
            furthest = std::max(furthest, std::abs(kinetic_energy(to) / before - 1.0));
            return true;
          }));
      rows.at_most(fmt::format("largest change of the kinetic energy, {}^3 cells", n),
                   {.limit = 1e-3, .computed = furthest, .because = "what sound holds of it, at a tenth of its speed"});
      const DivergenceForm plain{.n = n};
      schemes::State other = flow.start(vortex);
      const schemes::Outcome outcome = schemes::integrate(plain, other, 20.0, scheme, control);
      rows.equal("how the plain divergence form ends",
                 {.expected = std::string(schemes::name(schemes::Failure::no_value)),
                  .computed = std::string(schemes::name(outcome.failure)),
                  .because = "aliased, its convection makes kinetic energy without bound"});
      const std::string when = fmt::format("when it does, {}^3 cells [s]", n);
      if (rows.full()) {
        rows.compare(when, {.expected = 5.35,
                            .computed = outcome.t,
                            .tolerance = absolute(0.1),
                            .because = "a prototype found 5.3 to 5.4"});
      } else {
        rows.at_most(when,
                     {.limit = 10.0, .computed = outcome.t, .because = "half of the time that the other form runs"});
      }
    }};

// A thinning liquid between walls of 300 and 400 K, of which the hot one moves: all that the flow has, at once.
fluid::ThinningFlow<2> all_at_once(int threads = 1) {
  fluid::Boundaries<2> faces;
  faces[2] = fluid::Wall<2>{.theta = 300.0};
  faces[3] = fluid::Wall<2>{.velocity = {2.0, 0.0}, .theta = 400.0};
  return {box<2>(6), made_of(liquid, continuum::ExponentialViscosity{.mu_R = 100.0}), faces, threads};
}

constexpr double t_end = 0.13;

// Of each field the largest difference, over its largest value.
double apart(const fluid::ThinningFlow<2>& flow, const schemes::State& one, const schemes::State& other) {
  double worst = 0.0;
  for (const schemes::Range& field : flow.ranges()) {
    const auto off = [&](const schemes::State& at) { return at.y.segment(field.first, field.size); };
    worst = report::worse_of(worst, (off(one) - off(other)).cwiseAbs().maxCoeff() / off(other).cwiseAbs().maxCoeff());
  }
  return worst;
}

const Case semi_discrete{
    {.name = "semi_discrete_flow",
     .claim =
         "RK4, collocation and sweeps come to what CVODE and ARKODE find of the cells' equations, each at its order",
     .equation = "D 8.2",
     .reference = Reference::sundials},
    [](Rows& rows) {
      const fluid::ThinningFlow<2> flow = all_at_once();
      const schemes::State start = flow.start(stirred<2>);
      schemes::State known = start, by_adams = start;
      require_reached(
          reference::integrate(flow, known, t_end,
                               reference::ExplicitRungeKutta{
                                   .table = reference::Table::fehlberg_13_7_8, .relative = 1e-14, .absolute = 1e-14}));
      require_reached(
          reference::integrate(flow, by_adams, t_end, reference::Adams{.relative = 1e-13, .absolute = 1e-13}));
      rows.at_most("CVODE from ARKODE",
                   {.limit = 1e-11, .computed = apart(flow, by_adams, known), .because = "Adams is good to 1e-11"});
      const auto check = [&](const std::string& name, double order, std::initializer_list<int> counts, auto scheme,
                             schemes::FixedStep control) {
        std::vector<double> steps, errors;
        for (const int n : counts) {
          steps.push_back(t_end / n);
          schemes::State state = start;
          control.step = steps.back();
          reach(flow, state, t_end, scheme, control);
          errors.push_back(apart(flow, state, known));
        }
        rows.order(name, {.nominal = order,
                          .steps = steps,
                          .errors = errors,
                          .floor = 1e-13,
                          .because = "cells that are what they are, sweeps to rounding"});
      };
      check("RK4", 4.0, {6, 9, 13, 19, 28}, schemes::RungeKutta4(), {});
      check("Gauss 2", 4.0, {6, 9, 13, 19, 28}, schemes::Collocation<schemes::Gauss<2>>(), {.TOL = 1e-13});
      check("Gauss 3", 6.0, {4, 5, 7, 9, 12}, schemes::Collocation<schemes::Gauss<3>>(), {.TOL = 1e-13});
      check("sweeps", 1.0, {160, 200, 250, 320, 400}, in_turn(true, 1e-12), {.TOL = 1.0});
    }};

const Case bits{{.name = "bits_of_a_flow",
                 .claim = "one, two and three threads, an object used before and a copy of it give the same bits",
                 .equation = "D 8.2",
                 .reference = Reference::design},
                [](Rows& rows) {
                  const auto run = [](const auto& flow, const auto& stirred_start) {
                    schemes::State state = flow.start(stirred_start);
                    advance<schemes::RungeKutta4>(flow, state, 0.1, 5);
                    return state;
                  };
                  const auto check = [&](const std::string& name, const auto& made, const auto& stirred_start) {
                    const auto flow = made(1);
                    const schemes::State once = run(flow, stirred_start);
                    const auto none = [&](const std::string& what, const auto& other) {
                      rows.none(name + ", " + what, differing(once, run(other, stirred_start)), "the same operations");
                    };
                    none("numbers that differ with 2 threads", made(2));
                    none("numbers that differ with 3 threads", made(3));
                    none("numbers that differ the second time", flow);
                    const auto copy = flow;
                    none("numbers that differ in a copy", copy);
                  };
                  check("thinning liquid, 2-D", all_at_once, stirred<2>);
                  const auto in_space = [](int threads) {
                    return fluid::GasFlow<3>(box<3>(5), made_of(gas, continuum::ConstantViscosity{.mu = 20.0}),
                                             walls<3>(), threads);
                  };
                  check("gas, 3-D", in_space, stirred<3>);
                }};

}  // namespace verification::fluid_conservation
