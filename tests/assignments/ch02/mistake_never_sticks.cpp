// Mistake: friction slides always, however small the slip, and reverses it.
// graded: --variant 1 --student anna -> 0
// graded: --variant 1 --student bob@school.edu -> 0
// hint: friction is not capped
// hint: friction does not reverse the sliding

#include "right.hpp"

Eigen::Vector3d normal(double degrees) { return right::normal(degrees); }

double normal_impulse(const Body& i, const Body& j, const Eigen::Vector3d& n, double e) {
  return right::normal_impulse(i, j, n, e);
}

Eigen::Vector3d friction_impulse(const Body& i, const Body& j, const Eigen::Vector3d& n, const Surface& surface) {
  const Eigen::Vector3d slip = right::slip(i, j, n);
  return surface.mu_d * normal_impulse(i, j, n, surface.e) * slip.normalized();
}

Velocities impact(const Body& i, const Body& j, const Eigen::Vector3d& n, const Surface& surface) {
  return right::after(i, j, normal_impulse(i, j, n, surface.e) * n + friction_impulse(i, j, n, surface));
}
