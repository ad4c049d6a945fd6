#pragma once

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <particulate/kinematics/central_force.hpp>

/// @file
/// Turning points and periods of a pair from its energy, in extended precision and without any integrator.

namespace verification {

/// A pair that is released at rest and falls inwards.
struct ReleasedPair {
  particulate::kinematics::CentralForce law;  ///< of the pair
  long double reduced_mass;                   ///< [kg]
  long double start;                          ///< beyond the equilibrium distance [m]

  /// Integral of C from d to the start: the kinetic energy gained.
  long double fallen(long double d) const {
    const auto integral = [&](long double alpha, long double beta) {
      if (beta == 1.0L) return alpha * std::log(start / d);
      return alpha * (std::pow(start, 1.0L - beta) - std::pow(d, 1.0L - beta)) / (1.0L - beta);
    };
    return integral(law.alpha1, law.beta1) - integral(law.alpha2, law.beta2);
  }

  /// Inner turning point, by bisection between `inside`, which the pair cannot reach, and the equilibrium.
  long double nearest(long double inside, long double equilibrium) const {
    if (!(fallen(inside) < 0.0L && fallen(equilibrium) > 0.0L)) throw std::invalid_argument("no turning point between");
    for (int k = 0; k < 90; ++k) {
      const long double middle = 0.5L * (inside + equilibrium);
      (fallen(middle) < 0.0L ? inside : equilibrium) = middle;
    }
    return equilibrium;
  }

  /// T = 2 int dd / sqrt(2 fallen/m*). With d = mean - half cos(theta) the integrand is smooth and periodic in theta,
  /// where the midpoint rule converges faster than any power.
  long double period(long double near, int points) const {
    const long double mean = 0.5L * (start + near), half = 0.5L * (start - near);
    const long double width = std::numbers::pi_v<long double> / points;
    long double sum = 0.0L;
    for (int k = 0; k < points; ++k) {
      const long double theta = (k + 0.5L) * width;
      sum += half * std::sin(theta) / std::sqrt(2.0L * fallen(mean - half * std::cos(theta)) / reduced_mass);
    }
    return 2.0L * width * sum;
  }
};

}  // namespace verification
