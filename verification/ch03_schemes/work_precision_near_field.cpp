// Error against run time under near fields: bodies that breathe, the Pleiades, and a cloud of a hundred.

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/front.hpp>
#include <harness/races.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "classical_problems.hpp"
#include "collocation_races.hpp"
#include "kinsol_euler.hpp"

namespace verification::work_precision_near_field {

using namespace particulate;
using schemes::Anderson, schemes::BackwardEuler, schemes::PhiFamily;

// Steps in a leg between two outputs, and the slope that their errors must show. 0 where errors below a hundredth, on
// which alone a slope can be fitted, would take too many steps.
struct Ladder {
  Steps steps;
  double slope = 0.0;
  std::string steeper = {};
};

// One problem and the settings of its competitors; the ladders of the phi family are of Dt_lim.
struct Problem {
  std::string name;
  JudgedRace judged;
  std::string reference;
  Ladder runge_kutta, verlet, backward_euler, trapezoidal;
  double tightest, tightest_of_bdf;  // tolerances; 1 for none
  Steps collocation;                 // of both methods at fixed steps; none at first = 0
  std::vector<Competitor> others = {};
};

Competitor stepped(const char* name, const Problem& of, const Ladder& ladder, Begin begin) {
  Competitor who =
      competitor(name, of.judged.race, step_sizes(of.judged.race.outputs.front(), ladder.steps), std::move(begin));
  return ladder.slope > 0.0 ? with_slope(ladder.slope, std::move(who), ladder.steeper) : who;
}

// Nothing changes more slowly than the run is long. A tenth: what tighter tolerances change is not seen in a diagram.
SweepTolerance sweeps(const Problem& of, int order) {
  return {.order = order, .share = 0.1, .T = of.judged.race.outputs.back()};
}

// The parties of the front. Of all explicit tables of ARKODE of order 4 to 8, on seed 1 of the cloud, on the breathing
// bodies and on the Pleiades one of these needs the fewest evaluations at every error from 1e-4 to 1e-10.
const Party sundials{"SUNDIALS",
                     {"CVODE Adams", "ARKODE Cash-Karp 5(4)", "ARKODE Dormand-Prince 5(4)", "ARKODE Fehlberg 8(7)"}};

std::vector<Competitor> by_sundials(const Problem& of) {
  using reference::ExplicitRungeKutta, reference::Table;
  const auto toleranced = [&](const char* name, double tightest, const Begin& begin) {
    return competitor(name, of.judged.race, tolerances(tightest), begin);
  };
  std::vector<Competitor> all{
      toleranced("CVODE Adams", of.tightest, by(reference::Adams{})),
      toleranced("ARKODE Cash-Karp 5(4)", of.tightest, by(ExplicitRungeKutta{.table = Table::cash_karp_6_4_5})),
      toleranced("ARKODE Dormand-Prince 5(4)", of.tightest,
                 by(ExplicitRungeKutta{.table = Table::dormand_prince_7_4_5})),
      toleranced("ARKODE Fehlberg 8(7)", of.tightest, by(ExplicitRungeKutta{.table = Table::fehlberg_13_7_8}))};
  if (of.tightest_of_bdf < 1.0) all.push_back(toleranced("CVODE BDF", of.tightest_of_bdf, by(reference::Bdf{})));
  return all;
}

void append(std::vector<Competitor>& all, const std::vector<Competitor>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

std::vector<Competitor> everybody(const Problem& of) {
  std::vector<Competitor> all{
      stepped("RK4", of, of.runge_kutta, at_fixed_step<schemes::RungeKutta4>()),
      stepped("velocity Verlet", of, of.verlet, at_fixed_step<schemes::VelocityVerlet>()),
      stepped("backward Euler", of, of.backward_euler, under_phi_control(BackwardEuler(), sweeps(of, 1))),
      stepped("phi = 1/2", of, of.trapezoidal, under_phi_control(BackwardEuler(0.5), sweeps(of, 2)))};
  append(all, by_collocation(of.judged.race, of.collocation));
  append(all, by_sundials(of));
  append(all, of.others);
  return all;
}

// Anderson saves sweeps where the limit is so large that they hardly contract, and nothing where two are enough.
Competitor backward_euler_with_anderson(const Problem& of, const Steps& steps) {
  return tuned(stepped("backward Euler, Anderson", of, {.steps = steps},
                       under_phi_control(PhiFamily<Anderson>(1.0, Anderson(1)), sweeps(of, 1))));
}
Competitor trapezoidal_with_anderson(const Problem& of, const Steps& steps) {
  return tuned(stepped("phi = 1/2, Anderson", of, {.steps = steps},
                       under_phi_control(PhiFamily<Anderson>(0.5, Anderson(1)), sweeps(of, 2))));
}

Competitor by_kinsol_with_anderson(const Problem& of, const Steps& steps) {
  return stepped("backward Euler by KINSOL, Anderson", of, {.steps = steps},
                 by_kinsol(of.judged.race.speed, sweeps(of, 1)));
}

// Ratios of evaluations that are claimed of the collocation methods, at 1e-4, 1e-6, 1e-8 and 1e-10; 0: none.
struct Ratios {
  std::vector<double> adaptive, fixed;
  std::string because;
};

void measure(Rows& rows, const Problem& of, const std::vector<Competitor>& who, bool timed = true) {
  rows.work_precision(
      {.problem = of.name, .reference = of.reference, .floor = of.judged.floor, .competitors = who, .timed = timed});
}

void compare(Rows& rows, const Problem& of, const Ratios& claimed) {
  compare_fronts(rows, of.name, sundials,
                 {{adaptive, claimed.adaptive, claimed.because}, {at_fixed_steps, claimed.fixed, claimed.because}});
}

void measure(Rows& rows, const Problem& of, const Ratios& claimed) {
  measure(rows, of, everybody(of));
  compare(rows, of, claimed);
}

// A full run goes on where a quick one ends.
Ladder longer(Rows& rows, Ladder ladder, int times = 1) {
  if (rows.full()) ladder.steps.times += times;
  return ladder;
}

Problem breathing(Rows& rows, const std::string& name, const Race& race) {
  return {.name = name,
          .judged = {.race = race, .floor = rounding_floor},
          .reference = "closed form in extended precision, rounded",
          .runge_kutta = longer(rows, {{2, 2.0, 7}, 4.0, symmetric_turn}),
          .verlet = longer(rows, {{8, 2.0, 7}, 2.0}),
          .backward_euler = longer(rows, {{256, 1.6, 7}, 1.0}),
          .trapezoidal = longer(rows, {{4, 2.0, 7}, 2.0}),
          .tightest = rows.quick() ? 1e-13 : 1e-15,
          .tightest_of_bdf = rows.quick() ? 1e-8 : 1e-10,
          .collocation = {1, 1.45, 8}};
}

Claim claim_of(const std::string& problem, const std::string& bodies, Reference reference = Reference::closed_form) {
  return {.name = "work_precision_" + problem,
          .claim = "error against run time of " + bodies +
                   ": the phi family, explicit schemes, collocation, CVODE, ARKODE, KINSOL",
          .equation = "R 3.4",
          .reference = reference};
}

// What is missed of the goal of three: a breathing body is asked for nine states in a period, and each ends a step
// early; Adams methods, which use up to twelve earlier steps at one evaluation a step, lose less by that.
const std::string nine_stops = "nine output times a period, each of which cuts a step short; three were hoped for";

const Case soft{claim_of("breathing_pair_soft", "a breathing pair, alpha2 = 0.5"), [](Rows& rows) {
                  measure(rows, breathing(rows, "breathing_pair_soft", breathing_pair_race(0.5)),
                          {{1.3, 1.4, 1.5, 1.6}, {0, 0, 0, 1.2}, nine_stops});
                }};

const Case pentagon{claim_of("pentagon", "five bodies that breathe, alpha2 = 0.5"), [](Rows& rows) {
                      Problem of = breathing(rows, "pentagon", pentagon_race());
                      of.backward_euler = longer(rows, {{64, 2.0, 4}});
                      measure(rows, of, {{1.1, 1.5, 1.2, 1.2}, {0, 0, 0, 0}, nine_stops});
                    }};

void prove_stiff(Rows& rows) {
  Problem of = breathing(rows, "breathing_pair_stiff", breathing_pair_race(0.1));
  of.runge_kutta = longer(rows, {{64, 2.0, 5}, 4.0, symmetric_turn});
  of.verlet = longer(rows, {{256, 2.0, 4}, 2.0});
  // Backward Euler damps the passage so much that errors of a hundredth would need a million steps.
  of.backward_euler = longer(rows, {{16, 2.0, 7}});
  of.trapezoidal = longer(rows, {{64, 1.6, 5}, 2.0});
  const char* const fixed = "backward Euler, fixed steps";
  constexpr Steps few{16, 2.0, 4};
  of.others = {by_kinsol_with_anderson(of, few), backward_euler_with_anderson(of, few),
               stepped(fixed, of, {.steps = few}, sweeping_at_fixed_step(BackwardEuler(), sweeps(of, 1)))};
  of.collocation = {8, 1.45, 6};
  measure(rows, of, {{1.3, 1.5, 1.6, 1.8}, {0, 0, 0, 0}, nine_stops});
  const auto& points = rows.points();
  const auto largest =
      std::find_if(points.begin(), points.end(), [&](const auto& point) { return point.method == fixed; });
  rows.equal("backward Euler at the largest fixed step: how it failed",
             {.expected = "failed: the sweeps diverge",
              .computed = largest->status.substr(0, 26),
              .because = "omega Dt = 2.4 where the pair is nearest, 1 is where sweeps begin to diverge"});
}

const Case stiff{claim_of("breathing_pair_stiff", "a breathing pair, alpha2 = 0.1"), prove_stiff};

void prove_stars(Rows& rows) {
  Problem of{.name = "pleiades",
             .judged = judged_race(pleiades(), pleiades_end, 10),
             .reference = "ARKODE Fehlberg 8(7) at 1e-15, checked by CVODE Adams at 1e-15",
             .runge_kutta = longer(rows, {{384, 1.4, 4},
                                          4.0,
                                          "a close passage is nearly symmetric in time about its nearest point, "
                                          "which cancels most of RK4's leading error"}),
             .verlet = longer(rows, {{1024, std::numbers::sqrt2, 4}, 2.0}),
             .backward_euler = longer(rows, {{256, 2.0, 2}}, 3),
             .trapezoidal = longer(rows, {{64, 2.0, 4}}),
             .tightest = rows.quick() ? 1e-9 : 1e-14,
             .tightest_of_bdf = rows.quick() ? 1e-5 : 1e-8,
             .collocation = {.first = 0, .factor = 2.0, .times = 0}};
  measure(rows, of, {{1.7, 1.6, 0, 0}, {0, 0, 0, 0}, "ten output times, each of which cuts a step short"});
}

const Case stars{claim_of("pleiades", "the Pleiades, seven stars that pass close by one another", Reference::sundials),
                 prove_stars};

// A cloud to race in. The state is asked for at the end alone, so that every method goes at the steps that it chooses;
// what outputs cost is seen on the breathing bodies, and on the cloud with five.
struct NearFieldCloud {
  std::string name;
  Eigen::Index N = 100;  // particles
  double spacing = 1.4;  // of their lattice [m]
  std::uint64_t seed = 1;
  int legs = 1;  // outputs, the last of them at the end
};

// BDF is left out: each of its Jacobians costs six right-hand sides a particle, and the decomposition of as many
// unknowns.
Problem cloud_of(Rows& rows, const NearFieldCloud& cloud) {
  const auto steps = [=](Steps of_run) {
    of_run.first *= 5 / cloud.legs;
    return of_run;
  };
  return {.name = cloud.name,
          .judged = judged_race(near_field_cloud(cloud.N, cloud.seed, cloud.spacing), 1.0, cloud.legs),
          .reference = "ARKODE Fehlberg 8(7) at 1e-15, checked by CVODE Adams at 1e-15",
          .runge_kutta = longer(rows, {steps({4, 1.6, 4}), 4.0}),
          .verlet = longer(rows, {steps({12, 1.5, 4}), 2.0}),
          .backward_euler = longer(rows, {steps({4, 2.0, 4})}),
          .trapezoidal = longer(rows, {steps({4, 1.6, 6}), 2.0}),
          .tightest = rows.quick() ? 1e-11 : 1e-14,
          .tightest_of_bdf = 1.0,
          .collocation = {cloud.legs == 1 ? 2 : 1, 1.35, 8}};
}

// Of a cloud whose many evaluations are to be counted: the parties of the front, and a ruler.
std::vector<Competitor> parties(const Problem& of) {
  std::vector<Competitor> few{stepped("RK4", of, of.runge_kutta, at_fixed_step<schemes::RungeKutta4>())};
  append(few, by_collocation(of.judged.race, of.collocation));
  append(few, by_sundials(of));
  return few;
}

void measure_parties(Rows& rows, const Problem& of, const Ratios& claimed, bool timed) {
  measure(rows, of, parties(of), timed);
  compare(rows, of, claimed);
}

// Adaptive collocation meets the goal of two on every seed. At fixed steps it misses it at 1e-6 and at 1e-10: it begins
// with a step as long as all others, whose first guess knows only the rates at the start.
const Ratios of_cloud{{2.2, 1.9, 2.4, 2.6},
                      {1.8, 1.2, 1.6, 1.5},
                      "seen 2.3, 2.0, 2.6 and 2.8 or more on six seeds, at fixed steps 2.0, 1.3, 1.7 and 1.7; two were "
                      "hoped for; kernels round differently, which moves counts by a few of a hundred"};

const Case cloud{claim_of("near_field_100", "a cloud of a hundred under a near field", Reference::sundials),
                 [](Rows& rows) {
                   Problem of = cloud_of(rows, {.name = "near_field_100"});
                   const Steps few{20, 2.0, 3};
                   of.others = {backward_euler_with_anderson(of, few), trapezoidal_with_anderson(of, {20, 1.6, 2}),
                                by_kinsol_with_anderson(of, few)};
                   measure(rows, of, of_cloud);
                 }};

// Evaluations at the largest limit of a method.
long at_the_largest_limit(const Rows& rows, const std::string& problem, const std::string& method) {
  const auto& points = rows.points();
  return std::find_if(
             points.begin(), points.end(),
             [&](const WorkPrecisionPoint& point) { return point.problem == problem && point.method == method; })
      ->counts.evaluations;
}

void prove_other_seeds(Rows& rows) {
  for (std::uint64_t seed = 2; seed <= (rows.quick() ? 2 : 6); ++seed) {
    const std::string name = fmt::format("near_field_100_seed_{}", seed);
    Problem of = cloud_of(rows, {.name = name, .seed = seed});
    of.runge_kutta = {{40, 1.35, 4}, 4.0};
    of.backward_euler = {{20, 2.0, 2}};
    std::vector<Competitor> few = parties(of);
    append(few, {stepped("backward Euler", of, of.backward_euler, under_phi_control(BackwardEuler(), sweeps(of, 1))),
                 backward_euler_with_anderson(of, of.backward_euler.steps)});
    measure(rows, of, few, rows.full());
    compare(rows, of, of_cloud);
    rows.at_most(name + ": evaluations of backward Euler with Anderson at the largest limit",
                 {.limit = static_cast<double>(at_the_largest_limit(rows, name, "backward Euler")),
                  .computed = static_cast<double>(at_the_largest_limit(rows, name, "backward Euler, Anderson")),
                  .because = "as many as without, or fewer: there the sweeps hardly contract"});
  }
}

const Case other_seeds{
    {.name = "work_precision_near_field_100_other_seeds",
     .claim = "what was chosen on one cloud, Anderson's mixing and the collocation methods, saves on others",
     .equation = "R 3.4",
     .reference = Reference::sundials},
    prove_other_seeds};

// A thousand: a quick run takes two hundred. Their evaluations are counted; to time them takes ten minutes. Other seeds
// come by the program's --seed.
NearFieldCloud thousand_of(const Rows& rows, const std::string& kind, double spacing) {
  const Eigen::Index N = rows.quick() ? 200 : 1000;
  return {.name = fmt::format("near_field_{}{}", N, kind), .N = N, .spacing = spacing, .seed = rows.seed()};
}

const Case thousand{
    claim_of("near_field_1000", "a cloud of a thousand under a near field", Reference::sundials), [](Rows& rows) {
      Problem of = cloud_of(rows, thousand_of(rows, "", 1.6));
      of.runge_kutta = {{40, 1.35, 4}, 4.0};
      measure_parties(rows, of,
                      {{2.2, 1.6, 2.3, 2.8},
                       {1.5, 1.4, 1.4, 1.4},
                       "seen 2.5, 1.8, 2.6 and 3.2 or more on six seeds, at fixed steps 1.7, 1.6, 1.6 and 1.6; two "
                       "were hoped for; kernels round differently"},
                      false);
    }};

// In the last tenth of a second this cloud has fallen so deep that steps must be a tenth of those at the start: equal
// steps lose, and their ratios are reported only.
void prove_deep(Rows& rows) {
  Problem of = cloud_of(rows, thousand_of(rows, "_deep", 1.4));
  of.runge_kutta = {{40, 1.35, 4}, 4.0};
  if (rows.full()) {
    of.runge_kutta.steps = {600, 1.26, 4};
    of.collocation = {20, 1.6, 2};
    of.tightest = 1e-12;
  }
  measure_parties(rows, of,
                  {{1.8, 1.7, 2.1, 2.1}, {0, 0, 0, 0}, "seen 2.3, 1.9, 2.3 and 2.8; kernels round differently"}, false);
}

const Case deep{
    claim_of("near_field_1000_deep", "a thousand that fall together under a near field", Reference::sundials),
    prove_deep};

const Case outputs{{.name = "work_precision_near_field_100_outputs",
                    .claim = "five output times cost collocation, whose steps they cut short, more than Adams methods",
                    .equation = "R 3.4",
                    .reference = Reference::sundials},
                   [](Rows& rows) {
                     const Problem of = cloud_of(rows, {.name = "near_field_100_outputs", .legs = 5});
                     measure_parties(rows, of, {{0, 0, 0, 0}, {0, 0, 0, 0}, ""}, rows.full());
                   }};

}  // namespace verification::work_precision_near_field
