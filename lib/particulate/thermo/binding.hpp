#pragma once

#include <particulate/kinematics/domain.hpp>
#include <particulate/laws/law.hpp>

namespace particulate::thermo {

/// An attraction of short reach that holds spheres together once they are near: section 7.2.
///
/// \f[ \Psi_i^{b} = \sum_j F_b\, m_i m_j\, W(x_{ij})\, n_{ij}, \qquad W = 16\, x^2 (1 - x)^2, \qquad
///     x = \frac{d - d_0}{d_b - d_0}, \quad d_0 = b_i + b_j, \qquad 0 \le x \le 1 \f]
///
/// @equation{R 7.2} Zero outside of that range. It vanishes at touching, because an attraction that acts there would
/// draw spheres into each other under stepped contact. At both ends it has one continuous derivative, so that no scheme
/// is of an order above 3 across them.
struct Binding {
  double F_b = 0.0;  ///< strength, >= 0 [N/kg^2]
  double d_b = 0.0;  ///< distance of the centres at which it ends, above b_i + b_j of every pair [m]
};

/// Refuses constants that are no binding. Called once, where a law enters a scene.
///
/// @param law        the constants
/// @param particles  of the scene
/// @throws std::invalid_argument naming the constant, what must hold and what was given
void validate(const Binding& law, const kinematics::Particles& particles);

/// Refuses a binding that reaches farther than half the shortest period of space.
///
/// @param law     the constants
/// @param domain  space
/// @throws std::invalid_argument saying what must hold and what was given
void validate(const Binding& law, const kinematics::Space& domain);

/// @param law  the binding
/// @return the distance from which on it is exactly zero [m]
inline double reach(const Binding& law) { return law.d_b; }

/// The shape of the force, 0 to 1.
///
/// @equation{R 7.2}
/// @param x  place between touching, 0, and the end, 1 [-]
/// @return W; 0 outside of [0, 1] [-]
inline double binding_shape(double x) {
  const double w = x * (1.0 - x);
  return w > 0.0 ? 16.0 * w * w : 0.0;
}

/// Its integral from x to 1,
///
/// \f[ \frac{8}{15} - 16 \left(\frac{x^3}{3} - \frac{x^4}{2} + \frac{x^5}{5}\right) . \f]
///
/// @equation{D 7.2} Constant below 0, zero above 1.
/// @param x  place between touching, 0, and the end, 1 [-]
/// @return integral, 0 to 8/15 [-]
double binding_integral(double x);

/// Pairs of which some are within reach.
///
/// @param at  the particles
/// @return all pairs
template <kinematics::Domain D>
laws::Candidates candidates(const Binding&, const D&, const laws::At<>& at) {
  return {at.mass.size(), nullptr, nullptr};
}

/// The same in space: those that the scene's search finds.
///
/// @param law     the binding
/// @param domain  space
/// @param at      the particles; their scratch remembers neighbours
/// @return candidates, until neighbours are asked again
laws::Candidates candidates(const Binding& law, const kinematics::Space& domain, const laws::At<>& at);

/// Visits the pairs within reach: visit(i, j, r_j - r_i, d, x).
///
/// @param law     the binding
/// @param domain  forms the separations
/// @param at      the particles
/// @param visit   is called with each pair, its separation and distance [m], and its place between touching and end
template <kinematics::Domain D, class Visit>
void each_bound(const Binding& law, const D& domain, const laws::At<>& at, const Visit& visit) {
  const laws::Candidates near = candidates(law, domain, at);
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    const Eigen::Vector3d here = at.position.row(i);
    near.behind(i, [&](Eigen::Index j) {
      const Eigen::Vector3d towards = separation(domain, here, at.position.row(j));
      if (towards.squaredNorm() >= law.d_b * law.d_b) return;
      const double d = kinematics::length(towards), d_0 = at.radius[i] + at.radius[j];
      visit(i, j, towards, d, (d - d_0) / (law.d_b - d_0));
    });
  }
}

/// Adds the attraction of all pairs within reach.
///
/// @equation{R 7.2}
/// @param law     constants that validate() accepts
/// @param domain  forms the separations
/// @param at      the particles
/// @param force   receives the forces, added to what it holds [N]
/// @return false where a position is not finite
template <kinematics::Domain D>
bool add_force(const Binding& law, const D& domain, const laws::At<>& at, laws::Forces force) {
  if (!at.position.allFinite()) return false;
  each_bound(law, domain, at, [&](Eigen::Index i, Eigen::Index j, const Eigen::Vector3d& towards, double d, double x) {
    if (!(x > 0.0)) return;
    const Eigen::Vector3d pull = (law.F_b * at.mass[i] * at.mass[j] * binding_shape(x) / d) * towards;
    force.row(i) += pull;
    force.row(j) -= pull;
  });
  return true;
}

/// Potential energy of all bonds, zero beyond their reach.
///
/// \f[ V_b = -F_b\, m_i m_j\, (d_b - d_0) \int_x^1 W\,dx \f]
///
/// @equation{D 7.2}
/// @param law     constants that validate() accepts
/// @param domain  forms the separations
/// @param at      the particles
/// @return energy, <= 0 [J]
template <kinematics::Domain D>
double potential_energy(const Binding& law, const D& domain, const laws::At<>& at) {
  double sum = 0.0;
  each_bound(law, domain, at, [&](Eigen::Index i, Eigen::Index j, const Eigen::Vector3d&, double, double x) {
    const double width = law.d_b - at.radius[i] - at.radius[j];
    sum -= law.F_b * at.mass[i] * at.mass[j] * width * binding_integral(x);
  });
  return sum;
}

}  // namespace particulate::thermo
