#include <particulate/swarm/linear_drag.hpp>

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::swarm {

void validate(const LinearDrag& law) {
  if (law.c_d >= 0.0 && std::isfinite(law.c_d)) return;
  throw std::invalid_argument(fmt::format("drag: c_d must be finite and not negative, got {} 1/s", law.c_d));
}

}  // namespace particulate::swarm
