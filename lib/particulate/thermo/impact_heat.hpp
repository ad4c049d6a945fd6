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
/// the heat converges with the step; where a force F holds two together, at the rate \f$ \kappa \pi b^2 F/J^* \f$ for
/// as long as it does, as nothing is used up. Each of the two takes its share; what is immovable, and a wall, takes
/// none, and the other all of it. A law beside a contact, whose recorder it listens to.
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

/// Energy that an impact takes: its impulses times the mean relative velocity that they act on.
///
/// \f[ q = T - T' + W_E \f]
///
/// @equation{D 7.4.1} Where an impact lasts (gamma > 0) the other forces, which are constant over it, have a part in
/// that mean, so that W_E is their work in both phases: of one contact q is normal_heat(), never negative, and the work
/// of friction, negative only where the other forces turn the slip around meanwhile. Of contacts that are held it is
/// negative where they work off an overlap, and gives back what sinking into it took. The step that follows applies the
/// other forces again, so that in a scene kinetic energy and heat then add up to what they were but for O(gamma Dt) an
/// impact; without duration, to rounding.
/// @param impact  as it was resolved
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
