#pragma once

#include <cmath>

/// @file
/// Pressures, each law a value with its constants: `pressure(law, rho, theta)` and `speed_of_sound(law, rho, theta,
/// c)`; of a barotropic fluid, which has no temperature, `pressure(law, rho)` and `speed_of_sound(law, rho)`.
///
/// The energy per mass is c theta throughout. After the laws of thermodynamics an energy may depend on temperature
/// alone only if P is proportional to theta: of these laws that is the ideal gas. The others balance energy all the
/// same; all work of compression then shows as heat, and is had back in expansion.
///
/// Where heat neither flows nor comes, and nothing is dissipated, \f$ \rho c\, \dot\theta = -P\, \nabla \cdot v \f$. A
/// sound wave follows that line, so that
///
/// \f[ \frac{d\theta}{d\rho} = \frac{P}{\rho^2 c}, \qquad
///     c_s^2 = \frac{\partial P}{\partial \rho} + \frac{\partial P}{\partial \theta}\, \frac{P}{\rho^2 c} . \f]

namespace particulate::continuum {

/// A liquid near a state that is known.
///
/// \f[ P = P_R + Y \left( \frac{\rho}{\rho_R} - 1 + a_{th} (\theta - \theta_R) \right) \f]
///
/// @equation{R A.8} It leaves out that compression stiffens, that liquids boil (P may turn negative), and the energy of
/// compression itself.
struct LinearizedState {
  double P_R = 1e5;        ///< pressure of the known state [Pa]
  double Y = 1e9;          ///< bulk modulus at constant temperature, > 0 [Pa]
  double rho_R = 1000.0;   ///< its density, > 0 [kg/m^3]
  double theta_R = 300.0;  ///< its temperature, > 0 [K]
  double a_th = 1e-7;      ///< thermal expansion at constant pressure, of rho/rho_R, either sign [1/K]
};

/// Points without size or forces between them.
///
/// \f[ P = \rho R\, \theta \f]
///
/// @equation{D A.8} It leaves out condensation, and that c grows with temperature. gamma = 1 + R/c.
struct IdealGas {
  double R = 287.05287;  ///< gas constant per mass, > 0; the default is that of air [J/(kg K)]
};

/// A fluid whose pressure knows density alone.
///
/// \f[ P = P_R + Y \left( \frac{\rho}{\rho_R} - 1 \right) \f]
///
/// @equation{R A.8} LinearizedState with a_th = 0. It leaves out temperature, and with it the energy equation.
struct Barotropic {
  double P_R = 1e5;       ///< pressure of the known state [Pa]
  double Y = 1e9;         ///< bulk modulus, > 0 [Pa]
  double rho_R = 1000.0;  ///< its density, > 0 [kg/m^3]
};

/// Refuses constants that are no equation of state. Called once, where a law enters.
///
/// @param law  the constants
/// @throws std::invalid_argument naming the constant, what must hold and what was given
void validate(const LinearizedState& law);
/// Refuses constants that are no ideal gas.
///
/// @param law  the constants
/// @throws std::invalid_argument naming the constant, what must hold and what was given
void validate(const IdealGas& law);
/// Refuses constants that are no barotropic law.
///
/// @param law  the constants
/// @throws std::invalid_argument naming the constant, what must hold and what was given
void validate(const Barotropic& law);

/// @copybrief LinearizedState
///
/// @param law    constants that validate() accepts
/// @param rho    density [kg/m^3]
/// @param theta  temperature [K]
/// @return P [Pa]
template <class S>
S pressure(const LinearizedState& law, S rho, S theta) {
  return law.P_R + law.Y * (rho / law.rho_R - 1.0 + law.a_th * (theta - law.theta_R));
}
/// @copybrief IdealGas
///
/// @param law    constants that validate() accepts
/// @param rho    density [kg/m^3]
/// @param theta  temperature [K]
/// @return P [Pa]
template <class S>
S pressure(const IdealGas& law, S rho, S theta) {
  return rho * law.R * theta;
}
/// @copybrief Barotropic
///
/// @param law  constants that validate() accepts
/// @param rho  density [kg/m^3]
/// @return P [Pa]
template <class S>
S pressure(const Barotropic& law, S rho) {
  return law.P_R + law.Y * (rho / law.rho_R - 1.0);
}

/// Speed of sound of a linearized fluid.
///
/// \f[ c_s^2 = \frac{Y}{\rho_R} + \frac{Y a_{th} P}{\rho^2 c} \f]
///
/// @equation{D A.8} Along the line that the energy balance with e = c theta has a wave follow.
/// @param law    constants that validate() accepts
/// @param rho    density, > 0 [kg/m^3]
/// @param theta  temperature [K]
/// @param c      heat capacity per mass, > 0 [J/(kg K)]
/// @return c_s; NaN where tension is so large that there are no waves [m/s]
inline double speed_of_sound(const LinearizedState& law, double rho, double theta, double c) {
  return std::sqrt(law.Y / law.rho_R + law.Y * law.a_th * pressure(law, rho, theta) / (rho * rho * c));
}
/// Speed of sound of an ideal gas, \f$ c_s^2 = \gamma R\, \theta \f$ with \f$ \gamma = 1 + R/c \f$.
///
/// @equation{D A.8}
/// @param law    constants that validate() accepts
/// @param theta  temperature, >= 0 [K]
/// @param c      heat capacity per mass at constant volume, > 0 [J/(kg K)]
/// @return c_s, at any density [m/s]
inline double speed_of_sound(const IdealGas& law, double, double theta, double c) {
  return std::sqrt((1.0 + law.R / c) * law.R * theta);
}
/// Speed of sound of a barotropic fluid, \f$ c_s^2 = Y/\rho_R \f$.
///
/// @equation{D A.8}
/// @param law  constants that validate() accepts
/// @return c_s, at any density [m/s]
inline double speed_of_sound(const Barotropic& law, double) { return std::sqrt(law.Y / law.rho_R); }

}  // namespace particulate::continuum
