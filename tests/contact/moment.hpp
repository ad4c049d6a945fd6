#pragma once

#include <particulate/contact/contact.hpp>
#include <particulate/kinematics/particles.hpp>
#include <particulate/schemes/problem.hpp>

/// @file
/// What the tests of both contact models share.

namespace tests {

/// Particles at a moment, as a scene shows them to its laws.
struct Moment {
  particulate::kinematics::Particles particles;                                       ///< all of them
  Eigen::VectorXd inverse_mass = particulate::kinematics::inverse_masses(particles);  ///< computed once
  double t = 3.0;                                                                     ///< time [s]
  mutable particulate::laws::Scratch scratch = {};                                    ///< of whoever looks at it

  /// @return the view, as long as the moment lives
  particulate::laws::At<particulate::laws::Velocity> at() const {
    using particulate::kinematics::Vectors;
    const Eigen::Index N = particles.size();
    return {{.t = t,
             .position = Eigen::Map<const Vectors>(particles.position.data(), N, 3),
             .mass = particles.mass,
             .radius = particles.radius,
             .inverse_mass = inverse_mass,
             .scratch = scratch},
            Eigen::Map<const Vectors>(particles.velocity.data(), N, 3)};
  }
};

/// What became of a moment.
struct Resolved {
  particulate::schemes::Jump jump;            ///< as booked
  particulate::kinematics::Vectors velocity;  ///< of all particles, after it [m/s]
};

/// Resolves the impacts of a moment, of duration dt, under one force a particle.
template <class C>
Resolved resolved(const C& law, const Moment& moment, const particulate::contact::Touching& touching,
                  const particulate::kinematics::Vectors& force, double dt) {
  const Eigen::VectorXd f = force.reshaped();
  Eigen::VectorXd v = moment.particles.velocity.reshaped();
  const particulate::schemes::Jump jump = resolve_impacts(law, moment.at(), touching, f, dt, v);
  return {jump, v.reshaped(moment.particles.size(), 3)};
}

}  // namespace tests
