#pragma once

#include <cmath>

#include <Eigen/Core>

namespace particulate::kinematics {

/// The monograph's force towards a centre: attraction and repulsion, each a power of the distance.
///
/// \f[ C(d) = \alpha_1 d^{-\beta_1} - \alpha_2 d^{-\beta_2} \f]
///
/// @equation{M 1.30} Signs of the exponents as in (2.3): both powers fall with distance. Given for one pair: the
/// constants carry whatever masses or areas scale them.
struct CentralForce {
  double alpha1 = 0.0;  ///< strength of attraction, >= 0 [N m^beta1]
  double alpha2 = 0.0;  ///< strength of repulsion, >= 0 [N m^beta2]
  double beta1 = 1.0;   ///< exponent of attraction, >= 0 [-]
  double beta2 = 2.0;   ///< exponent of repulsion, >= 0 [-]
};

/// Refuses constants that are no central force. Called once, where a law enters a scene or a run.
///
/// @param law  the constants
/// @throws std::invalid_argument naming the constant, what must hold and what was given
void validate(const CentralForce& law);

/// Real power that is formed by multiplication where the exponent is a small whole number.
///
/// Products of powers of two are exact, so scenes that are scaled by powers of two keep their bits (section 1.4.3);
/// the near field's kernel forms its powers the same way.
///
/// @param x         base, >= 0
/// @param exponent  exponent, finite
/// @return x^exponent
double power(double x, double exponent);

/// Strength of the force towards the centre, attraction positive.
///
/// \f[ C(d) = \alpha_1 d^{-\beta_1} - \alpha_2 d^{-\beta_2} \f]
///
/// @equation{M 1.30}
/// @param law  constants that validate() accepts
/// @param d    distance to the centre, > 0 [m]
/// @return C, positive where it attracts (1.28), negative where it repels (1.29) [N]
double strength(const CentralForce& law, double d);

/// Force on a particle at r.
///
/// \f[ \Psi = C(\|r - r_o\|)\, n, \qquad n = \frac{r_o - r}{\|r - r_o\|} \f]
///
/// @equation{M 1.26}
/// @param law  constants that validate() accepts
/// @param r    place of the particle, not the centre [m]
/// @param r_o  the centre [m]
/// @return force on the particle [N]
/// @throws std::invalid_argument if r is the centre, where the direction is not defined
Eigen::Vector3d force(const CentralForce& law, const Eigen::Vector3d& r, const Eigen::Vector3d& r_o);

/// Potential energy, measured from a reference distance.
///
/// \f[ V(d) - V(d_{ref}) = \sum_k \pm \alpha_k\, d_{ref}^{1-\beta_k}\,
///     \frac{\operatorname{expm1}\big((1-\beta_k)\ln(d/d_{ref})\big)}{1-\beta_k}, \qquad \Psi = -\nabla V \f]
///
/// @equation{D 1.33} The printed V has no limit at beta = 1, its additive constant diverges; the difference has one,
/// \f$ \alpha \ln(d/d_{ref}) \f$, and is what stands here. Energies compare only with one reference distance.
/// @param law    constants that validate() accepts
/// @param d      distance to the centre, > 0 [m]
/// @param d_ref  distance at which V = 0, > 0 [m]
/// @return V(d) - V(d_ref) [J]
double potential(const CentralForce& law, double d, double d_ref = 1.0);

/// Stiffness along the line of centres, the slope of the force.
///
/// \f[ V''(d) = C'(d) = -\alpha_1\beta_1 d^{-\beta_1-1} + \alpha_2\beta_2 d^{-\beta_2-1} \f]
///
/// @equation{D 1.34}
/// @param law  constants that validate() accepts
/// @param d    distance to the centre, > 0 [m]
/// @return V'' [N/m]
double normal_stiffness(const CentralForce& law, double d);

/// Stiffness across the line of centres.
///
/// \f[ \frac{V'(d)}{d} = \frac{C(d)}{d} \f]
///
/// @equation{D 1.36} The double eigenvalue of the Hessian of V. It is zero at the equilibrium distance and only there:
/// the neutrality that the monograph states.
/// @param law  constants that validate() accepts
/// @param d    distance to the centre, > 0 [m]
/// @return V'/d [N/m]
double transverse_stiffness(const CentralForce& law, double d);

/// Distance at which attraction and repulsion balance.
///
/// \f[ d_e = \left(\frac{\alpha_2}{\alpha_1}\right)^{1/(\beta_2-\beta_1)} \f]
///
/// @equation{D 1.30}
/// @param law  constants that validate() accepts, both strengths positive, exponents different
/// @return d_e [m]
/// @throws std::invalid_argument if the law balances nowhere or everywhere, or at no distance that a double can hold
double equilibrium_distance(const CentralForce& law);

/// Distance beyond which the law is no longer convex along the line of centres: its inflection.
///
/// \f[ d^* = \left(\frac{\beta_2 \alpha_2}{\beta_1 \alpha_1}\right)^{1/(\beta_2-\beta_1)}
///        = \left(\frac{\beta_2}{\beta_1}\right)^{1/(\beta_2-\beta_1)} d_e, \qquad V''(d^*) = 0 \f]
///
/// @equation{D 7.3}
/// @param law  constants that validate() accepts, with an equilibrium
/// @return d*; infinite where beta1 <= 0, as the attraction then never falls [m]
/// @throws std::invalid_argument as equilibrium_distance()
double inflection_distance(const CentralForce& law);

/// Whether the equilibrium is stable along the line of centres, which it is iff \f$ \beta_2 > \beta_1 \f$.
///
/// @equation{M 1.36} From \f$ V''(d_e) = \alpha_1 d_e^{-\beta_1-1}(\beta_2-\beta_1) \f$.
/// @param law  constants that have an equilibrium
/// @return true if V has a minimum there
/// @throws std::invalid_argument as equilibrium_distance()
bool is_stable(const CentralForce& law);

/// Period of small oscillations of two bodies about their equilibrium distance.
///
/// \f[ T = 2\pi\sqrt{\frac{m^*}{V''(d_e)}}, \qquad m^* = \frac{m_i m_j}{m_i + m_j} \f]
///
/// @equation{D 1.36}
/// @param law  constants of the pair, with a stable equilibrium
/// @param m_i  mass of one body, > 0 [kg]
/// @param m_j  mass of the other, > 0 [kg]
/// @return period [s]
/// @throws std::invalid_argument if the equilibrium is not stable or a mass is not positive and finite
double small_oscillation_period(const CentralForce& law, double m_i, double m_j);

/// Reduced mass of two bodies.
///
/// \f[ m^* = \frac{m_i m_j}{m_i + m_j} \f]
///
/// @equation{D 1.4}
/// @param m_i  mass of one body, > 0 [kg]
/// @param m_j  mass of the other, > 0 [kg]
/// @return m*, finite wherever both masses are [kg]
inline double reduced_mass(double m_i, double m_j) { return 1.0 / (1.0 / m_i + 1.0 / m_j); }

}  // namespace particulate::kinematics
