#pragma once

#include <functional>
#include <string>
#include <utility>

#include <Eigen/Core>

namespace particulate::identification {

/// What a cost says of a set of parameters: a number, or why there is none.
struct Value {
  /// @param number  the cost; one that is not finite is no value
  Value(double number) : cost(number) {}
  /// @param reason  why these parameters have no value, in a few words that are the same for the same reason
  explicit Value(std::string reason);

  double cost;         ///< NaN where there is none
  std::string reason;  ///< empty where there is a value
};

/// \f$ \Pi(\Lambda) \f$: what is to be small, of parameters in the order of their Box. It must give the same for the
/// same parameters, and is called by several threads at once where a search is told to use them.
using Cost = std::function<Value(const Eigen::VectorXd& parameters)>;

/// Numbers whose sum of squares is to be small; an empty vector where the parameters have none. As many for all
/// parameters, and at least as many as there are parameters.
using Residuals = std::function<Eigen::VectorXd(const Eigen::VectorXd& parameters)>;

/// Where parameters are searched: each between two bounds.
///
/// @equation{R 5.1}
struct Box {
  Eigen::VectorXd lower;  ///< in the units of the parameters
  Eigen::VectorXd upper;  ///< above lower, entry by entry
  /// What parameters must hold besides, such as beta2 > beta1; none: nothing. Those that do not are drawn again.
  std::function<bool(const Eigen::VectorXd& parameters)> allows = {};
};

/// Refuses bounds that are no box.
///
/// @param box  the bounds
/// @throws std::invalid_argument naming the entry, what must hold and what was given
void validate(const Box& box);

/// A cost that never throws: what it throws, and a number that is not finite, is no value with that reason.
///
/// @param cost        the cost
/// @param parameters  of which its value is asked
/// @return its value
Value evaluate(const Cost& cost, const Eigen::VectorXd& parameters);

}  // namespace particulate::identification
