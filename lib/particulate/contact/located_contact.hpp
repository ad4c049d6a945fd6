#pragma once

#include <concepts>
#include <functional>
#include <optional>
#include <span>
#include <utility>

#include <particulate/contact/contact.hpp>
#include <particulate/schemes/problem.hpp>

namespace particulate::contact {

/// Contact of spheres with each other and with walls at the very moment at which they touch.
///
/// The step ends where the first gap closes (see schemes::integrate), and the impulses of section 2.2 act there at
/// once: no body enters another, and the motion between impacts keeps the order of its scheme. The other forces do
/// nothing during an impact, as it takes no time: the limit \f$ \gamma \to 0 \f$ of Contact.
///
/// @equation{R 2.2} The gaps of all pairs that could meet within the step are followed on its dense output, in a domain
/// of one's own at the cost of some N^2 tests a step. Every impact costs a step or two of all bodies: right for up to
/// some thousand, and needed where near fields bend their paths between impacts; without forces an event-driven gas
/// does the same faster. Contacts that close together within the touching tolerance are resolved together, so that a
/// symmetric hit stays symmetric. Bodies that touch or overlap at the start and part are left alone; if they approach,
/// and wherever touching bodies come closer by more than the tolerance, they meet at once.
///
/// Bodies that come to rest on each other meet infinitely often in a finite time. Where after an impact the other
/// forces press a pair together again before it has parted by a hundred times the touching tolerance, the run ends with
/// schemes::Failure::accumulating and the time at which all impacts would be over if the two met alone under a constant
/// acceleration a, \f$ t + (2/a) \sum_k w_k \f$ with the speeds of speeds_to_come() after each impact: a located
/// contact cannot hold what rests. Impacts that never end, as their restitution tends to 1, go on until the two part by
/// less than four times the tolerance; the run then ends with schemes::Failure::unsettled_jump, and no time.
/// @tparam RestitutionLaw  ConstantRestitution or Restitution
/// @tparam FrictionLaw     Frictionless or Friction
template <class RestitutionLaw = ConstantRestitution, class FrictionLaw = Frictionless>
struct LocatedContact {
  RestitutionLaw restitution = {};                 ///< ConstantRestitution or Restitution
  FrictionLaw friction = {};                       ///< Frictionless or Friction
  Resolution resolution = Resolution::sequential;  ///< of simultaneous contacts
  double touching = 1e-12;       ///< tau: a gap this small over the sum of the radii counts as closed, in (0, 1e-3] [-]
  ImpactRecorder recorder = {};  ///< is told of every impact; empty: nobody is
};

/// Refuses a width that is none.
///
/// @param touching  tau [-]
/// @throws std::invalid_argument saying what must hold and what was given
void validate_touching(double touching);

/// Refuses a contact law that is none. Called once, where a law enters a scene.
///
/// @param law  the law
/// @throws std::invalid_argument naming the constant, what must hold and what was given
template <class R, class F>
void validate(const LocatedContact<R, F>& law) {
  validate(law.restitution);
  validate(law.friction);
  validate(law.resolution);
  validate_touching(law.touching);
}

/// @param law  constants that validate() accepts
/// @return what counts as touching: a gap that rounding cannot tell from none
template <class R, class F>
ClosedGap touching_tolerance(const LocatedContact<R, F>& law) {
  return {.relative = law.touching, .roundings = 16.0};
}

/// Potential energy of a contact: none. @see potential_energy(const Contact<R, F>&, const D&, const laws::At<>&)
///
/// @equation{D 2.2}
/// @return zero [J]
template <class R, class F, kinematics::Domain D>
double potential_energy(const LocatedContact<R, F>&, const D&, const laws::At<>&) {
  return 0.0;
}

namespace detail {

// A domain with its type erased, as the search for gaps that close asks it.
struct AnyDomain {
  const void* self;
  const kinematics::Space* space;  // itself, if it is one
  Eigen::Vector3d (*between)(const void*, const Eigen::Vector3d& from, const Eigen::Vector3d& to);
  std::span<const kinematics::Wall> planes;
};

template <kinematics::Domain D>
AnyDomain erased(const D& domain) {
  AnyDomain any{&domain,
                nullptr,
                [](const void* self, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
                  return separation(*static_cast<const D*>(self), from, to);
                },
                {}};
  if constexpr (kinematics::HasWalls<D>) any.planes = walls(domain);
  if constexpr (std::same_as<D, kinematics::Space>) any.space = &domain;
  return any;
}

// The first place at which a gap closes.
std::optional<double> first_closing(const AnyDomain& domain, const ClosedGap& tolerance, const Eigen::VectorXd& radius,
                                    const Eigen::VectorXd& inverse_mass, laws::Neighbours& neighbours,
                                    const schemes::StepPath& path, double end);

// Books in a jump that two bodies have come to rest on each other, if any have; to_come gives speeds_to_come().
void tell_rest(const Touching& touching, const ClosedGap& gap, const laws::At<laws::Velocity>& at, schemes::In after,
               schemes::In force, const std::function<double(double)>& to_come, schemes::Jump& jump);

}  // namespace detail

/// The first place of a step at which a gap closes.
///
/// @param law           constants that validate() accepts
/// @param domain        forms the separations, and has the walls if there are any
/// @param radius        b_i, N [m]
/// @param inverse_mass  1/m_i, 0 for what is immovable, N [1/kg]
/// @param neighbours    the scene's, asked in space for the pairs that could meet
/// @param path          the step
/// @param end           how far to look [-]
/// @return its place, in (0, end]; none if no gap closes. A near miss is given as well where dense output, taken to be
///         off by 1e-4 of the radii in the middle of the step, cannot tell it from a touch
template <class R, class F, kinematics::Domain D>
std::optional<double> first_impact(const LocatedContact<R, F>& law, const D& domain, const Eigen::VectorXd& radius,
                                   const Eigen::VectorXd& inverse_mass, laws::Neighbours& neighbours,
                                   const schemes::StepPath& path, double end) {
  return detail::first_closing(detail::erased(domain), touching_tolerance(law), radius, inverse_mass, neighbours, path,
                               end);
}

/// Resolves the contacts of a moment: the jump of a scene with this law.
///
/// @equation{R 2.2}
/// @param law       constants that validate() accepts
/// @param at        the particles
/// @param touching  what find_touching() found with the law's tolerance
/// @param force     all other forces on the particles, 3 N numbers, column by column; they only tell rest [N]
/// @param velocity  a copy of the velocities, changed in place, 3 N numbers [m/s]
/// @return impacts, change of kinetic energy, overlap; what could not be settled, or come to rest and when
template <class R, class F>
schemes::Jump resolve_impacts(const LocatedContact<R, F>& law, const laws::At<laws::Velocity>& at, Touching touching,
                              schemes::In force, double, schemes::Out velocity) {
  if (!touching.directed) return undirected(touching);
  schemes::Jump jump = exchange_impulses(law, 0.0, at, touching, force, velocity);
  if (!jump.unsettled.empty()) return jump;
  const auto to_come = [&](double speed) { return speeds_to_come(law.restitution, speed); };
  detail::tell_rest(touching, touching_tolerance(law), at, velocity, force, to_come, jump);
  return jump;
}

}  // namespace particulate::contact
