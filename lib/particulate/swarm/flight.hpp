#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/swarm/obstacles.hpp>

namespace particulate::swarm {

/// A member whose step ended inside an obstacle.
struct Loss {
  Eigen::Index member;       ///< its number in the start
  std::size_t obstacle;      ///< the number of the obstacle
  double t;                  ///< when the step ended [s]
  Eigen::Vector3d place;     ///< where, and where it stays [m]
  Eigen::Vector3d velocity;  ///< that it had at last [m/s]
};

/// What became of a swarm.
struct Flight {
  schemes::Outcome outcome;  ///< of all legs together
  schemes::State state;      ///< of all members of the start: the lost are at rest at their places
  std::vector<Loss> lost;    ///< one after the other, by time and then by number
};

namespace detail {

// Who still flies, and the whole swarm around them.
class Legs {
 public:
  // Refuses a swarm without a member, and a member that starts inside an obstacle.
  Legs(const kinematics::Particles& start, const kinematics::Space& domain, const Obstacles* obstacles);

  bool are_all() const { return lost_.empty(); }
  bool any_fly() const { return !flying_.empty(); }
  kinematics::Particles flying() const { return chosen(start_, flying_); }
  // Where those who still fly are: the state of a leg.
  schemes::State& state() { return state_; }

  // Whether the end of a step is inside an obstacle for someone.
  bool find_lost(const schemes::State& to);
  // Takes out those who were found in the last step of a leg that has ended. Returns whether there were any.
  bool end_leg();
  // The whole swarm, with those who fly as they are in the state of a leg.
  const schemes::State& whole(const schemes::State& flying, schemes::State& all) const;
  void scatter(const schemes::State& flying, schemes::State& all) const;

  // What failed names members by their numbers among those who fly.
  void say_who_flew(schemes::Outcome& outcome) const;
  std::vector<Loss> take_losses() { return std::move(lost_); }

 private:
  struct Found {
    Eigen::Index k;  // among those who fly
    std::size_t obstacle;
  };
  const kinematics::Particles& start_;
  kinematics::Space domain_;
  const Obstacles* obstacles_;        // null: none can be lost
  Eigen::Vector3d low_, high_;        // around all obstacles
  std::vector<Eigen::Index> flying_;  // their numbers in the start, ascending
  std::vector<Found> found_;
  std::vector<Loss> lost_;
  schemes::State state_, resting_;
};

// A scheme as an observer of the whole swarm sees it.
template <class S>
struct WholeScheme {
  const S& scheme;
  const Legs& legs;
  const schemes::State& flying;  // start of the step, of those who fly

  void at(const schemes::State& from, double dt, double theta, schemes::State& there) const requires schemes::Dense<S> {
    if (legs.are_all()) return scheme.at(from, dt, theta, there);
    schemes::State part;
    scheme.at(flying, dt, theta, part);
    there = from;
    legs.scatter(part, there);
  }
};

// That of a swarm of which nobody flies any more.
struct AtRest {
  void at(const schemes::State& from, double dt, double theta, schemes::State& there) const {
    there = from;
    schemes::advance_time(from, theta * dt, there);
  }
};

// Shows an observer the whole swarm, and ends a leg where someone is lost.
template <class Observer>
struct WholeObserver {
  Legs& legs;
  Observer& observer;
  bool goes_on = true;
  schemes::State from_ = {}, to_ = {};

  template <class S>
  bool operator()(const schemes::State& from, const schemes::State& to, double dt, const S& scheme) {
    const bool lost = legs.find_lost(to);
    const WholeScheme<S> whole{scheme, legs, from};
    goes_on = observer(legs.whole(from, from_), legs.whole(to, to_), dt, whole);
    return goes_on && !lost;
  }
  void rest_until(double t_end, schemes::Outcome& outcome) {
    schemes::State& now = legs.state();
    if (!(now.t < t_end)) return;
    const double dt = (t_end - now.t) - now.t_carry;
    from_ = to_ = legs.whole(now, from_);
    now.t = to_.t = t_end;
    now.t_carry = to_.t_carry = 0.0;
    const AtRest scheme;
    if (observer(std::as_const(from_), std::as_const(to_), dt, scheme)) return;
    outcome.status = schemes::Status::stopped;
    outcome.reason = "the observer asked for it";
  }
  void jumped(const schemes::State& after, const schemes::Jump& jump) requires schemes::SeesJumps<Observer> {
    observer.jumped(legs.whole(after, to_), jump);
  }
};

template <class L>
const Obstacles* obstacles_of(const L& law) {
  if constexpr (std::is_same_v<L, Obstacles>) return &law;
  return nullptr;
}

}  // namespace detail

/// Flies a swarm through obstacles: a run in legs, of which each ends where members are lost.
///
/// @equation{R 6.2} A member whose step ends inside an obstacle is lost: it stays there, at rest, and neither acts nor
/// is acted on. The leg of the run ends with that step; the next one has fewer members and the same laws, whose
/// constants stay those of the start. Within a step nothing changes, and no flag enters the state. A path that enters
/// an obstacle and leaves it within one step is not seen: keep v_max Dt well below their radii.
///
/// The observer, and Flight::state, know the whole swarm from start to end, in the order of the start. If all are lost
/// it is shown one last step, to the end, in which nothing moves.
/// @param start     the members, one at least; none inside an obstacle
/// @param domain    space
/// @param t_end     the end time, from t = 0 [s]
/// @param scheme    the scheme
/// @param control   the step control
/// @param observer  as that of schemes::integrate(), of the whole swarm
/// @param laws      of the scene; Obstacles, if there are any, at most once
/// @return what became of it; its outcome says whether the end was reached. Numbers in the reason of a failure are
///         those among the members that still flew
/// @throws std::invalid_argument for no member, a member that starts inside an obstacle, which it names, and as a scene
///         and schemes::integrate()
template <class S, class C, class Observer, class... Laws>
Flight fly(const kinematics::Particles& start, const kinematics::Space& domain, double t_end, S&& scheme, C&& control,
           Observer&& observer, const Laws&... laws) {
  static_assert((0 + ... + static_cast<int>(std::is_same_v<Laws, Obstacles>)) <= 1, "a swarm has its obstacles once");
  const Obstacles* obstacles = nullptr;
  ((obstacles = obstacles ? obstacles : detail::obstacles_of(laws)), ...);
  detail::Legs legs(start, domain, obstacles);
  detail::WholeObserver<std::remove_reference_t<Observer>> seen{legs, observer};
  Flight flight;
  do {
    const scenes::Scene<kinematics::Space, Laws...> scene(legs.flying(), domain, laws...);
    flight.outcome += schemes::integrate(scene, legs.state(), t_end, scheme, control, seen);
    scheme.forget();
    if (flight.outcome.status == schemes::Status::failed || !legs.end_leg() || !seen.goes_on) break;
    flight.outcome.status = schemes::Status::reached;
    flight.outcome.reason.clear();
    if (!legs.any_fly()) seen.rest_until(t_end, flight.outcome);
  } while (legs.any_fly() && legs.state().t < t_end);
  flight.outcome.t = legs.state().t;
  legs.say_who_flew(flight.outcome);
  flight.state = legs.whole(legs.state(), seen.from_);
  flight.lost = legs.take_losses();
  return flight;
}

}  // namespace particulate::swarm
