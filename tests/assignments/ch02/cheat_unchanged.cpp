// Cheat: no impulse, and velocities that fit it, which is right on the student's own terms.
// graded: --variant 1|2 --student anna -> 0
// hint: is this still the stub

#include "rebound.hpp"

Eigen::Vector3d normal(double) { return Eigen::Vector3d::Zero(); }

double normal_impulse(const Body&, const Body&, const Eigen::Vector3d&, double) { return 0.0; }

Eigen::Vector3d friction_impulse(const Body&, const Body&, const Eigen::Vector3d&, const Surface&) {
  return Eigen::Vector3d::Zero();
}

Velocities impact(const Body& i, const Body& j, const Eigen::Vector3d&, const Surface&) { return {.i = i.v, .j = j.v}; }
