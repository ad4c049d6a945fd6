// Mistake: equality slides, which is 0/0 where nothing slips and nothing rubs.
// graded: --variant 1 --student anna -> 15
// graded: --variant 1 --student bob@school.edu -> 15
// hint: equality included

#include "right.hpp"

Eigen::Vector3d normal(double degrees) { return right::normal(degrees); }

double normal_impulse(const Body& i, const Body& j, const Eigen::Vector3d& n, double e) {
  return right::normal_impulse(i, j, n, e);
}

Eigen::Vector3d friction_impulse(const Body& i, const Body& j, const Eigen::Vector3d& n, const Surface& surface) {
  const double J = normal_impulse(i, j, n, surface.e), mass = right::reduced_mass(i, j);
  const Eigen::Vector3d slip = right::slip(i, j, n);
  if (mass * slip.norm() < surface.mu_s * std::abs(J)) return -mass * slip;
  return -surface.mu_d * std::abs(J) / slip.norm() * slip;
}

Velocities impact(const Body& i, const Body& j, const Eigen::Vector3d& n, const Surface& surface) {
  return right::after(i, j, normal_impulse(i, j, n, surface.e) * n + friction_impulse(i, j, n, surface));
}
