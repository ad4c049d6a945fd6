#include <array>
#include <cmath>
#include <functional>
#include <thread>
#include <type_traits>
#include <vector>

#include <particulate/contact/impulse_windows.hpp>
#include <particulate/contact/restitution.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/scenes/staggered_scene.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/events.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/symplectic_euler.hpp>
#include <particulate/schemes/verlet.hpp>
#include <particulate/thermo/binding.hpp>
#include <particulate/thermo/cooling.hpp>
#include <particulate/thermo/impact_heat.hpp>

#include "close.hpp"
#include "clouds.hpp"
#include "says.hpp"

namespace tests::heated_runs_test {

using boost::test_tools::tolerance;
using namespace particulate;
using contact::ConstantRestitution;
using contact::Contact;
using kinematics::Particles;
using kinematics::Space;
using thermo::Binding;
using thermo::Cooling;
using thermo::ImpactHeat;

// 1 mm, 2000 kg/m^3 and 1000 J/(kg K), at 1000 K.
Particles hot_sphere() {
  return kinematics::particles({{.position = {0.0, 0.0, 0.0},
                                 .velocity = {1.0, 0.0, 0.0},
                                 .mass = 2000.0 * 1e-3 * thermo::surface(1e-3) / 3.0,
                                 .radius = 1e-3,
                                 .temperature = 1000.0,
                                 .heat_capacity = 1000.0}});
}

// A cloud that is hit, bound, heated and cooled.
Particles warm_cloud() {
  Particles cloud = random_cloud(40, {1.0, 1.0, 1.0}, 0.05, 0.08);
  cloud.temperature = Eigen::VectorXd::LinSpaced(40, 300.0, 900.0);
  cloud.heat_capacity = Eigen::VectorXd::LinSpaced(40, 0.5, 1.5);
  return cloud;
}
auto scene_of(const Particles& cloud, double length) {
  return scenes::Scene(cloud, Space{}, Contact<ConstantRestitution>{.restitution = {0.5}},
                       Binding{.F_b = 2.0 * length, .d_b = 0.3 * length},
                       ImpactHeat{.kappa = 10.0, .J_star = 0.1 * length}, Cooling{.h_c = 2.0, .emissivity = 0.8});
}
schemes::State after_a_while(const Particles& cloud, double length = 1.0) {
  const auto scene = scene_of(cloud, length);
  schemes::State state = scenes::start(scene);
  const schemes::Outcome out = integrate(scene, state, 0.5, schemes::RungeKutta4{}, schemes::FixedStep{.step = 0x1p-7});
  BOOST_TEST((out.status == schemes::Status::reached), out);
  BOOST_TEST(out.impacts > 20);
  return state;
}

BOOST_AUTO_TEST_SUITE(integrate_)

// Convection, whose exponential is known: the error falls by 2^order where the step is halved.
BOOST_AUTO_TEST_CASE(cools_at_the_order_of_each_scheme) {
  const scenes::Scene scene(hot_sphere(), Space{}, Cooling{.h_c = 50.0});
  const double tau = 2000.0 * 1000.0 * 1e-3 / 3.0 / 50.0;
  const double exact = thermo::convected_temperature(1000.0, 300.0, tau, 16.0);
  const auto order = [&](auto scheme) {
    std::array<double, 2> error{};
    for (std::size_t k = 0; k < 2; ++k) {
      schemes::State state = scenes::start(scene);
      const schemes::Outcome out =
          integrate(scene, state, 16.0, scheme, schemes::FixedStep{.step = k == 0 ? 4.0 : 2.0});
      BOOST_TEST((out.status == schemes::Status::reached), out);
      BOOST_TEST(state.r[0] == 16.0, tolerance(1e-14));
      error[k] = std::abs(state.y[0] - exact);
    }
    return std::log2(error[0] / error[1]);
  };
  BOOST_TEST(std::abs(order(schemes::SymplecticEuler()) - 1.0) < 0.2);
  BOOST_TEST(std::abs(order(schemes::PhiFamily(0.5)) - 2.0) < 0.2);
  BOOST_TEST(std::abs(order(schemes::Collocation<schemes::Radau<2>>()) - 3.0) < 0.2);
  BOOST_TEST(std::abs(order(schemes::RungeKutta4()) - 4.0) < 0.2);
  BOOST_TEST(std::abs(order(schemes::Collocation<schemes::Gauss<2>>()) - 4.0) < 0.2);
}

// The closed form says when a sphere that radiates into nothing passes 500 K, and so does an event.
BOOST_AUTO_TEST_CASE(stops_at_a_temperature) {
  const scenes::Scene scene(hot_sphere(), Space{}, Cooling{.emissivity = 1.0, .theta_s = 0.0});
  schemes::Watch watch({{.function = [](const schemes::State& at) { return at.y[0] - 500.0; }}});
  schemes::State state = scenes::start(scene);
  const schemes::Outcome out = integrate(scene, state, 100.0, schemes::Collocation<schemes::Gauss<3>>{},
                                         schemes::ErrorControl{.TOL = 1e-10, .sweep_TOL = 1e-12}, watch);
  BOOST_TEST((out.status == schemes::Status::stopped), out);
  BOOST_TEST(state.t == 27.433030706813, tolerance(1e-9));
  BOOST_TEST(state.y[0] == 500.0, tolerance(1e-12));
}

// Steps are dt to the last bit, early and late; and by Newton iteration a run of 1e9 s
// ends where nothing flows.
BOOST_AUTO_TEST_CASE(does_not_tire) {
  const Cooling law{.h_c = 50.0, .theta_o = 350.0, .emissivity = 0.8};
  const scenes::Scene scene(hot_sphere(), Space{}, law);
  schemes::State early = scenes::start(scene), late = early;
  late.t = 1e9;
  (void)integrate(scene, early, 1.0, schemes::RungeKutta4{}, schemes::FixedStep{.step = 1e-3});
  (void)integrate(scene, late, 1e9 + 1.0, schemes::RungeKutta4{}, schemes::FixedStep{.step = 1e-3});
  BOOST_TEST((early.y == late.y && early.r == late.r));
  scenes::Temperatures<std::remove_cvref_t<decltype(scene)>> field{scene, scenes::start(scene)};
  schemes::State state{.y = field.at.y};
  const schemes::Outcome out =
      integrate(field, state, 1e9, schemes::Collocation<schemes::Radau<3>, schemes::Newton<schemes::SparseStages>>{},
                schemes::ErrorControl{.TOL = 1e-6, .sweep_TOL = 1e-9});
  BOOST_TEST((out.status == schemes::Status::reached), out);
  BOOST_TEST(state.y[0] == thermo::equilibrium_temperature(law), tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(says_which_temperature_is_none) {
  const scenes::Scene scene(warm_cloud(), Space{}, Cooling{.h_c = 2.0});
  schemes::State state = scenes::start(scene);
  state.y[7] = -5.0;
  const schemes::Outcome out = integrate(scene, state, 1.0, schemes::RungeKutta4{}, schemes::FixedStep{.step = 0.1});
  BOOST_TEST((out.failure == schemes::Failure::no_value));
  BOOST_TEST(contains(out.reason, "particle 7 has a temperature of -5 K, which must not be negative"));
  state.y[7] = NAN;
  CHECK_REFUSED(integrate(scene, state, 1.0, schemes::RungeKutta4{}, schemes::FixedStep{.step = 0.1}), "finite");
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(Scene_)

// Lengths in units of 2^-20 m, so that forces and impulses are 2^20 and energies 2^40 times as many: the same bits.
BOOST_AUTO_TEST_CASE(has_the_same_bits_in_micrometres) {
  const schemes::State metres = after_a_while(warm_cloud());
  Particles small = warm_cloud();
  small.position *= 0x1p20, small.velocity *= 0x1p20, small.radius *= 0x1p20, small.heat_capacity *= 0x1p40;
  const schemes::State other = after_a_while(small, 0x1p20);
  BOOST_TEST((metres.y == other.y));
  BOOST_TEST((metres.r * 0x1p20 == other.r && metres.v * 0x1p20 == other.v));
}

BOOST_AUTO_TEST_CASE(has_the_same_temperatures_in_a_moving_frame) {
  Particles moving = warm_cloud();
  moving.velocity.rowwise() += Eigen::RowVector3d(8.0, -4.0, 2.0);
  const schemes::State still = after_a_while(warm_cloud()), other = after_a_while(moving);
  BOOST_TEST((still.y != warm_cloud().temperature));
  BOOST_TEST(close(still.y, other.y, {.relative = 1e-11}));
}

BOOST_AUTO_TEST_CASE(runs_in_threads_as_copies) {
  const auto scene = scene_of(warm_cloud(), 1.0);
  std::array<schemes::State, 4> ends;
  const auto run = [&ends](auto copy, std::size_t k) {
    ends[k] = scenes::start(copy);
    (void)integrate(copy, ends[k], 0.5, schemes::RungeKutta4{}, schemes::FixedStep{.step = 0x1p-7});
  };
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < ends.size(); ++k) threads.emplace_back(run, scene, k);
  for (std::thread& thread : threads) thread.join();
  const schemes::State alone = after_a_while(warm_cloud());
  for (const schemes::State& end : ends) BOOST_TEST((end.y == alone.y && end.r == alone.r));
}

// Each round of impacts warms the bodies, so that what softens keeps less; the books close to rounding.
BOOST_AUTO_TEST_CASE(loses_more_where_heat_softens) {
  Particles cloud = warm_cloud();
  cloud.temperature.setConstant(300.0), cloud.heat_capacity.setConstant(0.01);
  const auto lost = [&](double theta_star) {
    const scenes::Scene scene(
        cloud, Space{},
        Contact<contact::SofteningRestitution>{.restitution = {.cold = {.e_o = 0.9}, .theta_star = theta_star}},
        ImpactHeat{});
    schemes::State state = scenes::start(scene);
    const schemes::Outcome out =
        integrate(scene, state, 0.5, schemes::VelocityVerlet{}, schemes::FixedStep{.step = 0.01});
    const double thermal = (cloud.mass.array() * cloud.heat_capacity.array() * (state.y.array() - 300.0)).sum();
    BOOST_TEST(thermal == -out.energy_change, tolerance(1e-11));
    return thermal;
  };
  BOOST_TEST(lost(310.0) > 1.2 * lost(1e9));
}

// Two spheres that attract each other as they touch, by 1 N: contacts that last do not hold them, and the outcome says
// so.
BOOST_AUTO_TEST_CASE(warns_of_spheres_that_sink_into_each_other) {
  const auto two = kinematics::particles({{.position = {-0.5, 0.0, 0.0}, .mass = 1.0, .radius = 0.5},
                                          {.position = {0.5, 0.0, 0.0}, .mass = 1.0, .radius = 0.5}});
  const auto outcome = [&](double gamma) {
    const scenes::Scene scene(two, Space{}, Contact<ConstantRestitution>{.restitution = {0.0}, .gamma = gamma},
                              laws::NearField{.alpha1 = 1.0, .beta1 = 0.0});
    schemes::State state = scenes::start(scene);
    const schemes::Outcome out =
        integrate(scene, state, 1.0, schemes::VelocityVerlet{}, schemes::FixedStep{.step = 0.2});
    const double depth = 1.0 - (state.r[1] - state.r[0]);
    BOOST_TEST(out.penetration >= depth, tolerance(1e-12));
    return out;
  };
  const schemes::Outcome sinks = outcome(0.01), held = outcome(0.0);
  BOOST_TEST(sinks.penetration > 0.1);
  BOOST_TEST(sinks.penetration == sinks.overlap, tolerance(1e-14));  // diameters of 1 m
  BOOST_TEST(contains(describe(sinks), "% of a diameter: take a smaller step"));
  BOOST_TEST(held.penetration < 0.1);
  BOOST_TEST(!contains(describe(held), "of a diameter"));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(ImpulseWindows_)

// Three bodies hit one of 10 kg from behind, first after 0.25, 0.5 and 1 s, and each other: it has the momentum that it
// was hit with.
BOOST_AUTO_TEST_CASE(sum_up_to_the_momentum_that_a_body_gains) {
  std::vector<kinematics::Particle> row{
      {.position = {0.0, 0.0, 0.0}, .mass = 10.0, .radius = 0.5, .temperature = 300.0, .heat_capacity = 1.0}};
  for (const double t : {0.25, 0.5, 1.0}) {
    row.push_back({.position = {-0.6 - 4.0 * t, 0.0, 0.0},
                   .velocity = {4.0, 0.0, 0.0},
                   .mass = 0.5,
                   .radius = 0.1,
                   .temperature = 300.0,
                   .heat_capacity = 1.0});
  }
  contact::ImpulseWindows windows(0, 0.3);
  const scenes::Scene scene(kinematics::particles(row), Space{},
                            Contact<ConstantRestitution>{.restitution = {0.2}, .recorder = std::ref(windows)},
                            ImpactHeat{});
  schemes::State state = scenes::start(scene);
  const auto tell = [&](const auto&, const schemes::State& to, double, const auto&) {
    windows.until(to.t);
    return true;
  };
  const schemes::Outcome out =
      integrate(scene, state, 1.5, schemes::VelocityVerlet{}, schemes::FixedStep{.step = 0.01}, tell);
  BOOST_TEST(out.impacts > 3);
  BOOST_TEST(windows.whole().normal == 10.0 * state.v[0], tolerance(1e-13));
  BOOST_TEST_REQUIRE(windows.windows().size() == 5U);
  double sum = 0.0;
  for (const contact::WindowImpulse& each : windows.windows()) sum += each.normal;
  BOOST_TEST(sum == windows.whole().normal, tolerance(1e-15));
  for (const std::size_t k : {2U, 4U}) BOOST_TEST(windows.windows()[k].normal == 0.0);
  // At rest it gets (1 + e) m* u from the first.
  BOOST_TEST(windows.windows()[0].normal == 1.2 * (10.0 * 0.5 / 10.5) * 4.0, tolerance(1e-13));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::heated_runs_test
