// Mistake: the first variant's map, where j is driven.
// graded: --variant 2 --student anna -> 0
// graded: --variant 2 --student bob@school.edu -> 0
// hint: this is the map of the other variant

#include "right.hpp"

Eigen::Vector3d normal(double degrees) { return right::normal(degrees); }

double normal_impulse(const Body& i, const Body& j, const Eigen::Vector3d& n, double e) {
  return right::normal_impulse(i, j, n, e);
}

Eigen::Vector3d friction_impulse(const Body& i, const Body& j, const Eigen::Vector3d& n, const Surface& surface) {
  return right::friction_impulse(i, j, n, surface);
}

Velocities impact(const Body& i, const Body& j, const Eigen::Vector3d& n, const Surface& surface) {
  return right::after(i, j, normal_impulse(i, j, n, surface.e) * n + friction_impulse(i, j, n, surface));
}
