#pragma once

#include <particulate/schemes/scheme.hpp>

namespace particulate::schemes {

/// Every step the same: for explicit schemes, and for measuring orders.
///
/// Satisfies Controller. A step at which the problem has no value cannot be made smaller, so the run fails there.
struct FixedStep {
  double step = 0.0;  ///< Dt, > 0 and finite [s]

  /// @return the step to try next [s]
  double dt() const { return step; }
  /// @return false: an explicit scheme has nothing to iterate
  bool goes_on(const Iteration&) const { return false; }
  /// Accepts what has a value.
  ///
  /// @param made  the attempted step
  /// @return accepted, or impossible with the reason
  Decision judge(const Attempt& made) const;
};

/// Refuses a step that is none. Called once, when a run starts.
///
/// @param control  the controller
/// @throws std::invalid_argument if the step is not positive and finite
void validate(const FixedStep& control);

}  // namespace particulate::schemes
