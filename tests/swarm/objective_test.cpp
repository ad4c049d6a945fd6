#include <particulate/swarm/objective.hpp>

#include <vector>

#include <particulate/schemes/symplectic_euler.hpp>

#include "close.hpp"

namespace tests::objective_test {

using namespace particulate::kinematics;
using namespace particulate::swarm;
using particulate::schemes::State;

// On the x axis.
Particles members_at(const std::vector<double>& x) {
  std::vector<Particle> list;
  for (const double one : x) list.push_back({.position = {one, 0.0, 0.0}, .mass = 1.0, .radius = 0.0});
  return particles(list);
}

void step(Objective& objective, const std::vector<double>& x, double dt) {
  const Particles now = members_at(x);
  const State to{.t = 0.0, .r = now.position.reshaped(), .v = now.velocity.reshaped()};
  BOOST_TEST(objective(State{}, to, dt, particulate::schemes::SymplecticEuler{}));
}

BOOST_AUTO_TEST_SUITE(Objective_)

// Target at 10, members 10 and 6 away: 8 on the average. After 1 s they are 6 and 2 away, after 3 more 2 and 2:
// (1 (1 + 1/2)/2 + 3 (1/2 + 1/4)/2)/4 = (0.75 + 1.125)/4.
BOOST_AUTO_TEST_CASE(is_the_mean_over_members_and_unequal_steps_by_the_trapezoidal_rule) {
  Objective objective({10.0, 0.0, 0.0}, members_at({0.0, 4.0}));
  BOOST_TEST(objective.mean() == 1.0);
  BOOST_TEST(objective.distance() == 8.0);
  step(objective, {4.0, 8.0}, 1.0);
  BOOST_TEST(objective.mean() == 0.75);
  BOOST_TEST(objective.distance() == 4.0);
  step(objective, {8.0, 12.0}, 3.0);
  BOOST_TEST(objective.mean() == 0.46875);
  BOOST_TEST(objective.distance() == 2.0);
}

BOOST_AUTO_TEST_CASE(goes_by_the_nearest_image_where_space_repeats_itself) {
  const Space ring{.lengths = {8.0, infinity, infinity}};
  Objective objective({7.0, 0.0, 0.0}, members_at({3.5}), ring);
  step(objective, {0.0}, 1.0);
  BOOST_TEST(objective.distance() == 1.0);
}

BOOST_AUTO_TEST_CASE(does_not_depend_on_units) {
  for (const double unit : {1e-6, 1e-200, 1e200}) {
    Objective objective({10.0 * unit, 0.0, 0.0}, members_at({0.0, 4.0 * unit}));
    step(objective, {4.0 * unit, 8.0 * unit}, 1e9);
    BOOST_TEST(objective.mean() == 0.75, tolerance(8 * eps));
  }
}

BOOST_AUTO_TEST_CASE(allows_members_at_the_target_but_not_all_of_them) {
  BOOST_TEST(Objective({1.0, 0.0, 0.0}, members_at({1.0, 2.0})).distance() == 0.5);
  CHECK_REFUSED(Objective({1.0, 0.0, 0.0}, members_at({1.0, 1.0})),
                "mean distance of the members from the target must be positive and finite at the start, as all "
                "distances are counted in it, got 0 m");
}

BOOST_AUTO_TEST_CASE(refuses_a_start_without_members_and_what_is_not_finite) {
  CHECK_REFUSED(Objective({1.0, 0.0, 0.0}, Particles{}), "must have one member at least, got none");
  CHECK_REFUSED(Objective({infinity, 0.0, 0.0}, members_at({1.0})), "got inf m");
  Particles wrong = members_at({0.0, 1.0});
  wrong.mass.resize(1);
  CHECK_REFUSED(Objective({2.0, 0.0, 0.0}, wrong), "must hold one entry a particle");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::objective_test
