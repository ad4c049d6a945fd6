#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <ch01_fundamentals/motions.hpp>
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

/// Distance of two states: positions and velocities, or all values.
inline double apart(const particulate::schemes::State& one, const particulate::schemes::State& other) {
  return std::hypot((one.r - other.r).norm(), (one.v - other.v).norm());
}
/// @copydoc apart
inline double apart(const particulate::schemes::State& one, const particulate::schemes::State& other) {
  return (one.y - other.y).norm();
}

/// Errors of one run in equal steps.
struct CollocationErrors {
  double at_end = 0.0;  ///< of the last state
  double inside = 0.0;  ///< the largest of the dense output, inside of all steps
  double joints = 0.0;  ///< the largest distance of the dense output from both ends of its step
};

/// One run of a method; `problem.exact(t)` knows the motion.
template <class Nodes, class P>
CollocationErrors collocation_errors(P& problem, double t_end, long steps) {
  using namespace particulate::schemes;
  Collocation<Nodes> scheme;
  auto state = problem.exact(0.0);
  auto there = state;
  CollocationErrors errors;
  const auto watch = [&](const auto& from, const auto& to, double dt, const auto& made) {
    for (const double theta : {0.13, 0.38, 0.61, 0.88}) {
      made.at(from, dt, theta, there);
      keep_worst(errors.inside, apart(there, problem.exact(there.t)));
    }
    made.at(from, dt, 0.0, there);
    keep_worst(errors.joints, apart(there, from));
    made.at(from, dt, 1.0, there);
    keep_worst(errors.joints, apart(there, to));
    return true;
  };
  FixedStep control{.step = t_end / static_cast<double>(steps)};
  require_reached(integrate(problem, state, t_end, scheme, control, watch));
  errors.at_end = apart(state, problem.exact(t_end));
  return errors;
}

/// Where to measure one method: coarsest steps for the order at the end, and for that of the dense output.
struct CollocationSteps {
  double t_end;       ///< [s]
  long coarsest;      ///< steps to there, refined four times by 5/4 or a little more
  double dense_end;   ///< [s]
  long dense_coarse;  ///< steps to there
};

/// Writes the rows of one method.
template <class Nodes, class P>
void compare_collocation_order(Rows& rows, const std::string& method, P& problem, const CollocationSteps& at) {
  const auto refine = [&](double t_end, long coarsest, double CollocationErrors::*which, double nominal,
                          const std::string& quantity, const std::string& because) {
    std::vector<double> steps, errors;
    for (long n = coarsest; steps.size() < 5; n = (n * 5 + 3) / 4) {
      steps.push_back(t_end / static_cast<double>(n));
      errors.push_back(collocation_errors<Nodes>(problem, t_end, n).*which);
    }
    rows.order(method + ": " + quantity,
               {.nominal = nominal, .steps = steps, .errors = errors, .floor = 1e-16, .because = because});
  };
  refine(at.t_end, at.coarsest, &CollocationErrors::at_end, Nodes::order, "state at the end",
         "2 s for Gauss, 2 s - 1 for Radau IIA: the order of the quadrature, on a smooth right-hand side, at no "
         "multiple of the period; sweeps to rounding");
  const int uniform = std::min(Nodes::stages + 1, Nodes::order);
  refine(at.dense_end, at.dense_coarse, &CollocationErrors::inside, uniform, "largest error inside the steps",
         "a polynomial of degree s misses the motion by a power s + 1 of the step, unless the ends are worse");
  rows.at_most(method + ": dense output off the ends of its step",
               {.limit = 16.0 * eps,
                .computed = collocation_errors<Nodes>(problem, at.dense_end, 4 * at.dense_coarse).joints,
                .because = "the polynomial passes through both, its sums rounded once more in states near 1"});
}

/// All methods on one problem; `at` is one line each for Gauss 1 ... 8 and Radau 1, 2, 3.
template <class P>
void compare_collocation_orders(Rows& rows, P& problem, const std::vector<CollocationSteps>& at) {
  using namespace particulate::schemes;
  compare_collocation_order<Gauss<1>>(rows, "Gauss 1", problem, at.at(0));
  compare_collocation_order<Gauss<2>>(rows, "Gauss 2", problem, at.at(1));
  compare_collocation_order<Gauss<3>>(rows, "Gauss 3", problem, at.at(2));
  compare_collocation_order<Gauss<4>>(rows, "Gauss 4", problem, at.at(3));
  compare_collocation_order<Gauss<5>>(rows, "Gauss 5", problem, at.at(4));
  compare_collocation_order<Gauss<6>>(rows, "Gauss 6", problem, at.at(5));
  compare_collocation_order<Gauss<7>>(rows, "Gauss 7", problem, at.at(6));
  compare_collocation_order<Gauss<8>>(rows, "Gauss 8", problem, at.at(7));
  compare_collocation_order<Radau<1>>(rows, "Radau 1", problem, at.at(8));
  compare_collocation_order<Radau<2>>(rows, "Radau 2", problem, at.at(9));
  compare_collocation_order<Radau<3>>(rows, "Radau 3", problem, at.at(10));
}

}  // namespace verification
