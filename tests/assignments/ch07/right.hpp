#pragma once

#include <cmath>
#include <numbers>

#include "temperature.hpp"

// What a student may well write, for both variants.
namespace right {

constexpr double B = 5.670374419e-8;

inline double surface(const Sphere& sphere) { return 4.0 * std::numbers::pi * sphere.b * sphere.b; }

inline double flux(const Surroundings& around, double theta) {
  return -around.h_c * (theta - around.theta_o) -
         B * around.emissivity * (std::pow(theta, 4.0) - std::pow(around.theta_s, 4.0));
}

inline double rate(const Sphere& sphere, const Surroundings& around, double theta) {
  return surface(sphere) * flux(around, theta) / (sphere.m * sphere.c);
}

// By Newton's method; phi is the share of the rate at the end.
inline double step(const Function& f, const Function& slope, double theta, double dt, double phi,
                   int iterations = 1000) {
  double x = theta;
  for (int k = 0; k < iterations; ++k) {
    const double misses = x - theta - dt * (phi * f(x) + (1.0 - phi) * f(theta));
    const double next = x - misses / (1.0 - dt * phi * slope(x));
    if (next == x) break;
    x = next;
  }
  return x;
}

inline double euler(const Function& f, const Function& slope, double theta, double dt) {
  return step(f, slope, theta, dt, 1.0);
}

inline double trapezoidal(const Function& f, const Function& slope, double theta, double dt) {
  return step(f, slope, theta, dt, 0.5);
}

}  // namespace right
