#pragma once

#include <cmath>

#include <particulate/laws/central_field.hpp>

namespace particulate::swarm {

/// A place that attracts every member.
///
/// \f[ \Psi_i^{mt} = m_i\, \alpha_t\, d_i^{\beta_t}\, n_i, \qquad d_i = \|r_t - r_i\|, \quad
///     n_i = \frac{r_t - r_i}{d_i} \f]
///
/// @equation{R 6.1} A member at the target feels nothing of it.
struct Target {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< r_t [m]
  double alpha = 1.0;                               ///< alpha_t, >= 0 [N m^-beta_t/kg]
  double beta = 1.0;                                ///< beta_t, 0 to 1: a pull that may grow with distance [-]
  laws::Kernel kernel = laws::Kernel::best;         ///< what adds the forces in Space
};

/// Refuses a target that is none. Called once, where a law enters a scene.
///
/// @param law  the target
/// @throws std::invalid_argument naming the constant, what must hold and what was given
void validate(const Target& law);

/// @param law  the target
/// @return what it exerts: a view
laws::CentralField field_of(const Target& law);

/// Adds the pull of the target.
///
/// @equation{R 6.1}
/// @param law     a target that validate() accepts
/// @param domain  forms the separations
/// @param at      the members
/// @param force   receives the forces, added to what it holds [N]
/// @return false where a force is too large for a double
template <kinematics::Domain D>
bool add_force(const Target& law, const D& domain, const laws::At<>& at, laws::Forces force) {
  return add_field(field_of(law), domain, at, force);
}

/// Potential energy of all members, zero at the target.
///
/// \f[ V = \sum_i m_i\, \alpha_t\, \frac{d_i^{\beta_t + 1}}{\beta_t + 1} \f]
///
/// @equation{R 6.1}
/// @param law     a target that validate() accepts
/// @param domain  forms the separations
/// @param at      the members
/// @return energy [J]
template <kinematics::Domain D>
double potential_energy(const Target& law, const D& domain, const laws::At<>& at) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    const double d = kinematics::length(separation(domain, at.position.row(i), law.place));
    sum += at.mass[i] * law.alpha * std::pow(d, law.beta + 1.0) / (law.beta + 1.0);
  }
  return sum;
}

}  // namespace particulate::swarm
