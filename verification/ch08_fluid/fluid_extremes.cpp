// Flows that must be borne, however extreme, and those that must be refused.

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <harness/motions.hpp>
#include <particulate/fluid/flow.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/staggering.hpp>

#include "../ch03_schemes/bits.hpp"

namespace verification::fluid_extremes {

using namespace particulate;

template <int Dim>
fluid::Grid<Dim> box(Eigen::Index cells, double length = 1.0) {
  fluid::Grid<Dim> grid;
  grid.cells.fill(cells);
  grid.lengths.setConstant(length);
  return grid;
}

Ending within(double error, double tolerance, const char* because) {
  return Ending::solved({.error = error, .tolerance = tolerance, .because = because});
}

schemes::Staggered in_turn() { return schemes::Staggered({{.name = "density", .p = 2}, {.name = "momentum", .p = 2}}); }

// A standing wave of sound, one wavelength in 16 cells, and how long it takes after the formula of the cells.
struct Sound {
  double Y = 1e5, length = 1.0;
  double k = 2.0 * std::numbers::pi / length;
  fluid::BarotropicFlow<1> flow{box<1>(16, length), {.state = {.Y = Y}, .viscosity = {.mu = 0.0}}, {}};

  double h() const { return flow.grid().h(0); }
  double c() const { return std::sqrt(Y / 1000.0); }
  double omega() const { return c() * std::sin(k * h()) / h(); }
  schemes::State start() const {
    return flow.start([this](const fluid::Vector<1>& x) {
      return fluid::Local<1>{.rho = 1000.0 * (1.0 + 1e-7 * std::cos(k * x[0]))};
    });
  }
  // Amplitude of density over that at the start.
  double of(const schemes::State& at) const {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < 16; ++i) sum += (at.y[i] / 1000.0 - 1.0) * std::cos(k * flow.grid().centre({i})[0]);
    return sum / 8e-7;
  }
  // By RK4, the step chosen by its error or the limit, over 1.3 periods.
  Ending solved() const {
    schemes::State state = start();
    const double t_end = 1.3 * 2.0 * std::numbers::pi / omega();
    const schemes::Outcome outcome =
        integrate(flow, state, t_end, schemes::RungeKutta4(), schemes::FixedStep{.step = t_end / 400.0});
    if (outcome.status != schemes::Status::reached) return Ending::refused(outcome.reason);
    return within(std::abs(of(state) - std::cos(omega() * t_end)), 1e-6, "an amplitude of 1e-7, and its rounding");
  }
  // A thousand fixed steps of so many sweeps; a hundred of 0, as many as it takes.
  schemes::Outcome stepped(double dt, int sweeps, schemes::State& state) const {
    const double t_end = (sweeps > 0 ? 1000.0 : 100.0) * dt;
    return sweeps > 0 ? integrate(flow, state, t_end, in_turn(), schemes::FixedSweeps{.step = dt, .sweeps = sweeps})
                      : integrate(flow, state, t_end, in_turn(), schemes::FixedStep{.step = dt, .TOL = 1.0});
  }
};

template <class Flow>
Ending stays(const Flow& flow, const schemes::State& start) {
  schemes::State state = start;
  advance<schemes::RungeKutta4>(flow, state, 0.01, 100);
  const double by_steps = static_cast<double>(differing(state, start) - 1);  // the time is another
  return within(by_steps, 0.0, "nothing drives it, and every face has the same flux");
}

const Case solved{{.name = "extreme_flows",
                   .claim = "stiff fluids, small and large boxes, no flow and no viscosity are solved",
                   .equation = "D 8.2",
                   .reference = Reference::closed_form},
                  [](Rows& rows) {
                    rows.must_be_solved("sound at Y = 1e10, 3162 m/s", [] { return Sound{.Y = 1e10}.solved(); });
                    rows.must_be_solved("sound in a box of 1e-6 m", [] { return Sound{.length = 1e-6}.solved(); });
                    rows.must_be_solved("sound in a box of 1e6 m", [] { return Sound{.length = 1e6}.solved(); });
                    rows.must_be_solved("no flow, a gas in 3-D", [] {
                      const fluid::GasFlow<3> flow(box<3>(5), {.c = 717.5}, {});
                      return stays(flow, flow.start([](const auto&) { return fluid::Local<3>{.rho = 1.2}; }));
                    });
                    rows.must_be_solved("no flow, a stiff liquid between walls", [] {
                      fluid::Boundaries<2> faces;
                      faces.fill(fluid::Wall<2>{.theta = 300.0});
                      const fluid::LiquidFlow<2> flow(box<2>(5), {.state = {.Y = 1e10}}, faces);
                      return stays(flow, flow.start([](const auto&) { return fluid::Local<2>{.rho = 1000.0}; }));
                    });
                  }};

// What a flow of a barotropic fluid is made of.
struct Barotropic {
  fluid::Grid<2> grid = box<2>(8);
  fluid::Fluid<continuum::Barotropic> fluid = {};
  fluid::Boundaries<2> faces = {};
  int threads = 1;
};
Ending barotropic(const std::function<void(Barotropic&)>& spoil) {
  Barotropic of;
  spoil(of);
  (void)fluid::BarotropicFlow<2>(of.grid, of.fluid, of.faces, of.threads);
  return accepted();
}
Ending liquid(const std::function<void(fluid::Fluid<continuum::LinearizedState>&)>& spoil) {
  fluid::Fluid<continuum::LinearizedState> water;
  spoil(water);
  (void)fluid::LiquidFlow<1>(box<1>(8), water, {});
  return accepted();
}

const Case bad_input{
    {.name = "bad_input_of_flows",
     .claim = "grids, fluids and boundaries that nobody can mean are refused by name",
     .equation = "D 8.2",
     .reference = Reference::design},
    [](Rows& rows) {
      const auto grid = [&](const std::string& name, const std::string& key_words, auto spoil) {
        rows.must_be_refused(name, key_words, [=] { return barotropic([=](auto& of) { spoil(of.grid); }); });
      };
      grid("3 cells across", "grid 4 cells 3 y", [](auto& g) { g.cells[1] = 3; });
      grid("a length of 0", "grid lengths positive x", [](auto& g) { g.lengths[0] = 0.0; });
      grid("a length that is no number", "grid lengths finite", [](auto& g) { g.lengths[1] = not_a_number; });
      grid("a corner at infinity", "grid corner finite", [](auto& g) { g.corner[0] = infinite; });
      const auto water = [&](const std::string& name, const std::string& key_words, auto spoil) {
        rows.must_be_refused(name, key_words, [=] { return liquid([=](auto& w) { spoil(w); }); });
      };
      for (const double x : {0.0, -1.0, not_a_number, infinite}) {
        water(fmt::format("Y = {}", x), "Y positive", [=](auto& w) { w.state.Y = x; });
        water(fmt::format("rho_R = {}", x), "rho_R positive", [=](auto& w) { w.state.rho_R = x; });
        water(fmt::format("c = {}", x), "c must be positive", [=](auto& w) { w.c = x; });
      }
      for (const double x : {-1e-9, not_a_number, infinite}) {
        water(fmt::format("mu = {}", x), "mu", [=](auto& w) { w.viscosity.mu = x; });
        water(fmt::format("K = {}", x), "K must be finite not negative", [=](auto& w) { w.K = x; });
      }
      water("lambda below -2/3 mu", "lambda_over_mu -2/3 gain", [](auto& w) { w.lambda_over_mu = -0.7; });
      const auto faces = [&](const std::string& name, const std::string& key_words, auto spoil) {
        rows.must_be_refused(name, key_words, [=] { return barotropic([=](auto& of) { spoil(of.faces); }); });
      };
      faces("a periodic face alone", "boundary x high periodic x low", [](auto& f) { f[0] = fluid::Wall<2>{}; });
      faces("a wall that moves across itself", "boundary y low wall along itself 0.1", [](auto& f) {
        f[2] = fluid::Wall<2>{.velocity = {1.0, 0.1}};
        f[3] = fluid::Wall<2>{};
      });
      faces("a wall that moves at no number", "boundary y low wall", [](auto& f) {
        f[2] = fluid::Wall<2>{.velocity = {not_a_number, 0.0}};
        f[3] = fluid::Wall<2>{};
      });
      faces("a temperature where there is none", "boundary x low barotropic temperature", [](auto& f) {
        f[0] = fluid::Wall<2>{.theta = 300.0};
        f[1] = fluid::Wall<2>{};
      });
      faces("a pressure that is no number", "boundary x low pressure finite", [](auto& f) {
        f[0] = fluid::Outflow{.P = not_a_number};
        f[1] = fluid::Wall<2>{};
      });
      faces("a fluid that is not given", "boundary x low fluid given", [](auto& f) {
        f[0] = fluid::Given<2>{};
        f[1] = fluid::Wall<2>{};
      });
      rows.must_be_refused("a wall at 0 K", "boundary x low temperature positive", [] {
        (void)fluid::LiquidFlow<1>(box<1>(8), {}, {fluid::Wall<1>{.theta = 0.0}, fluid::Wall<1>{}});
        return accepted();
      });
      for (const int threads : {0, -1, 1025}) {
        rows.must_be_refused(fmt::format("{} threads", threads), "threads from 1 to 1024",
                             [=] { return barotropic([=](auto& of) { of.threads = threads; }); });
      }
      const auto start = [&](const std::string& name, const fluid::Local<1>& local) {
        rows.must_be_refused("a start with " + name, "start positive finite cell 0", [=] {
          const fluid::LiquidFlow<1> flow(box<1>(8), {}, {});
          (void)flow.start([=](const auto&) { return local; });
          return accepted();
        });
      };
      start("no density", {.rho = 0.0});
      start("a negative density", {.rho = -1.0});
      start("no temperature", {.rho = 1.0, .theta = 0.0});
      start("a velocity that is no number", {.rho = 1.0, .v = fluid::Vector<1>(not_a_number)});
      start("infinite density", {.rho = infinite});
    }};

// A gas that is torn apart: its halves leave each other at twenty times the speed of sound.
template <class Control>
Ending torn(Control control) {
  const fluid::GasFlow<1> flow(box<1>(16), {.viscosity = {.mu = 0.0}, .c = 717.5, .K = 0.0}, {});
  schemes::State state = flow.start([=](const fluid::Vector<1>& x) {
    return fluid::Local<1>{.rho = 1.2, .v = fluid::Vector<1>(-7e3 * std::sin(2.0 * std::numbers::pi * x[0]))};
  });
  return ending_of(integrate(flow, state, 1.0, schemes::RungeKutta4(), control));
}

void refuse_steps(Rows& rows) {
  for (const int sweeps : {1, 2, 3, 12, 0}) {
    const Sound sound;
    const double limit = (sweeps == 1 ? 2.0 : 1.0) * sound.h() / sound.c();
    const std::string of = sweeps > 0 ? fmt::format("{} sweeps", sweeps) : "converged sweeps";
    schemes::Outcome outcome;
    rows.must_be_refused("z = c Dt/h a thousandth beyond the limit, " + of, "step span sound carried take at most",
                         [&] {
                           schemes::State state = sound.start();
                           outcome = sound.stepped(1.001 * limit, sweeps, state);
                           return ending_of(outcome);
                         });
    rows.must_be_solved("nine tenths of the step that it says would do, " + of, [&] {
      schemes::State state = sound.start();
      const schemes::Outcome again = sound.stepped(0.9 * outcome.workable_step, sweeps, state);
      if (again.status != schemes::Status::reached) return Ending::refused(again.reason);
      return within(std::abs(sound.of(state)), 1.1, "sound does not grow");
    });
  }
}

// A liquid of which one cell has been emptied.
Ending emptied() {
  const fluid::LiquidFlow<1> flow(box<1>(8), {}, {});
  schemes::State state = flow.start([](const auto&) { return fluid::Local<1>{.rho = 1000.0}; });
  state.y[3] = 0.0;
  return ending_of(integrate(flow, state, 1.0, schemes::RungeKutta4(), schemes::FixedStep{.step = 1e-5}));
}

const Case refused{{.name = "refused_flows",
                    .claim = "vacuum, and fixed steps beyond what the sweeps bear, are refused, with what would do",
                    .equation = "D 8.4",
                    .reference = Reference::design},
                   [](Rows& rows) {
                     rows.must_be_refused("a gas torn apart at 20 times its sound", "no finite value step",
                                          [] { return torn(schemes::FixedStep{.step = 1e-6}); });
                     rows.must_be_refused("the same, with steps that adapt", "no step small enough cell kg/m^3 K",
                                          [] { return torn(schemes::ErrorControl{.TOL = 1e-6, .step = 1e-6}); });
                     rows.must_be_refused("a cell that has been emptied", "cell 3 0 kg/m^3", emptied);
                     refuse_steps(rows);
                   }};

}  // namespace verification::fluid_extremes
