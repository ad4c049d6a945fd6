#include <particulate/laws/gravity.hpp>

#include <stdexcept>

#include <fmt/format.h>

namespace particulate::laws {

void validate(const Gravity& law) {
  if (!law.g.allFinite()) {
    throw std::invalid_argument(
        fmt::format("gravity: g must be finite, got ({}, {}, {}) m/s^2", law.g.x(), law.g.y(), law.g.z()));
  }
}

}  // namespace particulate::laws
