#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <particulate/contact/contact.hpp>
#include <particulate/schemes/crossing.hpp>
#include <particulate/schemes/events.hpp>

namespace particulate::contact {

/// What counts as touching to a located contact: a gap that rounding cannot tell from none.
///
/// \f[ \tau\,(b_i + b_j) + 16\,\varepsilon\,(\|r_i\| + \|r_j\|) \f]
///
/// with a wall without its \f$ b_j \f$ and \f$ r_j \f$.
struct RoundingGap {
  double relative;  ///< tau [-]

  /// @param position  r_i, N x 3 [m]
  /// @param radius    b_i, N [m]
  /// @param i         one particle
  /// @param j         another; negative: a wall
  /// @return the widest gap that counts as closed [m]
  double between(const kinematics::VectorsIn& position, const Eigen::VectorXd& radius, Eigen::Index i,
                 Eigen::Index j) const {
    double reach = radius[i], size = position.row(i).norm();
    if (j >= 0) reach += radius[j], size += position.row(j).norm();
    return relative * reach + 16.0 * std::numeric_limits<double>::epsilon() * size;
  }
  /// The same, as find_touching() asks.
  ///
  /// @param at  the particles
  /// @param i   one particle
  /// @param j   another; negative: a wall
  /// @return the widest gap that counts as closed [m]
  double operator()(const Places& at, Eigen::Index i, Eigen::Index j) const {
    return between(at.position, at.radius, i, j);
  }
};

/// Contact of spheres with each other and with walls at the very moment at which they touch.
///
/// The step ends where the first gap closes (see schemes::integrate), and the impulses of section 2.2 act there at
/// once: no body enters another, and the motion between impacts keeps the order of its scheme. The other forces do
/// nothing during an impact, as it takes no time: the limit \f$ \gamma \to 0 \f$ of Contact.
///
/// @equation{R 2.2} The gaps of all pairs that could meet within the step are followed on its dense output, which costs
/// some N^2 tests a step, and every impact costs a step or two: right for up to some hundred bodies, and needed where
/// near fields bend their paths between impacts; without forces an event-driven gas does the same faster. Contacts that
/// close together within the touching tolerance are resolved together, so that a symmetric hit stays symmetric. Bodies
/// that touch or overlap at the start and part are left alone; if they approach, and wherever touching bodies come
/// closer by more than the tolerance, they meet at once.
///
/// Bodies that come to rest on each other meet infinitely often in a finite time. Where after an impact the other
/// forces press a pair together again before it has parted by a hundred times the touching tolerance, the run ends with
/// schemes::Failure::accumulating and the time at which all impacts would be over, \f$ t + 2 w/(a (1 - e)) \f$ for a
/// speed w after the impact, e times that before, and a constant acceleration a: a located contact cannot hold what
/// rests.
/// @tparam RestitutionLaw  ConstantRestitution or Restitution
/// @tparam FrictionLaw     Frictionless or Friction
template <class RestitutionLaw = ConstantRestitution, class FrictionLaw = Frictionless>
struct LocatedContact {
  RestitutionLaw restitution = {};                 ///< ConstantRestitution or Restitution
  FrictionLaw friction = {};                       ///< Frictionless or Friction
  Resolution resolution = Resolution::sequential;  ///< of simultaneous contacts
  double touching = 1e-12;  ///< tau: a gap this small over the sum of the radii counts as closed, in (0, 1e-3] [-]
};

/// Refuses a contact law that is none. Called once, where a law enters a scene.
///
/// @param law  the law
/// @throws std::invalid_argument naming the constant, what must hold and what was given
template <class R, class F>
void validate(const LocatedContact<R, F>& law) {
  validate(law.restitution);
  validate(law.friction);
  validate(law.resolution);
  if (!(law.touching > 0.0 && law.touching <= 1e-3)) {
    throw std::invalid_argument(fmt::format("contact: touching must lie in (0, 1e-3], got {}", law.touching));
  }
}

/// @param law  constants that validate() accepts
/// @return what counts as touching
template <class R, class F>
RoundingGap touching_tolerance(const LocatedContact<R, F>& law) {
  return {law.touching};
}

/// Potential energy of a contact: none. @see potential_energy(const Contact<R, F>&, const D&, const Places&)
///
/// @equation{D 2.2}
/// @return zero [J]
template <class R, class F, kinematics::Domain D>
double potential_energy(const LocatedContact<R, F>&, const D&, const Places&) {
  return 0.0;
}

namespace detail {

// Two bodies that have met and will meet again and again.
struct Rest {
  Touch touch;
  double parting;  // speed after the impact [m/s]
  double rises;    // the widest gap before they meet again [m]
  double over;     // time at which all their impacts are over [s]
};

// The first contact whose bodies are pressed together again before they have parted by more than can be told from none.
inline std::optional<Rest> first_at_rest(const Touching& touching, const RoundingGap& gap, const Moving& at,
                                         const kinematics::VectorsIn& after, schemes::In force) {
  constexpr double indistinct = 100.0, rounding = 1e-13;
  const Eigen::Map<const kinematics::Vectors> f(force.data(), at.mass.size(), 3);
  for (const Touch& touch : touching.contacts) {
    const double met = approach_speed(touch, at.velocity);
    const double pressed = touch.acceleration.dot(touch.n);
    double felt = at.inverse_mass[touch.i] * f.row(touch.i).norm();
    if (touch.j >= 0) felt += at.inverse_mass[touch.j] * f.row(touch.j).norm();
    if (!(met > 0.0 && pressed > rounding * felt)) continue;
    const double parting = std::max(0.0, -approach_speed(touch, after));
    const double rises = parting * parting / (2.0 * pressed);
    if (rises > indistinct * gap(at, touch.i, touch.j)) continue;
    const double kept = parting / met;
    const double flights = kept < 1.0 ? 2.0 * parting / (pressed * (1.0 - kept)) : 0.0;
    return Rest{.touch = touch, .parting = parting, .rises = rises, .over = at.t + flights};
  }
  return {};
}

inline std::string comes_to_rest(const Rest& rest, double t) {
  const std::string who = rest.touch.j < 0 ? fmt::format("particle {} and a wall", rest.touch.i)
                                           : fmt::format("particles {} and {}", rest.touch.i, rest.touch.j);
  return fmt::format(
      "{} come to rest on each other: after their impact at t = {} s they part at {:.3g} m/s, the other forces press "
      "them together again before they are {:.3g} m apart, and their impacts are over at t = {} s; located contacts "
      "cannot hold what rests: end the run before, or take stepped contacts (Contact)",
      who, t, rest.parting, rest.rises, rest.over);
}

// A gap that may close: between two spheres, or between one and a wall.
struct Gap {
  Eigen::Index i;
  Eigen::Index j;  // negative: the wall
  const kinematics::Wall* wall;
};

// All gaps along one step.
template <kinematics::Domain D>
class Gaps {
 public:
  Gaps(const D& domain, const Eigen::VectorXd& radius, const Eigen::VectorXd& inverse_mass, const schemes::StepPath& path, double end)
      : domain_(domain),
        radius_(radius),
        inverse_mass_(inverse_mass),
        path_(path),
        places_(schemes::chebyshev_points(path.intervals, end)),
        states_(places_.size()) {
    Eigen::VectorXd fastest = Eigen::VectorXd::Zero(radius.size());
    for (std::size_t k = 0; k < places_.size(); ++k) {
      path_(places_[k], states_[k]);
      fastest = fastest.cwiseMax(rows(states_[k].v).rowwise().norm());
    }
    // The samples are dense enough that no speed between them is sqrt(2) times as large.
    travel_ = std::sqrt(2.0) * end * path.dt * fastest;
  }

  // The first place at which one of them closes.
  std::optional<double> first_closing(const RoundingGap& tolerance) {
    std::optional<double> first;
    const Rows start = rows(states_[0].r);
    const auto look_at = [&](const Gap& gap) {
      const double slack = tolerance.between(start, radius_, gap.i, gap.j);
      if (!(width(gap, states_[0]) <= travel_[gap.i] + (gap.j >= 0 ? travel_[gap.j] : 0.0) + slack)) return;
      const std::optional<double> closes = closing(gap, slack);
      if (closes && !(first && *first <= *closes)) first = closes;
    };
    for (Eigen::Index i = 0; i < radius_.size(); ++i) {
      for (Eigen::Index j = i + 1; j < radius_.size(); ++j) {
        if (inverse_mass_[i] > 0.0 || inverse_mass_[j] > 0.0) look_at({.i = i, .j = j, .wall = nullptr});
      }
      if constexpr (kinematics::HasWalls<D>) {
        if (!(inverse_mass_[i] > 0.0)) continue;
        for (const kinematics::Wall& wall : walls(domain_)) look_at({.i = i, .j = -1, .wall = &wall});
      }
    }
    return first;
  }

 private:
  using Rows = Eigen::Map<const kinematics::Vectors>;
  static Rows rows(const Eigen::VectorXd& flat) { return {flat.data(), flat.size() / 3, 3}; }

  double width(const Gap& gap, const schemes::State& there) const {
    const Rows r = rows(there.r);
    if (gap.wall) return kinematics::height_above(*gap.wall, r.row(gap.i).transpose()) - radius_[gap.i];
    return separation(domain_, r.row(gap.i).transpose(), r.row(gap.j).transpose()).norm() -
           (radius_[gap.i] + radius_[gap.j]);
  }

  // Its derivative by theta.
  double opening(const Gap& gap, const schemes::State& there) const {
    const Rows r = rows(there.r), v = rows(there.v);
    const Eigen::Vector3d v_i = v.row(gap.i);
    if (gap.wall) return path_.dt * v_i.dot(gap.wall->normal);
    const Eigen::Vector3d towards = separation(domain_, r.row(gap.i).transpose(), r.row(gap.j).transpose());
    const Eigen::Vector3d v_j = v.row(gap.j);
    return path_.dt * (v_j - v_i).dot(towards.normalized());
  }

  std::optional<double> closing(const Gap& gap, double slack) {
    std::vector<schemes::Sample> samples;
    for (std::size_t k = 0; k < places_.size(); ++k) {
      samples.push_back({.theta = places_[k], .value = width(gap, states_[k]), .slope = opening(gap, states_[k])});
    }
    if (!may_close(samples, slack)) return {};
    const schemes::Along along{.value =
                                   [&](double theta) {
                                     path_(theta, there_);
                                     return width(gap, there_);
                                   },
                               .slope =
                                   [&](double theta) {
                                     path_(theta, there_);
                                     return opening(gap, there_);
                                   }};
    // What dense output only brings near a touch is solved anew to see.
    const double reach = radius_[gap.i] + (gap.wall ? 0.0 : radius_[gap.j]);
    const double at_start = samples.front().value;
    // Touching bodies meet again where they come closer by the tolerance, and once they have parted, where they touch.
    const schemes::ZeroRules rules{.direction = schemes::Direction::falling,
                                   .leave = slack,
                                   .graze = slack,
                                   .doubt = 1e-4 * reach,
                                   .floor = std::min(at_start, 0.0) - slack};
    int side = at_start > slack ? 1 : 0;
    const std::optional<schemes::Crossing> found = schemes::first_crossing(samples, along, rules, side);
    return found ? std::optional(found->theta) : std::nullopt;
  }

  // The gap between two paths is convex but for what forces bend them: two of its tangents meet below it. Where they
  // meet above a quarter of its smaller end it stays open.
  static bool may_close(const std::vector<schemes::Sample>& samples, double slack) {
    for (std::size_t k = 1; k < samples.size(); ++k) {
      const schemes::Sample &a = samples[k - 1], &b = samples[k];
      const double smaller = std::min(a.value, b.value);
      if (smaller <= slack) return true;
      if (!(a.slope < 0.0 && b.slope > 0.0)) continue;
      const double meet = (b.value - a.value - b.slope * (b.theta - a.theta)) / (a.slope - b.slope);
      if (a.value + a.slope * meet < 0.25 * smaller) return true;
    }
    return false;
  }

  const D& domain_;
  const Eigen::VectorXd& radius_;
  const Eigen::VectorXd& inverse_mass_;
  const schemes::StepPath& path_;
  std::vector<double> places_;
  std::vector<schemes::State> states_;
  Eigen::VectorXd travel_;  // the farthest that each body can get within the step [m]
  schemes::State there_;
};

}  // namespace detail

/// The first place of a step at which a gap closes.
///
/// @param law           constants that validate() accepts
/// @param domain        forms the separations, and has the walls if there are any
/// @param radius        b_i, N [m]
/// @param inverse_mass  1/m_i, 0 for what is immovable, N [1/kg]
/// @param path          the step
/// @param end           how far to look [-]
/// @return its place, in (0, end]; none if no gap closes. A near miss is given as well where dense output, taken to be
/// off
///         by 1e-4 of the radii in the middle of the step, cannot tell it from a touch
template <class R, class F, kinematics::Domain D>
std::optional<double> first_impact(const LocatedContact<R, F>& law, const D& domain, const Eigen::VectorXd& radius,
                                   const Eigen::VectorXd& inverse_mass, const schemes::StepPath& path, double end) {
  return detail::Gaps<D>(domain, radius, inverse_mass, path, end).first_closing(touching_tolerance(law));
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
schemes::Jump resolve_impacts(const LocatedContact<R, F>& law, const Moving& at, Touching touching, schemes::In force,
                              double, schemes::Out velocity) {
  if (!touching.directed) return {.overlap = touching.overlap, .unsettled = without_direction(touching)};
  schemes::Jump jump = exchange_impulses(law, 0.0, at, touching, force, velocity);
  if (!jump.unsettled.empty()) return jump;
  const Eigen::Map<const kinematics::Vectors> after(velocity.data(), at.mass.size(), 3);
  const std::optional<detail::Rest> rest = detail::first_at_rest(touching, touching_tolerance(law), at, after, force);
  if (rest) {
    jump.unsettled = detail::comes_to_rest(*rest, at.t);
    jump.accumulates = rest->over;
  }
  return jump;
}

}  // namespace particulate::contact
