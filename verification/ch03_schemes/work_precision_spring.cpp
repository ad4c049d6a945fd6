// Error against run time of a mass on a spring, the problem whose contraction theory is exact.

#include <cmath>
#include <string>
#include <vector>

#include <harness/case.hpp>
#include <harness/races.hpp>
#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "collocation_races.hpp"
#include "linear_problems.hpp"

namespace verification::work_precision_spring {

using namespace particulate;

// Moving at the start, so that nothing is symmetric in time; the end is no multiple of the period or of a part of it.
Race spring_race() {
  constexpr double r_0 = 1.0, v_0 = 0.3, t_end = 7.3;
  Race race{.problem = oscillator(1.0), .start = motion(r_0, v_0), .outputs = {}, .truth = {}};
  for (int leg = 1; leg <= 5; ++leg) race.outputs.push_back(t_end * leg / 5.0);
  race.truth = [](double t) {
    const double c = std::cos(t), s = std::sin(t);
    schemes::State exact = motion(r_0 * c + v_0 * s, v_0 * c - r_0 * s);
    exact.t = t;
    return exact;
  };
  race.length = race.speed = std::hypot(r_0, v_0);
  return race;
}

const Case spring{
    {.name = "work_precision_spring",
     .claim = "error against run time of a mass on a spring: every scheme at the slope of its order",
     .equation = "R 3.3",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const Race race = spring_race();
      const double leg = race.outputs.front();
      const int more = rows.full() ? 1 : 0;
      const double tightest = rows.quick() ? 1e-11 : 1e-15;
      // The spring changes in the time of a radian.
      const SweepTolerance first{.order = 1, .share = 0.1, .T = 1.0}, second{.order = 2, .share = 0.1, .T = 1.0};
      const std::vector<double> coarse = step_sizes(leg, {2, 2.0, 7 + more}),
                                fine = step_sizes(leg, {16, 2.0, 9 + more});
      const reference::ExplicitRungeKutta dormand_prince{.table = reference::Table::dormand_prince_7_4_5};
      const reference::ExplicitRungeKutta fehlberg{.table = reference::Table::fehlberg_13_7_8};
      const schemes::PhiFamily<schemes::Anderson> with_anderson(1.0, schemes::Anderson(1));
      std::vector<Competitor> all{
          with_slope(4.0, competitor("RK4", race, coarse, at_fixed_step<schemes::RungeKutta4>())),
          with_slope(2.0, competitor("velocity Verlet", race, coarse, at_fixed_step<schemes::VelocityVerlet>())),
          with_slope(1.0, competitor("forward Euler", race, fine, at_fixed_step<schemes::ForwardEuler>())),
          with_slope(1.0, competitor("backward Euler", race, fine, under_phi_control(schemes::BackwardEuler(), first))),
          with_slope(2.0,
                     competitor("phi = 1/2", race, coarse, under_phi_control(schemes::BackwardEuler(0.5), second))),
          tuned(competitor("backward Euler, Anderson", race, step_sizes(leg, {2, 2.0, 4}),
                           under_phi_control(with_anderson, first))),
          competitor("CVODE Adams", race, tolerances(tightest), by(reference::Adams{})),
          competitor("CVODE BDF", race, tolerances(rows.quick() ? 1e-8 : 1e-10), by(reference::Bdf{})),
          competitor("ARKODE Dormand-Prince 5(4)", race, tolerances(tightest), by(dormand_prince)),
          competitor("ARKODE Fehlberg 8(7)", race, tolerances(tightest), by(fehlberg))};
      const std::vector<Competitor> collocation = by_collocation(race, {1, 1.45, 6});
      all.insert(all.begin() + 5, collocation.begin(), collocation.end());
      rows.work_precision(
          {.problem = "spring", .reference = "closed form, rounded", .floor = rounding_floor, .competitors = all});
    }};

}  // namespace verification::work_precision_spring
