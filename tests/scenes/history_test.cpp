#include <particulate/scenes/history.hpp>

#include <functional>
#include <vector>

#include <particulate/contact/contact.hpp>
#include <particulate/contact/located_contact.hpp>
#include <particulate/laws/gravity.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/legs.hpp>
#include <particulate/schemes/verlet.hpp>
#include <particulate/thermo/impact_heat.hpp>

#include "close.hpp"
#include "problems.hpp"

namespace tests::history_test {

using namespace particulate::contact;
using namespace particulate::kinematics;
using namespace particulate::laws;
using namespace particulate::scenes;
using namespace particulate::schemes;

struct Drag {};
bool add_force(const Drag&, const Space&, const At<Velocity>& at, Forces force) {
  force -= at.velocity;
  return true;
}

// 1 kg at 2 m/s towards 3 kg at rest; they touch after 0.5 s.
Particles pair() {
  return particles({{.position = {-1.5, 0.0, 0.0}, .velocity = {2.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.25},
                    {.position = {0.0, 0.0, 0.0}, .mass = 3.0, .radius = 0.25}});
}

BOOST_AUTO_TEST_SUITE(History_)

// By hand, per kg of 4: momentum 2 kg m/s, so 0.5 m/s and 0.125 J/kg of bulk motion; 2 J in all, 0.5 J/kg, so 0.375 of
// relative. With e = 0.5 that falls to a quarter, 0.09375, and 0.28125 J/kg or 1.125 J are lost.
BOOST_AUTO_TEST_CASE(tells_energies_momentum_and_impacts) {
  const Scene scene(pair(), Space{}, LocatedContact<>{.restitution = {0.5}});
  History history(scene, {0.0, 0.3, 0.7, 1.0});
  State state = start(scene);
  const Outcome outcome = run(scene, state, 1.0, VelocityVerlet(), FixedStep{.step = 0.25}, history);
  BOOST_TEST(
      history.columns() == std::vector<std::string>({"time [s]", "bulk [J/kg]", "relative [J/kg]", "potential [J/kg]",
                                                     "lost [J/kg]", "momentum x [kg m/s]", "momentum y [kg m/s]",
                                                     "momentum z [kg m/s]", "impacts", "overlap [m]"}),
      boost::test_tools::per_element());
  Eigen::MatrixXd expected(4, 10);
  expected << 0.0, 0.125, 0.375, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0,  //
      0.3, 0.125, 0.375, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0,          //
      0.7, 0.125, 0.09375, 0.0, 0.28125, 2.0, 0.0, 0.0, 1.0, 0.0,    //
      1.0, 0.125, 0.09375, 0.0, 0.28125, 2.0, 0.0, 0.0, 1.0, 0.0;
  BOOST_TEST(close(history.rows(), expected, {.absolute = 1e-14}));
  BOOST_TEST(outcome.impacts == 1);
  BOOST_TEST(outcome.energy_change == -4.0 * history.rows()(3, 4));
}

// Steps of 0.3 s: at 0.6 s they overlap by 0.2 m and are sent back there, in which row too.
BOOST_AUTO_TEST_CASE(writes_the_row_at_the_end_of_a_step_after_its_jump) {
  const Scene scene(pair(), Space{}, Contact<ConstantRestitution>{.restitution = {0.5}});
  History history(scene, {0.3, 0.6});
  State state = start(scene);
  (void)run(scene, state, 0.6, VelocityVerlet(), FixedStep{.step = 0.3}, history);
  BOOST_TEST(history.rows().rows() == 2);
  BOOST_TEST(history.rows()(0, 2) == 0.375);
  BOOST_TEST(history.rows()(0, 8) == 0.0);
  BOOST_TEST(history.rows()(1, 2) == 0.09375, tolerance(1e-14));
  BOOST_TEST(history.rows()(1, 8) == 1.0);
  BOOST_TEST(history.rows()(1, 9) == 0.2, tolerance(1e-14));
}

// A stone thrown up: kinetic and potential energy per mass add up to v^2/2 at all times, within a step too.
BOOST_AUTO_TEST_CASE(has_the_potential_of_the_laws_where_all_have_one) {
  const Particles stone =
      particles({{.position = Eigen::Vector3d::Zero(), .velocity = {0.0, 0.0, 3.0}, .mass = 2.0, .radius = 0.1}});
  const Scene scene(stone, Space{}, Gravity{});
  History history(scene, multiples(0.03, 0.0, 0.6));
  State state = start(scene);
  (void)run(scene, state, 0.6, VelocityVerlet(), FixedStep{.step = 0.25}, history);
  BOOST_TEST(history.rows().rows() == 21);
  const Eigen::VectorXd sum = history.rows().col(1) + history.rows().col(2) + history.rows().col(3);
  BOOST_TEST(close(sum, Eigen::VectorXd::Constant(21, 4.5), {.relative = 1e-13}));
  const Scene dragged(stone, Space{}, Gravity{}, Drag{});
  BOOST_TEST(History(dragged, {}).columns().size() == 9U);
}

BOOST_AUTO_TEST_CASE(tells_nothing_of_no_particles_and_is_told_of_by_another_observer) {
  const Scene scene(particles({}), Space{}, Gravity{});
  History history(scene, {0.5});
  std::vector<double> seen;
  Sampling samples(
      {0.25}, [&](const State& at) { seen.push_back(at.t); }, std::ref(history));
  State state = start(scene);
  (void)run(scene, state, 1.0, VelocityVerlet(), FixedStep{.step = 0.5}, samples);
  BOOST_TEST(close(history.rows(), Eigen::RowVectorXd::Unit(10, 0) * 0.5, {}));
  BOOST_TEST(seen.size() == 1U);
}

BOOST_AUTO_TEST_CASE(goes_on_where_another_was) {
  const Scene scene(pair(), Space{}, LocatedContact<>{.restitution = {0.5}});
  const std::vector<double> times = {0.0, 0.3, 0.7, 1.0};
  History whole(scene, times), first(scene, times), second(scene, times);
  State state = start(scene);
  (void)run(scene, state, 1.0, VelocityVerlet(), FixedStep{.step = 0.125}, whole);
  state = start(scene);
  (void)run(scene, state, 0.75, VelocityVerlet(), FixedStep{.step = 0.125}, first);
  second.remember(first.memory());
  (void)run(scene, state, 1.0, VelocityVerlet(), FixedStep{.step = 0.125}, second);
  BOOST_TEST(second.memory() == whole.memory(), boost::test_tools::per_element());

  History others(scene, {0.0, 0.3, 0.6, 1.0}), fewer(scene, {0.0, 0.3});
  const Scene dragged(pair(), Space{}, Drag{});
  History narrower(dragged, times);
  for (History* other : {&others, &fewer, &narrower}) {
    CHECK_REFUSED(other->remember(first.memory()), "must be of the same scene and the same times");
  }
  CHECK_REFUSED(others.remember({}), "got 0 numbers");
}

// The same pair, of 2 J/(kg K): the 1.125 J that the impact takes warm 1 kg by 0.28125 K and 3 kg by a third of that.
BOOST_AUTO_TEST_CASE(tells_heat_and_temperature_of_a_scene_that_has_them) {
  Particles warm = pair();
  warm.temperature = Eigen::Vector2d(300.0, 310.0);
  warm.heat_capacity = Eigen::Vector2d(2.0, 2.0);
  const Scene scene(warm, Space{}, LocatedContact<>{.restitution = {0.5}}, particulate::thermo::ImpactHeat{});
  History history(scene, {0.3, 1.0});
  State state = start(scene);
  const Outcome outcome = run(scene, state, 1.0, VelocityVerlet(), FixedStep{.step = 0.25}, history);
  const std::vector<std::string> last(history.columns().end() - 3, history.columns().end());
  BOOST_TEST(last == std::vector<std::string>({"heat [J/kg]", "released [J/kg]", "temperature [K]"}),
             boost::test_tools::per_element());
  Eigen::MatrixXd expected(2, 3);
  expected << 0.0, 0.0, 305.0, 0.28125, 0.0, 305.0 + 0.5 * (0.28125 + 0.09375);
  BOOST_TEST(close(history.rows().rightCols(3), expected, {.relative = 1e-14}));
  BOOST_TEST(outcome.heat == 1.125, tolerance(1e-14));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::history_test
