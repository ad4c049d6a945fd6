#include <particulate/contact/friction.hpp>

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::contact {

void validate(const Friction& law) {
  if (!(law.mu_d >= 0.0 && std::isfinite(law.mu_d))) {
    throw std::invalid_argument(fmt::format("friction: mu_d must be finite and not negative, got {}", law.mu_d));
  }
  if (!(law.mu_s >= law.mu_d && std::isfinite(law.mu_s))) {
    throw std::invalid_argument(
        fmt::format("friction: mu_s must be finite and at least mu_d = {}, got {}", law.mu_d, law.mu_s));
  }
}

Eigen::Vector3d tangential_impulse(const Friction& law, const Eigen::Vector3d& slip, double reduced_mass,
                                   double normal_impulse) {
  const double speed = slip.stableNorm();
  const double sticking = reduced_mass * speed;
  if (sticking <= law.mu_s * normal_impulse) return -reduced_mass * slip;
  return (-law.mu_d * normal_impulse / speed) * slip;
}

}  // namespace particulate::contact
