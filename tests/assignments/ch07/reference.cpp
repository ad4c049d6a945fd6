// The library's flux, and Newton's method, variant 1.
// graded: --variant 1 --student anna|bob@school.edu|1234567|carla-7 -> 20

#include <particulate/thermo/cooling.hpp>

#include "temperature.hpp"

namespace thermo = particulate::thermo;

double temperature_rate(const Sphere& sphere, const Surroundings& around, double theta) {
  const thermo::Cooling law{around.h_c, around.theta_o, around.emissivity, around.theta_s};
  return thermo::surface(sphere.b) * thermo::heat_flux(law, theta) / (sphere.m * sphere.c);
}

double next_temperature(const Function& rate, const Function& slope, double theta, double dt) {
  double next = theta;
  for (int k = 0; k < 200; ++k) next -= (next - theta - dt * rate(next)) / (1.0 - dt * slope(next));
  return next;
}
