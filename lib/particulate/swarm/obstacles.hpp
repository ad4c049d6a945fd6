#pragma once

#include <optional>
#include <string>
#include <vector>

#include <particulate/laws/central_field.hpp>

namespace particulate::swarm {

/// Spheres that stand where they are and push every member away. A member inside one is lost: see fly().
///
/// \f[ \Psi_i^{mo} = -m_i \sum_k \alpha_o\, d_{ik}^{-\beta_o}\, n_{ik}, \qquad d_{ik} = \|o_k - r_i\|, \quad
///     n_{ik} = \frac{o_k - r_i}{d_{ik}} \f]
///
/// @equation{R 6.1} It pushes from their centres, wherever their surface is.
struct Obstacles {
  std::vector<Eigen::Vector3d> centre = {};  ///< o_k [m]
  std::vector<double> radius = {};           ///< of each, >= 0 [m]
  double alpha = 1.0;                        ///< alpha_o, >= 0 [N m^beta_o/kg]
  double beta = 2.0;                         ///< beta_o, > 0 [-]
  double d_ref = 1.0;                        ///< distance from a centre at which its potential is zero, > 0 [m]
  laws::Kernel kernel = laws::Kernel::best;  ///< what adds the forces in Space
};

/// Refuses obstacles that are none. Called once, where a law enters a scene.
///
/// @param law  the obstacles
/// @throws std::invalid_argument naming the obstacle or the constant, what must hold and what was given
void validate(const Obstacles& law);

/// @param law  the obstacles
/// @return their centres and what these exert: a view
laws::CentralField field_of(const Obstacles& law);

/// Adds what the obstacles exert.
///
/// @equation{R 6.1}
/// @param law     obstacles that validate() accepts
/// @param domain  forms the separations
/// @param at      the members
/// @param force   receives the forces, added to what it holds [N]
/// @return false where a member is at the centre of an obstacle, or a force is too large for a double
template <kinematics::Domain D>
bool add_force(const Obstacles& law, const D& domain, const laws::At<>& at, laws::Forces force) {
  return add_field(field_of(law), domain, at, force);
}

/// Potential energy of all members about all obstacles, zero at d_ref of each.
///
/// @equation{R 6.1}
/// @param law     obstacles that validate() accepts
/// @param domain  forms the separations
/// @param at      the members
/// @return energy [J]
template <kinematics::Domain D>
double potential_energy(const Obstacles& law, const D& domain, const laws::At<>& at) {
  return energy_in_field(field_of(law), domain, at);
}

/// The obstacle that a place is inside of: nearer to its centre than its radius. On its surface is outside.
///
/// @param law     obstacles that validate() accepts
/// @param domain  forms the separations
/// @param place   a place [m]
/// @return the number of the first such obstacle; none: it is outside of all
template <kinematics::Domain D>
std::optional<std::size_t> obstacle_around(const Obstacles& law, const D& domain, const Eigen::Vector3d& place) {
  for (std::size_t k = 0; k < law.centre.size(); ++k) {
    if (separation(domain, place, law.centre[k]).squaredNorm() < law.radius[k] * law.radius[k]) return k;
  }
  return {};
}

/// @cond
std::string at_centre(Eigen::Index member, std::size_t obstacle);
/// @endcond

/// Why a member feels no force of the obstacles: it is at the centre of one.
///
/// @param law     obstacles
/// @param domain  forms the separations
/// @param at      the members
/// @return which member, which obstacle and what to do; empty: none is
template <kinematics::Domain D>
std::string why_no_force(const Obstacles& law, const D& domain, const laws::At<>& at) {
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    for (std::size_t k = 0; k < law.centre.size(); ++k) {
      if (separation(domain, at.position.row(i), law.centre[k]).isZero(0.0)) return at_centre(i, k);
    }
  }
  return {};
}

}  // namespace particulate::swarm
