#include <particulate/continuum/viscosity.hpp>

#include <stdexcept>

#include <fmt/format.h>

namespace particulate::continuum {

namespace {

void require_of_viscosity(bool holds, const char* what, double given) {
  if (!holds) throw std::invalid_argument(fmt::format("viscosity: {}, got {}", what, given));
}

}  // namespace

void validate(const ConstantViscosity& law) {
  require_of_viscosity(law.mu >= 0.0 && std::isfinite(law.mu), "mu must be finite and not negative", law.mu);
}

void validate(const ExponentialViscosity& law) {
  require_of_viscosity(law.mu_R >= 0.0 && std::isfinite(law.mu_R), "mu_R must be finite and not negative", law.mu_R);
  require_of_viscosity(std::isfinite(law.c_mu), "c_mu must be finite", law.c_mu);
  require_of_viscosity(law.theta_R > 0.0 && std::isfinite(law.theta_R), "theta_R must be positive and finite",
                       law.theta_R);
}

}  // namespace particulate::continuum
