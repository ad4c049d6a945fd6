#pragma once

#include <optional>

#include <particulate/schemes/scheme.hpp>

namespace particulate::schemes {

/// Every step the same: for explicit schemes, for measuring orders, and for seeing whether an iteration contracts.
///
/// Satisfies Controller. An iterative scheme sweeps until its error is at most TOL, by default until rounding keeps it
/// from coming closer. A step that has no value, or whose sweeps do not get there, cannot be made smaller: the run
/// fails there, and says what was seen.
struct FixedStep {
  static constexpr bool ignores_truncation = true;  ///< it is given no estimate
  static constexpr bool fixes_step = true;          ///< a step beyond a limit of the problem is refused

  double step = 0.0;               ///< Dt, > 0 and finite [s]
  std::optional<double> TOL = {};  ///< on the error w_K of the sweeps, at least 2.3e-16; none: to rounding [-]
  int contractions = 1000;         ///< sweeps allowed after the first, >= 1 [-]

  /// @return the step to try next [s]
  double dt() const { return step; }
  /// @return whether TOL was given: it then needs a scheme that sweeps
  bool bounds_sweeps() const { return TOL.has_value(); }
  /// @param it  the iteration so far
  /// @return whether the sweeps have still to go on
  bool goes_on(const Iteration& it) const { return !settled(it) && it.K < contractions; }
  /// Accepts what has a value and has settled.
  ///
  /// @param made  the attempted step
  /// @return accepted, or impossible with the reason
  Decision judge(const Attempt& made) const;

 private:
  bool settled(const Iteration& it) const;
};

/// Refuses settings that cannot be meant. Called once, when a run starts.
///
/// @param control  the controller
/// @throws std::invalid_argument naming the setting, what must hold and what was given
void validate(const FixedStep& control);

}  // namespace particulate::schemes
