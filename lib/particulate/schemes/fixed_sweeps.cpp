#include <particulate/schemes/fixed_sweeps.hpp>

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <particulate/schemes/iteration.hpp>

namespace particulate::schemes {

Decision FixedSweeps::judge(const Attempt& made) const {
  const Iteration& it = made.iteration;
  const bool diverges = it.K > 0 && it.rate >= 1.0 && !at_rounding(it);
  if (it.evaluated && !diverges) return {.accepted = true};
  Decision refused = unmet(made, it.w_0, sweeps);
  refused.impossible += ", and a fixed step cannot shrink";
  return refused;
}

void validate(const FixedSweeps& control) {
  if (!(control.step > 0.0 && std::isfinite(control.step))) {
    throw std::invalid_argument(fmt::format("fixed sweeps: step must be positive and finite, got {} s", control.step));
  }
  if (control.sweeps < 1) {
    throw std::invalid_argument(fmt::format("fixed sweeps: sweeps must be at least 1, got {}", control.sweeps));
  }
}

}  // namespace particulate::schemes
