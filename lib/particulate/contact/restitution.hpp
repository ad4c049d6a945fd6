#pragma once

#include <algorithm>
#include <limits>

namespace particulate::contact {

/// How much of its approach speed a pair keeps through an impact, and how that falls with the severity of the impact.
///
/// The defaults keep everything, at any speed: no critical speed, no floor. A restitution that does not fall is
/// ConstantRestitution.
struct Restitution {
  double e_o = 1.0;                                         ///< of a gentle impact, 0 <= e_o <= 1 [-]
  double v_star = std::numeric_limits<double>::infinity();  ///< critical approach speed v*, > 0 [m/s]
  double e_minus = 0.0;                                     ///< floor e^-, 0 <= e_minus <= e_o [-]
};

/// Refuses constants that are no restitution law. Called once, where a law enters a scene.
///
/// @param law  the constants
/// @throws std::invalid_argument naming the constant, what must hold and what was given
void validate(const Restitution& law);

/// Coefficient of restitution at an approach speed.
///
/// \f[ e = \max\!\left(e_o\left(1 - \frac{|v_{in} - v_{jn}|}{v^*}\right),\; e^-\right) \f]
///
/// @equation{R 2.4.2} The monograph idealizes the measured curve in words and in its Figure 2.4; the expression is
/// ours.
/// @param law             constants that validate() accepts
/// @param approach_speed  normal speed at which the pair closes before the impact, >= 0 [m/s]
/// @return e, between law.e_minus and law.e_o [-]
inline double restitution_at(const Restitution& law, double approach_speed) {
  return std::max(law.e_o * (1.0 - approach_speed / law.v_star), law.e_minus);
}

/// Sum of the speeds at which a ball leaves an impact and all that follow it, each as fast as the one before left it.
///
/// \f[ w_0 + w_1 + w_2 + \dots, \qquad w_{k+1} = e(w_k)\, w_k \f]
///
/// @equation{D 2.4.2} Under a constant acceleration a every flight takes 2 w/a. Summed until the rest is that of a
/// constant e_o. With e_o = 1 it has no end: w falls as v*/k.
/// @param law    constants that validate() accepts
/// @param speed  after the first impact, >= 0 [m/s]
/// @return sum, infinite if there is no end of it [m/s]
double speeds_to_come(const Restitution& law, double speed);

/// The same share of the approach speed at any speed: a contact that carries this asks for no speed at all.
struct ConstantRestitution {
  double e = 1.0;  ///< 0 <= e <= 1 [-]
};

/// Refuses a coefficient that is none. Called once, where a law enters a scene.
///
/// @param law  the coefficient
/// @throws std::invalid_argument saying what must hold and what was given
void validate(const ConstantRestitution& law);

/// Coefficient of restitution that does not fall.
///
/// @equation{M 2.13}
/// @param law  a coefficient that validate() accepts
/// @return e, whatever the approach speed [-]
inline double restitution_at(const ConstantRestitution& law, double) { return law.e; }

/// The same of a restitution that does not fall: a geometric series.
///
/// @equation{D 2.13}
/// @param law    a coefficient that validate() accepts
/// @param speed  after the first impact, >= 0 [m/s]
/// @return speed/(1 - e), infinite for e = 1 [m/s]
double speeds_to_come(const ConstantRestitution& law, double speed);

}  // namespace particulate::contact
