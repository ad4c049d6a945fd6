#include <particulate/fluid/frozen_flow.hpp>

#include <cmath>

#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/runge_kutta.hpp>

#include "close.hpp"

namespace tests::frozen_flow_test {

using namespace particulate;
using namespace particulate::fluid;
using Eigen::Vector3d;

static_assert(StreamField<FrozenFlow<GasFlow<2>>>);

const Grid<2> sheet{.cells = {8, 10}, .lengths = {2.0, 5.0}, .corner = {-1.0, 0.25}};
const Boundaries<2> channel{Periodic{}, Periodic{}, Wall<2>{}, Wall<2>{}};
GasFlow<2> gas() { return {sheet, {.state = {.R = 1.0}, .viscosity = {.mu = 0.75}, .c = 2.0}, channel}; }
Local<2> sheared(const Vector<2>& x) { return {.rho = 2.0, .v = {3.0 * x[1], -1.0}, .theta = 100.0 + 10.0 * x[1]}; }

BOOST_AUTO_TEST_SUITE(FrozenFlow_)

// Density is uniform, velocity and temperature are linear across the channel: away from its walls hats of whole cells
// read them exactly, at any time and along the channel anywhere.
BOOST_AUTO_TEST_CASE(reads_what_is_linear_at_any_place_and_time) {
  const GasFlow<2> flow = gas();
  for (const std::optional<double> w : {std::optional<double>(), {0.5}, {1.0}}) {
    const FrozenFlow field(flow, flow.start(sheared), w);
    for (const Vector3d& x : {Vector3d(0.3, 2.1, 0.0), Vector3d(-71.0, 3.17, 1e9)}) {
      const Stream there = field(1e3, x);
      BOOST_TEST(there.rho == 2.0, tolerance(1e-14));
      BOOST_TEST(there.mu == 0.75, tolerance(1e-14));
      BOOST_TEST(close(there.v, Vector3d(3.0 * x[1], -1.0, 0.0), {.relative = 1e-13, .absolute = 1e-15}));
      BOOST_TEST(there.theta == 100.0 + 10.0 * x[1], tolerance(1e-13));
    }
  }
}

BOOST_AUTO_TEST_CASE(has_a_viscosity_that_varies_and_no_temperature_of_a_barotropic_fluid) {
  const ThinningFlow<2> thinning(sheet, {.viscosity = {.mu_R = 2.0, .c_mu = 5.0, .theta_R = 300.0}}, channel);
  const FrozenFlow warm(thinning,
                        thinning.start([](const Vector<2>&) { return Local<2>{.rho = 1.0, .theta = 400.0}; }));
  BOOST_TEST(warm(0.0, {0.0, 1.0, 0.0}).mu == 2.0 * std::exp(-1.25), tolerance(1e-13));
  const BarotropicFlow<2> cold(sheet, {.viscosity = {.mu = 3.0}}, channel);
  const FrozenFlow without(cold, cold.start([](const Vector<2>&) { return Local<2>{.rho = 4.0, .theta = 7.0}; }));
  const Stream there = without(0.0, {0.0, 1.0, 0.0});
  BOOST_TEST(there.rho == 4.0, tolerance(1e-14));
  BOOST_TEST(there.mu == 3.0, tolerance(1e-14));
  BOOST_TEST(there.theta == 300.0);
}

BOOST_AUTO_TEST_CASE(has_no_value_outside_of_its_walls_where_a_run_ends) {
  const GasFlow<2> flow = gas();
  const FrozenFlow field(flow, flow.start(sheared));
  BOOST_TEST((is_value(field(0.0, {0.0, 5.25, 0.0})) && !is_value(field(0.0, {0.0, 5.2501, 0.0}))));
  const scenes::Scene scene(
      kinematics::particles({{.position = {0.0, 5.0, 0.0}, .velocity = {0.0, 1.0, 0.0}, .mass = 1e6, .radius = 0.01}}),
      kinematics::Space{}, Drag{field});
  schemes::State at = scenes::start(scene);
  const schemes::Outcome out = integrate(scene, at, 1.0, schemes::RungeKutta4{}, schemes::FixedStep{.step = 0.1});
  BOOST_TEST((out.failure == schemes::Failure::no_value));
  BOOST_TEST(contains(out.reason, "particle 0 at ("));
  BOOST_TEST(contains(out.reason, "is where there is no fluid, or none that can be: nan kg/m^3"));
  BOOST_TEST(at.t == 0.2, tolerance(1e-14));
}

// Its flow is its own: what is asked of the one that it came from does not change it, nor do questions to a copy.
BOOST_AUTO_TEST_CASE(stands_still_whatever_becomes_of_its_flow_and_of_copies) {
  const GasFlow<2> flow = gas();
  const FrozenFlow field(flow, flow.start(sheared)), copy = field;
  const Vector3d x(0.3, 2.1, 0.0);
  const Vector3d before = field(0.0, x).v;
  const schemes::State other = flow.start([](const Vector<2>&) { return Local<2>{.rho = 9.0, .theta = 1.0}; });
  Eigen::VectorXd dy(other.y.size());
  BOOST_TEST(flow.rate(0.0, other.y, dy));
  BOOST_TEST(!is_value(copy(0.0, {not_a_number, 0.0, 0.0})));
  BOOST_TEST((field(0.0, x).v == before && copy(0.0, x).v == before));
}

BOOST_AUTO_TEST_CASE(refuses_a_state_that_is_none_of_its_flow_and_a_hat_that_does_not_fit) {
  const GasFlow<2> flow = gas();
  schemes::State state = flow.start(sheared);
  CHECK_REFUSED(FrozenFlow(flow, state, 0.4),
                "between the largest edge of a cell, 0.5 m, and half the shortest edge of "
                "the box, 1 m, got 0.4 m");
  state.y[3] = -1.0;
  CHECK_REFUSED(FrozenFlow(flow, state), "frozen flow: the state must have a value everywhere: cell 3 has -1 kg/m^3");
  state.y.conservativeResize(7);
  CHECK_REFUSED(FrozenFlow(flow, state), "must hold 320 numbers, 4 a cell, got 7");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::frozen_flow_test
