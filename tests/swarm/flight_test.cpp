#include <particulate/swarm/flight.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <particulate/laws/near_field.hpp>
#include <particulate/scenes/history.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/sampling.hpp>
#include <particulate/schemes/symplectic_euler.hpp>
#include <particulate/schemes/verlet.hpp>
#include <particulate/swarm/linear_drag.hpp>
#include <particulate/swarm/speed_limit.hpp>
#include <particulate/swarm/target.hpp>

#include "close.hpp"
#include "clouds.hpp"

namespace tests::flight_test {

using namespace particulate::kinematics;
using namespace particulate::swarm;
using namespace particulate::schemes;
using particulate::laws::NearField;

FixedStep quarter() { return {.step = 0.25}; }

Particle member(const Eigen::Vector3d& place, const Eigen::Vector3d& velocity = {1.0, 0.0, 0.0}, double mass = 1.0) {
  return {.position = place, .velocity = velocity, .mass = mass, .radius = 0.0};
}

// Spheres that push nobody.
Obstacles spheres(const std::vector<Eigen::Vector3d>& centre, double radius) {
  return {.centre = centre, .radius = std::vector<double>(centre.size(), radius), .alpha = 0.0};
}

// Three side by side, 10 m apart, at 1 m/s along x; obstacle 0 is in the way of the last, obstacle 1 of the first.
Particles three_abreast() {
  return particles({member({0.0, 0.0, 0.0}), member({0.0, 10.0, 0.0}), member({0.0, 20.0, 0.0})});
}
const Obstacles two_in_the_way = spheres({{2.0, 20.0, 0.0}, {1.0, 0.0, 0.0}}, 0.25);

template <class Observer>
Flight fly_freely(const Particles& start, const Obstacles& obstacles, double t_end, Observer&& observer,
                  const Space& domain = {}) {
  return fly(start, domain, t_end, SymplecticEuler(), quarter(), observer, obstacles);
}

void same_bits(const State& a, const State& b) {
  BOOST_TEST(a.t == b.t);
  BOOST_TEST(a.t_carry == b.t_carry);
  BOOST_TEST(close(flat(a), flat(b), {}));
}

// Seven that attract and repel each other, of different masses, one of them immovable; number 3 flies into a wall of
// its own, far from the rest.
Particles unlike_members() {
  Particles some = random_cloud(7, Eigen::Vector3d::Constant(2.0), 0.1, 0.1);
  for (Eigen::Index i = 0; i < 7; ++i) some.mass[i] = 1.0 + 0.5 * static_cast<double>(i);
  some.immovable = {false, true, false, false, false, false, false};
  some.velocity.row(1).setZero();
  some.position.row(3) = Eigen::RowVector3d(1.0, 1.0, -4.0);
  some.velocity.row(3) = Eigen::RowVector3d(0.0, 0.0, -2.4);
  return some;
}
const Obstacles floor_of_one{.centre = {{1.5, 1.0, -5.5}}, .radius = {1.25}, .alpha = 0.05, .beta = 2.0};
const NearField bonds{.alpha1 = 0.03, .alpha2 = 0.01, .beta1 = -0.5, .beta2 = 1.5};
const Target ahead{.place = {10.0, 0.0, 0.0}, .alpha = 1.0, .beta = 0.5};
const LinearDrag drag{.c_d = 0.5};
const SpeedLimit limit{.v_max = 2.5};

template <class Observer = Unobserved>
Flight fly_together(const Particles& start, double t_end, Observer&& observer = {}) {
  return fly(start, Space{}, t_end, SymplecticEuler(), FixedStep{.step = 0.02}, observer, bonds, floor_of_one, ahead,
             drag, limit);
}

template <class Observer = Unobserved>
Outcome run_scene(const Particles& start, State& state, double t_end, Observer&& observer = {}) {
  const particulate::scenes::Scene scene(start, Space{}, bonds, floor_of_one, ahead, drag, limit);
  SymplecticEuler scheme;
  FixedStep control{.step = 0.02};
  return integrate(scene, state, t_end, scheme, control, observer);
}

BOOST_AUTO_TEST_SUITE(fly_)

// The first one is inside at the end of the step to x = 1, as x = 3/4 is on the surface; the last one at x = 2.
BOOST_AUTO_TEST_CASE(ends_the_way_of_members_whose_step_ends_inside_an_obstacle) {
  const Flight flight = fly_freely(three_abreast(), two_in_the_way, 4.0, Unobserved{});
  BOOST_TEST((flight.outcome.status == Status::reached));
  BOOST_TEST(flight.outcome.reason.empty());
  BOOST_TEST(flight.outcome.t == 4.0);
  BOOST_TEST(flight.outcome.steps == 16);
  BOOST_TEST(flight.outcome.evaluations == 16);
  BOOST_TEST_REQUIRE(flight.lost.size() == 2U);
  const Loss &first = flight.lost[0], &last = flight.lost[1];
  BOOST_TEST((first.member == 0 && first.obstacle == 1U && first.t == 1.0));
  BOOST_TEST((last.member == 2 && last.obstacle == 0U && last.t == 2.0));
  BOOST_TEST(close(first.place, Eigen::Vector3d(1.0, 0.0, 0.0), {}));
  BOOST_TEST(close(last.velocity, Eigen::Vector3d(1.0, 0.0, 0.0), {}));
  BOOST_TEST(close(positions(flight.state), Vectors{{1.0, 0.0, 0.0}, {4.0, 10.0, 0.0}, {2.0, 20.0, 0.0}}, {}));
  BOOST_TEST(close(velocities(flight.state), Vectors{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}, {}));
}

BOOST_AUTO_TEST_CASE(without_a_loss_is_the_run_of_a_scene_to_the_last_bit) {
  const Particles start = unlike_members();
  State state{.t = 0.0, .r = start.position.reshaped(), .v = start.velocity.reshaped()};
  const Outcome outcome = run_scene(start, state, 0.08);
  const Flight flight = fly_together(start, 0.08);
  BOOST_TEST(flight.lost.empty());
  same_bits(flight.state, state);
  BOOST_TEST(flight.outcome.energy_change == outcome.energy_change);
  BOOST_TEST(flight.outcome.evaluations == outcome.evaluations);
}

// From the loss on it is a scene of the others, which no longer feel the lost; M, masses and flags stay theirs.
BOOST_AUTO_TEST_CASE(goes_on_to_the_last_bit_as_a_scene_of_those_who_are_left) {
  const Particles start = unlike_members();
  const Flight whole = fly_together(start, 2.0);
  BOOST_TEST_REQUIRE(whole.lost.size() == 1U);
  BOOST_TEST(whole.lost[0].member == 3);
  const Flight until = fly_together(start, whole.lost[0].t);
  BOOST_TEST_REQUIRE(until.lost.size() == 1U);
  BOOST_TEST((until.outcome.status == Status::reached));

  const std::vector<Eigen::Index> others{0, 1, 2, 4, 5, 6};
  const Vectors r = positions(until.state)(others, Eigen::all), v = velocities(until.state)(others, Eigen::all);
  State left{.t = until.state.t, .r = r.reshaped(), .v = v.reshaped(), .t_carry = until.state.t_carry};
  const Outcome rest = run_scene(chosen(start, others), left, 2.0);
  const Vectors r_end = positions(whole.state)(others, Eigen::all), v_end = velocities(whole.state)(others, Eigen::all);
  BOOST_TEST(close(positions(left), r_end, {}));
  BOOST_TEST(close(velocities(left), v_end, {}));
  BOOST_TEST(close(position(whole.state, 1), Eigen::Vector3d(start.position.row(1)), {}));  // the immovable one
  BOOST_TEST(close(position(whole.state, 3), whole.lost[0].place, {}));
  BOOST_TEST(whole.outcome.energy_change == until.outcome.energy_change + rest.energy_change);
  BOOST_TEST(whole.outcome.steps == until.outcome.steps + rest.steps);
}

BOOST_AUTO_TEST_CASE(counts_a_loss_in_the_very_last_step) {
  const Flight flight = fly_freely(three_abreast(), two_in_the_way, 2.0, Unobserved{});
  BOOST_TEST((flight.outcome.status == Status::reached));
  BOOST_TEST(flight.outcome.t == 2.0);
  BOOST_TEST(flight.lost.size() == 2U);
  BOOST_TEST(velocity(flight.state, 2).isZero(0.0));
}

BOOST_AUTO_TEST_CASE(of_no_time_leaves_the_start) {
  const Flight flight = fly_freely(three_abreast(), two_in_the_way, 0.0, Unobserved{});
  BOOST_TEST((flight.outcome.status == Status::reached));
  BOOST_TEST(flight.outcome.steps == 0);
  BOOST_TEST(close(positions(flight.state), three_abreast().position, {}));
}

// Each before an obstacle of its own: at 1 s nobody flies any more, and one step of 3 s is left to be seen.
const Obstacles one_each = spheres({{1.0, 0.0, 0.0}, {1.0, 10.0, 0.0}, {1.0, 20.0, 0.0}}, 0.25);

BOOST_AUTO_TEST_CASE(of_which_all_are_lost_at_once_is_seen_to_rest_until_its_end) {
  std::vector<double> steps;
  State half;
  const auto observe = [&](const State& from, const State& to, double dt, const auto& scheme) {
    BOOST_TEST(to.t == from.t + dt);
    scheme.at(from, dt, 0.5, half);
    steps.push_back(dt);
    return true;
  };
  const Flight flight = fly_freely(three_abreast(), one_each, 4.0, observe);
  BOOST_TEST((flight.outcome.status == Status::reached));
  BOOST_TEST(flight.outcome.t == 4.0);
  BOOST_TEST(flight.outcome.steps == 4);
  BOOST_TEST(steps == std::vector<double>({0.25, 0.25, 0.25, 0.25, 3.0}), boost::test_tools::per_element());
  BOOST_TEST_REQUIRE(flight.lost.size() == 3U);
  for (Eigen::Index i = 0; i < 3; ++i) BOOST_TEST(flight.lost[static_cast<std::size_t>(i)].member == i);
  BOOST_TEST(half.t == 2.5);
  BOOST_TEST(close(half.r, flight.state.r, {}));
  BOOST_TEST(flight.state.v.isZero(0.0));
}

// The observer takes what it is shown as integrate() shows it: none of it is a temporary.
BOOST_AUTO_TEST_CASE(ends_with_all_lost_in_the_last_step_without_another_one) {
  int seen = 0;
  const auto observe = [&](auto&, auto&, double, auto&) { return ++seen > 0; };
  const Flight flight = fly_freely(three_abreast(), one_each, 1.0, observe);
  BOOST_TEST((flight.outcome.status == Status::reached));
  BOOST_TEST(flight.lost.size() == 3U);
  BOOST_TEST(seen == 4);
}

// In the step of a loss, and in the one in which nobody flies.
BOOST_AUTO_TEST_CASE(stops_where_the_observer_asks_for_it_and_keeps_the_loss_of_that_step) {
  const auto until = [](double t) {
    return [t](const State&, const State& to, double, const auto&) { return to.t < t; };
  };
  const Flight flight = fly_freely(three_abreast(), two_in_the_way, 4.0, until(1.0));
  BOOST_TEST((flight.outcome.status == Status::stopped));
  BOOST_TEST(flight.outcome.reason == "the observer asked for it");
  BOOST_TEST(flight.outcome.t == 1.0);
  BOOST_TEST_REQUIRE(flight.lost.size() == 1U);
  BOOST_TEST(flight.lost[0].member == 0);
  const Flight resting = fly_freely(three_abreast(), one_each, 4.0, until(4.0));
  BOOST_TEST((resting.outcome.status == Status::stopped));
  BOOST_TEST(resting.outcome.reason == "the observer asked for it");
  BOOST_TEST(resting.lost.size() == 3U);
}

// After 7.75 m the place 8 - 1/4 of the obstacle's image, with periods of 4 m.
BOOST_AUTO_TEST_CASE(loses_members_to_images_where_space_repeats_itself) {
  const Space ring{.lengths = {4.0, infinity, infinity}};
  const Obstacles one = spheres({{3.75, 5.0, 0.0}}, 0.2);
  const Flight flight =
      fly_freely(particles({member({0.0, 0.0, 0.0}), member({4.0, 5.0, 0.0})}), one, 8.0, Unobserved{}, ring);
  BOOST_TEST_REQUIRE(flight.lost.size() == 1U);
  BOOST_TEST(flight.lost[0].member == 1);
  BOOST_TEST(close(flight.lost[0].place, Eigen::Vector3d(7.75, 5.0, 0.0), {}));
}

BOOST_AUTO_TEST_CASE(loses_nobody_where_the_laws_hold_no_obstacles) {
  const Flight flight = fly(three_abreast(), Space{}, 1.0, SymplecticEuler(), quarter(), Unobserved{}, drag);
  BOOST_TEST((flight.outcome.status == Status::reached));
  BOOST_TEST(flight.lost.empty());
  BOOST_TEST(fly_freely(three_abreast(), Obstacles{}, 1.0, Unobserved{}).lost.empty());
}

// What a long sum of steps of 0.1 s takes from the time does not depend on who is lost.
BOOST_AUTO_TEST_CASE(keeps_the_time_to_the_last_bit_and_its_carry_through_a_loss) {
  const auto times_with = [](const Obstacles& obstacles) {
    std::vector<std::pair<double, double>> times;
    State last{.t = 0.0};
    const auto observe = [&](const State& from, const State& to, double, const auto&) {
      BOOST_TEST((from.t == last.t && from.t_carry == last.t_carry));
      last = to;
      times.emplace_back(to.t, to.t_carry);
      return true;
    };
    (void)fly(three_abreast(), Space{}, 50.0, SymplecticEuler(), FixedStep{.step = 0.1}, observe, obstacles);
    return times;
  };
  BOOST_TEST((times_with(two_in_the_way) == times_with(Obstacles{})));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(fly_observers)

// Also between the ends of steps, and of the step that follows a loss.
BOOST_AUTO_TEST_CASE(sample_the_whole_swarm) {
  int seen = 0;
  Sampling samples({0.0, 0.6, 1.0, 1.1, 2.0, 2.9, 4.0}, [&](const State& at) {
    const Vectors expected{{std::min(at.t, 1.0), 0.0, 0.0}, {at.t, 10.0, 0.0}, {std::min(at.t, 2.0), 20.0, 0.0}};
    BOOST_TEST_CONTEXT("at " << at.t << " s") { BOOST_TEST(close(positions(at), expected, {.absolute = 4 * eps})); }
    ++seen;
  });
  const Flight flight = fly_freely(three_abreast(), two_in_the_way, 4.0, samples);
  BOOST_TEST(flight.lost.size() == 2U);
  BOOST_TEST(seen == 7);
  BOOST_TEST(samples.left() == 0U);
}

// Everybody hits the cap of 1/2 m/s at the end of the first step and keeps to it: 3 (1 - 1/4)/2 J of 3 kg.
BOOST_AUTO_TEST_CASE(write_a_history_with_what_jumps_took) {
  const particulate::scenes::Scene scene(three_abreast(), Space{}, two_in_the_way);
  particulate::scenes::History history(scene, {0.25, 1.5, 8.0});
  const Flight flight = fly(three_abreast(), Space{}, 8.0, SymplecticEuler(), quarter(), history, two_in_the_way,
                            SpeedLimit{.v_max = 0.5});
  BOOST_TEST(flight.lost.size() == 2U);
  BOOST_TEST(flight.outcome.energy_change == -1.125);
  BOOST_TEST(flight.outcome.impacts == 3);
  const auto column = [&](const std::string& name) {
    const auto& names = history.columns();
    return static_cast<Eigen::Index>(std::find(names.begin(), names.end(), name) - names.begin());
  };
  BOOST_TEST_REQUIRE(history.rows().rows() == 3);
  BOOST_TEST(history.rows()(2, column("lost [J/kg]")) == 0.375);
  // Of three at 1/2 m/s one is left.
  BOOST_TEST(history.rows()(0, column("momentum x [kg m/s]")) == 1.5);
  BOOST_TEST(history.rows()(2, column("momentum x [kg m/s]")) == 0.5);
}

struct Jumps {
  std::vector<Eigen::Index> lengths = {};
  std::vector<double> last = {};
  template <class S>
  bool operator()(const State&, const State&, double, const S&) {
    return true;
  }
  void jumped(const State& after, const Jump&) {
    lengths.push_back(after.r.size());
    last.push_back(after.v[1]);
  }
};

BOOST_AUTO_TEST_CASE(are_told_the_jumps_of_the_whole_swarm) {
  Jumps jumps;
  const Flight flight =
      fly(three_abreast(), Space{}, 3.0, SymplecticEuler(), quarter(), jumps, two_in_the_way, SpeedLimit{.v_max = 0.5});
  BOOST_TEST(flight.lost.size() == 1U);
  BOOST_TEST(jumps.lengths == std::vector<Eigen::Index>(12, 9), boost::test_tools::per_element());
  BOOST_TEST(jumps.last == std::vector<double>(12, 0.5), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(may_throw_and_scheme_and_control_serve_again) {
  SymplecticEuler scheme;
  FixedStep control{.step = 0.25};
  const auto throws = [](const State&, const State& to, double, const auto&) -> bool {
    if (to.t >= 1.25) throw std::runtime_error("enough");
    return true;
  };
  BOOST_CHECK_EXCEPTION((void)fly(three_abreast(), Space{}, 4.0, scheme, control, throws, two_in_the_way),
                        std::runtime_error, says("enough"));
  const Flight again = fly(three_abreast(), Space{}, 4.0, scheme, control, Unobserved{}, two_in_the_way);
  same_bits(again.state, fly_freely(three_abreast(), two_in_the_way, 4.0, Unobserved{}).state);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(fly_schemes)

// Under a pull of 2 m/s^2 from far away, member 1 is on 8 t - t^2, and passes its turning point at 4 s; member 0 is
// lost on the way up, at the first end of a step at which it is above 9.
const Target below{.place = {-1e12, 0.0, 0.0}, .alpha = 2.0, .beta = 0.0};
const Obstacles lid = spheres({{10.0, 0.0, 0.0}}, 1.0);

template <class S, class C>
void parabola(S&& scheme, C&& control) {
  const Particles start =
      particles({member({0.0, 0.0, 0.0}, {8.0, 0.0, 0.0}), member({0.0, 9.0, 0.0}, {8.0, 0.0, 0.0}, 3.0)});
  Sampling samples({1.3, 4.7}, [](const State& at) {
    BOOST_TEST(at.r[1] == at.t * (8.0 - at.t), tolerance(1e-9));
    if (at.t > 2.0) BOOST_TEST(at.v[0] == 0.0);
  });
  const Flight flight = fly(start, Space{}, 5.0, scheme, control, samples, lid, below);
  BOOST_TEST((flight.outcome.status == Status::reached));
  BOOST_TEST_REQUIRE(flight.lost.size() == 1U);
  const Loss& lost = flight.lost[0];
  BOOST_TEST(lost.place.x() > 9.0);
  BOOST_TEST(lost.place.x() == lost.t * (8.0 - lost.t), tolerance(1e-9));
  BOOST_TEST(close(position(flight.state, 1), Eigen::Vector3d(15.0, 9.0, 0.0), {.relative = 1e-9, .absolute = 1e-9}));
  BOOST_TEST(close(velocity(flight.state, 1), Eigen::Vector3d(-2.0, 0.0, 0.0), {.relative = 1e-9, .absolute = 1e-9}));
}

BOOST_AUTO_TEST_CASE(of_equal_steps_serve) {
  parabola(VelocityVerlet(), FixedStep{.step = 0.01});
  parabola(RungeKutta4(), FixedStep{.step = 0.01});
}

BOOST_AUTO_TEST_CASE(of_steps_by_an_estimated_error_serve) {
  parabola(Collocation<Gauss<3>>(), ErrorControl{.TOL = 1e-9, .sweep_TOL = 1e-12, .limit = 0.05});
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(fly_failures)

// Members 1 and 2 meet on an exact time of a step, after member 0 is gone: among those who fly they are 0 and 1.
BOOST_AUTO_TEST_CASE(leave_the_state_and_say_why_and_whom_numbers_count) {
  const Particles start =
      particles({member({0.0, 0.0, 0.0}), member({0.0, 10.0, 0.0}), member({4.0, 10.0, 0.0}, {-1.0, 0.0, 0.0}, 1.0)});
  const NearField idle{.alpha1 = 1e-300};
  const Flight flight =
      fly(start, Space{}, 4.0, SymplecticEuler(), quarter(), Unobserved{}, spheres({{1.0, 0.0, 0.0}}, 0.25), idle);
  BOOST_TEST((flight.outcome.status == Status::failed));
  BOOST_TEST((flight.outcome.failure == Failure::no_value));
  BOOST_TEST(flight.outcome.t == 2.0);
  BOOST_TEST(flight.lost.size() == 1U);
  BOOST_TEST(close(position(flight.state, 2), Eigen::Vector3d(2.0, 10.0, 0.0), {}));
  BOOST_TEST(contains(flight.outcome.reason, "particles 0 and 1"));
  BOOST_TEST(contains(flight.outcome.reason, "its numbers count the 2 members that still flew, in their order"));
}

BOOST_AUTO_TEST_CASE(before_any_loss_need_no_such_words) {
  const Particles start = particles({member({0.0, 0.0, 0.0}), member({0.0, 0.0, 0.0})});
  const Flight flight = fly(start, Space{}, 4.0, SymplecticEuler(), quarter(), Unobserved{}, NearField{.alpha1 = 1.0});
  BOOST_TEST((flight.outcome.status == Status::failed));
  BOOST_TEST(flight.outcome.steps == 0);
  BOOST_TEST(flight.outcome.reason.find("still flew") == std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(fly_refuses)

BOOST_AUTO_TEST_CASE(a_swarm_of_nobody_and_a_member_that_starts_inside_an_obstacle) {
  const auto flight_of = [](const Particles& start) {
    return fly_freely(start, two_in_the_way, 1.0, Unobserved{}).lost.size();
  };
  CHECK_REFUSED(flight_of(Particles{}), "swarm: must have one member at least, got none");
  CHECK_REFUSED(flight_of(particles({member({0.0, 0.0, 0.0}), member({2.0, 20.1, 0.0})})),
                "swarm: no member may start inside an obstacle, but member 1 is inside obstacle 0: place it elsewhere");
  BOOST_CHECK_NO_THROW(flight_of(particles({member({2.0, 20.25, 0.0})})));
}

BOOST_AUTO_TEST_CASE(what_its_parts_refuse) {
  Particles wrong = three_abreast();
  wrong.mass[1] = 0.0;
  CHECK_REFUSED(fly_freely(wrong, two_in_the_way, 1.0, Unobserved{}), "masses must be positive");
  CHECK_REFUSED(fly_freely(three_abreast(), two_in_the_way, -1.0, Unobserved{}), "end time must be finite and not");
  CHECK_REFUSED(fly_freely(three_abreast(), spheres({{1.0, 0.0, 0.0}}, -1.0), 1.0, Unobserved{}),
                "radius of obstacle 0");
  CHECK_REFUSED(fly_freely(three_abreast(), two_in_the_way, 1.0, Unobserved{}, Space{.lengths = {0.0, 1.0, 1.0}}),
                "must be positive");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::flight_test
