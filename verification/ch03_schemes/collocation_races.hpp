#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include <harness/front.hpp>
#include <harness/races.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/fixed_sweeps.hpp>

#include "classical_problems.hpp"

/// @file
/// The collocation family as a competitor.

namespace verification {

/// A run that has begun: `advance(state, t_end)`.
using Advance = std::function<schemes::Outcome(schemes::State&, double)>;

/// Begins a run of Gauss collocation with sweeps through the stages in turn.
///
/// @param stages    4 or 8
/// @param problem   the right-hand side
/// @param settings  of the method
/// @param control   of its steps
/// @return the run
/// @throws std::invalid_argument for another number of stages
Advance gauss(int stages, const schemes::Problem& problem, const schemes::CollocationSettings& settings,
              const schemes::FixedSweeps& control);
/// @copydoc gauss(int, const schemes::Problem&, const schemes::CollocationSettings&, const schemes::FixedSweeps&)
Advance gauss(int stages, const schemes::Problem& problem, const schemes::CollocationSettings& settings,
              const schemes::ErrorControl& control);

/// Begins a run of Radau IIA collocation with Newton's method and dense matrices.
///
/// @param stages    3 or 5
/// @param problem   the right-hand side
/// @param settings  of the method
/// @param control   of its steps
/// @return the run
/// @throws std::invalid_argument for another number of stages
Advance radau(int stages, const schemes::Problem& problem, const schemes::CollocationSettings& settings,
              const schemes::ErrorControl& control);

/// Gauss collocation at fixed steps, each with so many sweeps, for competitor().
///
/// @param stages  4 or 8 @param sweeps of each step @return begin(problem, start, step)
inline auto gauss_at_fixed_step(int stages, int sweeps) {
  return [=](const schemes::Problem& problem, const schemes::State&, double step) {
    return gauss(stages, problem, {}, schemes::FixedSweeps{.step = step, .sweeps = sweeps});
  };
}

/// What is chosen for an adaptive collocation method, other than its tolerance.
struct Choice {
  int stages;            ///< s
  double share = 1.0;    ///< tolerance of the sweeps over that of the step [-]
  double growth = 3.0;   ///< largest, from step to step [-]
  double first = 0.125;  ///< the first step, of the run [-]
};

/// Gauss collocation under ErrorControl, for competitor(): the setting is TOL.
///
/// @param choice  see Choice @param race tells the sizes of positions and velocities, and how long the run is
/// @return begin(problem, start, tolerance)
template <class P>
auto gauss_under_control(const Choice& choice, const Race<P>& race) {
  const schemes::CollocationSettings settings{.size = race.length, .speed = race.speed, .sizes = {}};
  const double T = race.outputs.back();
  return [=](const schemes::Problem& problem, const schemes::State&, double tolerance) {
    return gauss(choice.stages, problem, settings,
                 schemes::ErrorControl{.TOL = tolerance,
                                       .sweep_TOL = std::max(choice.share * tolerance, 2.3e-16),
                                       .step = choice.first * T,
                                       .limit = T,
                                       .safety = 0.7,
                                       .growth = choice.growth});
  };
}

inline const Party adaptive{"collocation, adaptive", {"Gauss 4", "Gauss 8"}};  ///< collocation under ErrorControl
/// Collocation at fixed steps, with as many sweeps as pay.
inline const Party at_fixed_steps{"collocation, fixed steps", {"Gauss 4, 2 sweeps", "Gauss 8, 3 sweeps"}};

/// Both parties of collocation.
///
/// Their settings were chosen on the breathing bodies, the Pleiades and the cloud of seed 1. Few stages need sweeps as
/// exact as the step: what a sweep leaves is not made good by the guess of the next step. With many the guess is so
/// good that the sweep after it leaves far less than its change shows.
///
/// @param race   their task
/// @param steps  in a leg, of those at fixed steps; none if there are to be no such
/// @param tightest  tolerance of those that choose their steps [-]
/// @return tuned competitors
template <class P>
std::vector<Competitor> by_collocation(const Race<P>& race, const Steps& steps, double tightest = 1e-11) {
  constexpr Choice few_stages{.stages = 4, .share = 1.0, .growth = 1.5}, many_stages{.stages = 8, .share = 1e3};
  const std::vector<double> TOL = tolerances(tightest, 1.0);
  std::vector<Competitor> all{tuned(competitor("Gauss 4", race, TOL, gauss_under_control(few_stages, race))),
                              tuned(competitor("Gauss 8", race, TOL, gauss_under_control(many_stages, race)))};
  if (steps.first == 0) return all;
  const std::vector<double> sizes = step_sizes(race.outputs.front(), steps);
  all.push_back(tuned(competitor("Gauss 4, 2 sweeps", race, sizes, gauss_at_fixed_step(4, 2))));
  all.push_back(tuned(competitor("Gauss 8, 3 sweeps", race, sizes, gauss_at_fixed_step(8, 3))));
  return all;
}

}  // namespace verification
