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

double equilibrium_temperature(const Cooling& law, double absorbed) {
  validate(law);
  if (!(absorbed >= 0.0 && std::isfinite(absorbed))) {
    throw std::invalid_argument(
        fmt::format("cooling: what is absorbed must be finite and not negative, got {} W/m^2", absorbed));
  }
  if (law.h_c == 0.0 && law.emissivity == 0.0) {
    throw std::invalid_argument(
        "cooling: without convection and radiation any temperature stays: give h_c or emissivity");
  }
  double low = std::min(law.theta_o, law.theta_s), high = std::max(law.theta_o, law.theta_s);
  if (absorbed == 0.0 && (law.h_c == 0.0 || law.emissivity == 0.0)) return law.h_c == 0.0 ? law.theta_s : law.theta_o;
  // What is absorbed must go, by convection or by radiation: no more than either would take alone.
  const double convected = law.theta_o + absorbed / law.h_c;
  const double radiated = law.theta_s + std::pow(absorbed / (stefan_boltzmann * law.emissivity), 0.25);
  if (absorbed > 0.0) high = std::max(high, std::min(convected, radiated));
  while (true) {
    const double middle = low + 0.5 * (high - low);
    if (!(middle > low && middle < high)) return middle;
    (heat_flux(law, middle) + absorbed > 0.0 ? low : high) = middle;
  }
}

double convected_temperature(double theta_0, double theta_o, double tau, double t) {
  return theta_o + (theta_0 - theta_o) * std::exp(-t / tau);
}

namespace {

// The time 1/k of radiation from infinitely hot down to x, but for a constant where x is below theta_s. As a series of
// theta_s/x where that is small: of the terms of F only a difference of the third order is left there.
double radiated_down_to(double x, double theta_s) {
  const double ratio = theta_s / x;
  if (ratio <= 0.5) {
    double sum = 0.0, power = 1.0;
    for (int n = 3; n < 60; n += 4, power *= ratio * ratio * ratio * ratio) sum += power / n;
    return sum / (x * x * x);
  }
  const double angle = x > theta_s ? -std::atan(ratio) : std::atan(x / theta_s);
  return (std::log(std::abs((x + theta_s) / (x - theta_s))) + 2.0 * angle) / (4.0 * theta_s * theta_s * theta_s);
}

}  // namespace

double radiation_time(double k, double theta_0, double theta, double theta_s) {
  const bool between = theta_s <= theta_0 ? theta > theta_s && theta <= theta_0 : theta < theta_s && theta >= theta_0;
  if (!(k > 0.0)) throw std::invalid_argument(fmt::format("radiation: k must be positive, got {} 1/(s K^3)", k));
  if (!(between && theta > 0.0 && theta_s >= 0.0)) {
    throw std::invalid_argument(
        fmt::format("radiation: the temperature reached must lie between that at the start, {} K, and that of the "
                    "surroundings, {} K, without it, got {} K",
                    theta_0, theta_s, theta));
  }
  return (radiated_down_to(theta, theta_s) - radiated_down_to(theta_0, theta_s)) / k;
}

}  // namespace particulate::thermo
