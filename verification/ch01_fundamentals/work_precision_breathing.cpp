// Error against run time for bodies that breathe, pairs of growing stiffness and the pentagon, against the closed form.

#include <numbers>
#include <string>
#include <vector>

#include <harness/case.hpp>
#include <harness/races.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

namespace verification::work_precision_breathing {

using namespace particulate;

// Two-sided orders are claimed by order_rk4 and order_verlet, before the bodies turn. Tuned on the softest pair and
// reported on all: orders above 8 cost CVODE more than they gain, and ARKODE gains from an absolute tolerance above the
// relative one. Velocity Verlet takes so many times the steps of RK4.
std::vector<Competitor> everybody(const Race& race, const Steps& steps, double tightest, int verlet) {
  using reference::ExplicitRungeKutta, reference::Table;
  const double tenth = race.outputs.front();
  const std::vector<double> tight = tolerances(tightest);
  const ExplicitRungeKutta dormand_prince{.table = Table::dormand_prince_7_4_5};
  const ExplicitRungeKutta fehlberg{.table = Table::fehlberg_13_7_8};
  return {with_slope(4.0, competitor("RK4", race, step_sizes(tenth, steps), at_fixed_step<schemes::RungeKutta4>()),
                     symmetric_turn),
          with_slope(2.0, competitor("velocity Verlet", race, step_sizes(tenth, steps, verlet),
                                     at_fixed_step<schemes::VelocityVerlet>())),
          competitor("CVODE Adams", race, tight, by(reference::Adams{})),
          tuned(competitor("CVODE Adams, orders to 8", race, tight, by(reference::Adams{.max_order = 8}))),
          competitor("ARKODE Dormand-Prince 5(4)", race, tight, by(dormand_prince)),
          competitor("ARKODE Fehlberg 8(7)", race, tight, by(fehlberg)),
          tuned(competitor("ARKODE Fehlberg 8(7), absolute 1000 relative", race, tight, by(fehlberg, 1e3)))};
}

void measure(Rows& rows, const std::string& problem, const Race& race, Steps steps, int verlet = 4) {
  if (rows.full()) steps.times += 1;
  // The closed form is rounded to doubles; its own error, in extended precision, lies below.
  rows.work_precision({.problem = problem,
                       .reference = "closed form in extended precision, rounded",
                       .floor = rounding_floor,
                       .competitors = everybody(race, steps, rows.quick() ? 1e-13 : 1e-15, verlet)});
}

void measure_pair(Rows& rows, const std::string& problem, double alpha2, const Steps& steps, int verlet = 4) {
  measure(rows, problem, breathing_pair_race(alpha2), steps, verlet);
}

Claim claim_of(const std::string& problem, const std::string& bodies) {
  return {.name = "work_precision_" + problem,
          .claim = "error against run time of " + bodies + ", to 0.9 of a period",
          .equation = "D 1.4.1",
          .reference = Reference::closed_form};
}

void prove_soft(Rows& rows) { measure_pair(rows, "breathing_pair_soft", 0.5, {2, 2.0, 7}); }

const Case soft{claim_of("breathing_pair_soft", "a breathing pair, alpha2 = 0.5"), prove_soft};
void prove_stiff(Rows& rows) { measure_pair(rows, "breathing_pair_stiff", 0.1, {64, 2.0, 5}); }

const Case stiff{claim_of("breathing_pair_stiff", "a breathing pair, alpha2 = 0.1"), prove_stiff};
const Case stiffest{claim_of("breathing_pair_stiffest", "a breathing pair, alpha2 = 0.01"), [](Rows& rows) {
                      const Steps steps{rows.quick() ? 2900 : 4096, std::numbers::sqrt2, 4};
                      measure_pair(rows, "breathing_pair_stiffest", 0.01, steps, rows.quick() ? 2 : 4);
                    }};
void prove_pentagon(Rows& rows) { measure(rows, "pentagon", pentagon_race(), {2, 2.0, 7}); }

const Case pentagon{claim_of("pentagon", "five bodies that breathe, alpha2 = 0.5"), prove_pentagon};

// RK4 that moves by 1.001 steps and calls it one: the smallest kind of defect that a diagram must show.
struct TooLongSteps : schemes::RungeKutta4 {
  bool predict(const schemes::Problem& problem, const schemes::State& from, double dt, schemes::State& to) {
    const bool value = schemes::RungeKutta4::predict(problem, from, 1.001 * dt, to);
    to.t = from.t + dt;
    return value;
  }
};

void prove_defect(Rows& rows) {
  const Race race = breathing_pair_race(0.5);
  const std::vector<double> sizes = step_sizes(race.outputs.front(), {2, 2.0, 6});
  rows.work_precision(
      {.problem = "planted_defect",
       .reference = "closed form in extended precision, rounded",
       .floor = rounding_floor,
       .competitors = {
           with_slope(4.0, competitor("RK4", race, sizes, at_fixed_step<schemes::RungeKutta4>()), symmetric_turn),
           competitor("RK4, steps 0.1 % too long", race, sizes, at_fixed_step<TooLongSteps>())}});
  const double right = rows.points()[sizes.size() - 1].errors->end;
  const double wrong = rows.points()[2 * sizes.size() - 1].errors->end;
  rows.at_least("error with the defect over the error without, smallest step",
                {.limit = 1e4,
                 .computed = wrong / right,
                 .because = "0.1 % of a period against an error of 1e-9: five decades and more"});
}

const Case defect{{.name = "work_precision_shows_a_defect",
                   .claim = "a step that is 0.1 % too long moves the curve of RK4 by orders of magnitude",
                   .equation = "D 1.4.1",
                   .reference = Reference::closed_form},
                  prove_defect};

}  // namespace verification::work_precision_breathing
