#pragma once

#include <string>

#include <Eigen/Core>

#include <particulate/identification/cost.hpp>

namespace particulate::identification {

/// How residuals are differentiated, and when polishing ends.
struct Polishing {
  double step = 1e-6;           ///< of the differences, over the width of the box, between 0 and 0.5 [-]
  bool central = false;         ///< differences to both sides instead of one
  double tolerance = 1e-8;      ///< it ends where the sum of squares falls by less than this share of itself, >= 0 [-]
  long most_evaluations = 500;  ///< of the residuals, those of differences included, >= 1
};

/// What polishing gave.
struct Polished {
  Eigen::VectorXd parameters = {};  ///< with the smallest sum of squares of all evaluated; in the box
  double before = 0.0;              ///< sum of squares at the start, infinite if it has no residuals
  double after = 0.0;               ///< and at the parameters, at most that
  long evaluations = 0;             ///< calls of the residuals, all of them
  long for_differences = 0;         ///< those that differences took
  long failed_differences = 0;      ///< those that had no residuals
  std::string reason = {};          ///< why it ended, in a sentence
};

/// Refuses numbers with which nothing can be polished.
///
/// @param polishing  the numbers
/// @throws std::invalid_argument naming the number, what must hold and what was given
void validate(const Polishing& polishing);

/// Minimizes a sum of squares from a start on, by the method of Levenberg and Marquardt.
///
/// \f[ \min_\Lambda \sum_k \rho_k(\Lambda)^2, \qquad
///     \Lambda_i = l_i + \tfrac12 (u_i - l_i)(1 - \cos\theta_i) \f]
///
/// @equation{R 5.1} The gradient-type method after the genetic algorithm. It moves in the angles \f$ \theta \f$, which
/// have no bounds; a start within 1e-3 of a bound, in widths of the box, moves off it by as much, since at a bound the
/// angle moves nothing. What Box::allows refuses has no residuals. A difference without residuals is taken to the other
/// side; where that has none either, the parameter stands still for a step.
/// @param residuals  of which the sum of squares is to be small
/// @param box        the bounds
/// @param start      in the box, and allowed; where it has no residuals nothing is done
/// @param polishing  steps and ends
/// @return the best parameters found
/// @throws std::invalid_argument for a start outside the box, fewer residuals than parameters, or a number of them that
///         changes; and as validate() does
Polished polish(const Residuals& residuals, const Box& box, const Eigen::VectorXd& start,
                const Polishing& polishing = {});

}  // namespace particulate::identification
