#pragma once

#include <particulate/schemes/scheme.hpp>

namespace particulate::schemes {

/// Every step the same, each with the same number of sweeps: the iteration cut off becomes an explicit scheme.
///
/// What the sweeps leave adds to the error of the step, as measured by refining it. Satisfies Controller. A step that
/// has no value, or whose sweeps drive the iterates apart, fails the run.
struct FixedSweeps {
  static constexpr bool ignores_truncation = true;  ///< it is given no estimate
  static constexpr bool needs_sweeps = true;        ///< a scheme without them makes none
  static constexpr bool fixes_sweeps = true;        ///< every step makes the same number of them
  static constexpr bool fixes_step = true;          ///< a step beyond a limit of the problem is refused

  double step = 0.0;  ///< Dt, > 0 and finite [s]
  int sweeps = 2;     ///< of each step, >= 1 [-]

  /// @return the step to try next [s]
  double dt() const { return step; }
  /// @param it  the iteration so far
  /// @return whether sweeps are left
  bool goes_on(const Iteration& it) const { return it.K + 1 < sweeps && it.w_K > 0.0; }
  /// Accepts what has a value and does not diverge.
  ///
  /// @param made  the attempted step
  /// @return accepted, or impossible with the reason
  Decision judge(const Attempt& made) const;
};

/// Refuses settings that cannot be meant. Called once, when a run starts.
///
/// @param control  the controller
/// @throws std::invalid_argument naming the setting, what must hold and what was given
void validate(const FixedSweeps& control);

}  // namespace particulate::schemes
