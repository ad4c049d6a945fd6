// Mistake: the impulse on i is positive, and j gets the opposite.
// graded: --variant 1 --student anna -> 0
// graded: --variant 1 --student bob@school.edu -> 0
// hint: sign of J: contacts push
// never: restitution: along n

#include "right.hpp"

Eigen::Vector3d normal(double degrees) { return right::normal(degrees); }

double normal_impulse(const Body& i, const Body& j, const Eigen::Vector3d& n, double e) {
  return -right::normal_impulse(i, j, n, e);
}

Eigen::Vector3d friction_impulse(const Body& i, const Body& j, const Eigen::Vector3d& n, const Surface& surface) {
  const double J = normal_impulse(i, j, n, surface.e);
  return right::friction(right::slip(i, j, n), right::reduced_mass(i, j), J, surface.mu_s, surface.mu_d);
}

Velocities impact(const Body& i, const Body& j, const Eigen::Vector3d& n, const Surface& surface) {
  return right::after(i, j, normal_impulse(i, j, n, surface.e) * n + friction_impulse(i, j, n, surface));
}
