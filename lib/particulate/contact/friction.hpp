#pragma once

#include <Eigen/Core>

namespace particulate::contact {

/// Coulomb's two coefficients.
struct Friction {
  double mu_s = 0.0;  ///< static: the largest ratio of tangential to normal impulse that sticks, >= mu_d [-]
  double mu_d = 0.0;  ///< dynamic: that ratio while it slides, >= 0 [-]
};

/// Without friction: a contact that carries this has no tangential code at all.
struct Frictionless {};

/// Refuses coefficients that are no friction law. Called once, where a law enters a scene.
///
/// @param law  the coefficients
/// @throws std::invalid_argument naming the coefficient, what must hold and what was given
void validate(const Friction& law);

/// Tangential impulse on particle i through an impact: it sticks if it can, else it slides.
///
/// \f[ P_{stick} = -\frac{u_t + \Delta_t}{1/m_i + 1/m_j}, \qquad
///     P = P_{stick} \text{ if } \|P_{stick}\| \le \mu_s |J|, \text{ else }
///     P = \mu_d |J|\, \frac{P_{stick}}{\|P_{stick}\|} \f]
///
/// @equation{M 2.30} The monograph's force F_f times the duration of the impact, with the other sign because it acts on
/// i; written in impulses it has a limit as the duration vanishes. With \f$ \mu_d \le \mu_s \f$ sliding friction is
/// smaller than the one that sticks, so it never reverses the sliding.
/// @param law             coefficients that validate() accepts
/// @param slip            \f$ u_t + \Delta_t \f$: tangential velocity of i relative to j before the impact, plus
///                        what the other forces add to it meanwhile [m/s]
/// @param reduced_mass    \f$ 1/(1/m_i + 1/m_j) \f$, finite [kg]
/// @param normal_impulse  |J| >= 0 [N s]
/// @return impulse on i; the opposite acts on j [N s]
Eigen::Vector3d tangential_impulse(const Friction& law, const Eigen::Vector3d& slip, double reduced_mass,
                                   double normal_impulse);

/// Tangential impulses of several contacts that hang together: which stick and which slide is decided together.
///
/// \f[ P = \arg\min\; P \cdot (s + \tfrac12 W P) \quad \text{over} \quad \|P_k\| \le p_k, \f]
///
/// the least kinetic energy that friction up to \f$ p_k \f$ can leave. First \f$ p_k = \mu_s |J_k| \f$ everywhere. A
/// contact that slips even so slides, and may hold \f$ p_k = \mu_d |J_k| \f$ from then on, until no other one slips. So
/// what sticks has no slip and \f$ \|P_k\| \le \mu_s |J_k| \f$; what slides has \f$ \mu_d |J_k| \f$ against the slip
/// that is left. The slips left are unique; of many impulses that stop all slip the least of \f$ \sum_k
/// \|P_k\|^2/p_k \f$ are taken. No impulse at all is among those compared, so energy never rises. One contact gets
/// what tangential_impulse() gives.
///
/// @equation{D 2.30} (2.30) for each contact, with the slip that the friction of its neighbours leaves.
/// @param law              coefficients that validate() accepts
/// @param W                how the impulses change the slips, two rows a contact, diagonal 1/m* of each [1/kg]
/// @param slip             slips before, each in two directions across the normal [m/s]
/// @param normal_impulses  |J_k| >= 0 [N s]
/// @param given            friction that acts already and is decided anew, zero if none: where sliding contacts would
///                         give energy back, those that slip keep \f$ \mu_s |J_k| \f$ [N s]
/// @return impulses, those given included; empty if the minimum is not reached in 2000 rounds [N s]
Eigen::VectorXd tangential_impulses(const Friction& law, const Eigen::MatrixXd& W, const Eigen::VectorXd& slip,
                                    const Eigen::VectorXd& normal_impulses, const Eigen::VectorXd& given);

/// Friction coefficient that just stops the sliding, the largest that the sliding formula allows, and the one that
/// takes most energy.
///
/// \f[ \mu_d^* = \frac{\|u_t\|}{(1 + e)\, u_n} \f]
///
/// @equation{M 2.49} Printed for two equal particles; it holds for any masses [D].
/// @param tangential_speed  \f$ \|u_t\| \f$, >= 0 [m/s]
/// @param approach_speed    \f$ u_n \f$, > 0 [m/s]
/// @param e                 restitution, 0 <= e <= 1 [-]
/// @return mu_d* [-]
inline double stopping_friction(double tangential_speed, double approach_speed, double e) {
  return tangential_speed / ((1.0 + e) * approach_speed);
}

}  // namespace particulate::contact
