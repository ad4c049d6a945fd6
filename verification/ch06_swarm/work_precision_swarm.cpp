// Error against run time of the objective of a design: with drag, without it, and with a speed limit.

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <harness/case.hpp>
#include <harness/competitors.hpp>
#include <harness/races.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/symplectic_euler.hpp>
#include <particulate/schemes/verlet.hpp>

#include "swarms.hpp"

namespace verification::work_precision_swarm {

using namespace particulate;

constexpr double v_max = 3.0;

kinematics::Particles the_swarm() { return swarm_at_rest(32, 1); }

// The rate of the objective: the mean distance over that at the start and the whole time.
std::function<double(schemes::In, schemes::In)> rate_of_objective(double t_end) {
  const Eigen::RowVector3d target = swarm::fence().target;
  const auto distance = [=](const auto& places) { return (places.rowwise() - target).rowwise().norm().mean(); };
  return [=, over = t_end * distance(the_swarm().position)](schemes::In r, schemes::In) {
    return distance(vectors_in(r)) / over;
  };
}

template <class... Damping>
auto flight(double t_end, const Damping&... damping) {
  return Riding{scene_of(the_swarm(), passing, swarm::fence(), damping...), rate_of_objective(t_end)};
}

// The objective alone counts: places and velocities are looked at in a unit in which they are nothing.
Race race_of(HeldProblem problem, schemes::State start, double t_end) {
  return {.problem = std::move(problem),
          .start = std::move(start),
          .outputs = {t_end},
          .truth = {},
          .length = 1e15,
          .speed = 1e15};
}

// Two families of SUNDIALS fly the same: the first is the truth, and the second tells how good it is.
JudgedRace judged(Race race, const Race& flown, reference::Table table, double tolerance) {
  const std::vector<schemes::State> truth =
      handed_by(flown, reference::ExplicitRungeKutta{.table = table, .relative = tolerance, .absolute = tolerance});
  race.truth = [at = truth.front()](double) { return at; };
  const reference::Adams adams{.relative = tolerance, .absolute = tolerance};
  const double floor = errors_of(race, handed_by(flown, adams)).max;
  return {std::move(race), std::max(floor, rounding_floor)};
}

Begin gauss_by_tolerance() {
  return under(schemes::Collocation<schemes::Gauss<4>>(),
               [](double tolerance) { return schemes::ErrorControl{.TOL = tolerance, .sweep_TOL = 0.1 * tolerance}; });
}

// All but the explicit schemes choose their steps.
std::vector<Competitor> everybody(const Race& race, int coarsest, double euler, bool quick) {
  const double leg = race.outputs.front();
  return {with_slope(euler, competitor("symplectic Euler", race, step_sizes(leg, {coarsest, 2.0, quick ? 4 : 6}),
                                       at_fixed_step<schemes::SymplecticEuler>())),
          with_slope(4.0, competitor("RK4", race, step_sizes(leg, {coarsest, 1.5, quick ? 5 : 6}),
                                     at_fixed_step<schemes::RungeKutta4>())),
          competitor("Gauss 4", race, tolerances(quick ? 1e-7 : 1e-11), gauss_by_tolerance()),
          competitor("CVODE Adams", race, tolerances(quick ? 1e-7 : 1e-12), by(reference::Adams{}))};
}

const Case with_drag{
    {.name = "work_precision_swarm",
     .claim = "error against run time of the objective of a design with drag: symplectic Euler has order 1, RK4 4",
     .equation = "R 6.2",
     .reference = Reference::sundials},
    [](Rows& rows) {
      constexpr double t_end = 6.0;  // through the fence and to the target
      const auto problem = flight(t_end, swarm::LinearDrag{});
      const Race race = race_of(problem, start_of(problem), t_end);
      const JudgedRace known = judged(race, race, reference::Table::fehlberg_13_7_8, 1e-14);
      rows.work_precision({.problem = "swarm",
                           .reference = "ARKODE Fehlberg 8(7) at 1e-14, checked by CVODE Adams",
                           .floor = known.floor,
                           .competitors = everybody(known.race, 150, 1.0, rows.quick())});
    }};

// Velocity Verlet carries no values along. The objective is added by the trapezoidal rule, of its order, from what the
// right-hand side says at both ends of a step.
struct MotionAlone {
  schemes::Problem whole;
  Eigen::VectorXd v, y, dy = Eigen::VectorXd::Zero(1);
  double before = missing;

  bool acceleration(double t, schemes::In r, schemes::Out a) {
    before = dy[0];
    return whole.rates(schemes::Where{t, {r.data(), r.size()}, {v.data(), v.size()}, {y.data(), y.size()}},
                       schemes::Answers{{a.data(), a.size()}, {dy.data(), dy.size()}});
  }
};

Begin by_verlet() {
  return [](const schemes::Problem& problem, const schemes::State&, double step) -> Advance {
    return [problem, step](schemes::State& state, double end) {
      MotionAlone motion{.whole = problem, .v = state.v, .y = state.y};
      schemes::State moving{.t = state.t, .r = state.r, .v = state.v};
      schemes::VelocityVerlet scheme;
      schemes::FixedStep control{.step = step};
      const auto add = [&](const auto&, const auto&, double dt, const auto&) {
        state.y[0] += 0.5 * dt * (motion.before + motion.dy[0]);
        return true;
      };
      const schemes::Outcome outcome = schemes::integrate(motion, moving, end, scheme, control, add);
      state.t = moving.t, state.r = moving.r, state.v = moving.v;
      return outcome;
    };
  };
}

// From rest, and under forces of places alone, the places of symplectic Euler are those of half a step later, and its
// rule for the values takes them half a step early.
const Case without_drag{
    {.name = "work_precision_swarm_without_drag",
     .claim = "error against run time of the objective of a design without drag: velocity Verlet has order 2, RK4 4; "
              "symplectic Euler, from rest, 2",
     .equation = "R 6.2",
     .reference = Reference::sundials},
    [](Rows& rows) {
      constexpr double t_end = 2.5;  // to the fence: without drag members meet too closely for orders after it
      const auto problem = flight(t_end);
      const Race race = race_of(problem, start_of(problem), t_end);
      const JudgedRace known = judged(race, race, reference::Table::fehlberg_13_7_8, 1e-14);
      std::vector<Competitor> all = everybody(known.race, 110, 2.0, rows.quick());
      all.push_back(with_slope(2.0, competitor("velocity Verlet", known.race,
                                               step_sizes(t_end, {110, 2.0, rows.quick() ? 4 : 6}), by_verlet())));
      rows.work_precision({.problem = "swarm_without_drag",
                           .reference = "ARKODE Fehlberg 8(7) at 1e-14, checked by CVODE Adams",
                           .floor = known.floor,
                           .competitors = std::move(all)});
    }};

const Case with_cap{
    {.name = "work_precision_swarm_capped",
     .claim = "error against run time of the objective of a design with drag and speed limit: every scheme has order 1",
     .equation = "R 6.2",
     .reference = Reference::sundials},
    [](Rows& rows) {
      constexpr double t_end = 6.0;
      const auto problem = flight(t_end, swarm::LinearDrag{}, swarm::SpeedLimit{.v_max = v_max});
      const Riding limit{Gliding{flight(t_end, swarm::LinearDrag{}).scene, v_max}, rate_of_objective(t_end)};
      // Fehlberg's estimate of the error does not see the force change where a member comes to the limit.
      const JudgedRace known =
          judged(race_of(problem, start_of(problem), t_end), race_of(limit, start_of(problem), t_end),
                 reference::Table::dormand_prince_7_4_5, 1e-12);
      const std::vector<double> steps = step_sizes(t_end, {150, 2.0, rows.quick() ? 4 : 6});
      const Begin gauss = under(schemes::Collocation<schemes::Gauss<2>>(),
                                [](double step) { return schemes::FixedStep{.step = step, .TOL = 1e-8}; });
      rows.work_precision(
          {.problem = "swarm_capped",
           .reference = "ARKODE Dormand-Prince 5(4) of the motion that keeps to the limit, checked by CVODE Adams",
           .floor = known.floor,
           .competitors = {with_slope(1.0, competitor("symplectic Euler", known.race, steps,
                                                      at_fixed_step<schemes::SymplecticEuler>())),
                           with_slope(1.0, competitor("RK4", known.race, steps, at_fixed_step<schemes::RungeKutta4>())),
                           competitor("Gauss 2", known.race, steps, gauss)}});
      std::vector<double> errors;
      for (const WorkPrecisionPoint& point : rows.points()) {
        if (point.method == "Gauss 2") errors.push_back(point.errors.value_or(Errors{missing, missing}).end);
      }
      rows.order("swarm_capped, Gauss 2: order fitted to the errors at the end, against steps",
                 {.nominal = 1.0,
                  .steps = steps,
                  .errors = errors,
                  .floor = known.floor,
                  .because = "a member meets the limit only at the end of a step; shorter ones need fewer sweeps"});
    }};

}  // namespace verification::work_precision_swarm
