#pragma once

#include <cmath>

/// @file
/// How viscosity depends on temperature, each law a value with its constants: `viscosity(law, theta)`.

namespace particulate::continuum {

/// A viscosity that is the same at all temperatures, \f$ \mu(\theta) = \mu \f$.
///
/// @equation{D A.8}
struct ConstantViscosity {
  double mu = 1e-3;  ///< >= 0 [Pa s]
};

/// A viscosity that falls as a liquid warms, or with c_mu < 0 rises.
///
/// \f[ \mu = \mu_R\, e^{c_\mu (\theta_R/\theta - 1)} \f]
///
/// @equation{R A.8} Beyond the range of a double, below \f$ \theta_R c_\mu/(709 + c_\mu) \f$ or so, it is infinite.
struct ExponentialViscosity {
  double mu_R = 1e-3;      ///< at theta_R, >= 0 [Pa s]
  double c_mu = 5.0;       ///< how fast it falls: at theta_R by c_mu/theta_R a kelvin, of itself [-]
  double theta_R = 300.0;  ///< > 0 [K]
};

/// Refuses constants that are no viscosity. Called once, where a law enters.
///
/// @param law  the constants
/// @throws std::invalid_argument naming the constant, what must hold and what was given
void validate(const ConstantViscosity& law);
/// Refuses constants that are no viscosity.
///
/// @param law  the constants
/// @throws std::invalid_argument naming the constant, what must hold and what was given
void validate(const ExponentialViscosity& law);

/// @copybrief ConstantViscosity
///
/// @param law  constants that validate() accepts; a temperature need not be given
/// @return mu, at any temperature [Pa s]
template <class S = double>
S viscosity(const ConstantViscosity& law, S = 0.0) {
  return law.mu;
}
/// @copybrief ExponentialViscosity
///
/// @param law    constants that validate() accepts
/// @param theta  temperature, > 0 [K]
/// @return mu [Pa s]
template <class S>
S viscosity(const ExponentialViscosity& law, S theta) {
  return law.mu_R * std::exp(law.c_mu * (law.theta_R / theta - 1.0));
}

}  // namespace particulate::continuum
