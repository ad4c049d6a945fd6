#pragma once

#include <cmath>

#include <particulate/kinematics/domain.hpp>
#include <particulate/laws/law.hpp>

namespace particulate::thermo {

/// A reaction that heats itself, at a rate that rises with temperature after Arrhenius.
///
/// \f[ c\,\dot\theta = P\, e^{-T_a/\theta} \f]
///
/// @equation{R 7.4.2} With P = c B: nothing is used up, so that the temperature runs away.
struct Arrhenius {
  double power = 0.0;  ///< P, per unit mass, >= 0 [W/kg]
  double T_a = 1e4;    ///< activation temperature, > 0 [K]
};

/// Refuses constants that are no reaction. Called once, where a law enters a scene.
///
/// @param law  the constants
/// @throws std::invalid_argument naming the constant, what must hold and what was given
void validate(const Arrhenius& law);

/// Adds the heat that each particle sets free.
///
/// @equation{R 7.4.2}
/// @param law   constants that validate() accepts
/// @param at    the particles
/// @param heat  receives the flows, added to what it holds, N [W]
/// @return true; at 0 K nothing reacts
template <kinematics::Domain D>
bool add_heat(const Arrhenius& law, const D&, const laws::At<laws::Temperature>& at, laws::Heats heat) {
  for (Eigen::Index i = 0; i < heat.size(); ++i) {
    heat[i] += at.mass[i] * law.power * std::exp(-law.T_a / at.temperature[i]);
  }
  return true;
}

/// Appends the slopes of that heat, \f$ m P\, e^{-T_a/\theta}\, T_a/\theta^2 \f$.
///
/// @equation{D 7.4.2}
/// @param law     constants that validate() accepts
/// @param at      the particles
/// @param slopes  receives N entries; near 0 K none is left [W/K]
template <kinematics::Domain D>
void add_heat_slopes(const Arrhenius& law, const D&, const laws::At<laws::Temperature>& at, laws::HeatSlopes& slopes) {
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    const double theta = at.temperature[i], share = std::exp(-law.T_a / theta);
    slopes.emplace_back(i, i, share > 0.0 ? at.mass[i] * law.power * share * law.T_a / theta / theta : 0.0);
  }
}

/// Time in which a temperature runs from one value to another.
///
/// \f[ t = G(\theta) - G(\theta_0), \qquad
///     G(x) = \frac1B \left(x\, e^{T_a/x} - T_a \operatorname{Ei}(T_a/x)\right), \qquad
///     \dot\theta = B\, e^{-T_a/\theta} \f]
///
/// @equation{D 7.4.2}
/// @param B        > 0 [K/s]
/// @param T_a      activation temperature, > 0 [K]
/// @param theta_0  at the start, above T_a/700 [K]
/// @param theta    at the end, >= theta_0 [K]
/// @return t [s]
/// @throws std::invalid_argument for temperatures out of order, or so low that e^u is too large
double runaway_time(double B, double T_a, double theta_0, double theta);

}  // namespace particulate::thermo
