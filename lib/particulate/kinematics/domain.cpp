#include <particulate/kinematics/domain.hpp>

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::kinematics {

namespace {

void validate_across(const Space& domain, Eigen::Index axis) {
  if (!std::isfinite(domain.lengths[axis])) return;
  for (std::size_t k = 0; k < domain.walls.size(); ++k) {
    const Eigen::Vector3d& normal = domain.walls[k].normal;
    if (normal[axis] == 0.0) continue;
    throw std::invalid_argument(fmt::format(
        "wall {}: its normal must have no component in direction {}, in which space repeats itself after {} m, got "
        "({}, {}, {}); turn the wall, or leave that length out",
        k, "xyz"[axis], domain.lengths[axis], normal.x(), normal.y(), normal.z()));
  }
}

}  // namespace

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
    if (!(length > 0.0)) {
      throw std::invalid_argument(fmt::format(
          "space: its length in direction {} must be positive, got {} m; leave it out if space does not repeat itself "
          "there",
          "xyz"[axis], length));
    }
    validate_across(domain, axis);
  }
}

void validate_periods(const Space& domain, const Eigen::VectorXd& radius) {
  Eigen::Index largest = 0;
  const double b = radius.size() > 0 ? radius.maxCoeff(&largest) : 0.0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double length = domain.lengths[axis];
    if (length >= 4.0 * b) continue;
    throw std::invalid_argument(fmt::format(
        "space: its length in direction {} must be at least two diameters of the largest body, {} m with particle {}, "
        "got {} m: lengthen it, or take smaller bodies",
        "xyz"[axis], 4.0 * b, largest, length));
  }
}

Eigen::Vector3d wrapped(const Space& domain, const Eigen::Vector3d& place) {
  Eigen::Vector3d image = place;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double length = domain.lengths[axis];
    if (!std::isfinite(length)) continue;
    image[axis] -= length * std::floor(image[axis] / length);
    if (image[axis] >= length || image[axis] < 0.0) image[axis] = 0.0;  // by rounding
  }
  return image;
}

}  // namespace particulate::kinematics
