#pragma once

#include <particulate/kinematics/central_force.hpp>
#include <particulate/kinematics/particles.hpp>

namespace particulate::kinematics {

/// Units that make a scene dimensionless: \f$ r = L r^* \f$, \f$ t = \tau t^* \f$, \f$ m = M m^* \f$.
struct Scales {
  double length = 1.0;  ///< L > 0 [m]
  double time = 1.0;    ///< tau > 0 [s]
  double mass = 1.0;    ///< M > 0 [kg]
};

/// Refuses scales that are none.
///
/// @param scales  the units
/// @throws std::invalid_argument if one is not positive and finite
void validate(const Scales& scales);

/// The dimensionless numbers of a scene with near fields; scenes that agree in all of them move alike.
///
/// \f[ \pi_1 = \alpha_1 m \tau^2 L^{-\beta_1-1}, \quad \pi_2 = \alpha_2 m \tau^2 L^{-\beta_2-1}, \quad
///     \frac{v\,\tau}{L}, \quad \frac{b}{L}, \quad \frac{\Delta t}{\tau} \f]
///
/// @equation{D 1.4.3} Strengths are per unit mass squared, as below (2.3). Restitution, friction, gamma and TOL have no
/// dimension and must agree as they are.
struct SimilarityGroups {
  double attraction = 0.0;  ///< pi_1 [-]
  double repulsion = 0.0;   ///< pi_2 [-]
  double speed = 0.0;       ///< v tau / L [-]
  double radius = 0.0;      ///< b / L [-]
  double step = 0.0;        ///< Delta t / tau [-]
};

/// The dimensional numbers that the groups are made of.
struct Dimensional {
  CentralForce law;     ///< strengths per unit mass squared [N m^beta / kg^2]
  double mass = 0.0;    ///< a typical mass m [kg]
  double speed = 0.0;   ///< a typical speed v [m/s]
  double radius = 0.0;  ///< a typical radius b [m]
  double step = 0.0;    ///< Delta t [s]
};

/// Groups of a scene.
///
/// @equation{D 1.4.3}
/// @param scene   its dimensional numbers
/// @param scales  length and time that make it dimensionless; the mass is the scene's own
/// @return the five numbers
/// @throws std::invalid_argument if a scale is not positive and finite
SimilarityGroups similarity_groups(const Dimensional& scene, const Scales& scales);

/// The near field that, among particles scaled by `scales`, keeps both groups of this one.
///
/// \f[ \alpha_k' = \alpha_k\, \frac{L^{\beta_k+1}}{M\,\tau^2} \f]
///
/// @equation{D 1.4.3} Exact to the last bit when L, tau, M and every L^beta are powers of two.
/// @param law     strengths per unit mass squared
/// @param scales  ratio of the new scene's units to the old one's
/// @return strengths of the scaled scene, the same exponents
/// @throws std::invalid_argument if a scale is not positive and finite
CentralForce scaled(const CentralForce& law, const Scales& scales);

/// The same start in other units: positions and radii times L, velocities times L/tau, masses times M.
///
/// @equation{D 1.4.3}
/// @param particles  a start
/// @param scales     ratio of the new scene's units to the old one's
/// @return the scaled start
/// @throws std::invalid_argument if a scale is not positive and finite
Particles scaled(const Particles& particles, const Scales& scales);

}  // namespace particulate::kinematics
