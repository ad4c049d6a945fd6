#include <cmath>

#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>

#include "close.hpp"
#include "says.hpp"

namespace tests::heat_test {

using boost::test_tools::tolerance;
using namespace particulate;
using kinematics::Space;

// Temperature falls as exp(-t), and pushes along x: x'' = theta/m.
struct Loses {};
template <kinematics::Domain D>
bool add_heat(const Loses&, const D&, const laws::At<laws::Temperature>& at, laws::Heats heat) {
  heat.array() -= 6.0 * at.temperature.array();
  return true;
}
struct Pushes {};
template <kinematics::Domain D>
bool add_force(const Pushes&, const D&, const laws::At<laws::Temperature>& at, laws::Forces force) {
  force.col(0) += at.temperature;
  return true;
}
// What rubs becomes warm.
struct Rubs {};
template <kinematics::Domain D>
bool add_heat(const Rubs&, const D&, const laws::At<laws::Velocity, laws::Temperature>& at, laws::Heats heat) {
  heat += at.velocity.rowwise().squaredNorm();
  return true;
}

// 2 kg of 3 J/(kg K) at 5 K.
const auto one = kinematics::particles({{.position = {0.0, 0.0, 0.0},
                                         .velocity = {0.0, 1.0, 0.0},
                                         .mass = 2.0,
                                         .radius = 0.1,
                                         .temperature = 5.0,
                                         .heat_capacity = 3.0}});

BOOST_AUTO_TEST_SUITE(Scene_)

// theta = 5 exp(-t), so that x = 5/2 (exp(-t) - 1 + t).
BOOST_AUTO_TEST_CASE(advances_temperatures_with_the_motion_that_they_act_on) {
  const scenes::Scene scene(one, Space{}, Loses{}, Pushes{});
  static_assert(schemes::traits_of<decltype(scene)>().values && !schemes::traits_of<decltype(scene)>().velocities);
  schemes::State state = scenes::start(scene);
  const schemes::Outcome out =
      integrate(scene, state, 1.0, schemes::Collocation<schemes::Gauss<3>>{}, schemes::ErrorControl{.TOL = 1e-9});
  BOOST_TEST((out.status == schemes::Status::reached));
  BOOST_TEST(state.y[0] == 5.0 * std::exp(-1.0), tolerance(1e-8));
  BOOST_TEST(close(state.r, Eigen::Vector3d(2.5 * std::exp(-1.0), 1.0, 0.0), {.relative = 1e-8}));
}

BOOST_AUTO_TEST_CASE(hands_velocities_to_heat_that_asks_for_them) {
  const scenes::Scene scene(one, Space{}, Rubs{});
  static_assert(schemes::traits_of<decltype(scene)>().velocities);
  schemes::State state = scenes::start(scene);
  Eigen::VectorXd a(3), dy(1);
  BOOST_TEST(scene.rates(0.0, state.r, state.v, state.y, a, dy));
  BOOST_TEST(dy[0] == 1.0 / 6.0, tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(has_no_value_at_a_negative_temperature) {
  const scenes::Scene scene(one, Space{}, Loses{});
  schemes::State state = scenes::start(scene);
  Eigen::VectorXd a(3), dy(1);
  state.y[0] = -1e-300;
  BOOST_TEST(!scene.rates(0.0, state.r, state.v, state.y, a, dy));
  BOOST_TEST(scene.why_no_value(state) ==
             "particle 0 has a temperature of -1e-300 K, which must not be negative: take a smaller step");
  state.y[0] = 0.0;
  BOOST_TEST(scene.rates(0.0, state.r, state.v, state.y, a, dy));
  BOOST_TEST(scene.why_no_value(state).empty());
}

BOOST_AUTO_TEST_CASE(refuses_particles_and_states_without_temperatures) {
  kinematics::Particles cold = one;
  cold.temperature.resize(0);
  cold.heat_capacity.resize(0);
  CHECK_REFUSED(scenes::Scene(cold, Space{}, Loses{}), "every particle must have a temperature and a heat capacity");
  const scenes::Scene scene(one, Space{}, Loses{});
  schemes::State state = scenes::start(scene);
  Eigen::VectorXd a(3), dy(1);
  CHECK_REFUSED(scene.rates(0.0, state.r, state.v, Eigen::VectorXd(), a, dy), "a temperature a particle, 1, got 0");
}

// Without heat a state has no y, whatever the particles have.
BOOST_AUTO_TEST_CASE(has_temperatures_only_with_heat) {
  const scenes::Scene<Space> scene(one, Space{});
  static_assert(!decltype(scene)::has_temperatures && !decltype(scene)::values_by_jumps);
  BOOST_TEST(scenes::start(scene).y.size() == 0);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::heat_test
