// Error against run time of fluids: sound, a stirred gas, and a vortex on finer and finer grids.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/front.hpp>
#include <harness/motions.hpp>
#include <harness/races.hpp>
#include <particulate/fluid/flow.hpp>
#include <particulate/report/table.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/staggering.hpp>

namespace verification::work_precision_fluid {

using namespace particulate;

constexpr double two_pi = 2.0 * std::numbers::pi;

// Fields solved in turn, each by one step of Euler's, as the flow itself does; right-hand sides are asked for here, so
// that they are counted and replayed as those of everybody else.
struct InTurn {
  schemes::Problem whole;
  schemes::Rates rates = {};

  std::size_t fields() const { return whole.fields(); }
  schemes::Part part(std::size_t k) const { return whole.part(k); }
  std::vector<schemes::TimeScale> step_limits(const schemes::State& at) const { return whole.step_limits(at); }
  bool solve(std::size_t k, const schemes::State& from, double dt, const schemes::State& seen, schemes::State& to) {
    if (!whole.rates(seen, rates)) return false;
    const schemes::Part own = part(k);
    to.y.segment(own.first, own.size) =
        from.y.segment(own.first, own.size) + dt * rates.dy.segment(own.first, own.size);
    return true;
  }
};

// Sweeps over them under a control that is made of the setting, each field to a tolerance of its own.
template <class Control>
Begin in_turn(double TOL, Control control) {
  return [=](const schemes::Problem& problem, const schemes::State&, double setting) -> Advance {
    std::vector<schemes::Field> fields(problem.fields(), {.name = "field", .TOL = TOL, .p = 2});
    return [fields = InTurn{.whole = problem}, scheme = schemes::Staggered(fields), now = control(setting)](
               schemes::State& state, double t_end) mutable {
      return schemes::integrate(fields, state, t_end, scheme, now);
    };
  };
}
Begin one_sweep() {
  return in_turn(1.0, [](double step) { return schemes::FixedSweeps{.step = step, .sweeps = 1}; });
}
Begin adaptive_staggering(double TOL) {
  return in_turn(TOL, [](double limit) { return schemes::PhiControl{.TOL = 1.0, .step = limit, .limit = limit}; });
}

// A race between two references, which may have no value 0 anywhere.
JudgedRace judged(HeldProblem problem, const schemes::State& start, double t_end) {
  Race race{.problem = std::move(problem), .start = start, .outputs = {0.5 * t_end, t_end}, .truth = {}};
  const reference::ExplicitRungeKutta fehlberg{
      .table = reference::Table::fehlberg_13_7_8, .relative = 1e-14, .absolute = 1e-14};
  race.truth = [handed = handed_by(race, fehlberg)](double t) { return t < handed.back().t ? handed[0] : handed[1]; };
  const double floor = errors_of(race, handed_by(race, reference::Adams{.relative = 1e-14, .absolute = 1e-14})).max;
  return {.race = race, .floor = std::max(floor, rounding_floor)};
}

template <int stages>
Competitor gauss(const Race& race, double tightest) {
  const double leg = race.outputs.front();
  return competitor(fmt::format("Gauss {}", stages), race, tolerances(tightest, 1e-2),
                    under(schemes::Collocation<schemes::Gauss<stages>>(), [=](double TOL) {
                      return schemes::ErrorControl{
                          .TOL = TOL, .sweep_TOL = 0.1 * TOL, .step = 0.01 * leg, .limit = leg};
                    }));
}

// Steps in a leg to begin with: those from which RK4 is stable, and those that are good to some hundredths.
struct Coarsest {
  int rk4, one_sweep, staggering;
};
std::vector<Competitor> all_of(const Race& race, const Coarsest& from, bool quick) {
  const double leg = race.outputs.front();
  const auto sweeping = [&](const std::string& name, double TOL) {
    return competitor(name, race, step_sizes(leg, {from.staggering, 2.0, quick ? 1 : 4}), adaptive_staggering(TOL));
  };
  return {with_slope(
              4.0, competitor("RK4", race, step_sizes(leg, {from.rk4, 1.5, 5}), at_fixed_step<schemes::RungeKutta4>())),
          with_slope(1.0,
                     competitor("one sweep", race, step_sizes(leg, {from.one_sweep, 2.0, quick ? 4 : 5}), one_sweep())),
          sweeping("staggering", 1e-6),
          tuned(sweeping("staggering, TOL 1e-2", 1e-2)),
          gauss<3>(race, quick ? 1e-6 : 1e-10),
          gauss<6>(race, quick ? 1e-6 : 1e-12),
          competitor("CVODE Adams", race, tolerances(quick ? 1e-6 : 1e-12), by(reference::Adams{})),
          competitor("ARKODE", race, tolerances(quick ? 1e-6 : 1e-12), by(reference::ExplicitRungeKutta{}))};
}

// What the sweeps cost at an error that they come to, over what RK4 does, and what everybody does over SUNDIALS.
void compare_costs(Rows& rows, const std::string& problem) {
  const auto evaluations = [](const WorkPrecisionPoint& p) { return static_cast<double>(p.counts.evaluations); };
  const auto seconds = [](const WorkPrecisionPoint& p) { return p.seconds_min.value_or(missing); };
  const auto over_rk4 = [&](const std::string& method, double error, const auto& of) {
    return cost_over(rows.points(), problem, method, "RK4", error, of);
  };
  report::Table table({"error", "method", "evaluations over those of RK4", "seconds over those of RK4"});
  for (const char* method : {"one sweep", "staggering", "staggering, TOL 1e-2"}) {
    for (const double error : {1e-2, 3e-3, 1e-3})
      table.add({error, method, over_rk4(method, error, evaluations), over_rk4(method, error, seconds)});
  }
  rows.write("cost_of_sweeps_" + problem, table);
  const auto claim = [&](const std::string& method, double least, const std::string& because) {
    rows.at_least(fmt::format("{}, {} to 1e-2: evaluations over those of RK4", problem, method),
                  {.limit = least, .computed = over_rk4(method, 1e-2, evaluations), .because = because});
  };
  claim("staggering", 10.0,
        "a prototype found ten: sweeps converge in shorter steps than RK4 bears, many a step, and are of order 1");
  claim("staggering, TOL 1e-2", 5.0, "fewer sweeps a step, at the same order");
  const std::vector<double> reported{0.0, 0.0, 0.0, 0.0};
  compare_fronts(rows, problem, {"SUNDIALS", {"CVODE Adams", "ARKODE"}},
                 {{{"RK4", {"RK4"}}, reported, "reported"},
                  {{"collocation, adaptive", {"Gauss 3", "Gauss 6"}}, reported, "reported"}});
}

void measure(Rows& rows, const std::string& problem, HeldProblem flow, const schemes::State& start, double t_end,
             const Coarsest& from) {
  const JudgedRace judged_one = judged(std::move(flow), start, t_end);
  rows.work_precision({.problem = problem,
                       .reference = "ARKODE Fehlberg 8(7) at 1e-14, checked by CVODE Adams",
                       .floor = judged_one.floor,
                       .competitors = all_of(judged_one.race, from, rows.quick())});
  compare_costs(rows, problem);
}

const Case sound{
    {.name = "work_precision_sound",
     .claim = "error against run time of sound: RK4 has order 4, one sweep order 1, and the adaptive staggering takes "
              "at least ten times the evaluations of RK4 to a hundredth",
     .equation = "R 8.4",
     .reference = Reference::sundials},
    [](Rows& rows) {
      // A wave of a hundredth for 1.3 periods, on a stream of six hundredths of the speed of sound, 10 m/s.
      const fluid::BarotropicFlow<1> flow({.cells = {32}}, {.state = {.Y = 1e5}, .viscosity = {.mu = 0.0}}, {});
      const schemes::State start = flow.start([](const fluid::Vector<1>& x) {
        const double wave = 0.01 * std::cos(two_pi * x[0]);
        return fluid::Local<1>{.rho = 1000.0 * (1.0 + wave), .v = fluid::Vector<1>(0.6 + 10.0 * wave)};
      });
      measure(rows, "sound", flow, start, 0.13, {.rk4 = 10, .one_sweep = 84, .staggering = 320});
    }};

// A gas in which sound has the speed 10 m/s, gamma = 1.4.
fluid::Fluid<continuum::IdealGas> light_gas(double mu, double K) {
  return {.state = {.R = 100.0 / (1.4 * 300.0)}, .viscosity = {.mu = mu}, .c = 100.0 / (1.4 * 0.4 * 300.0), .K = K};
}

const Case stirred{
    {.name = "work_precision_stirred_gas",
     .claim = "error against run time of vortices that drift in a viscous gas: RK4 has order 4, one sweep order 1, and "
              "the adaptive staggering takes at least ten times the evaluations of RK4 to a hundredth",
     .equation = "R 8.4",
     .reference = Reference::sundials},
    [](Rows& rows) {
      const int n = rows.full() ? 16 : 8;
      fluid::Grid<2> grid;
      grid.cells.fill(n);
      grid.lengths.setConstant(two_pi);
      const fluid::GasFlow<2> flow(grid, light_gas(0.02, 0.02), {});
      const schemes::State start = flow.start([](const fluid::Vector<2>& x) {
        return fluid::Local<2>{
            .rho = 1.0,
            .v = {1.0 + 0.4 * std::sin(x[0]) * std::cos(x[1]), 1.0 - 0.4 * std::cos(x[0]) * std::sin(x[1])}};
      });
      measure(rows, "stirred_gas", flow, start, 1.0, {.rk4 = 5 * n / 4, .one_sweep = 12 * n, .staggering = 5 * n});
    }};

// A vortex that a stream carries, without friction: an exact solution of a gas of gamma = 1.4 and R = 1, with
// 1 m/s of stream at 1 K and 1 kg/m^3. In a box of 12 m its neighbours are not felt.
fluid::Local<2> carried_vortex(const fluid::Vector<2>& x) {
  const double strength = 0.2 / two_pi, swirl = strength * std::exp(0.5 * (1.0 - x.squaredNorm()));
  const double theta = 1.0 - 0.5 * (0.4 / 1.4) * swirl * swirl;
  return {.rho = std::pow(theta, 2.5), .v = {1.0 - swirl * x[1], swirl * x[0]}, .theta = theta};
}

const Case in_space{
    {.name = "work_precision_in_space",
     .claim =
         "a vortex that a stream carries comes out with order 2 in the size of the cells, for seconds that grow as "
         "their number times the steps",
     .equation = "D 8.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      constexpr double t_end = 1.3, length = 12.0, core = std::numbers::pi;
      report::Table table({"cells in a direction", "error", "evaluations", "seconds"});
      std::vector<double> sizes, errors;
      for (const int n : {8, 12, 16, 24, 30, 38, 48, 64}) {
        fluid::Grid<2> grid;
        grid.cells.fill(n);
        grid.lengths.setConstant(length);
        grid.corner.setConstant(-0.5 * length);
        const fluid::GasFlow<2> flow(grid, {.state = {.R = 1.0}, .viscosity = {.mu = 0.0}, .c = 2.5, .K = 0.0}, {},
                                     rows.threads());
        schemes::State state = flow.start(carried_vortex);
        const auto began = std::chrono::steady_clock::now();
        const schemes::Outcome outcome =
            reached(flow, state, t_end, schemes::RungeKutta4(), schemes::FixedStep{.step = t_end / n});
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
        double squares = 0.0;
        for (Eigen::Index cell = 0; cell < grid.size(); ++cell) {
          const fluid::Vector<2> x = grid.centre({cell % n, cell / n}) - fluid::Vector<2>(t_end, 0.0);
          squares += grid.h(0) * grid.h(1) * (flow.local(state, cell).v - carried_vortex(x).v).squaredNorm();
        }
        const double error = std::sqrt(squares / core);
        table.add({n, error, outcome.evaluations, took.count()});
        if (n >= 24) sizes.push_back(length / n), errors.push_back(error);
      }
      rows.write("work_precision_in_space", table);
      rows.order("velocity of a carried vortex over that of the stream, root mean square over its core",
                 {.nominal = 2.0,
                  .steps = sizes,
                  .errors = errors,
                  .floor = 1e-8,
                  .because = "central differences, and a box that cuts the vortex at 1e-8"});
    }};

}  // namespace verification::work_precision_fluid
