#include <particulate/scenes/staggered_scene.hpp>

#include <cmath>
#include <type_traits>
#include <vector>

#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/staggering.hpp>
#include <particulate/schemes/verlet.hpp>
#include <particulate/thermo/arrhenius.hpp>
#include <particulate/thermo/cooling.hpp>
#include <particulate/thermo/impact_heat.hpp>

#include "close.hpp"
#include "says.hpp"

namespace tests::staggered_scene_test {

using boost::test_tools::tolerance;
using namespace particulate;
using kinematics::Space;
using thermo::Arrhenius;
using thermo::Cooling;

// A spring to the origin that is as stiff as its body is hot, and a body that is cooled by moving away from there.
struct HotSpring {};
template <kinematics::Domain D>
bool add_force(const HotSpring&, const D&, const laws::At<laws::Temperature>& at, laws::Forces force) {
  force -= (at.position.array().colwise() * at.temperature.array()).matrix();
  return true;
}
struct CooledFarAway {};
template <kinematics::Domain D>
bool add_heat(const CooledFarAway&, const D&, const laws::At<laws::Temperature>& at, laws::Heats heat) {
  heat -= (at.temperature.array() * at.position.rowwise().squaredNorm().array()).matrix();
  return true;
}

kinematics::Particles spheres(Eigen::Index N, double theta) {
  kinematics::Particles all{.position = kinematics::Vectors::Zero(N, 3),
                            .velocity = kinematics::Vectors::Zero(N, 3),
                            .mass = Eigen::VectorXd::LinSpaced(N, 1.0, 2.0),
                            .radius = Eigen::VectorXd::Constant(N, 0.1),
                            .temperature = Eigen::VectorXd::LinSpaced(N, theta, 2.0 * theta),
                            .heat_capacity = Eigen::VectorXd::Constant(N, 3.0)};
  all.position.col(0) = Eigen::VectorXd::LinSpaced(N, 1.0, static_cast<double>(N));
  return all;
}

BOOST_AUTO_TEST_SUITE(StaggeredScene_)

// Two-way: against both at once, by collocation to 1e-11. Fields frozen at the end of a step: order 1.
BOOST_AUTO_TEST_CASE(converges_to_the_coupled_motion_at_order_one) {
  const scenes::Scene scene(spheres(1, 5.0), Space{}, HotSpring{}, CooledFarAway{});
  schemes::State exact = scenes::start(scene);
  BOOST_TEST(
      (integrate(scene, exact, 0.7, schemes::Collocation<schemes::Gauss<3>>{}, schemes::ErrorControl{.TOL = 1e-11})
           .status == schemes::Status::reached));
  const auto error = [&](double dt) {
    auto fields = staggered(scene, schemes::VelocityVerlet{}, schemes::PhiFamily(0.5));
    schemes::State state = scenes::start(scene);
    const schemes::Outcome out = integrate(
        fields, state, 0.7, schemes::Staggered({{.name = "motion", .TOL = 1e-12}, {.name = "heat", .TOL = 1e-12}}),
        schemes::FixedStep{.step = dt});
    BOOST_TEST_REQUIRE((out.status == schemes::Status::reached), out);
    return std::hypot((state.r - exact.r).norm(), (state.y - exact.y).norm());
  };
  const double coarse = error(0.01), fine = error(0.005);
  BOOST_TEST(std::abs(std::log2(coarse / fine) - 1.0) < 0.1);
  BOOST_TEST(coarse < 0.05);
}

// No force looks at temperature: the second sweep finds nothing to change, and the third none is made.
BOOST_AUTO_TEST_CASE(is_trivial_where_heat_does_not_act_back) {
  const scenes::Scene scene(spheres(3, 300.0), Space{}, Cooling{.h_c = 5.0, .theta_o = 250.0});
  auto fields = staggered(scene, schemes::VelocityVerlet{}, schemes::PhiFamily(1.0));
  schemes::State state = scenes::start(scene);
  const schemes::Outcome out = integrate(fields, state, 1.0, schemes::Staggered({{.name = "motion"}, {.name = "heat"}}),
                                         schemes::FixedStep{.step = 0.25, .TOL = 1.0});
  BOOST_TEST((out.status == schemes::Status::reached), out);
  BOOST_TEST(out.sweeps == 2 * out.steps);
}

// Backward Euler of convection is (1 + dt/tau)^-n, however late the run begins: a step is dt to the last bit.
BOOST_AUTO_TEST_CASE(makes_the_same_steps_early_and_late) {
  const scenes::Scene scene(spheres(1, 1000.0), Space{}, Cooling{.h_c = 5.0, .theta_o = 250.0});
  const double theta_0 = scene.particles().temperature[0];
  const double rate = 5.0 * thermo::surface(0.1) / (3.0 * scene.particles().mass[0]);
  for (const double t_0 : {0.0, 1e9}) {
    auto fields = staggered(scene, schemes::VelocityVerlet{}, schemes::PhiFamily(1.0));
    schemes::State state = scenes::start(scene);
    state.t = t_0;
    (void)integrate(fields, state, t_0 + 1.0, schemes::Staggered({{.name = "motion"}, {.name = "heat"}}),
                    schemes::FixedStep{.step = 1e-3, .TOL = 1.0});
    BOOST_TEST(state.y[0] == 250.0 + (theta_0 - 250.0) * std::pow(1.0 + 1e-3 * rate, -1000.0), tolerance(1e-12));
  }
}

// The controller shrinks what does not contract. The same objects serve a second run to the same bits, and what is
// relaxed comes to the same fields.
BOOST_AUTO_TEST_CASE(serves_a_controller_relaxation_and_a_second_run) {
  const scenes::Scene scene(spheres(2, 5.0), Space{}, HotSpring{}, CooledFarAway{});
  auto fields = staggered(scene, schemes::VelocityVerlet{}, schemes::PhiFamily(0.5));
  const auto run = [&](schemes::Staggered& scheme, double limit) {
    schemes::State state = scenes::start(scene);
    const schemes::Outcome out = integrate(fields, state, 0.5, scheme,
                                           schemes::PhiControl{.TOL = 1.0, .K_d = 10, .step = limit, .limit = limit});
    BOOST_TEST_REQUIRE((out.status == schemes::Status::reached), out);
    BOOST_TEST((limit == 0.5) == (out.rejections > 0), out);
    return state;
  };
  const std::vector<schemes::Field> both{{.name = "motion", .TOL = 1e-11}, {.name = "heat", .TOL = 1e-11}};
  schemes::Staggered plain(both), relaxed(both, schemes::Seen::newest, schemes::Aitken{});
  const schemes::State wide = run(plain, 0.5), first = run(plain, 1e-3), second = run(plain, 1e-3);
  BOOST_TEST((first.y == second.y && first.r == second.r));
  BOOST_TEST(!close(wide.y, first.y, {.relative = 1e-4}));
  BOOST_TEST(close(run(relaxed, 1e-3).y, first.y, {.relative = 1e-8}));
}

// An explicit scheme overshoots below 0 K in a step of ten time scales: refused, and the state stays what it was; with
// a control that can, shortened.
BOOST_AUTO_TEST_CASE(fails_where_a_field_does_and_leaves_the_state_alone) {
  const scenes::Scene scene(spheres(1, 1000.0), Space{}, Cooling{.h_c = 5.0, .theta_o = 250.0});
  const double tau = 3.0 * scene.particles().mass[0] / (5.0 * thermo::surface(0.1));
  auto fields = staggered(scene, schemes::VelocityVerlet{}, schemes::RungeKutta4{});
  schemes::Staggered scheme({{.name = "motion"}, {.name = "heat"}});
  schemes::State state = scenes::start(scene);
  schemes::Outcome out =
      integrate(fields, state, 20.0 * tau, scheme, schemes::FixedStep{.step = 10.0 * tau, .TOL = 1.0});
  BOOST_TEST((out.failure == schemes::Failure::no_value));
  BOOST_TEST(contains(out.reason, "no finite value within this step"));
  BOOST_TEST((state.t == 0.0 && state.y == scenes::start(scene).y));
  out = integrate(fields, state, 20.0 * tau, scheme,
                  schemes::PhiControl{.TOL = 1.0, .K_d = 5, .step = 10.0 * tau, .limit = 10.0 * tau});
  BOOST_TEST((out.status == schemes::Status::reached), out);
  BOOST_TEST(out.rejections > 0);
  BOOST_TEST((state.y[0] >= 0.0 && state.y[0] < scene.particles().temperature[0]));
  state = scenes::start(scene);
  state.y[0] = -5.0;
  out = integrate(fields, state, tau, scheme, schemes::FixedStep{.step = tau, .TOL = 1.0});
  BOOST_TEST(contains(out.reason, "particle 0 has a temperature of -5 K"));
}

// Contacts and their heat come once a step.
BOOST_AUTO_TEST_CASE(jumps_at_the_end_of_a_step) {
  kinematics::Particles two = spheres(2, 300.0);
  two.position << 0.0, 0.0, 0.0, 0.2, 0.0, 0.0;
  two.velocity(0, 0) = 1.0;
  const scenes::Scene scene(two, Space{}, contact::Contact<contact::ConstantRestitution>{.restitution = {0.0}},
                            Cooling{}, thermo::ImpactHeat{});
  auto fields = staggered(scene, schemes::VelocityVerlet{}, schemes::PhiFamily(1.0));
  schemes::State state = scenes::start(scene);
  const schemes::Outcome out =
      integrate(fields, state, 1e-9, schemes::Staggered({{.name = "motion"}, {.name = "heat"}}),
                schemes::FixedStep{.step = 1e-9, .TOL = 1.0});
  BOOST_TEST(out.impacts == 1);
  BOOST_TEST(out.heat == 0.5 / 1.5, tolerance(1e-9));  // 1/2 m* u^2 of 1 kg and 2 kg at 1 m/s
  BOOST_TEST(state.y[0] == 300.0 + out.heat / 2.0 / 3.0, tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(Temperatures_)

// A derivative is a limit of quotients.
BOOST_AUTO_TEST_CASE(knows_its_jacobian) {
  const scenes::Scene scene(spheres(3, 900.0), Space{}, Cooling{.h_c = 5.0, .theta_o = 250.0, .emissivity = 0.7},
                            Arrhenius{.power = 1e5, .T_a = 4000.0});
  const scenes::Temperatures<std::remove_cvref_t<decltype(scene)>> field{scene, scenes::start(scene)};
  static_assert(schemes::HasSparseJacobian<decltype(field)>);
  const Eigen::VectorXd y = scenes::start(scene).y;
  schemes::SparseJacobian J;
  field.sparse_jacobian(0.0, y, J);
  BOOST_TEST(J.nonZeros() == 3);
  Eigen::VectorXd above(3), below(3);
  const double h = 1e-2;
  BOOST_TEST((field.rate(0.0, y.array() + h, above) && field.rate(0.0, y.array() - h, below)));
  BOOST_TEST(close(Eigen::VectorXd(J.diagonal()), (above - below) / (2.0 * h), {.relative = 1e-7}));
}

BOOST_AUTO_TEST_CASE(has_no_jacobian_where_a_law_knows_no_slopes) {
  using Unknown = scenes::Scene<Space, CooledFarAway>;
  static_assert(!schemes::HasSparseJacobian<scenes::Temperatures<Unknown>>);
  static_assert(schemes::FirstOrderProblem<scenes::Temperatures<Unknown>>);
}

// Cooling from 1e4 K, whose rate falls by 1e4 on the way: Newton iteration takes steps far beyond 1/|slope| at the
// start.
BOOST_AUTO_TEST_CASE(takes_long_steps_where_heat_is_stiff) {
  const Cooling law{.emissivity = 1.0, .theta_s = 300.0};
  kinematics::Particles one = spheres(1, 1e4);
  one.mass[0] = 1e-5, one.temperature[0] = 1e4;
  const scenes::Scene scene(one, Space{}, law);
  scenes::Temperatures<std::remove_cvref_t<decltype(scene)>> field{scene, scenes::start(scene)};
  const double k = thermo::stefan_boltzmann * thermo::surface(0.1) / (1e-5 * 3.0);
  const double t_end = thermo::radiation_time(k, 1e4, 350.0, 300.0);
  schemes::State state{.y = scenes::start(scene).y};
  const schemes::Outcome out =
      integrate(field, state, t_end, schemes::Collocation<schemes::Radau<3>, schemes::Newton<schemes::SparseStages>>{},
                schemes::ErrorControl{.TOL = 1e-6, .sweep_TOL = 1e-9});
  BOOST_TEST((out.status == schemes::Status::reached), out);
  BOOST_TEST(state.y[0] == 350.0, tolerance(1e-6));
  const double fastest = 4.0 * k * 1e12;  // the slope at the start [1/s]
  BOOST_TEST(static_cast<double>(out.evaluations) < 0.05 * fastest * t_end, out);
}

// The same steps with the scene's own sparse Jacobian as with differences of all rates, of 30 spheres of two thousand
// degrees of difference, against the time that radiation takes.
BOOST_AUTO_TEST_CASE(has_the_same_solution_by_any_jacobian) {
  const Cooling law{.emissivity = 1.0, .theta_s = 0.0};
  const scenes::Scene scene(spheres(30, 2000.0), Space{}, law);
  scenes::Temperatures<std::remove_cvref_t<decltype(scene)>> field{scene, scenes::start(scene)};
  const auto end = [&](auto scheme) {
    schemes::State state{.y = scenes::start(scene).y};
    const schemes::Outcome out =
        integrate(field, state, 5.0, scheme, schemes::ErrorControl{.TOL = 1e-8, .sweep_TOL = 1e-11});
    BOOST_TEST((out.status == schemes::Status::reached), out);
    return state.y;
  };
  const Eigen::VectorXd sparse = end(schemes::Collocation<schemes::Radau<3>, schemes::Newton<schemes::SparseStages>>{});
  BOOST_TEST(close(sparse, end(schemes::Collocation<schemes::Radau<3>, schemes::Newton<>>{}), {.relative = 1e-7}));
  for (const Eigen::Index i : {0, 29}) {
    const double k = thermo::stefan_boltzmann * thermo::surface(0.1) / (3.0 * scene.particles().mass[i]);
    BOOST_TEST(thermo::radiation_time(k, scene.particles().temperature[i], sparse[i], 0.0) == 5.0, tolerance(1e-6));
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::staggered_scene_test
