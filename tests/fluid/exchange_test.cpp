#include <particulate/fluid/exchange.hpp>

#include <cmath>

#include "close.hpp"

namespace tests::exchange_test {

using namespace particulate::fluid;
using Eigen::Vector3d, Eigen::VectorXd;
using particulate::schemes::State;
namespace kinematics = particulate::kinematics;

// 6 pi mu b = 1 kg/s; m c = 6 J/K; a_s = 4 pi b^2.
constexpr double b = 1.0 / (6.0 * pi), area = 4.0 * pi * b * b;
const Stream stream{.v = {1.0, 0.0, 0.0}, .rho = 1e-3, .mu = 1.0, .theta = 350.0};
const HeatExchange convection{.h_c = 12.0 / area};  // 12 W/K

kinematics::Particles one(bool immovable = false) {
  return kinematics::particles({{.position = {0.0, 0.0, 0.0},
                                 .mass = 2.0,
                                 .radius = b,
                                 .immovable = immovable,
                                 .temperature = 400.0,
                                 .heat_capacity = 3.0}});
}
Exchange exchange(std::optional<HeatExchange> heat = {}, int axes = 3, bool immovable = false) {
  Exchange made(one(immovable), axes, VectorXd::Constant(1, 1.0), false, heat);
  made.around = {stream};
  return made;
}
VectorXd numbers(const std::vector<double>& all) {
  return Eigen::Map<const VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

// One step of dt from a velocity, with the coefficient of that velocity unless another iterate is given.
struct Moved {
  Vector3d v, r;
};
Moved moved(Exchange& with, const Vector3d& from, const Vector3d& force, double dt,
            std::optional<Vector3d> iterate = {}) {
  const State start{.r = Vector3d(5.0, 6.0, 7.0), .v = from};
  VectorXd v = iterate.value_or(from), r(3);
  BOOST_TEST_REQUIRE(with.move(start, force, dt, v, r));
  return {v, r};
}

BOOST_AUTO_TEST_SUITE(Exchange_rates)

// A slip of (1, -2, 0): 1 kg/s of it is the force. Its power on the sphere is 0 * 1 + 2 * (-2), it dissipates 5 W, of
// which a fifth goes to the sphere beside 12 (350 - 400) W of convection and B eps a_s (400^4 - 300^4) of radiation.
BOOST_AUTO_TEST_CASE(are_drag_heat_and_what_the_fluid_gives_for_both) {
  HeatExchange heat = convection;
  heat.emissivity = 0.5, heat.a_v = 0.2;
  Exchange with = exchange(heat);
  VectorXd force, flow;
  BOOST_TEST(with.rates(Vector3d(0.0, 2.0, 0.0), Eigen::Matrix<double, 1, 1>(400.0), force, flow));
  BOOST_TEST(close(force, Vector3d(1.0, -2.0, 0.0), {.relative = 1e-14}));
  BOOST_TEST(flow[0] == -600.0 - area * 496.1577616625 + 1.0, tolerance(1e-13));
  BOOST_TEST(close(numbers(with.given()), Eigen::Vector4d(1.0, -2.0, 0.0, -4.0 - 600.0 + 1.0), {.relative = 1e-14}));
}

BOOST_AUTO_TEST_CASE(have_none_across_the_directions_of_the_fluid) {
  Exchange with = exchange({}, 1);
  VectorXd force, flow;
  BOOST_TEST(with.rates(Vector3d(0.0, 2.0, 3.0), VectorXd(), force, flow));
  BOOST_TEST(close(force, Vector3d(1.0, 0.0, 0.0), {.relative = 1e-14}));
  BOOST_TEST(close(numbers(with.given()), Eigen::Vector2d(1.0, 0.0), {.relative = 1e-14}));
}

BOOST_AUTO_TEST_CASE(have_no_value_where_something_is_not_finite) {
  Exchange with = exchange(convection);
  VectorXd force, flow;
  const VectorXd theta = VectorXd::Constant(1, 400.0), none = VectorXd::Constant(1, not_a_number);
  BOOST_TEST(!with.rates(Vector3d(not_a_number, 0.0, 0.0), theta, force, flow));
  BOOST_TEST(!with.rates(Vector3d(1e200, 0.0, 0.0), theta, force, flow));
  BOOST_TEST(!with.rates(Vector3d::Zero(), none, force, flow));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(Exchange_move)

// dt xi/m = 1: half of the slip of 1 m/s is left, J = 2 * 1 * 1/2. The work, J times the mean velocity of 1/4, is the
// kinetic energy that 2 kg get: 1/2 2 (1/2)^2. r = r_0 + 2 * 1/2.
BOOST_AUTO_TEST_CASE(takes_a_step_of_backward_euler) {
  Exchange with = exchange();
  const Moved to = moved(with, Vector3d::Zero(), Vector3d::Zero(), 2.0);
  BOOST_TEST(close(to.v, Vector3d(0.5, 0.0, 0.0), {.relative = 1e-15}));
  BOOST_TEST(close(to.r, Vector3d(6.0, 6.0, 7.0), {.relative = 1e-15}));
  BOOST_TEST(close(numbers(with.given()), Eigen::Vector4d(1.0, 0.0, 0.0, 0.25), {.relative = 1e-15}));
}

// Beside 2 N along x, which bring 2 m/s: of the slip -1 m/s half is left, J = -1; v = (-1 + 4)/2.
BOOST_AUTO_TEST_CASE(sees_the_other_forces_and_gives_its_own_work_alone) {
  Exchange with = exchange();
  const Moved to = moved(with, Vector3d::Zero(), Vector3d(2.0, 0.0, 0.0), 2.0);
  BOOST_TEST(to.v[0] == 1.5, tolerance(1e-15));
  BOOST_TEST(close(numbers(with.given()), Eigen::Vector4d(-1.0, 0.0, 0.0, -0.75), {.relative = 1e-14}));
}

// The work is the change of the kinetic energy, less what other forces did, for any numbers and on any branch of C_D.
BOOST_AUTO_TEST_CASE(works_as_much_as_kinetic_energy_changes) {
  const Vector3d from(3.0, -40.0, 0.5), force(7.0, 0.0, -2.0);
  for (const double rho : {1e-3, 1.0, 1e5, 1e9}) {
    Exchange with = exchange();
    with.around[0].rho = rho;
    const double dt = 0.3;
    const Vector3d v = moved(with, from, force, dt, Vector3d(1.0, -2.0, 3.0)).v;
    const double kinetic = v.squaredNorm() - from.squaredNorm(), other = 0.5 * dt * force.dot(v + from);
    BOOST_TEST(with.given()[3] == kinetic - other, tolerance(1e-12));
    BOOST_TEST(close(numbers(with.given()).head(3), 2.0 * (v - from) - dt * force, {.relative = 1e-11}));
  }
}

BOOST_AUTO_TEST_CASE(leaves_what_is_immovable_and_lets_the_fluid_feel_it) {
  Exchange with = exchange({}, 3, true);
  const Moved to = moved(with, Vector3d(-3.0, 0.0, 0.0), Vector3d(9.0, 9.0, 9.0), 2.0);
  BOOST_TEST(close(to.v, Vector3d(-3.0, 0.0, 0.0), {}));
  BOOST_TEST(to.r[0] == -1.0);
  BOOST_TEST(close(numbers(with.given()), Eigen::Vector4d(8.0, 0.0, 0.0, -24.0), {.relative = 1e-14}));
}

// 6 pi b/(g w) = 1/2 doubles the slip that is felt, and with it the force.
BOOST_AUTO_TEST_CASE(feels_the_slip_without_its_own_disturbance_where_that_is_corrected) {
  Exchange with(one(), 3, VectorXd::Constant(1, 2.0 / 13.9586), true, {});
  with.around = {stream};
  VectorXd force, flow;
  BOOST_TEST(with.rates(Vector3d::Zero(), VectorXd(), force, flow));
  BOOST_TEST(force[0] == 2.0, tolerance(1e-14));
  BOOST_TEST(moved(with, Vector3d::Zero(), Vector3d::Zero(), 1.0).v[0] == 0.5, tolerance(1e-14));
  BOOST_TEST(with.reynolds(0, Vector3d::Zero()) == 2.0 * 2.0 * b * 1e-3, tolerance(1e-14));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(Exchange_roots)

// With k = dt rho pi b^2/(2 m) the slip u obeys u + k C_D u^2 = coming. At the jump, u_c = 3e5 mu/(2 b rho), the left
// side falls from u_c + 0.5 k u_c^2 to u_c + 0.080343 k u_c^2: between, at 0.3 of it, there is a root on each side.
// Every iterate stays on its side and comes to that side's root.
BOOST_AUTO_TEST_CASE(are_counted_where_there_are_two_by_the_side_that_was_taken) {
  Exchange with = exchange();
  with.around[0].rho = 1e3;
  const double u_c = 3e5 / (2.0 * b * 1e3), k = 4.0 / u_c, dt = 4.0 * k / (1e3 * pi * b * b);
  const auto settled = [&](double coming, double slip) {
    const Vector3d from(1.0 - coming, 0.0, 0.0);
    for (int sweep = 0; sweep < 200; ++sweep)
      slip = 1.0 - moved(with, from, Vector3d::Zero(), dt, Vector3d(1.0 - slip, 0.0, 0.0)).v[0];
    const double left = slip + k * drag_coefficient(slip / u_c * 3e5) * slip * slip;
    BOOST_TEST(left == coming, tolerance(1e-9));
    return std::pair{with.roots().slow, with.roots().fast};
  };
  const double between = u_c + 0.3 * k * u_c * u_c;
  BOOST_TEST((settled(between, 0.9 * u_c) == std::pair{1L, 0L}));
  BOOST_TEST((settled(between, 1.1 * u_c) == std::pair{0L, 1L}));
  BOOST_TEST((settled(0.5 * u_c, 0.4 * u_c) == std::pair{0L, 0L}));
  BOOST_TEST((settled(u_c + 0.6 * k * u_c * u_c, 1.1 * u_c) == std::pair{0L, 0L}));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(Exchange_warm)

VectorXd warmed(Exchange& with, double from, double other, double dt, double iterate) {
  VectorXd theta = VectorXd::Constant(1, iterate);
  BOOST_TEST_REQUIRE(with.warm(VectorXd::Constant(1, from), VectorXd::Constant(1, other), dt, theta));
  return theta;
}

// dt 12/6 = 1: from 400 K half way to 350 K, whatever the iterate; the fluid gives dt 12 (350 - 375) J beside the work.
BOOST_AUTO_TEST_CASE(takes_convection_implicitly) {
  for (const double iterate : {400.0, 1.0, 1e4}) {
    Exchange with = exchange(convection);
    moved(with, Vector3d::Zero(), Vector3d::Zero(), 0.5);
    const double work = with.given()[3];
    BOOST_TEST(warmed(with, 400.0, 0.0, 0.5, iterate)[0] == 375.0, tolerance(1e-13));
    BOOST_TEST(with.given()[3] == work - 150.0, tolerance(1e-13));
  }
}

// 60 W more bring 10 K in a second without convection, and all of what drag dissipated goes to the sphere with a_v = 1:
// J (v_f - mean v) = 1 * (1 - 1/4) in the step of `move` above.
BOOST_AUTO_TEST_CASE(adds_the_other_heat_and_the_share_of_the_dissipation) {
  Exchange with = exchange(HeatExchange{.a_v = 1.0});
  moved(with, Vector3d::Zero(), Vector3d::Zero(), 2.0);
  BOOST_TEST(warmed(with, 400.0, 60.0, 2.0, 400.0)[0] == 420.0 + 0.75 / 6.0, tolerance(1e-14));
  BOOST_TEST(with.given()[3] == 0.25 + 0.75, tolerance(1e-14));
}

// At the fixed point of the tangents: m c (theta - theta_0) = dt a_s B eps (theta_s^4 - theta^4). The fluid gives none.
BOOST_AUTO_TEST_CASE(converges_to_implicit_radiation_which_the_fluid_does_not_feel) {
  Exchange with = exchange(HeatExchange{.emissivity = 1.0, .theta_s = 200.0});
  with.around[0].v.setZero();
  moved(with, Vector3d::Zero(), Vector3d::Zero(), 1.0);
  for (const double start : {1e3, 1e5}) {
    double theta = start;
    for (int sweep = 0; sweep < 60; ++sweep) theta = warmed(with, start, 0.0, 1.0, theta)[0];
    const double lost = area * 5.670374419e-8 * (std::pow(200.0, 4) - std::pow(theta, 4));
    BOOST_TEST(6.0 * (theta - start) == lost, tolerance(1e-9));
    BOOST_TEST(theta > 200.0);
  }
  BOOST_TEST(with.given()[3] == 0.0);
}

BOOST_AUTO_TEST_CASE(has_no_value_below_0_K) {
  Exchange with = exchange(convection);
  VectorXd theta = VectorXd::Constant(1, 400.0);
  BOOST_TEST(!with.warm(theta, VectorXd::Constant(1, -1e6), 1.0, theta));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(Exchange_step_rates)

// xi = 1 kg/s over 2 kg; 12 W/K and 4 B eps a_s 400^3 over 6 J/K.
BOOST_AUTO_TEST_CASE(are_those_of_drag_and_of_heat) {
  HeatExchange heat = convection;
  heat.emissivity = 0.5;
  const Exchange::Rates all = exchange(heat).step_rates(Vector3d::Zero(), Eigen::Matrix<double, 1, 1>(400.0));
  BOOST_TEST((all.mass[0] == 2.0 && all.capacity[0] == 6.0));
  BOOST_TEST(all.drag[0] == 1.0, tolerance(1e-14));
  BOOST_TEST(all.relaxes[0] == 0.5, tolerance(1e-14));
  BOOST_TEST(all.heat[0] == 12.0, tolerance(1e-14));
  BOOST_TEST(all.cools[0] == (12.0 + 2.0 * area * 5.670374419e-8 * 6.4e7) / 6.0, tolerance(1e-9));
  const Exchange::Rates fixed = exchange({}, 3, true).step_rates(Vector3d::Zero(), VectorXd());
  BOOST_TEST((fixed.relaxes[0] == 0.0 && fixed.mass[0] > 1e100 && fixed.heat.size() == 0));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::exchange_test
