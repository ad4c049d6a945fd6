#pragma once

#include <algorithm>
#include <concepts>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <particulate/contact/law.hpp>
#include <particulate/contact/resolution.hpp>
#include <particulate/schemes/problem.hpp>

namespace particulate::contact {

/// Contact of spheres with each other and with walls, as a jump of the velocities at the end of a step.
///
/// Pairs that overlap and approach there exchange the impulses of section 2.2, with the other forces acting on them
/// over the duration gamma Dt. Between jumps nothing is felt of a contact, so the motion stays smooth.
///
/// @equation{R 2.2} The monograph adds the impulse as a force J/Dt over the step; the two differ by one free flight of
/// the impulse, O(Dt). Impulses change velocities, not positions: a body at rest on another under a normal acceleration
/// g approaches it with \f$ (1 - \gamma)\, g\, \Delta t/(1 + e) \f$ at the end of each step and sinks by
/// \f$ \tfrac12 g\, \Delta t^2\, (1 - e - 2\gamma)/(1 + e) \f$ in it while \f$ e < 1 - 2\gamma \f$; the largest overlap
/// of the run tells. A more elastic body hops, and gains the work of g over the duration, O(gamma Dt) an impact.
/// @tparam RestitutionLaw  ConstantRestitution or Restitution
/// @tparam FrictionLaw     Frictionless or Friction
template <class RestitutionLaw = ConstantRestitution, class FrictionLaw = Frictionless>
struct Contact {
  RestitutionLaw restitution = {};                 ///< ConstantRestitution or Restitution
  FrictionLaw friction = {};                       ///< Frictionless or Friction
  double gamma = 0.01;                             ///< duration of an impact over the step, 0 < gamma << 1 [-]
  Resolution resolution = Resolution::sequential;  ///< of simultaneous contacts
};

/// @cond
inline void validate(const Frictionless&) {}
/// @endcond

/// Refuses a resolution that is none.
///
/// @param resolution  of simultaneous contacts
/// @throws std::invalid_argument saying what must hold and what was given
inline void validate(Resolution resolution) {
  if (resolution != Resolution::summed && resolution != Resolution::sequential) {
    throw std::invalid_argument(
        fmt::format("contact: resolution must be summed or sequential, got number {}", static_cast<int>(resolution)));
  }
}

/// Refuses a contact law that is none. Called once, where a law enters a scene.
///
/// @param law  the law
/// @throws std::invalid_argument naming the constant, what must hold and what was given
template <class R, class F>
void validate(const Contact<R, F>& law) {
  validate(law.restitution);
  validate(law.friction);
  if (!(law.gamma > 0.0 && law.gamma < 1.0)) {
    throw std::invalid_argument(fmt::format("contact: gamma must lie between 0 and 1, got {}", law.gamma));
  }
  validate(law.resolution);
}

/// Potential energy of a contact: none, as nothing is felt of it between impacts. So a scene with contacts has the
/// potential energy of its other laws.
///
/// @equation{D 2.2}
/// @return zero [J]
template <class R, class F, kinematics::Domain D>
double potential_energy(const Contact<R, F>&, const D&, const Places&) {
  return 0.0;
}

/// Contacts of a moment, and the deepest of them.
struct Touching {
  std::vector<Touch> contacts;  ///< pairs and walls that touch or overlap
  double overlap = 0.0;         ///< largest depth among them [m]
  bool directed = true;         ///< false: two centres coincide, so the direction of their contact is not finite
};

/// Exact touching: what does not overlap is apart.
struct Exactly {
  /// @return zero: no gap counts as closed [m]
  double operator()(const Moving&, Eigen::Index, Eigen::Index) const { return 0.0; }
};

/// Finds the spheres that touch each other or a wall. Two bodies of which neither can move do not count.
///
/// @param domain     forms the separations, and has the walls if there are any
/// @param at         the particles
/// @param tolerance  `tolerance(at, i, j)`: how wide a gap counts as closed; j is negative for a wall [m]
/// @return contacts without their accelerations
template <kinematics::Domain D, class Tolerance = Exactly>
Touching find_touching(const D& domain, const Moving& at, const Tolerance& tolerance = {}) {
  Touching found;
  const auto add = [&](Eigen::Index i, Eigen::Index j, double depth, const Eigen::Vector3d& n) {
    found.directed = found.directed && n.allFinite();
    found.overlap = std::max(found.overlap, depth);
    found.contacts.push_back({.i = i, .j = j, .n = n});
  };
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    const bool moves = at.inverse_mass[i] > 0.0;
    const Eigen::Vector3d here = at.position.row(i);
    for (Eigen::Index j = i + 1; j < at.mass.size(); ++j) {
      if (!moves && !(at.inverse_mass[j] > 0.0)) continue;
      const Eigen::Vector3d towards = separation(domain, here, at.position.row(j));
      const double d = towards.norm(), reach = at.radius[i] + at.radius[j];
      if (d - reach <= tolerance(at, i, j)) add(i, j, reach - d, towards / d);
    }
    if constexpr (kinematics::HasWalls<D>) {
      if (!moves) continue;
      for (const kinematics::Wall& wall : walls(domain)) {
        const double gap = kinematics::height_above(wall, here) - at.radius[i];
        if (gap <= tolerance(at, i, -1)) add(i, -1, -gap, -wall.normal);
      }
    }
  }
  return found;
}

/// @param touch     a contact
/// @param velocity  of all particles, N x 3 [m/s]
/// @return the speed at which its two bodies approach; negative: they part [m/s]
inline double approach_speed(const Touch& touch, const kinematics::VectorsIn& velocity) {
  Eigen::Vector3d approach = velocity.row(touch.i);
  if (touch.j >= 0) approach -= velocity.row(touch.j).transpose();
  return approach.dot(touch.n);
}

/// Whether any contact of a moment must be looked at.
///
/// @param touching  contacts
/// @param at        the particles
/// @return true if a pair approaches, or has no direction
inline bool any_approach(const Touching& touching, const Moving& at) {
  return !touching.directed || std::any_of(touching.contacts.begin(), touching.contacts.end(), [&](const Touch& touch) {
    return approach_speed(touch, at.velocity) > 0.0;
  });
}

/// Why two bodies that touch cannot be parted.
///
/// @param touching  contacts of which one has no direction
/// @return the reason, with their numbers and what to do
inline std::string without_direction(const Touching& touching) {
  const auto lost = std::find_if(touching.contacts.begin(), touching.contacts.end(),
                                 [](const Touch& touch) { return !touch.n.allFinite(); });
  return fmt::format(
      "particles {} and {} touch with the same centre, so there is no direction to part them in: start them apart, or "
      "take a smaller step",
      lost->i, lost->j);
}

/// Resolves the contacts of a moment, each of which has a direction.
///
/// @param law       restitution, friction and resolution
/// @param duration  of the impacts [s]
/// @param at        the particles
/// @param touching  what find_touching() found; receives the accelerations
/// @param force     all other forces on the particles, 3 N numbers, column by column [N]
/// @param velocity  a copy of the velocities, changed in place, 3 N numbers [m/s]
/// @return impacts, change of kinetic energy, overlap, and what could not be settled
template <class L>
schemes::Jump exchange_impulses(const L& law, double duration, const Moving& at, Touching& touching, schemes::In force,
                                schemes::Out velocity) {
  const Eigen::Index N = at.mass.size();
  const Eigen::Map<const kinematics::Vectors> f(force.data(), N, 3);
  Forces v(velocity.data(), N, 3);
  for (Touch& touch : touching.contacts) {
    touch.acceleration = at.inverse_mass[touch.i] * f.row(touch.i).transpose();
    if (touch.j >= 0) touch.acceleration -= at.inverse_mass[touch.j] * f.row(touch.j).transpose();
  }
  const ContactResolver resolver{law.restitution, law.friction, law.resolution};
  const Resolved done = resolver(touching.contacts, at.inverse_mass, duration, v);
  const double change = 0.5 * at.mass.dot(v.rowwise().squaredNorm() - at.velocity.rowwise().squaredNorm());
  return {.impacts = done.impacts, .energy_change = change, .overlap = touching.overlap, .unsettled = done.unsettled};
}

/// Resolves the contacts of a moment: the jump of a scene with this law.
///
/// @equation{R 2.2}
/// @param law       constants that validate() accepts
/// @param at        the particles
/// @param touching  what find_touching() found
/// @param force     all other forces on the particles, 3 N numbers, column by column [N]
/// @param dt        the step that ends here [s]
/// @param velocity  a copy of the velocities, changed in place, 3 N numbers [m/s]
/// @return impacts, change of kinetic energy, overlap, and what could not be settled
template <class R, class F>
schemes::Jump resolve_impacts(const Contact<R, F>& law, const Moving& at, Touching touching, schemes::In force,
                              double dt, schemes::Out velocity) {
  if (!touching.directed) return {.overlap = touching.overlap, .unsettled = without_direction(touching)};
  return exchange_impulses(law, law.gamma * dt, at, touching, force, velocity);
}

/// A law that resolves impacts: `resolve_impacts(law, moving, touching, force, dt, velocity)`.
template <class L>
concept Impacts = requires(const L& law, const Moving& at, Touching touching, schemes::In force, double dt,
                           schemes::Out velocity) {
  { resolve_impacts(law, at, touching, force, dt, velocity) } -> std::same_as<schemes::Jump>;
};

/// A law that locates its impacts: `first_impact(law, domain, radius, inverse_mass, path, end)`.
template <class L, class D>
concept LocatesImpacts = Impacts<L> &&
    requires(const L& law, const D& domain, const Eigen::VectorXd& x, const schemes::StepPath& path,
             double end) {
  { first_impact(law, domain, x, x, path, end) } -> std::same_as<std::optional<double>>;
};

/// What counts as touching to a law that resolves impacts: `touching_tolerance(law)`, exact touching by default.
///
/// @return a tolerance for find_touching()
template <class L>
Exactly touching_tolerance(const L&) {
  return {};
}

}  // namespace particulate::contact
