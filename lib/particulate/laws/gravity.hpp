#pragma once

#include <particulate/kinematics/domain.hpp>
#include <particulate/laws/law.hpp>

namespace particulate::laws {

/// Uniform gravity.
///
/// \f[ \Psi_i = m_i\, g, \qquad V = -\sum_i m_i\, g \cdot r_i \f]
///
/// @equation{D 1.13}
struct Gravity {
  Eigen::Vector3d g{0.0, 0.0, -9.81};  ///< acceleration [m/s^2]
};

/// Refuses an acceleration that is not finite. Called once, where a law enters a scene.
///
/// @param law  the acceleration
/// @throws std::invalid_argument saying what was given
void validate(const Gravity& law);

/// Adds the weights.
///
/// @equation{D 1.13}
/// @param law    a law that validate() accepts
/// @param at     the particles
/// @param force  receives the forces, added to what it holds [N]
/// @return true
template <kinematics::Domain D>
bool add_force(const Gravity& law, const D&, const At<>& at, Forces force) {
  // Column by column: the outer product would ask for memory at every step.
  for (Eigen::Index axis = 0; axis < 3; ++axis) force.col(axis) += law.g[axis] * at.mass;
  return true;
}

/// Potential energy in uniform gravity, zero at the origin.
///
/// @equation{D 1.13}
/// @param law  a law that validate() accepts
/// @param at   the particles
/// @return energy [J]
template <kinematics::Domain D>
double potential_energy(const Gravity& law, const D&, const At<>& at) {
  return -at.mass.dot(at.position * law.g);
}

}  // namespace particulate::laws
