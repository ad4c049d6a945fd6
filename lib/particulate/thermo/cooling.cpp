#include <particulate/thermo/cooling.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::thermo {

void validate(const Cooling& law) {
  const auto require = [](bool holds, const char* what, double given) {
    if (!holds) throw std::invalid_argument(fmt::format("cooling: {}, got {}", what, given));
  };
  require(law.h_c >= 0.0 && std::isfinite(law.h_c), "h_c must be finite and not negative", law.h_c);
  require(law.theta_o >= 0.0 && std::isfinite(law.theta_o), "theta_o must be finite and not negative", law.theta_o);
  require(law.emissivity >= 0.0 && law.emissivity <= 1.0, "emissivity must lie between 0 and 1", law.emissivity);
  require(law.theta_s >= 0.0 && std::isfinite(law.theta_s), "theta_s must be finite and not negative", law.theta_s);
}

double heat_flux(const Cooling& law, double theta) {
  // theta^4 - theta_s^4 by factors, which keeps its digits where the two are close.
  const double fourth = (theta - law.theta_s) * (theta + law.theta_s) * (theta * theta + law.theta_s * law.theta_s);
  return -law.h_c * (theta - law.theta_o) - stefan_boltzmann * law.emissivity * fourth;
}

double heat_flux_slope(const Cooling& law, double theta) {
  return -law.h_c - 4.0 * stefan_boltzmann * law.emissivity * theta * theta * theta;
}

double equilibrium_temperature(const Cooling& law) {
  validate(law);
  if (law.h_c == 0.0 && law.emissivity == 0.0) {
    throw std::invalid_argument(
        "cooling: without convection and radiation any temperature stays: give h_c or emissivity");
  }
  double low = std::min(law.theta_o, law.theta_s), high = std::max(law.theta_o, law.theta_s);
  if (law.h_c == 0.0 || law.emissivity == 0.0) return law.h_c == 0.0 ? law.theta_s : law.theta_o;
  while (true) {
    const double middle = low + 0.5 * (high - low);
    if (!(middle > low && middle < high)) return middle;
    (heat_flux(law, middle) > 0.0 ? low : high) = middle;
  }
}

double convected_temperature(double theta_0, double theta_o, double tau, double t) {
  return theta_o + (theta_0 - theta_o) * std::exp(-t / tau);
}

double radiation_time(double k, double theta_0, double theta, double theta_s) {
  const bool between = theta_s <= theta_0 ? theta > theta_s && theta <= theta_0 : theta < theta_s && theta >= theta_0;
  if (!(between && theta > 0.0 && theta_s >= 0.0)) {
    throw std::invalid_argument(
        fmt::format("radiation: the temperature reached must lie between that at the start, {} K, and that of the "
                    "surroundings, {} K, without it, got {} K",
                    theta_0, theta_s, theta));
  }
  const auto inverse_cube = [](double x) { return 1.0 / (x * x * x); };
  if (theta_s == 0.0) return (inverse_cube(theta) - inverse_cube(theta_0)) / (3.0 * k);
  const auto F = [&](double x) {
    return std::log(std::abs((x - theta_s) / (x + theta_s))) - 2.0 * std::atan(x / theta_s);
  };
  return (F(theta_0) - F(theta)) / (4.0 * k * theta_s * theta_s * theta_s);
}

}  // namespace particulate::thermo
