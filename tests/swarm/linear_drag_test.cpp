#include <particulate/swarm/linear_drag.hpp>

#include <particulate/scenes/scene.hpp>

#include "close.hpp"
#include "contact/moment.hpp"

namespace tests::linear_drag_test {

using namespace particulate::kinematics;
using namespace particulate::laws;
using namespace particulate::swarm;

// It has no potential, and a scene with it offers none.
static_assert(!Conservative<LinearDrag, Space> && needs_velocity<LinearDrag, Space>);

BOOST_AUTO_TEST_SUITE(linear_drag_force)

// -0.5 m v on top of what is there.
BOOST_AUTO_TEST_CASE(is_against_each_velocity_in_proportion_to_mass) {
  const Moment moment{
      particles({{.position = {0.0, 0.0, 0.0}, .velocity = {1.0, -2.0, 4.0}, .mass = 2.0, .radius = 0.0},
                 {.position = {1.0, 0.0, 0.0}, .velocity = {0.0, 8.0, 0.0}, .mass = 3.0, .radius = 0.0}})};
  Vectors force{{1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}};
  BOOST_TEST(add_force(LinearDrag{.c_d = 0.5}, Space{}, moment.at(), Forces(force.data(), 2, 3)));
  BOOST_TEST(close(force, Vectors{{0.0, 3.0, -3.0}, {0.0, -12.0, 0.0}}, {}));
}

BOOST_AUTO_TEST_CASE(of_no_coefficient_is_nothing) {
  const Moment moment{
      particles({{.position = {0.0, 0.0, 0.0}, .velocity = {1.0, -2.0, 4.0}, .mass = 2.0, .radius = 0.0}})};
  Vectors force = Vectors::Zero(1, 3);
  BOOST_TEST(add_force(LinearDrag{.c_d = 0.0}, Space{}, moment.at(), Forces(force.data(), 1, 3)));
  BOOST_TEST(force.isZero(0.0));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(linear_drag_validate)

BOOST_AUTO_TEST_CASE(names_what_must_hold_and_what_was_given) {
  BOOST_CHECK_NO_THROW(validate(LinearDrag{.c_d = 0.0}));
  CHECK_REFUSED(validate(LinearDrag{.c_d = -1.0}), "drag: c_d must be finite and not negative, got -1 1/s");
  CHECK_REFUSED(validate(LinearDrag{.c_d = infinity}), "got inf 1/s");
  CHECK_REFUSED(validate(LinearDrag{.c_d = not_a_number}), "got nan 1/s");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::linear_drag_test
