#pragma once

#include <Eigen/Core>

#include <particulate/contact/friction.hpp>
#include <particulate/contact/restitution.hpp>

namespace particulate::contact {

/// One partner of an impact.
struct Body {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< before the impact [m/s]
  double inverse_mass = 0.0;                           ///< 1/m [1/kg]; 0: immovable, a wall
};

/// The two phases of an impact.
struct Phases {
  double compression = 0.0;  ///< dt_1, until both move alike [s]
  double recovery = 0.0;     ///< dt_2 = e dt_1 [s]
};

/// Splits the duration of an impact into its phases.
///
/// \f[ \delta t = \gamma\,\Delta t = \delta t_1 + \delta t_2, \quad \delta t_2 = e\,\delta t_1, \quad
///     \delta t_1 = \frac{\gamma\,\Delta t}{1+e} \f]
///
/// @equation{M 2.18}
/// @param duration  gamma Dt, >= 0 [s]
/// @param e         restitution, 0 <= e <= 1 [-]
/// @return both phases
Phases phases(double duration, double e);

/// What all other forces do to the pair while it touches, as changes of the relative velocity of i and j.
///
/// \f[ \Delta_1 = \frac{E_i(t, t+\delta t_1)}{m_i} - \frac{E_j(t, t+\delta t_1)}{m_j}, \qquad
///     \Delta_2 \text{ likewise over the recovery} \f]
///
/// @equation{M 2.15} Vectors: the normal components enter the normal impulse, the tangential ones the friction.
struct External {
  Eigen::Vector3d compression = Eigen::Vector3d::Zero();  ///< Delta_1 [m/s]
  Eigen::Vector3d recovery = Eigen::Vector3d::Zero();     ///< Delta_2 [m/s]
};

/// Changes that constant forces make over both phases; then \f$ \Delta_2 = e\,\Delta_1 \f$.
///
/// @equation{D 2.15}
/// @param acceleration_i  of particle i by all other forces, zero if it is immovable [m/s^2]
/// @param acceleration_j  of particle j likewise [m/s^2]
/// @param phases          their durations
/// @return both changes
External external_changes(const Eigen::Vector3d& acceleration_i, const Eigen::Vector3d& acceleration_j,
                          const Phases& phases);

/// Normal impulse on particle i along n_ij, which is never a pull.
///
/// \f[ J = -(1 + e)\, m^* (u + \Delta_1), \qquad u = v_{in} - v_{jn}, \qquad m^* = \frac{1}{1/m_i + 1/m_j}, \f]
///
/// and J = 0 unless u > 0 and \f$ u + \Delta_1 > 0 \f$: the pair must approach, and go on approaching under the other
/// forces. Two immovable bodies exchange nothing either.
///
/// @equation{D 2.13} From the balances of both phases. The mean force of (2.17) is J over the duration.
/// @param u             approach speed before the impact [m/s]
/// @param delta1        normal change of it over the compression by other forces [m/s]
/// @param e             restitution, 0 <= e <= 1 [-]
/// @param reduced_mass  m*, infinite if neither body can move [kg]
/// @return J <= 0 [N s]
double normal_impulse(double u, double delta1, double e, double reduced_mass);

/// Impulse that one partner of an impact gets; the other gets its opposite.
struct Impulse {
  double normal = 0.0;                                   ///< J along n_ij, <= 0: contacts push [N s]
  Eigen::Vector3d tangential = Eigen::Vector3d::Zero();  ///< of friction, across n_ij [N s]

  /// @param n  unit vector from i to j
  /// @return the whole impulse on i [N s]
  Eigen::Vector3d total(const Eigen::Vector3d& n) const { return normal * n + tangential; }
};

/// Impulse of an impact of two bodies, without friction.
///
/// @equation{D 2.13}
/// @param i         one body
/// @param j         the other
/// @param n         unit vector from i to j
/// @param e         restitution, 0 <= e <= 1 [-]
/// @param external  what the other forces do meanwhile
/// @return impulse on i
Impulse impact_impulse(const Body& i, const Body& j, const Eigen::Vector3d& n, double e, const External& external,
                       const Frictionless&);

/// Impulse of an impact of two bodies with friction: the normal impulse first, then what of the slip it can stop.
///
/// @equation{M 2.30}
/// @param i         one body
/// @param j         the other
/// @param n         unit vector from i to j
/// @param e         restitution, 0 <= e <= 1 [-]
/// @param external  what the other forces do meanwhile
/// @param friction  coefficients that validate() accepts
/// @return impulse on i
Impulse impact_impulse(const Body& i, const Body& j, const Eigen::Vector3d& n, double e, const External& external,
                       const Friction& friction);

/// Velocities after an impact, the work of the other forces included.
struct Rebound {
  Eigen::Vector3d velocity_i = Eigen::Vector3d::Zero();  ///< of i [m/s]
  Eigen::Vector3d velocity_j = Eigen::Vector3d::Zero();  ///< of j [m/s]
  Impulse impulse;                                       ///< on i
};

/// The impact map of section 2.2 for two bodies on which constant other forces act meanwhile.
///
/// \f[ v_{in}' = \frac{m_i v_{in} + m_j v_{jn} + E_{in} + E_{jn} - m_j (e (u + \Delta_1) - \Delta_2)}{m_i + m_j}, \f]
/// \f[ v_{jn}' = v_{in}' + e (u + \Delta_1) - \Delta_2 \f]
///
/// @equation{M 2.16} Computed from impulses, which gives the same with one mass infinite. If the bodies do not meet,
/// the other forces alone act.
/// @param i               one body
/// @param j               the other
/// @param n               unit vector from i to j
/// @param e               restitution, 0 <= e <= 1 [-]
/// @param acceleration_i  of i by the other forces, zero if it is immovable [m/s^2]
/// @param acceleration_j  of j likewise [m/s^2]
/// @param duration        gamma Dt, >= 0 [s]
/// @param friction        Friction or Frictionless
/// @return velocities after the duration, and the impulse of the contact
template <class FrictionLaw>
Rebound impact(const Body& i, const Body& j, const Eigen::Vector3d& n, double e, const Eigen::Vector3d& acceleration_i,
               const Eigen::Vector3d& acceleration_j, double duration, const FrictionLaw& friction) {
  const External external = external_changes(acceleration_i, acceleration_j, phases(duration, e));
  const Impulse impulse = impact_impulse(i, j, n, e, external, friction);
  return {.velocity_i = i.velocity + i.inverse_mass * impulse.total(n) + duration * acceleration_i,
          .velocity_j = j.velocity - j.inverse_mass * impulse.total(n) + duration * acceleration_j,
          .impulse = impulse};
}

/// Energy that a frictionless contact takes from the pair, per impact.
///
/// \f[ q_n = \tfrac12\, m^* (u + \Delta_1)\left[u - e\,(e (u + \Delta_1) - \Delta_2)\right] \f]
///
/// @equation{D 7.4.1} Kinetic energy lost plus the work of the other forces, each phase with its own mean velocity.
/// Without other forces \f$ \tfrac12 m^* (1 - e^2) u^2 \f$, the loss of (2.22) for any pair.
/// @param u             approach speed, > 0 [m/s]
/// @param delta1        normal change of it by other forces over the compression, > -u [m/s]
/// @param delta2        the same over the recovery [m/s]
/// @param e             restitution, 0 <= e <= 1 [-]
/// @param reduced_mass  m*, finite [kg]
/// @return heat [J]
inline double normal_heat(double u, double delta1, double delta2, double e, double reduced_mass) {
  const double met = u + delta1;
  return 0.5 * reduced_mass * met * (u - e * (e * met - delta2));
}

}  // namespace particulate::contact
