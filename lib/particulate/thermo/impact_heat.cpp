#include <particulate/thermo/impact_heat.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::thermo {

void validate(const ImpactHeat& law) {
  if (!(law.kappa >= 0.0 && std::isfinite(law.kappa))) {
    throw std::invalid_argument(
        fmt::format("heat of impacts: kappa must be finite and not negative, got {} J/m^2", law.kappa));
  }
  if (!(law.J_star > 0.0 && std::isfinite(law.J_star))) {
    throw std::invalid_argument(
        fmt::format("heat of impacts: J_star must be positive and finite, got {} N s", law.J_star));
  }
}

double released_energy(const ImpactHeat& law, double J, double radius) {
  return law.kappa * std::min(J / law.J_star, 1.0) * std::numbers::pi * radius * radius;
}

double dissipated_energy(const contact::ImpactRecord& impact) {
  return (impact.push * impact.n - impact.tangential).dot(0.5 * (impact.before + impact.after + impact.meanwhile));
}

double add_heat_of_impact(const ImpactHeat& law, const laws::At<laws::Temperature>& at,
                          const contact::ImpactRecord& impact, schemes::Out heat) {
  const auto [i, j] = std::pair{impact.i, impact.j};
  const double H = released_energy(law, impact.push, j < 0 ? at.radius[i] : std::min(at.radius[i], at.radius[j]));
  const double all = dissipated_energy(impact) + H;
  const bool j_takes = j >= 0 && at.inverse_mass[j] > 0.0, i_takes = at.inverse_mass[i] > 0.0;
  const double share = i_takes && j_takes ? 0.5 * all : all;
  if (i_takes) heat[i] += share;
  if (j_takes) heat[j] += share;
  return H;
}

}  // namespace particulate::thermo
