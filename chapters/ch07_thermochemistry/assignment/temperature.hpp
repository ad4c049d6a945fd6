#pragma once

#include <functional>

/// @file
/// The header to keep: write these functions in temperature.cpp, and change nothing here. Only your variant is to be
/// coded, which the head of the score table names: run the check once to learn it.

/// A sphere of one temperature.
struct Sphere {
  double b = 0.0;  ///< radius [m]
  double m = 0.0;  ///< mass [kg]
  double c = 0.0;  ///< heat capacity [J/(kg K)]
};

/// What takes its heat.
struct Surroundings {
  double h_c = 0.0;         ///< coefficient of convection [W/(m^2 K)]
  double theta_o = 0.0;     ///< temperature of the fluid around it [K]
  double emissivity = 0.0;  ///< epsilon, 0 to 1 [-]
  double theta_s = 0.0;     ///< temperature of what it radiates to [K]
};

/// Rate at which a sphere's temperature changes, by convection and radiation.
/// @param sphere  the sphere
/// @param around  what takes its heat
/// @param theta   its temperature [K]
/// @return the rate of the brief [K/s]
double temperature_rate(const Sphere& sphere, const Surroundings& around, double theta);

/// A rate, or how it changes with the temperature, at a temperature [K].
using Function = std::function<double(double theta)>;

/// One implicit step of a temperature, of any rate that falls where the temperature rises.
/// @param rate   f, continuous [K/s]
/// @param slope  its derivative f', <= 0 [1/s]
/// @param theta  temperature at the start of the step [K]
/// @param dt     the step, >= 0 [s]
/// @return temperature at its end, the equation of your variant solved to rounding [K]
double next_temperature(const Function& rate, const Function& slope, double theta, double dt);
