#pragma once

#include <particulate/contact/contact.hpp>

namespace particulate::thermo {

/// What becomes of the energy of impacts, Stage I: kinetic energy that an impact takes becomes heat of the two bodies,
/// and so does the chemical energy that it sets free.
///
/// \f[ m_i c_i\, \Delta\theta_i + m_j c_j\, \Delta\theta_j = q + H, \qquad q = T - T' + W_E, \qquad
///     H = \kappa \min\!\left(\frac{J}{J^*}, 1\right) \pi \min(b_i, b_j)^2 \f]
///
/// @equation{R 7.4.1} J is the normal impulse. J* is an impulse and not a force times the duration of a step, so that
/// the heat converges with the step. Each of the two takes its share; what is immovable, and a wall, takes none, and
/// the other all of it. A law beside a contact, whose recorder it listens to.
struct ImpactHeat {
  double kappa = 0.0;   ///< energy per area of a full reaction, >= 0 [J/m^2]
  double J_star = 1.0;  ///< impulse J* from which on the reaction is full, > 0 [N s]
};

/// Refuses constants that are no heat. Called once, where a law enters a scene.
///
/// @param law  the constants
/// @throws std::invalid_argument naming the constant, what must hold and what was given
void validate(const ImpactHeat& law);

/// Chemical energy that an impact sets free.
///
/// @equation{R 7.4.1}
/// @param law     constants that validate() accepts
/// @param J       normal impulse, >= 0 [N s]
/// @param radius  the smaller radius [m]
/// @return H [J]
double released_energy(const ImpactHeat& law, double J, double radius);

/// Kinetic energy that an impact takes, by its impulses times the mean relative velocity that they act on.
///
/// @equation{D 7.4.1}
/// @param impact  as it was resolved, without the work of other forces during it
/// @return q [J]
double dissipated_energy(const contact::ImpactRecord& impact);

/// Adds the heat of one impact.
///
/// @equation{R 7.4.1}
/// @param law     constants that validate() accepts
/// @param at      the particles
/// @param impact  as it was resolved
/// @param heat    of each particle, N; receives the heat, added to what it holds [J]
/// @return H [J]
double add_heat_of_impact(const ImpactHeat& law, const laws::At<laws::Temperature>& at,
                          const contact::ImpactRecord& impact, schemes::Out heat);

}  // namespace particulate::thermo
