#pragma once

#include <functional>
#include <string>

#include <Eigen/Core>

#include <particulate/schemes/problem.hpp>

/// @file
/// A fixed point by KINSOL: the independent judge of our own iterations.

namespace particulate::reference {

/// A map whose fixed point is asked for: `map(x, g)` writes g(x), as long as x, and returns whether it has a value.
using Map = std::function<bool(schemes::In x, schemes::Out g)>;

/// When a fixed-point iteration ends, and whether it is accelerated.
struct FixedPointSettings {
  double tolerance = 1e-12;    ///< the largest change of any unknown in the last iteration, > 0, in their units
  int anderson = 0;            ///< earlier iterations that Anderson acceleration mixes in, 0 (none) to unknowns [-]
  long max_iterations = 1000;  ///< > 0 [-]
};

/// How a fixed-point iteration ended.
struct FixedPoint {
  bool converged = false;  ///< whether the last change was within the tolerance
  std::string reason;      ///< empty if it converged, else why not and what to do
  long iterations = 0;     ///< [-]
  long evaluations = 0;    ///< of the map, one an iteration [-]
  double change = 0.0;     ///< \f$ \max_i |x_i^{K+1} - x_i^K| \f$ of the last complete iteration, in their units
};

/// Refuses settings that cannot be meant.
///
/// @param settings  tolerance, depth and limit
/// @param unknowns  how many there are, >= 0 [-]
/// @throws std::invalid_argument naming the setting, what must hold and what was given
void validate(const FixedPointSettings& settings, Eigen::Index unknowns);

/// Iterates \f$ x^{K+1} = g(x^K) \f$ until no unknown changes by more than the tolerance: KINSOL's KIN_FP.
///
/// \f[ \max_i |x_i^{K+1} - x_i^K| \le \text{tolerance} \f]
///
/// With a depth m > 0, \f$ x^{K+1} \f$ is Anderson's mixture of the last m + 1 values of g, that for which the same
/// mixture of \f$ g(x) - x \f$ is shortest; the test is then of the change of the mixture. The tolerance is absolute
/// and all scaling vectors of KINSOL are ones: scale the unknowns if they differ. Plain iteration that contracts by C
/// stops within \f$ C/(1 - C) \f$ tolerances of the fixed point.
///
/// @param map       the map g; where it returns false or writes what is not finite, the iteration ends
/// @param x         the start; on return the newest iterate if it converged or came to max_iterations. Else, and if the
///                  map throws, it stays as it was. No unknowns: converged at once.
/// @param settings  tolerance, depth and limit
/// @return whether it converged, why not, and counts
/// @throws std::invalid_argument if the start is not finite or a setting cannot be meant
/// @throws whatever the map throws
FixedPoint solve_fixed_point(const Map& map, Eigen::VectorXd& x, const FixedPointSettings& settings = {});

}  // namespace particulate::reference
