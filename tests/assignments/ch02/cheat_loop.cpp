// Accident: a loop without end, in one line of the table.
// graded: --variant 1|2 --student anna -> 0
// hint: took too long
// hint: a loop does not end

#include "rebound.hpp"

Eigen::Vector3d normal(double) {
  for (volatile double x = 1.0; x > 0.0;) x = x + 1.0;
  return Eigen::Vector3d::Zero();
}

double normal_impulse(const Body&, const Body&, const Eigen::Vector3d&, double) { return 0.0; }

Eigen::Vector3d friction_impulse(const Body&, const Body&, const Eigen::Vector3d&, const Surface&) {
  return Eigen::Vector3d::Zero();
}

Velocities impact(const Body&, const Body&, const Eigen::Vector3d&, const Surface&) { return {}; }
