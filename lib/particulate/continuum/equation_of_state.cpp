#include <particulate/continuum/equation_of_state.hpp>

#include <stdexcept>

#include <fmt/format.h>

namespace particulate::continuum {

namespace {

void require_positive(const char* law, const char* name, double given) {
  if (given > 0.0 && std::isfinite(given)) return;
  throw std::invalid_argument(fmt::format("{}: {} must be positive and finite, got {}", law, name, given));
}
void require_finite_constant(const char* law, const char* name, double given) {
  if (std::isfinite(given)) return;
  throw std::invalid_argument(fmt::format("{}: {} must be finite, got {}", law, name, given));
}

}  // namespace

void validate(const LinearizedState& law) {
  const char* name = "linearized equation of state";
  require_finite_constant(name, "P_R", law.P_R);
  require_positive(name, "Y", law.Y);
  require_positive(name, "rho_R", law.rho_R);
  require_positive(name, "theta_R", law.theta_R);
  require_finite_constant(name, "a_th", law.a_th);
}

void validate(const IdealGas& law) { require_positive("ideal gas", "R", law.R); }

void validate(const Barotropic& law) {
  const char* name = "barotropic fluid";
  require_finite_constant(name, "P_R", law.P_R);
  require_positive(name, "Y", law.Y);
  require_positive(name, "rho_R", law.rho_R);
}

}  // namespace particulate::continuum
