#pragma once

#include <string>
#include <vector>

#include <particulate/identification/cost.hpp>
#include <particulate/identification/identifiability.hpp>

/// @file
/// What parameters are to lead to, as a few numbers: how far others are from them, and which cannot be reached.

namespace particulate::identification {

/// A number that parameters are to lead to.
struct Wanted {
  std::string name;     ///< of the quantity, with its unit
  double value;         ///< A*, finite
  double weight = 1.0;  ///< of this number among several, >= 0; their sum counts as 1 [-]
  double scale = 0.0;   ///< what a difference is counted in, > 0; 0: the size of the value, which then must not be 0
};

/// What came of a number that is wanted.
struct Reached {
  std::string name;  ///< of the quantity
  double wanted;     ///< A*
  double found;      ///< A
  double misfit;     ///< (A - A*)/scale [-]
};

/// The cost of parameters: how far the numbers that they lead to are from those that are wanted. It is a Cost.
///
/// \f[ \Pi(\Lambda) = \sum_k \frac{w_k}{\sum w}\, \frac{|A_k(\Lambda) - A_k^*|}{|A_k^*|} \f]
///
/// @equation{R 9.7}
class Misfit {
 public:
  /// @param wanted  at least one; weights not all zero
  /// @param model   gives as many numbers, in their order; none where there is no value
  /// @throws std::invalid_argument naming the number, what must hold and what was given
  Misfit(std::vector<Wanted> wanted, SampledModel model);

  /// @param parameters  of which the cost is asked
  /// @return the weighted mean of the misfits' sizes, or why there is none [-]
  /// @throws std::invalid_argument if the model gives another number of numbers
  Value operator()(const Eigen::VectorXd& parameters) const;
  /// The same of numbers that are known already.
  ///
  /// @param found  one for each that is wanted, in their order; none: no value
  /// @return as above
  /// @throws std::invalid_argument for another number of numbers
  Value of(const Eigen::VectorXd& found) const;
  /// Misfits times the root of their shares: the sum of their squares is the cost with squares for sizes.
  ///
  /// @param parameters  of which they are asked
  /// @return one a number, in their order; empty where there is no value
  /// @throws std::invalid_argument as the cost does
  Eigen::VectorXd residuals(const Eigen::VectorXd& parameters) const;
  /// @param parameters  of which they are asked
  /// @return what came of each number; empty where there is no value
  /// @throws std::invalid_argument as the cost does
  std::vector<Reached> reached(const Eigen::VectorXd& parameters) const;

 private:
  Eigen::VectorXd misfits(const Eigen::VectorXd& found) const;

  std::vector<Wanted> wanted_;
  SampledModel model_;
  Eigen::VectorXd shares_;
};

/// Says which numbers were not reached, and what came nearest.
///
/// @param reached    by the best parameters that were found
/// @param tolerance  a misfit up to this size counts as reached, > 0 [-]
/// @return a sentence for each; empty: all were
std::string unreached(const std::vector<Reached>& reached, double tolerance);

}  // namespace particulate::identification
