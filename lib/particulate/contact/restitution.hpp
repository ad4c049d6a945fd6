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

/// A restitution that falls with temperature as well: optional, and ours.
///
/// \f[ e = \max\!\left(e_o \left\langle 1 - \frac{u}{v^*} \right\rangle s(\theta_m),\; e^-\right), \qquad
///     s = \min\!\left(\left\langle 1 - \frac{\theta_m - \theta_r}{\theta^* - \theta_r} \right\rangle, 1\right) \f]
///
/// @equation{R 7.4.1} \f$ \langle x \rangle = \max(x, 0) \f$; the mean of the temperatures of the two bodies counts,
/// and of a wall nothing. Below theta_r nothing changes, so that e never exceeds e_o.
struct SofteningRestitution {
  Restitution cold = {};      ///< at theta_r and below
  double theta_r = 300.0;     ///< reference, >= 0 [K]
  double theta_star = 600.0;  ///< at which nothing but e_minus is left, above theta_r [K]
};

/// Refuses constants that are no restitution law. Called once, where a law enters a scene.
///
/// @param law  the constants
/// @throws std::invalid_argument naming the constant, what must hold and what was given
void validate(const SofteningRestitution& law);

/// What is left of a restitution at a temperature.
///
/// @equation{R 7.4.1}
/// @param law    constants that validate() accepts
/// @param theta  mean temperature of the two bodies, >= 0 [K]
/// @return s, 0 to 1 [-]
inline double softening(const SofteningRestitution& law, double theta) {
  return std::clamp(1.0 - (theta - law.theta_r) / (law.theta_star - law.theta_r), 0.0, 1.0);
}

/// Coefficient of restitution at an approach speed and a temperature.
///
/// @equation{R 7.4.1}
/// @param law             constants that validate() accepts
/// @param approach_speed  >= 0 [m/s]
/// @param softened        softening() of the pair [-]
/// @return e [-]
inline double restitution_at(const SofteningRestitution& law, double approach_speed, double softened) {
  const Restitution& cold = law.cold;
  return std::max(cold.e_o * std::max(1.0 - approach_speed / cold.v_star, 0.0) * softened, cold.e_minus);
}

/// The same of a restitution that softens: as if it stayed cold, which is the most that it can be.
///
/// @equation{D 2.4.2}
/// @param law    constants that validate() accepts
/// @param speed  after the first impact, >= 0 [m/s]
/// @return sum [m/s]
inline double speeds_to_come(const SofteningRestitution& law, double speed) { return speeds_to_come(law.cold, speed); }

}  // namespace particulate::contact
