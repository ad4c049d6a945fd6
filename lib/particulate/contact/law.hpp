#pragma once

#include <concepts>

#include <particulate/kinematics/domain.hpp>
#include <particulate/kinematics/particles.hpp>

/// @file
/// What a law of a scene may be asked. Laws are plain structs; what they do are free functions found beside them.

namespace particulate::contact {

/// What a law sees of the particles: nothing is copied.
struct Places {
  double t;                                        ///< time [s]
  Eigen::Map<const kinematics::Vectors> position;  ///< r_i, N x 3 [m]
  const Eigen::VectorXd& mass;                     ///< m_i, N [kg]
  const Eigen::VectorXd& radius;                   ///< b_i, N [m]
};

/// What a law sees that asks for velocities too.
struct Moving : Places {
  Eigen::Map<const kinematics::Vectors> velocity;  ///< v_i, N x 3 [m/s]
  const Eigen::VectorXd& inverse_mass;             ///< 1/m_i, 0 for what is immovable, N [1/kg]
};

using Forces = Eigen::Map<kinematics::Vectors>;  ///< forces on the particles, N x 3, that a law adds to [N]

/// A law whose forces depend on positions only: `add_force(law, domain, places, forces)` adds them, and returns whether
/// they have a value there.
template <class L, class D>
concept PositionForce = requires(const L& law, const D& domain, const Places& at, Forces force) {
  { add_force(law, domain, at, force) } -> std::same_as<bool>;
};

/// A law whose forces depend on velocities too. It makes its scene a problem with velocities, at compile time.
template <class L, class D>
concept MotionForce = !PositionForce<L, D> && requires(const L& law, const D& domain, const Moving& at, Forces force) {
  { add_force(law, domain, at, force) } -> std::same_as<bool>;
};

/// A law with a potential: `potential_energy(law, domain, places)` [J], of which its forces are the negative gradient.
template <class L, class D>
concept Conservative = requires(const L& law, const D& domain, const Places& at) {
  { potential_energy(law, domain, at) } -> std::same_as<double>;
};

/// A law that can be checked where it enters a scene: `validate(law)` throws std::invalid_argument.
template <class L>
concept Validated = requires(const L& law) {
  validate(law);
};

}  // namespace particulate::contact
