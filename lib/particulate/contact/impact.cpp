#include <particulate/contact/impact.hpp>

#include <cmath>

namespace particulate::contact {

Phases phases(double duration, double e) {
  const double compression = duration / (1.0 + e);
  return {.compression = compression, .recovery = e * compression};
}

External external_changes(const Eigen::Vector3d& acceleration_i, const Eigen::Vector3d& acceleration_j,
                          const Phases& phases) {
  const Eigen::Vector3d relative = acceleration_i - acceleration_j;
  return {.compression = phases.compression * relative, .recovery = phases.recovery * relative};
}

double normal_impulse(double u, double delta1, double e, double reduced_mass) {
  const bool acts = u > 0.0 && u + delta1 > 0.0 && std::isfinite(reduced_mass);
  return acts ? -(1.0 + e) * reduced_mass * (u + delta1) : 0.0;
}

Impulse impact_impulse(const Body& i, const Body& j, const Eigen::Vector3d& n, double e, const External& external,
                       const Frictionless&) {
  const double u = (i.velocity - j.velocity).dot(n);
  const double reduced_mass = 1.0 / (i.inverse_mass + j.inverse_mass);
  return {.normal = normal_impulse(u, external.compression.dot(n), e, reduced_mass)};
}

Impulse impact_impulse(const Body& i, const Body& j, const Eigen::Vector3d& n, double e, const External& external,
                       const Friction& friction) {
  Impulse impulse = impact_impulse(i, j, n, e, external, Frictionless{});
  if (impulse.normal == 0.0) return impulse;
  const Eigen::Vector3d slip = i.velocity - j.velocity + external.compression + external.recovery;
  const double reduced_mass = 1.0 / (i.inverse_mass + j.inverse_mass);
  impulse.tangential = tangential_impulse(friction, slip - slip.dot(n) * n, reduced_mass, -impulse.normal);
  return impulse;
}

}  // namespace particulate::contact
