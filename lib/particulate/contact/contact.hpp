#pragma once

#include <algorithm>
#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <particulate/contact/resolution.hpp>
#include <particulate/laws/law.hpp>
#include <particulate/schemes/problem.hpp>

namespace particulate::contact {

/// Contact of spheres with each other and with walls, as a jump of the velocities at the end of a step.
///
/// Pairs that overlap and approach there exchange the impulses of section 2.2. Between jumps nothing is felt of a
/// contact, so the motion stays smooth. The impulse comes late by part of a step, an error of O(Dt).
///
/// By default an impact takes no time, so that an elastic ball keeps its energy to rounding. What rests is held, unless
/// impulses are summed: where the other forces press two bodies together with the acceleration \f$ a_n \f$, and they
/// approach no faster than such forces made any contact that hangs together with theirs within the step
/// (\f$ u \le a_n\,\Delta t \f$), or restitution would part them for less than one, they part at
///
/// \f[ w = \tfrac12\, a_n\,\Delta t + \min\!\left(a_n\,\Delta t,\;
///     \tfrac12 \left\langle \frac{\delta}{\Delta t} - \tfrac12\, a_n\,\Delta t \right\rangle\right), \f]
///
/// instead: under constant forces the next step ends where it began. The second term, where there is room, works off an
/// overlap delta beyond that of a fall of one step, such as an impact or a start leaves; its work is booked. So nothing
/// sinks. Static friction stops the slip halfway through the step to come, so that nothing creeps either. Held bodies
/// quiver with \f$ \tfrac12 a_n\,\Delta t \f$ between the ends of steps. All of this is exact for schemes of second
/// order or more; Euler's methods rest an overlap of \f$ a_n\,\Delta t^2 \f$ deep, and creep.
///
/// A gamma is the monograph's: the other forces act on the pair over the duration gamma Dt, for which the impulse makes
/// up. As the step that follows applies them again, an elastic ball gains their work over the duration, O(gamma Dt) an
/// impact, and what rests is not held: it sinks by
/// \f$ \tfrac12 g\, \Delta t^2\, (1 - e - 2\gamma)/(1 + e) \f$ a step, or hops where that is negative.
///
/// @equation{R 2.2} The monograph adds the impulse as a force J/Dt over the step; the two differ by one free flight of
/// the impulse, O(Dt).
/// @tparam RestitutionLaw  ConstantRestitution or Restitution
/// @tparam FrictionLaw     Frictionless or Friction
template <class RestitutionLaw = ConstantRestitution, class FrictionLaw = Frictionless>
struct Contact {
  RestitutionLaw restitution = {};                 ///< ConstantRestitution or Restitution
  FrictionLaw friction = {};                       ///< Frictionless or Friction
  double gamma = 0.0;                              ///< duration of an impact over the step, 0 <= gamma << 1 [-]
  Resolution resolution = Resolution::sequential;  ///< of simultaneous contacts
  ImpactRecorder recorder = {};                    ///< is told of every impact; empty: nobody is
};

/// @cond
inline void validate(const Frictionless&) {}
/// @endcond

/// Refuses a resolution that is none.
///
/// @param resolution  of simultaneous contacts
/// @throws std::invalid_argument saying what must hold and what was given
void validate(Resolution resolution);

/// Refuses a duration that is none.
///
/// @param gamma  duration of an impact over the step [-]
/// @throws std::invalid_argument saying what must hold and what was given
void validate_gamma(double gamma);

/// Refuses a contact law that is none. Called once, where a law enters a scene.
///
/// @param law  the law
/// @throws std::invalid_argument naming the constant, what must hold and what was given
template <class R, class F>
void validate(const Contact<R, F>& law) {
  validate(law.restitution);
  validate(law.friction);
  validate_gamma(law.gamma);
  validate(law.resolution);
}

/// Potential energy of a contact: none, as nothing is felt of it between impacts. So a scene with contacts has the
/// potential energy of its other laws.
///
/// @equation{D 2.2}
/// @return zero [J]
template <class R, class F, kinematics::Domain D>
double potential_energy(const Contact<R, F>&, const D&, const laws::At<>&) {
  return 0.0;
}

/// Contacts of a moment, and the deepest of them.
struct Touching {
  std::vector<Touch> contacts;  ///< pairs and walls that touch or overlap
  double overlap = 0.0;         ///< largest depth among them [m]
  double penetration = 0.0;     ///< largest depth over the smaller diameter of its two bodies [-]
  bool directed = true;         ///< false: two centres coincide, so the direction of their contact is not finite
};

/// @param touching  contacts of a moment
/// @return how many of them overlap, and how deep
schemes::Overlap overlap_of(const Touching& touching);

/// How wide a gap between two bodies counts as closed.
///
/// \f[ \tau\,(b_i + b_j) + n\,\varepsilon\,(\|r_i\| + \|r_j\|) \f]
///
/// with a wall without its \f$ b_j \f$ and \f$ r_j \f$. By default none: what does not overlap is apart.
struct ClosedGap {
  double relative = 0.0;   ///< tau [-]
  double roundings = 0.0;  ///< n, roundings of the places [-]

  /// @return whether a gap must be closed to the last bit
  bool is_none() const { return relative == 0.0 && roundings == 0.0; }

  /// @param position  r_i, N x 3 [m]
  /// @param radius    b_i, N [m]
  /// @return share of each particle in the gaps at it: two together are between() [m]
  Eigen::VectorXd shares(const kinematics::VectorsIn& position, const Eigen::VectorXd& radius) const;

  /// @param position  r_i, N x 3 [m]
  /// @param radius    b_i, N [m]
  /// @param i         one particle
  /// @param j         another; negative: a wall
  /// @return the widest gap that counts as closed [m]
  double between(const kinematics::VectorsIn& position, const Eigen::VectorXd& radius, Eigen::Index i,
                 Eigen::Index j) const;
};

namespace detail {

// Of two bodies; a point and a wall have none, and a point in a wall has no depth over it.
inline double smaller_diameter(const Eigen::VectorXd& radius, Eigen::Index i, Eigen::Index j) {
  const double b_i = radius[i], b_j = j < 0 ? 0.0 : radius[j];
  return 2.0 * (b_i > 0.0 && b_j > 0.0 ? std::min(b_i, b_j) : std::max(b_i, b_j));
}

// The spheres that touch each other or a wall, among all pairs {i, j > i} that behind(i, visit) visits with j.
template <kinematics::Domain D, class Behind>
Touching find_touching(const D& domain, const laws::At<laws::Velocity>& at, const ClosedGap& tolerance,
                       const Behind& behind) {
  Touching found;
  const auto add = [&](Eigen::Index i, Eigen::Index j, double depth, const Eigen::Vector3d& n) {
    found.directed = found.directed && n.allFinite();
    found.overlap = std::max(found.overlap, depth);
    const double diameter = smaller_diameter(at.radius, i, j);
    if (depth > 0.0 && diameter > 0.0) found.penetration = std::max(found.penetration, depth / diameter);
    found.contacts.push_back({.i = i, .j = j, .n = n, .overlap = depth});
  };
  const bool exact = tolerance.is_none();
  const auto closed = [&](double gap, Eigen::Index i, Eigen::Index j) {
    return gap <= 0.0 || (!exact && gap <= tolerance.between(at.position, at.radius, i, j));
  };
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    const bool moves = at.inverse_mass[i] > 0.0;
    const Eigen::Vector3d here = at.position.row(i);
    behind(i, [&](Eigen::Index j) {
      if (!moves && !(at.inverse_mass[j] > 0.0)) return;
      const Eigen::Vector3d towards = separation(domain, here, at.position.row(j));
      const double reach = at.radius[i] + at.radius[j];
      // Most pairs are apart, whatever rounding or the range of a double makes of their squares.
      if (exact && towards.squaredNorm() > (1.0 + 1e-12) * reach * reach + 1e-300) return;
      const double d = kinematics::length(towards);
      if (reach > 0.0 && closed(d - reach, i, j)) add(i, j, reach - d, towards / d);
    });
    if constexpr (kinematics::HasWalls<D>) {
      if (!moves) continue;
      for (const kinematics::Wall& wall : walls(domain)) {
        const double gap = kinematics::height_above(wall, here) - at.radius[i];
        if (closed(gap, i, -1)) add(i, -1, -gap, -wall.normal);
      }
    }
  }
  return found;
}

}  // namespace detail

/// Finds the spheres that touch each other or a wall, among all pairs. Two bodies of which neither can move do not
/// count, nor do two points, which have no surface.
///
/// @param domain     forms the separations, and has the walls if there are any
/// @param at         the particles
/// @param tolerance  how wide a gap counts as closed
/// @return contacts without their accelerations, by their first particle, then their second; of each its walls last
template <kinematics::Domain D>
Touching find_touching(const D& domain, const laws::At<laws::Velocity>& at, const ClosedGap& tolerance = {}) {
  const laws::Candidates all{at.mass.size(), nullptr, nullptr};
  return detail::find_touching(domain, at, tolerance, [&](Eigen::Index i, auto&& visit) { all.behind(i, visit); });
}

/// The same in space, among the neighbours of each sphere: the same contacts, at a cost that grows with N.
///
/// @param domain     forms the separations, and has the walls
/// @param at         the particles; their scratch remembers neighbours
/// @param tolerance  how wide a gap counts as closed
/// @return contacts without their accelerations, by their first particle, then their second; of each its walls last
Touching find_touching(const kinematics::Space& domain, const laws::At<laws::Velocity>& at,
                       const ClosedGap& tolerance = {});

/// The largest move of a body in a step over its radius: relative to the mean velocity of all, which a common motion
/// does not enter, and along the normals of walls. A point counts with the smallest radius that is none.
///
/// @param at     the particles at the end of the step
/// @param walls  which bound them
/// @param dt     the step [s]
/// @return speed times step over radius; above 1 bodies may have passed each other unseen, or entered deeply [-]
double travel(const laws::At<laws::Velocity>& at, std::span<const kinematics::Wall> walls, double dt);

/// @param domain  with walls or without
/// @param at      the particles at the end of the step
/// @param dt      the step [s]
/// @return travel() there [-]
template <kinematics::Domain D>
double travel(const D& domain, const laws::At<laws::Velocity>& at, double dt) {
  if constexpr (kinematics::HasWalls<D>) return travel(at, walls(domain), dt);
  return travel(at, {}, dt);
}

/// @param touch     a contact
/// @param velocity  of all particles, N x 3 [m/s]
/// @return the speed at which its two bodies approach; negative: they part [m/s]
double approach_speed(const Touch& touch, const kinematics::VectorsIn& velocity);

/// Whether any contact of a moment must be looked at.
///
/// @param touching  contacts
/// @param at        the particles
/// @return true if a pair approaches, or has no direction
bool any_approach(const Touching& touching, const laws::At<laws::Velocity>& at);

/// Why two bodies that touch cannot be parted.
///
/// @param touching  contacts of which one has no direction
/// @return the reason, with their numbers and what to do
std::string without_direction(const Touching& touching);

/// @param touching  contacts of which one has no direction
/// @return the jump that could not be completed for it
schemes::Jump undirected(const Touching& touching);

/// Gives every contact the relative acceleration of its bodies by the other forces.
///
/// @param touching      contacts; receives the accelerations
/// @param inverse_mass  1/m_i, N [1/kg]
/// @param force         all other forces on the particles, 3 N numbers, column by column [N]
void set_accelerations(Touching& touching, const Eigen::VectorXd& inverse_mass, schemes::In force);

/// Has contacts held over the next step if they rest. @see Contact
///
/// @param touching  contacts with their accelerations; receives Touch::hold, parting and slow
/// @param dt        the step that ends here, taken for the next one as well [s]
void hold(Touching& touching, double dt);

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
schemes::Jump exchange_impulses(const L& law, double duration, const laws::At<laws::Velocity>& at, Touching& touching,
                                schemes::In force, schemes::Out velocity) {
  set_accelerations(touching, at.inverse_mass, force);
  laws::Forces v(velocity.data(), at.mass.size(), 3);
  const ContactResolver<decltype(law.restitution), decltype(law.friction)> resolver{law.restitution, law.friction,
                                                                                    law.resolution, law.recorder};
  const Resolved done = resolver(touching.contacts, at.inverse_mass, duration, v);
  return {.impacts = done.impacts,
          .energy_change = done.energy_change,
          .overlap = touching.overlap,
          .penetration = touching.penetration,
          .unsettled = done.unsettled};
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
schemes::Jump resolve_impacts(const Contact<R, F>& law, const laws::At<laws::Velocity>& at, Touching touching,
                              schemes::In force, double dt, schemes::Out velocity) {
  if (!touching.directed) return undirected(touching);
  if (law.gamma == 0.0 && law.resolution == Resolution::sequential) {
    set_accelerations(touching, at.inverse_mass, force);
    hold(touching, dt);
  }
  return exchange_impulses(law, law.gamma * dt, at, touching, force, velocity);
}

/// A law that resolves impacts: `resolve_impacts(law, moving, touching, force, dt, velocity)`.
template <class L>
concept Impacts = requires(const L& law, const laws::At<laws::Velocity>& at, Touching touching, schemes::In force,
                           double dt, schemes::Out velocity) {
  { resolve_impacts(law, at, touching, force, dt, velocity) } -> std::same_as<schemes::Jump>;
};

/// A law that resolves impacts with a restitution that falls with temperature.
template <class L>
concept Softens = Impacts<L> && requires(const L& law, double theta) {
  { softening(law.restitution, theta) } -> std::same_as<double>;
};

/// Tells contacts what temperature leaves of their restitution.
///
/// @param law       with softening()
/// @param theta     temperatures, N [K]
/// @param touching  contacts; receives Touch::softened
template <class R>
void soften(const R& law, schemes::In theta, Touching& touching) {
  for (Touch& touch : touching.contacts) {
    touch.softened = softening(law, touch.j < 0 ? theta[touch.i] : 0.5 * (theta[touch.i] + theta[touch.j]));
  }
}

/// A law that turns impacts into heat: `add_heat_of_impact(law, at, impact, heat)` adds what the bodies gain to `heat`
/// [J] and returns the chemical energy of which it came beside kinetic energy [J].
template <class L>
concept HeatsImpacts = requires(const L& law, const laws::At<laws::Temperature>& at, const ImpactRecord& impact,
                                schemes::Out heat) {
  { add_heat_of_impact(law, at, impact, heat) } -> std::same_as<double>;
};

/// A law that locates its impacts: `first_impact(law, domain, radius, inverse_mass, neighbours, path, end)`.
template <class L, class D>
concept LocatesImpacts = Impacts<L> &&
    requires(const L& law, const D& domain, const Eigen::VectorXd& x, laws::Neighbours& neighbours,
             const schemes::StepPath& path, double end) {
  { first_impact(law, domain, x, x, neighbours, path, end) } -> std::same_as<std::optional<double>>;
};

/// What counts as touching to a law that resolves impacts: `touching_tolerance(law)`, exact touching by default.
///
/// @return a tolerance for find_touching()
template <class L>
ClosedGap touching_tolerance(const L&) {
  return {};
}

}  // namespace particulate::contact
