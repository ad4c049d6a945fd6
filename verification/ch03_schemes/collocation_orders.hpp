#pragma once

#include <functional>
#include <vector>

#include <harness/motions.hpp>
#include <harness/rows.hpp>
#include <particulate/schemes/collocation.hpp>

#include "linear_problems.hpp"

/// @file
/// Orders of the collocation family on a problem that knows its exact motion.
///
/// Orders above ten leave few steps between 1e-2 and rounding, and those are long. All problems here have uniform
/// circular motions: along them every step meets the same derivatives, and errors follow their leading power though
/// steps are long. The problems are not linear, so that all conditions of order count.

namespace verification {

/// @return distance of two states: positions, velocities and values, whichever there are
double apart(const particulate::schemes::State& one, const particulate::schemes::State& other);

/// Where to measure one method: coarsest steps for the order at the end, and for that of the dense output.
struct CollocationSteps {
  double t_end;       ///< [s]
  long coarsest;      ///< steps to there, refined four times by 5/4 or a little more
  double dense_end;   ///< [s]
  long dense_coarse;  ///< steps to there
};

/// Writes the rows of all methods on one problem.
///
/// @param rows     where to
/// @param problem  the right-hand side
/// @param exact    its motion at a time
/// @param at       one line each for Gauss 1 ... 7, Radau 1, 2, 3 and, if it is there, Gauss 8
void compare_collocation_orders(Rows& rows, const particulate::schemes::Problem& problem,
                                const std::function<particulate::schemes::State(double)>& exact,
                                const std::vector<CollocationSteps>& at);
/// The same of a problem that knows its motion, `exact(t)`.
template <class P>
void compare_collocation_orders(Rows& rows, const P& problem, const std::vector<CollocationSteps>& at) {
  compare_collocation_orders(
      rows, problem, [&problem](double t) { return problem.exact(t); }, at);
}

}  // namespace verification
