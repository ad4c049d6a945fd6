#include <particulate/schemes/fixed_sweeps.hpp>

#include <particulate/schemes/iteration.hpp>
#include <particulate/schemes/step_settings.hpp>

namespace particulate::schemes {

Decision FixedSweeps::judge(const Attempt& made) const {
  const Iteration& it = made.iteration;
  // Two sweeps of fields that drive each other may say nothing yet: the first moves little and the second much, where
  // a wave turns. Where time scales bound the step they need not be asked.
  const int first_told = made.within_limits ? 2 : 1;
  const bool diverges = it.K >= first_told && it.rate >= 1.0 && shows_contraction(it);
  if (it.evaluated && !diverges) return {.accepted = true};
  Decision refused = unmet(made, it.w_0, sweeps);
  refused.impossible += ", and a fixed step cannot shrink";
  return refused;
}

void validate(const FixedSweeps& control) {
  detail::validate_step("fixed sweeps", control.step);
  detail::require("fixed sweeps", control.sweeps >= 1, "sweeps must be at least 1", control.sweeps);
}

}  // namespace particulate::schemes
