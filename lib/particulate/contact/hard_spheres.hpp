#pragma once

#include <concepts>
#include <functional>
#include <utility>

#include <particulate/contact/impact.hpp>
#include <particulate/kinematics/domain.hpp>
#include <particulate/kinematics/particles.hpp>
#include <particulate/schemes/outcome.hpp>
#include <particulate/schemes/state.hpp>

namespace particulate::contact {

/// One impact of a gas of hard spheres.
struct Collision {
  double t = 0.0;                               ///< when [s]
  double t_carry = 0.0;                         ///< what rounding took from t: the time is t + t_carry [s]
  Eigen::Index i = 0;                           ///< one particle
  Eigen::Index j = -1;                          ///< the other, j > i; negative: a wall
  Eigen::Index wall = -1;                       ///< number of the wall; negative: a particle
  Eigen::Vector3d n = Eigen::Vector3d::Zero();  ///< unit vector from i to j, or into the wall
  Impulse impulse = {};                         ///< momentum that i gets, and j or the wall loses
  double approach_speed = 0.0;                  ///< \f$ (v_i - v_j) \cdot n \f$ before it, > 0 [m/s]
  double energy_change = 0.0;                   ///< of the kinetic energy [J]
  bool elastic = false;                         ///< whether it was made so, as it followed within the contact time
};

/// Is told of every impact after it, in the order of time; empty: nobody is.
using CollisionRecorder = std::function<void(const Collision&)>;

/// What a run of a gas of hard spheres did beyond its outcome.
struct Tally {
  long wall_impacts = 0;     ///< of outcome.impacts those with walls [-]
  long elastic_impacts = 0;  ///< of outcome.impacts those that the contact time made elastic [-]
  long crossings = 0;        ///< of a body from one cell of the search into the next [-]
  long predictions = 0;      ///< of the next impact of a body, from all near it [-]
};

namespace detail {

// Spheres, where they are and what an impact does, its laws erased.
struct Gas {
  const kinematics::Particles& particles;
  const Eigen::VectorXd& inverse_mass;
  const kinematics::Space& domain;
  double contact_time;
  const void* laws;
  Impulse (*impulse)(const void* laws, const Body& i, const Body& j, const Eigen::Vector3d& n, bool elastic);
};

void validate(const Gas& gas);
schemes::Outcome advance(const Gas& gas, schemes::State& state, double t_end, const CollisionRecorder& recorder,
                         Tally& tally);

}  // namespace detail

/// A gas of hard spheres without forces: free flight from impact to impact, each exact in time.
///
/// Every body flies straight until the first root of
///
/// \f[ \|r_{ij} + v_{ij}\,\tau\| = b_i + b_j, \qquad
///     \tau = \frac{c}{-\beta + \sqrt{\beta^2 - v^2 c}}, \quad \beta = r_{ij} \cdot v_{ij} < 0, \quad
///     c = r_{ij}^2 - (b_i + b_j)^2, \f]
///
/// or until it meets a wall. There the impulses of section 2.2 act at once, with the same restitution and friction as
/// in Contact and LocatedContact, of which this is the limit without forces. The cost of an impact hardly depends on
/// the number of bodies: each is looked for among those near it, in cells that bodies leave as events of their own, and
/// the first event of all stands at the top of a tree.
///
///     HardSpheres gas(particles, {.lengths = {1, 1, 1}}, ConstantRestitution{0.9});
///     State state = start(gas);
///     for (const double t : times) {
///       if (gas.advance(state, t).status != Status::reached) break;
///       measure(state);
///     }
///
/// Events of one time happen in the order of their smaller number, then of the larger, walls last: bodies that meet in
/// one moment are resolved pair by pair until none approach. A run depends on the state alone: nothing but the state,
/// y included, goes on from one advance() to the next, so that a run goes on from a state that was written with the
/// same bits.
///
/// **Rounding.** A pair that touches and approaches meets at once, however deep; after an impact it does not approach,
/// to the last bit. Approaches within the rounding of velocities are no impacts: they are stopped, unrecorded, when
/// they have come closer by some roundings of the places. So no impact is lost or doubled, and the deepest overlap,
/// which the outcome tells, is of the size of roundings of places and of the steps from one to the next period.
///
/// **Inelastic collapse.** Three bodies or more can meet infinitely often in finite time (for three equal ones on a
/// line if \f$ e < 7 - 4\sqrt3 \approx 0.0718 \f$). Where a body meets others five times in a row with no flight that
/// rounding could tell from none, and the last time more slowly by 1e-8 than the first or as slowly as rounding, the
/// run ends with schemes::Failure::accumulating, the bodies, and the time as well as rounding of places over that first
/// speed lets it be known; so does an endless elastic one, of a body held between opposite walls, after 1e5 impacts.
/// That is so too where three that touch are hit and never done with. What collapses faster than five impacts can tell
/// goes on with its bodies at rest on each other. With a contact time t_c > 0 impacts that follow the last one of
/// either body by less are elastic and without friction, which ends every collapse: the TC model of @cite luding1998.
/// The rest of t_c of every body rides along in the state's y.
///
/// @equation{D 2.2} Impacts of (2.16) without other forces, at the moments of first touch.
/// @tparam RestitutionLaw  ConstantRestitution or Restitution
/// @tparam FrictionLaw     Frictionless or Friction
template <class RestitutionLaw = ConstantRestitution, class FrictionLaw = Frictionless>
class HardSpheres {
 public:
  /// Checks all of it once.
  ///
  /// @param particles     the start, and what stays with each particle; points meet no points, immovable bodies are
  ///                      moved by no impact
  /// @param domain        with periods of two diameters at least
  /// @param restitution   ConstantRestitution or Restitution
  /// @param friction      Frictionless or Friction
  /// @param contact_time  t_c >= 0; 0: none [s]
  /// @throws std::invalid_argument from the first part that refuses itself
  explicit HardSpheres(kinematics::Particles particles, kinematics::Space domain = {}, RestitutionLaw restitution = {},
                       FrictionLaw friction = {}, double contact_time = 0.0)
      : particles_(std::move(particles)),
        domain_(std::move(domain)),
        laws_{restitution, friction},
        contact_time_(contact_time) {
    contact::validate(restitution);
    if constexpr (!std::same_as<FrictionLaw, Frictionless>) contact::validate(friction);
    detail::validate(gas());
    inverse_mass_ = inverse_masses(particles_);
  }

  /// @return the start, and what stays with each particle
  const kinematics::Particles& particles() const { return particles_; }
  /// @return where they are
  const kinematics::Space& domain() const { return domain_; }
  /// @return what the last run did
  const Tally& tally() const { return tally_; }

  /// Lets the gas fly on. A run in several parts is another one than that in one part, by roundings.
  ///
  /// @param state     of N particles, none of which overlaps another or a wall; y empty or N rests of the contact time.
  ///                  Receives the end, as far as the run came, also if the recorder throws
  /// @param t_end     not before it [s]
  /// @param recorder  is told of every impact
  /// @return how it ended, impacts, change of kinetic energy, deepest overlap
  /// @throws std::invalid_argument for a state or a time that cannot be meant, or of a size that roots of gaps do not
  ///         hold, beyond 1e70 and below 1e-70; for bodies that overlap by more than rounding, with the deepest overlap
  schemes::Outcome advance(schemes::State& state, double t_end, const CollisionRecorder& recorder = {}) {
    return detail::advance(gas(), state, t_end, recorder, tally_);
  }

 private:
  using Laws = std::pair<RestitutionLaw, FrictionLaw>;

  static Impulse impulse(const void* laws, const Body& i, const Body& j, const Eigen::Vector3d& n, bool elastic) {
    const auto& [restitution, friction] = *static_cast<const Laws*>(laws);
    if (elastic) return impact_impulse(i, j, n, 1.0, External{}, Frictionless{});
    const double e = restitution_at(restitution, (i.velocity - j.velocity).dot(n));
    return impact_impulse(i, j, n, e, External{}, friction);
  }
  detail::Gas gas() const { return {particles_, inverse_mass_, domain_, contact_time_, &laws_, &impulse}; }

  kinematics::Particles particles_;
  kinematics::Space domain_;
  Laws laws_;
  double contact_time_;
  Eigen::VectorXd inverse_mass_;
  Tally tally_;
};

/// Where a gas starts.
///
/// @param gas  the gas
/// @return its particles' positions and velocities at t = 0
template <class R, class F>
schemes::State start(const HardSpheres<R, F>& gas) {
  return {.t = 0.0, .r = gas.particles().position.reshaped(), .v = gas.particles().velocity.reshaped()};
}

}  // namespace particulate::contact
