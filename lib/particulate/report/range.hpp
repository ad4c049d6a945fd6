#pragma once

#include <limits>
#include <string>
#include <vector>

namespace particulate::report {

/// The values that a field of a program's parameters may take.
///
/// NaN is in no range. Infinity is only in one that says so with or_infinite().
struct Range {
  double lowest = -std::numeric_limits<double>::infinity();  ///< smallest value
  double highest = std::numeric_limits<double>::infinity();  ///< largest value
  bool above_lowest = false;                                 ///< lowest itself is excluded
  bool below_highest = false;                                ///< highest itself is excluded
  bool infinite = false;                                     ///< plus infinity is allowed
  std::vector<std::string> choices = {};                     ///< for texts: the allowed ones; empty: any

  /// Whether a number lies in the range.
  /// @param value  any number
  /// @return false for NaN, whatever the range
  bool holds(double value) const;
  /// Whether a text is one of the choices.
  /// @param value  any text
  /// @return true if it is, or if there are no choices
  bool holds(const std::string& value) const;
  /// @return a copy that allows plus infinity too
  Range or_infinite() const;
  /// @return what must hold, to follow the word "must": "be at least 0", "lie in [0, 1]", "be one of a, b"
  std::string text() const;
};

/// @return the range of every finite number, or of every text
Range any();
/// @param lowest  smallest allowed value
/// @return the range of the finite numbers from lowest on
Range at_least(double lowest);
/// @param bound  largest value that is not allowed
/// @return the range of the finite numbers above bound
Range more_than(double bound);
/// @param highest  largest allowed value
/// @return the range of the finite numbers up to highest
Range at_most(double highest);
/// @param lowest   smallest allowed value
/// @param highest  largest allowed value, not below lowest
/// @return the closed interval
/// @throws std::invalid_argument if no number lies in it
Range between(double lowest, double highest);
/// @param choices  the allowed texts, at least one
/// @return the range of these texts
/// @throws std::invalid_argument if there are none
Range one_of(std::vector<std::string> choices);

}  // namespace particulate::report
