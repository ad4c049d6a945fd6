#pragma once

#include <limits>

#include <particulate/kinematics/domain.hpp>
#include <particulate/laws/law.hpp>

namespace particulate::swarm {

/// A speed that no member can exceed: at the end of every step the velocity of one that is faster is shortened to it.
///
/// \f[ v_i' = v_i \min\!\left(1, \frac{v_{max}}{\|v_i\|}\right) \f]
///
/// @equation{R 6.3} Within a step a member may exceed it by what the forces of one step add, so that the path depends
/// on the step at order 1.
struct SpeedLimit {
  double v_max = std::numeric_limits<double>::infinity();  ///< >= 0; infinite: none [m/s]
};

/// Refuses a limit that is none. Called once, where a law enters a scene.
///
/// @param law  the limit
/// @throws std::invalid_argument saying what must hold and what was given
void validate(const SpeedLimit& law);

/// Slows down the members that are too fast. Immovable ones keep their velocity.
///
/// @equation{R 6.3}
/// @param law       a limit that validate() accepts
/// @param at        the members, with the velocities at the end of a step
/// @param velocity  the same velocities, N x 3; receives the new ones [m/s]
/// @return how many were too fast, and the change of their kinetic energy, which is what the limit takes
schemes::Jump limit_speeds(const SpeedLimit& law, const laws::At<laws::Velocity>& at, laws::Forces velocity);

/// The jump of a scene with this law: limit_speeds().
///
/// @equation{R 6.3}
/// @param law       a limit that validate() accepts
/// @param at        the members, with the velocities at the end of a step
/// @param velocity  the same velocities, 3 N numbers, column by column; receives the new ones [m/s]
/// @return what limit_speeds() did
template <kinematics::Domain D>
schemes::Jump jump(const SpeedLimit& law, const D&, const laws::At<laws::Velocity>& at, double, schemes::Out velocity) {
  return limit_speeds(law, at, {velocity.data(), at.mass.size(), 3});
}

}  // namespace particulate::swarm
