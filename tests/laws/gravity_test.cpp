#include <particulate/laws/gravity.hpp>

#include <particulate/scenes/scene.hpp>

#include "close.hpp"

namespace tests::gravity_test {

using namespace particulate::kinematics;
using namespace particulate::laws;
using namespace particulate::scenes;
using namespace particulate::schemes;

static_assert(AddsForce<Gravity, Space, At<>> && Conservative<Gravity, Space>);

Particles two_particles() {
  return {.position = Vectors{{1.0, 2.0, 3.0}, {-4.0, 0.5, 0.0}},
          .velocity = Vectors::Zero(2, 3),
          .mass = Eigen::Vector2d(2.0, 4.0),
          .radius = Eigen::Vector2d(0.5, 0.5)};
}

BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(accepts_any_finite_acceleration) {
  BOOST_CHECK_NO_THROW(validate(Gravity{}));
  BOOST_CHECK_NO_THROW(validate(Gravity{{0.0, 0.0, 0.0}}));
  BOOST_CHECK_NO_THROW(validate(Gravity{{-1e300, 5.0, 1.0}}));
}

BOOST_AUTO_TEST_CASE(says_what_was_given) {
  CHECK_REFUSED(validate(Gravity{{0.0, 1.0, infinity}}), "gravity: g must be finite, got (0, 1, inf) m/s^2");
  CHECK_REFUSED(validate(Gravity{{not_a_number, 0.0, 0.0}}), "got (nan, 0, 0)");
  CHECK_REFUSED(Scene(two_particles(), Space{}, Gravity{{0.0, 1.0, infinity}}), "gravity: g must be finite");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(add_force_)

BOOST_AUTO_TEST_CASE(weighs_each_particle_by_its_mass) {
  const Scene scene(two_particles(), Space{}, Gravity{{1.0, -2.0, 0.5}});
  Eigen::VectorXd f(6), expected(6);
  expected << 2.0, 4.0, -4.0, -8.0, 1.0, 2.0;
  BOOST_TEST(scene.total_force(start(scene), f));
  BOOST_TEST(close(f, expected, {}));
}

BOOST_AUTO_TEST_CASE(is_added_to_other_forces) {
  const Scene twice(two_particles(), Space{}, Gravity{{1.0, 0.0, 0.0}}, Gravity{{0.5, 0.0, 0.0}});
  Eigen::VectorXd f(6), expected(6);
  expected << 3.0, 6.0, 0.0, 0.0, 0.0, 0.0;
  BOOST_TEST(twice.total_force(start(twice), f));
  BOOST_TEST(close(f, expected, {}));
}

// Every mass falls alike, and by default as on the earth, along -z.
BOOST_AUTO_TEST_CASE(accelerates_all_alike) {
  const Scene scene(two_particles(), Space{}, Gravity{});
  Eigen::VectorXd a(6), expected(6);
  expected << 0.0, 0.0, 0.0, 0.0, -9.81, -9.81;
  BOOST_TEST(scene.acceleration(0.0, start(scene).r, a));
  BOOST_TEST(close(a, expected, {.relative = 1e-15}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(potential_energy_)

// -2 (1 - 4 + 1.5) - 4 (-4 - 1 + 0) = 3 + 20.
BOOST_AUTO_TEST_CASE(is_the_weight_times_the_height) {
  const Scene scene(two_particles(), Space{}, Gravity{{1.0, -2.0, 0.5}});
  BOOST_TEST(scene.potential_energy(start(scene)) == 23.0);
  const Scene earth(two_particles(), Space{}, Gravity{{0.0, 0.0, -10.0}});
  BOOST_TEST(earth.potential_energy(start(earth)) == 60.0);
}

// A linear potential: any displacement s of particle i changes it by -f_i.s.
BOOST_AUTO_TEST_CASE(falls_by_the_work_of_the_force) {
  const Scene scene(two_particles(), Space{}, Gravity{{1.0, -2.0, 0.5}});
  State state = start(scene);
  const double before = scene.potential_energy(state);
  Eigen::VectorXd f(6);
  BOOST_TEST(scene.total_force(state, f));
  Eigen::VectorXd displacement(6);
  displacement << 0.5, -1.0, 2.0, 0.25, 8.0, -0.5;
  state.r += displacement;
  BOOST_TEST(scene.potential_energy(state) == before - f.dot(displacement));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::gravity_test
