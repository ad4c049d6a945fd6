#pragma once

#include <string_view>

#include <particulate/schemes/scheme.hpp>

/// @file
/// What the step controls share: which settings can be meant, and when a refused step is not tried again.

namespace particulate::schemes::detail {

/// The settings of a control that grows and shrinks its step; see PhiControl for what they mean.
struct StepSettings {
  double step;      ///< in (0, limit], or 0: none was given [s]
  double limit;     ///< > 0 [s]
  double smallest;  ///< in [0, step] [s]
  double growth;    ///< > 1, finite [-]
  double retry;     ///< in (0, 1) [-]
  double shrink;    ///< in (0, retry) [-]
};

/// @param whose     the setting's owner, for the message
/// @param holds     whether the setting can be meant
/// @param what      what must hold
/// @param given     what was given
/// @throws std::invalid_argument saying so, if it does not hold
void require(std::string_view whose, bool holds, std::string_view what, double given);

/// @param whose     the settings' owner, for the message
/// @param settings  to be checked
/// @throws std::invalid_argument naming the setting, what must hold and what was given
void validate(std::string_view whose, const StepSettings& settings);

/// @param whose  the setting's owner, for the message
/// @param step   that never changes, > 0 and finite [s]
/// @throws std::invalid_argument saying what must hold and what was given
void validate_step(std::string_view whose, double step);

/// Makes of a step that did not meet its tolerance one that is tried again.
///
/// @param unmet     why it did not
/// @param next      the step to try next [s]
/// @param smallest  below it a step is not tried [s]
/// @return refused, unless it is impossible: the tolerance is below rounding, or the next step below the smallest
Decision retried(Decision unmet, double next, double smallest);

}  // namespace particulate::schemes::detail
