#pragma once

#include <functional>
#include <string>
#include <vector>

#include <particulate/contact/impact.hpp>
#include <particulate/kinematics/particles.hpp>

/// @file
/// Several contacts at one moment: in what order their impulses act, and how often.

namespace particulate::contact {

/// How simultaneous contacts are resolved.
enum class Resolution {
  /// One impulse a contact, all from the velocities before, added: as the monograph does. It can create energy.
  summed,
  /// The fastest approach first, equal ones together, until no pair approaches. It cannot, but for the work of the
  /// other forces during the impacts, O(gamma Dt).
  sequential
};

/// Two bodies that touch.
struct Touch {
  Eigen::Index i = 0;                                      ///< one particle
  Eigen::Index j = -1;                                     ///< the other; negative: a wall
  Eigen::Vector3d n = Eigen::Vector3d::Zero();             ///< unit vector from i to j
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  ///< of i minus that of j, by all other forces [m/s^2]
  double overlap = 0.0;                                    ///< how deep they overlap [m]
  double hold = 0.0;                                       ///< step to hold it over if it rests; 0: it is not held [s]
  double parting = 0.0;                                    ///< speed at which it parts at least if it is held [m/s]
  double slow = 0.0;                                       ///< approach that the other forces make in hold [m/s]
  double softened = 1.0;                                   ///< what is left of restitution by temperature, 0 to 1 [-]
};

/// One impact, as it was resolved. Friction of contacts that were hit one after the other has a record of its own,
/// without a push: it is decided when the last one is.
struct ImpactRecord {
  Eigen::Index i = 0;                                    ///< one particle
  Eigen::Index j = -1;                                   ///< the other; negative: a wall
  Eigen::Vector3d n = Eigen::Vector3d::Zero();           ///< unit vector from i to j
  double push = 0.0;                                     ///< normal impulse that drives them apart, >= 0 [N s]
  Eigen::Vector3d tangential = Eigen::Vector3d::Zero();  ///< impulse of friction on i, across n [N s]
  Eigen::Vector3d before = Eigen::Vector3d::Zero();      ///< velocity of i as seen from j, before it [m/s]
  Eigen::Vector3d after = Eigen::Vector3d::Zero();       ///< and after it, with those resolved together [m/s]
  Eigen::Vector3d meanwhile = Eigen::Vector3d::Zero();   ///< change of it by the other forces over gamma Dt [m/s]
};

/// Is told of every impact; empty: nobody is.
using ImpactRecorder = std::function<void(const ImpactRecord&)>;

inline const ImpactRecorder nobody = {};  ///< records nothing

/// What the impulses of one moment did.
struct Resolved {
  long impacts = 0;            ///< impulses exchanged [-]
  double largest_impulse = 0;  ///< largest normal impulse of one impact [N s]
  double energy_change = 0;    ///< of the kinetic energy: every impulse times the mean relative velocity it acts on [J]
  std::string unsettled;       ///< not empty: pairs still approach, how fast, and what to do
};

/// Changes velocities by the impulses of contacts.
///
/// Contacts that hang together through bodies that can move form a cluster, which no other cluster concerns. Sequential
/// resolution takes, again and again, the contacts of a cluster that approach fastest, within 1e-10 of one another
/// relative to it, and resolves each connected group of them at once, by impulses that make all of them part with e
/// times their approach speed,
///
/// \f[ W P = (1 + e)(u + \Delta_1), \qquad P \ge 0, \f]
///
/// with W the inverse mass matrix seen along the normals, contacts that would have to pull left out. So a symmetric hit
/// stays symmetric and the order of numbering does not matter, beyond rounding. Without other forces the normal
/// impulses of a group take the energy \f$ \tfrac12 (1 - e^2)\, u^T W^{-1} u \ge 0 \f$.
///
/// Once no pair approaches, tangential_impulses() decides the friction of all contacts of the cluster together that
/// have pushed, equally fast or not, from the whole push of each and the slip that is left; it never gives energy.
/// Where it presses a pair together, pushes follow, and friction is decided anew from the sums, until both agree, at
/// most 1000 times; from the hundredth on it is kept if it presses nothing faster than 1e-9 of the first approach:
/// pushes alone make the end, and what sticks may slip about that fast. Contacts that only touch have no push, so no
/// friction.
///
/// A cluster is settled when it approaches nowhere faster than 1e-13 of its first approach, or than the rounding of its
/// velocities; it is given up after \f$ 10^4 + 200\,n^2 \f$ rounds of n contacts, which a light body pinched between
/// bodies thousands of times as heavy needs, as it carries their momentum across in as many hits as that ratio, and
/// which never suffice to an elastic body held between opposite walls; and before that where the rounds cost more than
/// some seconds, as those of hundreds of contacts do that overlap because there is no room for them. Then it says how
/// many contacts hang together and how deep. Two bodies that are both immovable exchange nothing.
///
/// Contacts that are to be held (Touch::hold) and rest take no part in that. Afterwards every cluster with an approach
/// in it gets the impulses after which each of its contacts parts at Touch::parting at least, those that just do so
/// together, with no restitution and friction that judges the slip halfway through the step to come.
///
/// @equation{D 2.2} The monograph sums; the rest is beyond it.
/// @tparam RestitutionLaw  ConstantRestitution or Restitution
/// @tparam FrictionLaw     Frictionless or Friction
template <class RestitutionLaw, class FrictionLaw>
struct ContactResolver {
  RestitutionLaw restitution;                      ///< share of the approach speed that is kept
  FrictionLaw friction;                            ///< Friction or Frictionless
  Resolution resolution = Resolution::sequential;  ///< in what order
  const ImpactRecorder& recorder = nobody;         ///< is told of every impact; it must outlive the resolver
  bool holding = false;                            ///< every contact parts at Touch::parting at least
  double most_work = 3e9;                          ///< work after which a cluster is given up [multiplications]

  /// Resolves all contacts of one moment.
  ///
  /// @param touching      the contacts, each direction a unit vector
  /// @param inverse_mass  1/m_i, 0 for what is immovable, N [1/kg]
  /// @param duration      gamma Dt [s]
  /// @param velocity      velocities before, changed in place, N x 3 [m/s]
  /// @return what was done; velocities are meaningless where it is unsettled
  Resolved operator()(const std::vector<Touch>& touching, const Eigen::VectorXd& inverse_mass, double duration,
                      kinematics::VectorsOut velocity) const;
};

}  // namespace particulate::contact
