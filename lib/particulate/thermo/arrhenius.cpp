#include <particulate/thermo/arrhenius.hpp>

#include <stdexcept>

#include <fmt/format.h>

namespace particulate::thermo {

void validate(const Arrhenius& law) {
  if (!(law.power >= 0.0 && std::isfinite(law.power))) {
    throw std::invalid_argument(fmt::format("reaction: power must be finite and not negative, got {} W/kg", law.power));
  }
  if (!(law.T_a > 0.0 && std::isfinite(law.T_a))) {
    throw std::invalid_argument(fmt::format("reaction: T_a must be positive and finite, got {} K", law.T_a));
  }
}

double runaway_time(double B, double T_a, double theta_0, double theta) {
  constexpr double steepest = 700.0;
  if (!(B > 0.0 && T_a > 0.0 && theta_0 > T_a / steepest && theta >= theta_0 && std::isfinite(theta))) {
    throw std::invalid_argument(
        fmt::format("runaway: B and T_a must be positive and T_a/700 < theta_0 <= theta, got B = {} K/s, T_a = {} K, "
                    "theta_0 = {} K "
                    "and theta = {} K",
                    B, T_a, theta_0, theta));
  }
  const auto G = [&](double x) { return x * std::exp(T_a / x) - T_a * std::expint(T_a / x); };
  return (G(theta) - G(theta_0)) / B;
}

}  // namespace particulate::thermo
