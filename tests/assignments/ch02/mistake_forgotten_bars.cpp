// Mistake: J stands where |J| belongs.
// graded: --variant 1 --student anna -> 0
// graded: --variant 1 --student bob@school.edu -> 0
// hint: the impulse J is negative, friction is proportional

#include "right.hpp"

Eigen::Vector3d normal(double degrees) { return right::normal(degrees); }

double normal_impulse(const Body& i, const Body& j, const Eigen::Vector3d& n, double e) {
  return right::normal_impulse(i, j, n, e);
}

Eigen::Vector3d friction_impulse(const Body& i, const Body& j, const Eigen::Vector3d& n, const Surface& surface) {
  const double J = normal_impulse(i, j, n, surface.e), mass = right::reduced_mass(i, j);
  const Eigen::Vector3d slip = right::slip(i, j, n);
  if (mass * slip.norm() <= surface.mu_s * J) return -mass * slip;
  return -surface.mu_d * J / slip.norm() * slip;
}

Velocities impact(const Body& i, const Body& j, const Eigen::Vector3d& n, const Surface& surface) {
  return right::after(i, j, normal_impulse(i, j, n, surface.e) * n + friction_impulse(i, j, n, surface));
}
