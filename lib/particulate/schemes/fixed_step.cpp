#include <particulate/schemes/fixed_step.hpp>

#include <particulate/schemes/iteration.hpp>
#include <particulate/schemes/step_settings.hpp>

namespace particulate::schemes {

bool FixedStep::settled(const Iteration& it) const { return TOL ? met(it, *TOL) : at_rounding(it); }

Decision FixedStep::judge(const Attempt& made) const {
  const Iteration& it = made.iteration;
  if (it.evaluated && (it.K < 0 || settled(it))) return {.accepted = true};
  Decision refused = unmet(made, TOL.value_or(it.rounding), contractions);
  refused.impossible += refused.failure == Failure::no_value
                            ? ", and a fixed step cannot shrink: choose a smaller step, or a start where it has one"
                            : ", and a fixed step cannot shrink";
  return refused;
}

void validate(const FixedStep& control) {
  detail::validate_step("fixed step", control.step);
  if (control.TOL) validate_tolerance("fixed step", *control.TOL);
  detail::require("fixed step", control.contractions >= 1, "contractions must be at least 1", control.contractions);
}

}  // namespace particulate::schemes
