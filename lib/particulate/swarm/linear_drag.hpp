#pragma once

#include <particulate/kinematics/domain.hpp>
#include <particulate/laws/law.hpp>

namespace particulate::swarm {

/// Drag of a medium at rest, in proportion to the velocity.
///
/// \f[ \Psi_i = -c_d\, m_i\, v_i \f]
///
/// @equation{R 6.3} It has no potential: what it takes from the energy is \f$ \int \sum_i c_d\, m_i\, v_i^2\,dt \f$.
struct LinearDrag {
  double c_d = 1.0;  ///< per unit mass, >= 0 [1/s]
};

/// Refuses a drag that is none. Called once, where a law enters a scene.
///
/// @param law  the drag
/// @throws std::invalid_argument saying what must hold and what was given
void validate(const LinearDrag& law);

/// Adds the drag.
///
/// @equation{R 6.3}
/// @param law    a drag that validate() accepts
/// @param at     the members
/// @param force  receives the forces, added to what it holds [N]
/// @return true
template <kinematics::Domain D>
bool add_force(const LinearDrag& law, const D&, const laws::At<laws::Velocity>& at, laws::Forces force) {
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    force.col(axis).array() -= law.c_d * at.mass.array() * at.velocity.col(axis).array();
  }
  return true;
}

}  // namespace particulate::swarm
