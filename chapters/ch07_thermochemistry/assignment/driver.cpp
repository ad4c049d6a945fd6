#include "driver.hpp"

#include <cmath>

#include "temperature.hpp"

namespace {

using Numbers = std::vector<double>;

// Inputs: b m c h_c theta_o emissivity theta_s theta.
Numbers of_the_rate(const Numbers& x) { return {temperature_rate({x[0], x[1], x[2]}, {x[3], x[4], x[5], x[6]}, x[7])}; }

// The same and t. The classical Runge-Kutta method, in so many steps that its error does not count.
Numbers of_cooling(const Numbers& x) {
  constexpr int steps = 4000;
  const auto f = [&](double theta) { return temperature_rate({x[0], x[1], x[2]}, {x[3], x[4], x[5], x[6]}, theta); };
  double theta = x[7];
  for (int k = 0; k < steps; ++k) {
    const double dt = x[8] / steps;
    const double f1 = f(theta), f2 = f(theta + 0.5 * dt * f1), f3 = f(theta + 0.5 * dt * f2), f4 = f(theta + dt * f3);
    theta += dt / 6.0 * (f1 + 2.0 * f2 + 2.0 * f3 + f4);
  }
  return {theta};
}

// Inputs: k a p theta dt. The rate is k a (1 - (theta/a)^p).
Numbers of_a_step(const Numbers& x) {
  const double k = x[0], a = x[1], p = x[2];
  const auto rate = [&](double theta) { return k * a * (1.0 - std::pow(theta / a, p)); };
  const auto slope = [&](double theta) { return -k * p * std::pow(theta / a, p - 1.0); };
  return {next_temperature(rate, slope, x[3], x[4])};
}

}  // namespace

int main(int argc, char** argv) {
  return driver::answer(argc, argv,
                        {{"temperature_rate", of_the_rate}, {"cooled", of_cooling}, {"next_temperature", of_a_step}});
}
