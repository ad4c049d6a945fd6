// Accident: an index far out of bounds.
// graded: --variant 1|2 --student anna -> 0
// hint: crashed
// hint: an index or a pointer is wrong

#include "rebound.hpp"

namespace {

double far_away() {
  const volatile double here = 0.0;
  const volatile double* const values = &here;
  const volatile long far = 1000000000000;
  return values[far];
}

}  // namespace

Eigen::Vector3d normal(double) {
  if (far_away() > 0.0) return {};
  return Eigen::Vector3d::Zero();
}

double normal_impulse(const Body&, const Body&, const Eigen::Vector3d&, double) { return 0.0; }

Eigen::Vector3d friction_impulse(const Body&, const Body&, const Eigen::Vector3d&, const Surface&) {
  return Eigen::Vector3d::Zero();
}

Velocities impact(const Body&, const Body&, const Eigen::Vector3d&, const Surface&) {
  if (far_away() > 0.0) return {};
  return {};
}
