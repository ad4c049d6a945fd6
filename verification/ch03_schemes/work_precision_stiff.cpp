// Error against run time of stiff problems: Radau collocation by Newton's method against CVODE's BDF, both with the
// problem's own Jacobian, to the published digits.

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/front.hpp>
#include <harness/races.hpp>

#include "classical_problems.hpp"
#include "collocation_races.hpp"

namespace verification::work_precision_stiff {

using namespace particulate;

// What is chosen for a problem, and what is claimed of it.
struct Stiff {
  std::string name;
  Eigen::VectorXd sizes;         // below which errors of unknowns count as absolute
  double loose, tight;           // absolute tolerance over the relative one, for CVODE
  std::vector<double> at_least;  // ratios of evaluations at 1e-4, 1e-6, 1e-8 and 1e-10; 0: none
  std::string because;
};

// The Jacobian is kept as long as the sweeps contract fast, and a step as long as it is nearly the best: each new one
// costs s/2 decompositions. Sweeps to a hundredth of the step's tolerance: what they leave would pass for truncation.
Begin radau_under_control(int stages, const Stiff& of, double t_end) {
  schemes::CollocationSettings settings;
  settings.sizes = of.sizes;
  return radau(stages, settings, [t_end](double tolerance) {
    return schemes::ErrorControl{.TOL = tolerance,
                                 .sweep_TOL = std::max(0.1 * tolerance, 2.3e-16),
                                 .K_d = 3,
                                 .step = 1e-4,
                                 .limit = t_end,
                                 .growth = 8.0,
                                 .worth = 1.2};
  });
}

// Published to sixteen digits, of which the last few depend on the machine that computed them.
constexpr double published_floor = 1e-13;

template <class P>
Race race_of() {
  const schemes::State end = P::published();
  return {.problem = P{}, .start = P::start(), .outputs = {end.t}, .truth = [end](double) { return end; }};
}

void measure(Rows& rows, const Race& race, const Stiff& of) {
  const double t_end = race.outputs.back();
  const auto by_bdf = [&](double absolute) {
    return tuned(competitor(fmt::format("CVODE BDF, absolute {:.0e}", absolute), race, tolerances(1e-14, 1e-3),
                            by(reference::Bdf{}, absolute)));
  };
  const std::vector<Competitor> bdf{by_bdf(of.loose), by_bdf(of.tight)};
  // A quick run counts and does not time: what CVODE takes for ten digits would be most of it.
  rows.work_precision(
      {.problem = of.name,
       .reference = "published digits",
       .floor = published_floor,
       .competitors = {tuned(competitor("Radau 3", race, tolerances(1e-8, 0.1), radau_under_control(3, of, t_end))),
                       tuned(competitor("Radau 5", race, tolerances(1e-10, 0.1), radau_under_control(5, of, t_end))),
                       bdf.front(), bdf.back()},
       .timed = rows.full(),
       .no_ruler = "steps of one size would have to be as small as the fastest change"});
  compare_fronts(rows, of.name, {"SUNDIALS", {bdf.front().name, bdf.back().name}},
                 {{{"collocation, adaptive", {"Radau 3", "Radau 5"}}, of.at_least, of.because}});
}

Claim claim_of(const std::string& name, const std::string& problem) {
  return {.name = "work_precision_" + name,
          .claim = "error against run time of " + problem + ": Radau collocation and CVODE's stiff method",
          .equation = "D 3.4",
          .reference = Reference::published};
}

const Case robertson{claim_of("robertson", "Robertson's reactions to t = 1e11"), [](Rows& rows) {
                       measure(rows, race_of<Robertson>(),
                               {.name = "robertson",
                                .sizes = Eigen::Vector3d{1e-8, 1e-14, 1e-8},
                                .loose = 1e-8,
                                .tight = 1e-14,
                                .at_least = {1.3, 1.6, 1.8, 1.6},
                                .because = "seen 1.5, 2.0, 2.1 and 1.9; par was hoped for at 1e-6"});
                     }};
const Case van_der_pol{claim_of("van_der_pol", "van der Pol's oscillator, mu = 1000"), [](Rows& rows) {
                         measure(
                             rows, race_of<VanDerPol>(),
                             {.name = "van_der_pol",
                              .sizes = Eigen::Vector2d{1.0, 1e-3},
                              .loose = 1e-8,
                              .tight = 1e-11,
                              .at_least = {0, 1.0, 1.35, 1.8},
                              .because = "seen 0.5, 1.2, 1.5 and 2.1: at 1e-4 its few long steps each need sweeps of "
                                         "three or five rates, where BDF needs two or three"});
                       }};
const Case oregonator{
    claim_of("oregonator", "the Oregonator to t = 360"), [](Rows& rows) {
      measure(rows, race_of<Oregonator>(),
              {.name = "oregonator",
               .sizes = Eigen::Vector3d{1.0, 1.0, 1.0},
               .loose = 1.0,
               .tight = 1e-8,
               .at_least = {0, 1.0, 1.15, 2.0},
               .because = "seen 0.8, 1.2, 1.3 and 2.4 to 2.9, as sums are rounded; par was hoped for at 1e-6"});
    }};

}  // namespace verification::work_precision_stiff
