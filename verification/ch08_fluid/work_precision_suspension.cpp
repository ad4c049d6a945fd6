// Error against run time of what is asked of the volume element: the means of its particles.

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/front.hpp>
#include <harness/races.hpp>
#include <harness/starts.hpp>
#include <particulate/report/table.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/runge_kutta.hpp>

#include "suspensions.hpp"

namespace verification::work_precision_suspension {

using namespace particulate;

// Mean velocity, mean speed and mean temperature of particles.
schemes::State means(const schemes::State& at) {
  const auto v = schemes::velocities(at);
  schemes::State seen{.t = at.t, .r = {}, .v = {}, .y = Eigen::VectorXd(5)};
  seen.y.head<3>() = v.colwise().mean().transpose();
  seen.y[3] = v.rowwise().norm().mean();
  seen.y[4] = at.y.tail(v.rows()).mean();
  return seen;
}

// Sweeps: no right-hand side is asked for, so that there is nothing to replay, and the replay is the run itself. A
// sweep counts as one, because it adds the fluxes of each field once.
template <class Control>
struct Sweeping {
  Race race;
  double TOL;
  Control control;
  std::vector<schemes::State> handed = {};

  Counts run() {
    const schemes::Problem problem = race.problem.seen();
    schemes::Staggered scheme(std::vector<schemes::Field>(problem.fields(), {.name = "field", .TOL = TOL, .p = 2}));
    Control now = control;
    schemes::State state = race.start;
    Counts counts;
    handed.clear();
    for (const double t : race.outputs) {
      const schemes::Outcome outcome = schemes::integrate(problem, state, t, scheme, now);
      counts.evaluations += outcome.sweeps, counts.iterations += outcome.sweeps;
      if (outcome.status != schemes::Status::reached) {
        counts.failure = outcome.reason;
        break;
      }
      handed.push_back(state);
    }
    return counts;
  }
  Task task() const {
    const auto numbers = [](const Eigen::VectorXd& all) { return std::vector<double>(all.begin(), all.end()); };
    schemes::Rates rates;
    if (!race.problem.seen().rates(race.start, rates)) rates.a.setConstant(missing), rates.dy.setConstant(missing);
    return {.start = numbers(schemes::flat(race.start)),
            .rate = numbers(schemes::flat({.r = rates.a, .y = rates.dy})),
            .outputs = race.outputs};
  }
};

template <class Make>
Competitor sweeping(const std::string& name, const Race& race, const std::vector<double>& settings, double TOL,
                    Make control) {
  using Lane = Sweeping<decltype(control(0.0))>;
  const auto prepare = [=](double setting) {
    const auto lane = std::make_shared<Lane>(Lane{.race = race, .TOL = TOL, .control = control(setting)});
    const auto run = [=] { return lane->run(); };
    return Prepared{
        .task = lane->task(), .run = run, .errors = [=] { return errors_of(lane->race, lane->handed); }, .replay = run};
  };
  return {.name = name, .tuned = false, .slope = {}, .settings = settings, .prepare = prepare};
}

Competitor adaptive(const std::string& name, const Race& race, double TOL, bool quick) {
  return sweeping(name, race, step_sizes(race.outputs.front(), {8, 2.0, quick ? 2 : 4}), TOL, [](double limit) {
    return schemes::PhiControl{.TOL = 1.0, .step = limit, .limit = limit, .spare = 2};
  });
}

template <int stages>
Competitor gauss(const Race& race, double tightest) {
  const double leg = race.outputs.front();
  return competitor(fmt::format("Gauss {}", stages), race, tolerances(tightest, 1e-3),
                    under(schemes::Collocation<schemes::Gauss<stages>>(), [=](double TOL) {
                      return schemes::ErrorControl{
                          .TOL = TOL, .sweep_TOL = 0.1 * TOL, .step = 0.01 * leg, .limit = leg};
                    }));
}

std::vector<Competitor> all_of(const Race& race, bool quick) {
  const double leg = race.outputs.front(), tightest = quick ? 1e-4 : 1e-6;
  const auto one_sweep = [](double step) { return schemes::FixedSweeps{.step = step, .sweeps = 1}; };
  return {competitor("RK4", race, step_sizes(leg, {2, 2.0, quick ? 3 : 6}), at_fixed_step<schemes::RungeKutta4>()),
          with_slope(1.0, sweeping("one sweep", race, step_sizes(leg, {4, 2.0, quick ? 4 : 6}), 1.0, one_sweep)),
          adaptive("staggering", race, 1e-6, quick),
          tuned(adaptive("staggering, TOL 1e-3", race, 1e-3, quick)),
          gauss<3>(race, tightest),
          competitor("CVODE Adams", race, tolerances(tightest, 1e-3), by(reference::Adams{})),
          competitor("ARKODE", race, tolerances(tightest, 1e-3), by(reference::ExplicitRungeKutta{}))};
}

void compare(Rows& rows, const std::string& problem) {
  const auto evaluations = [](const WorkPrecisionPoint& p) { return static_cast<double>(p.counts.evaluations); };
  const auto seconds = [](const WorkPrecisionPoint& p) { return p.seconds_min.value_or(missing); };
  const auto over_rk4 = [&](const std::string& method, double error, const auto& of) {
    return cost_over(rows.points(), problem, method, "RK4", error, of);
  };
  report::Table table({"error", "method", "evaluations over those of RK4", "seconds over those of RK4"});
  for (const char* method : {"one sweep", "staggering", "staggering, TOL 1e-3", "Gauss 3", "CVODE Adams", "ARKODE"}) {
    for (const double error : {1e-2, 1e-3, 1e-4, 1e-5})
      table.add({error, method, over_rk4(method, error, evaluations), over_rk4(method, error, seconds)});
  }
  rows.write("cost_of_means", table);
  rows.at_least("staggering to 1e-3: sweeps over right-hand sides of RK4",
                {.limit = 2.0,
                 .computed = over_rk4("staggering", 1e-3, evaluations),
                 .because = "a dozen sweeps a step, and steps that no sound may cross"});
  rows.at_most("one sweep to 1e-2 over RK4",
               {.limit = 2.0,
                .computed = over_rk4("one sweep", 1e-2, evaluations),
                .because = "means ask for little, and a sweep a step is the least that anyone can make"});
}

const Case element{
    {.name = "work_precision_suspension",
     .claim = "error against run time of the means of the volume element: one sweep has order 1 and is cheap to a "
              "hundredth, the monograph's staggering takes several times the work of RK4",
     .equation = "R 8.4",
     .reference = Reference::sundials},
    [](Rows& rows) {
      const suspensions::VolumeElement of(8, rows.quick() ? 40 : 100, smooth);
      const auto suspension = of.with(suspensions::near_field);
      const double t_end = rows.quick() ? 0.04 : 0.06;
      Race race{.problem = suspension,
                .start = suspension.start(suspensions::still_water),
                .outputs = {0.5 * t_end, t_end},
                .truth = {},
                .seen = means};
      const reference::ExplicitRungeKutta fehlberg{
          .table = reference::Table::fehlberg_13_7_8, .relative = 1e-10, .absolute = 1e-10};
      race.truth = [handed = handed_by(race, fehlberg)](double t) {
        return t < handed.back().t ? handed[0] : handed[1];
      };
      const double floor = errors_of(race, handed_by(race, reference::Adams{.relative = 1e-10, .absolute = 1e-10})).max;
      rows.at_most("CVODE Adams against ARKODE", {.limit = 1e-7,
                                                  .computed = floor,
                                                  .because = "particles cross the middles of cells, where weights "
                                                             "have kinks, some hundred times"});
      rows.work_precision({.problem = "suspension",
                           .reference = "ARKODE Fehlberg 8(7) at 1e-10, checked by CVODE Adams",
                           .floor = std::max(floor, rounding_floor),
                           .competitors = all_of(race, rows.quick())});
      compare(rows, "suspension");
    }};

}  // namespace verification::work_precision_suspension
