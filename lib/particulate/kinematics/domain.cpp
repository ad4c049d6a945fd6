#include <particulate/kinematics/domain.hpp>

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::kinematics {

void validate(const Space& domain) {
  for (std::size_t k = 0; k < domain.walls.size(); ++k) {
    const auto& [point, normal] = domain.walls[k];
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
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double length = domain.lengths[axis];
    if (!(std::isinf(length) && length > 0.0)) {
      throw std::invalid_argument(fmt::format(
          "space: its length in direction {} must be infinite, got {} m: a space that repeats itself is not "
          "built yet",
          "xyz"[axis], length));
    }
  }
}

}  // namespace particulate::kinematics
