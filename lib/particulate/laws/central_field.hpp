#pragma once

#include <span>

#include <Eigen/Core>

#include <particulate/kinematics/central_force.hpp>
#include <particulate/laws/near_field.hpp>

/// @file
/// Forces of fixed centres on every particle: what obstacles and targets are made of.

namespace particulate::laws {

/// Fixed centres, each of which attracts and repels every particle by the same central force per unit mass. A view: the
/// law that it is of holds the centres.
///
/// \f[ \Psi_i = m_i \sum_k \left(\alpha_1 d_{ik}^{-\beta_1} - \alpha_2 d_{ik}^{-\beta_2}\right) n_{ik}, \qquad
///     d_{ik} = \|c_k - r_i\|, \quad n_{ik} = \frac{c_k - r_i}{d_{ik}} \f]
///
/// @equation{R 6.2}
struct CentralField {
  kinematics::CentralForce per_mass;             ///< exponents may be as low as -1 [N m^beta/kg]
  std::span<const Eigen::Vector3d> centre = {};  ///< c_k [m]
  double d_ref = 1.0;                            ///< distance at which a potential energy is zero, > 0 [m]
  Kernel kernel = Kernel::best;                  ///< what adds the forces in Space
  bool vanishes_at_centre = false;  ///< whether a particle at a centre feels nothing of it; false: no force
};

/// Adds the forces of fixed centres, pair by pair.
///
/// @equation{R 6.2}
/// @param field   the centres
/// @param domain  forms the separations
/// @param at      the particles
/// @param force   receives the forces, added to what it holds [N]
/// @return false where a particle is at a centre that has no force there or is nowhere, or a force is too large for a
///         double; the forces are then meaningless
template <kinematics::Domain D>
bool add_field(const CentralField& field, const D& domain, const At<>& at, Forces force) {
  bool all_apart = true;
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    for (const Eigen::Vector3d& centre : field.centre) {
      const Eigen::Vector3d towards = separation(domain, at.position.row(i), centre);
      const double d = kinematics::length(towards);
      if (d == 0.0) {
        all_apart = all_apart && field.vanishes_at_centre;
      } else {
        force.row(i) += at.mass[i] * strength(field.per_mass, d) * (towards / d);
      }
    }
  }
  return all_apart && force.allFinite();
}

/// The same in space, by a kernel of the near field, which takes 2, 4 or 8 particles at once; where space repeats
/// itself, and where distances are extreme, pair by pair.
///
/// @copydetails add_field(const CentralField&, const D&, const At<>&, Forces)
bool add_field(const CentralField& field, const kinematics::Space& domain, const At<>& at, Forces force);

/// Potential energy in the field of fixed centres.
///
/// \f[ V = \sum_i m_i \sum_k \big(V_k(d_{ik}) - V_k(d_{ref})\big) \f]
///
/// @equation{R 6.2}
/// @param field   the centres
/// @param domain  forms the separations
/// @param at      the particles
/// @return energy; infinite or NaN at a centre that repels without bound [J]
template <kinematics::Domain D>
double energy_in_field(const CentralField& field, const D& domain, const At<>& at) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    for (const Eigen::Vector3d& centre : field.centre) {
      const double d = kinematics::length(separation(domain, at.position.row(i), centre));
      sum += at.mass[i] * potential(field.per_mass, d, field.d_ref);
    }
  }
  return sum;
}

}  // namespace particulate::laws
