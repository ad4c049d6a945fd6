#include <particulate/swarm/design.hpp>

#include <cmath>
#include <cstddef>
#include <string>
#include <thread>
#include <vector>

#include "close.hpp"
#include "clouds.hpp"
#include "contact/moment.hpp"

namespace tests::design_test {

using namespace particulate::kinematics;
using namespace particulate::swarm;
using particulate::schemes::Failure;
using particulate::schemes::State;
using particulate::schemes::Status;

// A constant pull of 4 per unit mass to the target.
const Design pulled{.alpha_t = 4.0, .beta_t = 0.0};

Particles one_at(const Eigen::Vector3d& place, const Eigen::Vector3d& velocity = Eigen::Vector3d::Zero()) {
  return particles({{.position = place, .velocity = velocity, .mass = 2.0, .radius = 0.0}});
}

// N members at rest in the cube of half side 1 about (0, 0, -1).
Particles cloud_of(Eigen::Index N) {
  Particles cloud = random_cloud(N, Eigen::Vector3d::Constant(2.0), 0.1, 0.1);
  cloud.position.rowwise() -= Eigen::RowVector3d(1.0, 1.0, 2.0);
  cloud.velocity.setZero();
  return cloud;
}

// Nothing but the way to the target, and so long a flight.
Course open_course(double duration, double step) { return {.c_d = 0.0, .duration = duration, .step = step}; }

BOOST_AUTO_TEST_SUITE(design_string)

BOOST_AUTO_TEST_CASE(is_a_design_in_the_order_of_its_parameters) {
  const Eigen::VectorXd string = Eigen::VectorXd::LinSpaced(8, 1.0, 8.0);
  const Design design = design_of(string);
  BOOST_TEST((design.alpha1 == 1.0 && design.alpha2 == 2.0 && design.beta1 == 3.0 && design.beta2 == 4.0));
  BOOST_TEST((design.alpha_o == 5.0 && design.beta_o == 6.0 && design.alpha_t == 7.0 && design.beta_t == 8.0));
  BOOST_TEST(close(string_of(design), string, {}));
}

BOOST_AUTO_TEST_CASE(of_another_length_is_refused) {
  for (const Eigen::Index length : {0, 7, 9}) {
    CHECK_REFUSED(design_of(Eigen::VectorXd::Zero(length)),
                  "design: must have 8 parameters, got " + std::to_string(length));
  }
}

BOOST_AUTO_TEST_CASE(may_lie_anywhere_within_the_bounds) {
  const auto bounds = design_bounds();
  const Eigen::VectorXd &lower = bounds.lower, &upper = bounds.upper;
  BOOST_TEST((lower.array() < upper.array()).all());
  BOOST_CHECK_NO_THROW(validate(design_of(lower)));
  BOOST_CHECK_NO_THROW(validate(design_of(upper)));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(design_validate)

// As it was given, not as the laws call it.
BOOST_AUTO_TEST_CASE(names_the_parameter_what_must_hold_and_what_was_given) {
  BOOST_CHECK_NO_THROW(validate(Design{}));
  CHECK_REFUSED(validate(Design{.alpha1 = -1.0}), "design: alpha1 must be finite and not negative, got -1");
  CHECK_REFUSED(validate(Design{.alpha2 = not_a_number}), "design: alpha2 must be finite and not negative, got nan");
  CHECK_REFUSED(validate(Design{.beta1 = 1.5}), "design: beta1 must be finite and at most 1, got 1.5");
  CHECK_REFUSED(validate(Design{.beta2 = -2.0}), "design: beta2 must be finite and at least -1, got -2");
  CHECK_REFUSED(validate(Design{.alpha_o = infinity}), "design: alpha_o must be finite and not negative, got inf");
  CHECK_REFUSED(validate(Design{.beta_o = 0.0}), "design: beta_o must be positive and finite, got 0");
  CHECK_REFUSED(validate(Design{.alpha_t = -3.0}), "design: alpha_t must be finite and not negative, got -3");
  CHECK_REFUSED(validate(Design{.beta_t = 1.1}), "design: beta_t must lie between 0 and 1, got 1.1");
  CHECK_REFUSED(fly(Design{.beta1 = 1.5}, fence(), cloud_of(2)), "design: beta1 must be finite and at most 1");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(course)

BOOST_AUTO_TEST_CASE(fence_is_nine_obstacles_before_the_target_the_centre_one_on_the_way) {
  const Course course = fence();
  BOOST_CHECK_NO_THROW(validate(course));
  BOOST_TEST_REQUIRE(course.obstacles.size() == 9U);
  BOOST_TEST(course.radii == std::vector<double>(9, 0.5), boost::test_tools::per_element());
  BOOST_TEST(close(course.obstacles[4], Eigen::Vector3d(5.0, 0.0, 0.0), {}));
  BOOST_TEST(close(course.obstacles[0], Eigen::Vector3d(5.0, -2.0, -2.0), {}));
  BOOST_TEST(close(course.obstacles[5], Eigen::Vector3d(5.0, 0.0, 2.0), {}));
  BOOST_TEST(close(course.target, Eigen::Vector3d(10.0, 0.0, 0.0), {}));
}

BOOST_AUTO_TEST_CASE(names_what_cannot_be_flown) {
  const auto refuses = [](auto change, const char* words) {
    Course course = fence();
    change(course);
    CHECK_REFUSED(validate(course), words);
    CHECK_REFUSED(objective({cloud_of(1)}, course), words);
  };
  refuses([](Course& c) { c.radii.pop_back(); }, "got 9 centres and 8 radii");
  refuses([](Course& c) { c.target.x() = infinity; }, "target: place must be finite");
  refuses(
      [](Course& c) {
        c.target = {5.0, 0.0, 0.4};
      },
      "course: the target must be outside of all obstacles, but is inside obstacle 4: place it elsewhere");
  refuses([](Course& c) { c.c_d = -1.0; }, "drag: c_d must be finite and not negative, got -1");
  refuses([](Course& c) { c.v_max = -1.0; }, "speed limit: v_max must not be negative, got -1");
  refuses([](Course& c) { c.duration = 0.0; }, "course: duration must be positive and finite, got 0");
  refuses([](Course& c) { c.step = not_a_number; }, "course: step must be positive and finite, got nan");
  refuses([](Course& c) { c.loss_penalty = -1.0; }, "course: loss_penalty must be finite and not negative, got -1");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(members_law_)

// Of 2 and 3 kg, 4 m apart, of 10 kg in all: 2 3/10 (5 4^0.5 - 8 4^-1) = 0.6 8 N together.
BOOST_AUTO_TEST_CASE(is_per_mass_of_the_whole_and_attracts_by_a_power_that_grows) {
  const particulate::laws::NearField law =
      members_law({.alpha1 = 5.0, .alpha2 = 8.0, .beta1 = 0.5, .beta2 = 1.0}, 10.0);
  const Moment moment{particles({{.position = {0.0, 0.0, 0.0}, .mass = 2.0, .radius = 0.0},
                                 {.position = {0.0, 4.0, 0.0}, .mass = 3.0, .radius = 0.0}})};
  Vectors force = Vectors::Zero(2, 3);
  BOOST_TEST(add_force(law, Space{}, moment.at(), particulate::laws::Forces(force.data(), 2, 3)));
  BOOST_TEST(close(force, Vectors{{0.0, 4.8, 0.0}, {0.0, -4.8, 0.0}}, {.relative = 16 * eps}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(fly_a_design)

// Capped at 3 m/s after 3/4 s: (10 3/4 - (2/3) 0.75^3 + 2.25 (8.875 + 2.125)/2)/30 = 0.653125, but for O(Dt).
BOOST_AUTO_TEST_CASE(comes_to_the_closed_form_of_one_member_at_order_one) {
  std::vector<double> errors;
  for (const double step : {0.01, 0.005, 0.0025, 0.00125}) {
    const Trial trial = fly(pulled, open_course(3.0, step), one_at({0.0, 0.0, 0.0}));
    BOOST_TEST((trial.flight.outcome.status == Status::reached));
    errors.push_back(std::abs(trial.objective - 0.653125));
  }
  for (std::size_t k = 1; k < errors.size(); ++k) {
    BOOST_TEST(std::abs(std::log2(errors[k - 1] / errors[k]) - 1.0) <= 0.1);
  }
  BOOST_TEST(errors.back() <= 0.00125);
}

// Attraction and repulsion of two at distance 2 s: 4 s^0.7 + (1/2) (2 s)^0.3 = (1/2) (2 s)^-1.5 at s = 0.2162....
BOOST_AUTO_TEST_CASE(lets_two_members_come_to_rest_on_either_side_of_the_target) {
  Course course = open_course(60.0, 0.02);
  course.c_d = 1.0;
  const Particles start = particles({{.position = {9.7, 0.0, 0.0}, .mass = 1.0, .radius = 0.0},
                                     {.position = {10.3, 0.0, 0.0}, .mass = 1.0, .radius = 0.0}});
  const Design design{.alpha1 = 1.0, .alpha2 = 1.0, .beta1 = 0.3, .beta2 = 1.5, .alpha_t = 4.0, .beta_t = 0.7};
  const Trial trial = fly(design, course, start);
  const double s = 0.216229868450448;
  BOOST_TEST(
      close(positions(trial.flight.state), Vectors{{10.0 - s, 0.0, 0.0}, {10.0 + s, 0.0, 0.0}}, {.absolute = 1e-12}));
}

// At 1 m/s from 10 m away, lost at 4.75 m after 4.75 s, where it stays 5.25 m away for the other 5.25 s of ten:
// (4.75 (10 + 5.25)/2 + 5.25 5.25)/100 = 0.6378125, and the penalty for all.
BOOST_AUTO_TEST_CASE(counts_the_lost_at_their_place_and_adds_the_penalty_for_their_share) {
  Course course = open_course(10.0, 0.25);
  course.obstacles = {{5.0, 0.0, 0.0}};
  course.radii = {0.5};
  course.loss_penalty = 3.0;
  const Design idle{.alpha_o = 0.0};
  const Trial all = fly(idle, course, one_at({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}));
  BOOST_TEST(all.flight.lost.size() == 1U);
  BOOST_TEST(all.objective == 3.6378125, tolerance(4 * eps));
  // Of four, three of which stand as far away, one is lost.
  std::vector<Particle> list(4, {.position = {10.0, 10.0, 0.0}, .mass = 1.0, .radius = 0.0});
  for (std::size_t i = 1; i < 4; ++i) list[i].position.z() = 0.0, list[i].position.y() = i == 2 ? -10.0 : 10.0;
  list[3].position = {20.0, 0.0, 0.0};
  list[0] = {.position = {0.0, 0.0, 0.0}, .velocity = {1.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.0};
  const Trial some = fly(idle, course, particles(list));
  BOOST_TEST(some.flight.lost.size() == 1U);
  BOOST_TEST(some.objective == 0.25 * (3.0 + 0.6378125 + 3.0), tolerance(8 * eps));
}

BOOST_AUTO_TEST_CASE(shows_the_watcher_every_step_of_the_whole_swarm) {
  std::vector<double> times;
  const Watcher watcher = [&](const State& swarm) {
    BOOST_REQUIRE(swarm.r.size() == 12);
    times.push_back(swarm.t);
  };
  const Trial trial = fly(pulled, open_course(1.0, 0.25), cloud_of(4), watcher);
  BOOST_TEST(times == std::vector<double>({0.25, 0.5, 0.75, 1.0}), boost::test_tools::per_element());
  BOOST_TEST(trial.objective == fly(pulled, open_course(1.0, 0.25), cloud_of(4)).objective);
}

// Lengths times a million with strengths to match, a duration of 1e9 s: the same flight, but for roundings.
BOOST_AUTO_TEST_CASE(does_not_depend_on_units) {
  const Design design{.alpha1 = 0.1,
                      .alpha2 = 0.2,
                      .beta1 = 0.5,
                      .beta2 = 1.0,
                      .alpha_o = 0.3,
                      .beta_o = 2.0,
                      .alpha_t = 2.0,
                      .beta_t = 0.5};
  const double L = 1e-6, T = 1e9 / 3.0, F = L / (T * T);
  Course course = fence(), scaled = fence();
  course.duration = 3.0;
  for (Eigen::Vector3d& centre : scaled.obstacles) centre *= L;
  for (double& radius : scaled.radii) radius *= L;
  scaled.target *= L, scaled.c_d /= T, scaled.v_max *= L / T, scaled.duration = 1e9, scaled.step *= T;
  Particles start = cloud_of(8), small = start;
  small.position *= L;
  const Design other{.alpha1 = design.alpha1 * F * std::pow(L, -0.5),
                     .alpha2 = design.alpha2 * F * L,
                     .beta1 = 0.5,
                     .beta2 = 1.0,
                     .alpha_o = design.alpha_o * F * L * L,
                     .beta_o = 2.0,
                     .alpha_t = design.alpha_t * F * std::pow(L, -0.5),
                     .beta_t = 0.5};
  BOOST_TEST(fly(other, scaled, small).objective == fly(design, course, start).objective, tolerance(1e-10));
}

// Each step of 0.02 s begins at rest and moves a member by 4 Dt^2, before the cap stops it: 10 m less 0.08 m/s for 1 s.
BOOST_AUTO_TEST_CASE(creeps_by_what_one_step_adds_under_a_cap_of_nothing) {
  for (const double v_max : {0.0, 1e-12}) {
    Course course = open_course(1.0, 0.02);
    course.v_max = v_max;
    const Trial trial = fly(pulled, course, one_at({0.0, 0.0, 0.0}));
    BOOST_TEST(trial.objective == 1.0 - 0.004, tolerance(1e-12));
    BOOST_TEST(trial.flight.state.v.norm() <= v_max * (1.0 + 8.0 * eps));
  }
}

BOOST_AUTO_TEST_CASE(is_no_number_where_the_flight_fails) {
  const Particles twice = chosen(cloud_of(2), {0, 0, 1});
  const Trial trial = fly({.alpha1 = 1.0}, fence(), twice);
  BOOST_TEST(std::isnan(trial.objective));
  BOOST_TEST((trial.flight.outcome.failure == Failure::no_value));
  BOOST_TEST(contains(trial.flight.outcome.reason, "particles 0 and 1"));
}

BOOST_AUTO_TEST_CASE(refuses_a_start_that_cannot_be_meant) {
  CHECK_REFUSED(fly(pulled, fence(), Particles{}), "must have one member at least");
  CHECK_REFUSED(fly(pulled, fence(), one_at({5.0, 2.0, 0.1})), "member 0 is inside obstacle 7");
  CHECK_REFUSED(fly(pulled, fence(), one_at({10.0, 0.0, 0.0})), "must be positive and finite at the start");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(objective_)

BOOST_AUTO_TEST_CASE(is_the_mean_over_the_starts) {
  const std::vector<Particles> starts{cloud_of(3), cloud_of(5)};
  Course course = fence();
  course.duration = 1.0;
  const double mean = 0.5 * (fly(pulled, course, starts[0]).objective + fly(pulled, course, starts[1]).objective);
  BOOST_TEST(objective(starts, course)(string_of(pulled)).cost == mean, tolerance(2 * eps));
}

BOOST_AUTO_TEST_CASE(has_no_value_and_says_why_where_a_flight_fails_or_the_design_is_none) {
  const auto cost = objective({chosen(cloud_of(2), {0, 0})}, fence());
  BOOST_TEST(evaluate(cost, string_of({.alpha1 = 1.0})).reason == "no value");
  BOOST_TEST(contains(evaluate(cost, Eigen::VectorXd::Zero(3)).reason, "must have 8 parameters, got 3"));
  BOOST_TEST(contains(evaluate(cost, string_of({.beta_t = 2.0})).reason, "beta_t must lie between 0 and 1, got 2"));
}

BOOST_AUTO_TEST_CASE(is_the_same_to_the_last_bit_in_every_thread) {
  Course course = fence();
  course.duration = 1.0;
  const auto cost = objective({cloud_of(12)}, course);
  const Design design{.alpha1 = 0.1, .alpha2 = 0.2, .beta1 = 0.5, .alpha_o = 0.3, .alpha_t = 2.0};
  std::vector<double> costs(4);
  std::vector<std::thread> threads;
  for (double& one : costs) threads.emplace_back([&] { one = cost(string_of(design)).cost; });
  for (std::thread& thread : threads) thread.join();
  BOOST_TEST(costs == std::vector<double>(4, cost(string_of(design)).cost), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(refuses_no_start_and_one_that_cannot_be_meant) {
  CHECK_REFUSED(objective({}, fence()), "objective: needs one start at least, got none");
  CHECK_REFUSED(objective({cloud_of(2), one_at({5.0, 0.0, 0.1})}, fence()), "member 0 is inside obstacle 4");
  CHECK_REFUSED(objective({Particles{}}, fence()), "must have one member at least");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::design_test
