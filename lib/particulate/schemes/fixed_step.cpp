#include <particulate/schemes/fixed_step.hpp>

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::schemes {

Decision FixedStep::judge(const Attempt& made) const {
  if (made.iteration.evaluated) return {.accepted = true, .impossible = {}};
  return {.accepted = false,
          .impossible = fmt::format("the problem has no finite value within this step of {} s, and a fixed step cannot "
                                    "shrink: choose a smaller step, or a start where it has one",
                                    made.dt)};
}

void validate(const FixedStep& control) {
  if (!(control.step > 0.0 && std::isfinite(control.step))) {
    throw std::invalid_argument(fmt::format("fixed step: step must be positive and finite, got {} s", control.step));
  }
}

}  // namespace particulate::schemes
