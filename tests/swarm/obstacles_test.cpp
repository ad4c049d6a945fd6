#include <particulate/swarm/obstacles.hpp>

#include <cmath>

#include "close.hpp"
#include "contact/moment.hpp"

namespace tests::obstacles_test {

using namespace particulate::kinematics;
using namespace particulate::laws;
using namespace particulate::swarm;

const Obstacles gate{
    .centre = {{0.0, 1.0, 0.0}, {0.0, -1.0, 0.0}}, .radius = {0.5, 0.25}, .alpha = 4.0, .beta = 3.0, .d_ref = 1.0};

Moment member_at(const Eigen::Vector3d& place, double mass = 1.0) {
  return {particles({{.position = place, .mass = mass, .radius = 0.0}})};
}

Vectors force_on(const Obstacles& law, const Moment& moment) {
  Vectors force = Vectors::Zero(moment.particles.size(), 3);
  BOOST_TEST(add_force(law, Space{}, moment.at(), Forces(force.data(), force.rows(), 3)));
  return force;
}

BOOST_AUTO_TEST_SUITE(obstacles_force)

// 2 kg at (0, 3, 0), 2 and 4 from the centres: 2 4 (1/8 + 1/64) = 1.125 away from both.
BOOST_AUTO_TEST_CASE(pushes_away_from_every_centre) {
  BOOST_TEST(close(force_on(gate, member_at({0.0, 3.0, 0.0}, 2.0)), Vectors{{0.0, 1.125, 0.0}}, {.relative = 8 * eps}));
}

// At (1, 0, 0) both are sqrt(2) away: the pushes along y cancel, and those along x add up to 2 4 2^-3/2 / sqrt(2) = 2.
BOOST_AUTO_TEST_CASE(of_a_gate_is_along_its_axis) {
  BOOST_TEST(close(force_on(gate, member_at({1.0, 0.0, 0.0})), Vectors{{2.0, 0.0, 0.0}},
                   {.relative = 8 * eps, .absolute = 8 * eps}));
  BOOST_TEST(close(force_on(gate, member_at({0.0, 0.0, 0.0})), Vectors{{0.0, 0.0, 0.0}}, {.absolute = 8 * eps}));
}

BOOST_AUTO_TEST_CASE(has_no_value_at_a_centre_and_says_whose) {
  const Moment moment{particles({{.position = {2.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.0},
                                 {.position = gate.centre[1], .mass = 1.0, .radius = 0.0}})};
  Vectors force = Vectors::Zero(2, 3);
  BOOST_TEST(!add_force(gate, Space{}, moment.at(), Forces(force.data(), 2, 3)));
  BOOST_TEST(why_no_force(gate, Space{}, moment.at()) ==
             "obstacles: member 1 must not be at the centre of obstacle 1: place it otherwise");
  BOOST_TEST(why_no_force(gate, Space{}, member_at({2.0, 0.0, 0.0}).at()).empty());
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(obstacles_potential)

// The integral of 4 d^-3 from d to 1 is 2 (d^-2 - 1): of 2 kg, 2 and 4 away, 2 2 (1/4 - 1 + 1/16 - 1) = -6.75.
BOOST_AUTO_TEST_CASE(is_zero_at_d_ref_of_each) {
  BOOST_TEST(potential_energy(gate, Space{}, member_at({0.0, 3.0, 0.0}, 2.0).at()) == -6.75, tolerance(8 * eps));
  const Obstacles one{.centre = {{1.0, 0.0, 0.0}}, .radius = {0.1}, .d_ref = 2.0};
  BOOST_TEST(potential_energy(one, Space{}, member_at({-1.0, 0.0, 0.0}).at()) == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(obstacle_around_)

BOOST_AUTO_TEST_CASE(is_the_first_that_is_nearer_than_its_radius) {
  BOOST_TEST(obstacle_around(gate, Space{}, {0.0, 0.51, 0.0}).value() == 0U);
  BOOST_TEST(obstacle_around(gate, Space{}, {0.0, -0.8, 0.0}).value() == 1U);
  BOOST_TEST(!obstacle_around(gate, Space{}, {0.0, -0.7, 0.0}));
  const Obstacles twice{.centre = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}, .radius = {1.0, 2.0}};
  BOOST_TEST(obstacle_around(twice, Space{}, {0.0, 0.0, 0.5}).value() == 0U);
  BOOST_TEST(obstacle_around(twice, Space{}, {0.0, 0.0, 1.5}).value() == 1U);
}

BOOST_AUTO_TEST_CASE(has_its_surface_outside) {
  BOOST_TEST(!obstacle_around(gate, Space{}, {0.0, 0.5, 0.0}));
  BOOST_TEST(obstacle_around(gate, Space{}, {0.0, std::nextafter(0.5, 1.0), 0.0}).has_value());
  const Obstacles point{.centre = {{0.0, 0.0, 0.0}}, .radius = {0.0}};
  BOOST_TEST(!obstacle_around(point, Space{}, Eigen::Vector3d::Zero()));
}

BOOST_AUTO_TEST_CASE(may_be_an_image) {
  const Space ring{.lengths = {4.0, infinity, infinity}};
  BOOST_TEST(obstacle_around(gate, ring, {7.9, 0.9, 0.0}).value() == 0U);
  BOOST_TEST(!obstacle_around(gate, Space{}, {7.9, 0.9, 0.0}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(obstacles_validate)

BOOST_AUTO_TEST_CASE(accepts_none_and_points) {
  BOOST_CHECK_NO_THROW(validate(Obstacles{}));
  BOOST_CHECK_NO_THROW(validate(Obstacles{.centre = {{0.0, 0.0, 0.0}}, .radius = {0.0}, .alpha = 0.0}));
}

BOOST_AUTO_TEST_CASE(names_the_obstacle_what_must_hold_and_what_was_given) {
  const auto refuses = [](auto change, const char* words) {
    Obstacles law = gate;
    change(law);
    CHECK_REFUSED(validate(law), words);
  };
  refuses([](Obstacles& law) { law.radius.pop_back(); }, "got 2 centres and 1 radii");
  refuses([](Obstacles& law) { law.centre[1].y() = infinity; }, "centre of obstacle 1 must be finite, got (0, inf, 0)");
  refuses([](Obstacles& law) { law.radius[1] = -0.5; },
          "radius of obstacle 1 must be finite and not negative, got -0.5");
  refuses([](Obstacles& law) { law.radius[0] = not_a_number; }, "radius of obstacle 0 must be finite");
  refuses([](Obstacles& law) { law.alpha = -1.0; }, "alpha must be finite and not negative, got -1");
  refuses([](Obstacles& law) { law.beta = 0.0; }, "beta must be positive and finite, so that they push less");
  refuses([](Obstacles& law) { law.beta = not_a_number; }, "got nan");
  refuses([](Obstacles& law) { law.d_ref = 0.0; }, "d_ref must be positive and finite, got 0 m");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::obstacles_test
