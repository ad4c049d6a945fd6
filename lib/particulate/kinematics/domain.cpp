#include <particulate/kinematics/domain.hpp>

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::kinematics {

void validate(const Walled& domain) {
  for (std::size_t k = 0; k < domain.planes.size(); ++k) {
    const auto& [point, normal] = domain.planes[k];
    if (!point.allFinite()) {
      throw std::invalid_argument(
          fmt::format("wall {}: its point must be finite, got ({}, {}, {}) m", k, point.x(), point.y(), point.z()));
    }
    if (!(std::abs(normal.norm() - 1.0) <= 1e-12)) {
      throw std::invalid_argument(fmt::format(
          "wall {}: its normal must be a unit vector, got ({}, {}, {}) of length {}; divide it by its length", k,
          normal.x(), normal.y(), normal.z(), normal.norm()));
    }
  }
}

}  // namespace particulate::kinematics
