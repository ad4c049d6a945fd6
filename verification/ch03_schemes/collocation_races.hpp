#pragma once

#include <functional>
#include <vector>

#include <harness/front.hpp>
#include <harness/races.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>

/// @file
/// The collocation family as a competitor.

namespace verification {

/// Radau IIA collocation by Newton's method with dense matrices, for competitor().
///
/// @param stages    3 or 5
/// @param settings  of the method
/// @param control   of a setting
/// @return begin(problem, start, setting)
/// @throws std::invalid_argument for another number of stages
Begin radau(int stages, const schemes::CollocationSettings& settings,
            const std::function<schemes::ErrorControl(double setting)>& control);

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
std::vector<Competitor> by_collocation(const Race& race, const Steps& steps, double tightest = 1e-11);

}  // namespace verification
