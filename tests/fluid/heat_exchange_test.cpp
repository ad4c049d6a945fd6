#include <particulate/fluid/heat_exchange.hpp>

#include <cmath>

#include <Eigen/SparseCore>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/verlet.hpp>

#include "close.hpp"

namespace tests::heat_exchange_test {

using namespace particulate;
using namespace particulate::fluid;
using Eigen::Vector3d;
using kinematics::Space;

using Heated = scenes::Scene<Space, HeatFromFluid<Stream>>;
static_assert(Heated::has_heat_flow && Heated::needs_velocity);
static_assert(!schemes::Advances<schemes::VelocityVerlet, Heated>);

// Of 6 pi mu b = 1 kg/s where mu = 1 Pa s.
constexpr double b = 1.0 / (6.0 * pi);
kinematics::Particles one(double theta, const Vector3d& v = Vector3d::Zero()) {
  return kinematics::particles({{.position = {0.5, 0.0, 0.0},
                                 .velocity = v,
                                 .mass = 2.0,
                                 .radius = b,
                                 .temperature = theta,
                                 .heat_capacity = 3.0}});
}

// dtheta/dt of the only particle at t.
template <class L>
double rate(const L& law, const kinematics::Particles& particles, double t = 0.0) {
  const scenes::Scene scene(particles, Space{}, law);
  const schemes::State at = scenes::start(scene);
  Eigen::VectorXd a(3), dy(1);
  BOOST_TEST_REQUIRE(scene.rates(t, at.r, at.v, at.y, a, dy));
  BOOST_TEST(a.isZero(0.0));
  return dy[0];
}

BOOST_AUTO_TEST_SUITE(add_heat_)

// 10 (350 - 400) W/m^2 by convection, 0.5 B (400^4 - 300^4) = 496.1577616625 W/m^2 by radiation, and a quarter of the
// 2^2 W that Stokes drag dissipates at a slip of 2 m/s; over m c = 6 J/K.
BOOST_AUTO_TEST_CASE(is_convection_radiation_and_a_share_of_what_drag_dissipates) {
  const double area = 4.0 * pi * b * b;
  const Stream stream{.v = {0.0, 3.0, 0.0}, .rho = 0.1, .mu = 1.0, .theta = 350.0};
  const HeatExchange heat{.h_c = 10.0, .emissivity = 0.5, .a_v = 0.25};
  const double expected = (area * (-500.0 - 496.1577616625) + 1.0) / 6.0;
  const kinematics::Particles particles = one(400.0, {0.0, 1.0, 0.0});
  BOOST_TEST(rate(HeatFromFluid{stream, heat}, particles) == expected, tolerance(1e-13));
  const auto field = [&](double, const Vector3d&) { return stream; };
  BOOST_TEST(rate(HeatFromFluid{field, heat}, particles) == expected, tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(is_nothing_among_equals_at_rest) {
  const HeatExchange heat{.h_c = 10.0, .emissivity = 1.0, .a_v = 1.0};
  BOOST_TEST(rate(HeatFromFluid{Stream{}, heat}, one(300.0)) == 0.0);
  BOOST_TEST(rate(HeatFromFluid{Stream{}, HeatExchange{}}, one(400.0, {5.0, 0.0, 0.0})) == 0.0);
}

// 300 K + 100 K/m x + 50 K/s t at x = 1/2 m and t = 2 s: 450 K.
BOOST_AUTO_TEST_CASE(asks_the_field_at_its_time_and_place) {
  const auto field = [](double t, const Vector3d& x) { return Stream{.theta = 300.0 + 100.0 * x[0] + 50.0 * t}; };
  BOOST_TEST(rate(HeatFromFluid{field, {.h_c = 1.0}}, one(440.0), 2.0) == 10.0 * 4.0 * pi * b * b / 6.0,
             tolerance(1e-13));
}

// theta_f + (theta_0 - theta_f) exp(-h_c a_s t/(m c)).
BOOST_AUTO_TEST_CASE(relaxes_a_sphere_to_its_fluid) {
  const double area = 4.0 * pi * b * b, h_c = 6.0 / area;
  const scenes::Scene scene(one(500.0), Space{}, HeatFromFluid{Stream{.theta = 350.0}, HeatExchange{.h_c = h_c}});
  schemes::State at = scenes::start(scene);
  (void)integrate(scene, at, 2.0, schemes::RungeKutta4{}, schemes::FixedStep{.step = 0.01});
  BOOST_TEST(at.y[0] == 350.0 + 150.0 * std::exp(-2.0), tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(says_where_a_field_has_no_value) {
  const auto ends = [](double t, const Vector3d&) { return Stream{.theta = t > 0.5 ? -1.0 : 300.0}; };
  const scenes::Scene scene(one(500.0), Space{}, HeatFromFluid{ends, HeatExchange{.h_c = 1.0}});
  schemes::State at = scenes::start(scene);
  const schemes::Outcome out = integrate(scene, at, 1.0, schemes::RungeKutta4{}, schemes::FixedStep{.step = 0.125});
  BOOST_TEST((out.failure == schemes::Failure::no_value));
  BOOST_TEST(at.t == 0.5);
  BOOST_TEST(contains(out.reason, "particle 0 at (0.5, 0, 0) m is where there is no fluid, or none that can be"));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(add_heat_slopes_)

// Against a difference quotient of the rate itself.
BOOST_AUTO_TEST_CASE(are_those_of_the_heat_flow) {
  const HeatFromFluid law{Stream{.theta = 350.0}, HeatExchange{.h_c = 10.0, .emissivity = 0.7}};
  const scenes::Scene scene(one(400.0), Space{}, law);
  const schemes::State at = scenes::start(scene);
  schemes::SparseJacobian J;
  scene.temperature_jacobian(0.0, at.r, at.v, at.y, J);
  const double h = 1e-3, slope = (rate(law, one(400.0 + h)) - rate(law, one(400.0 - h))) / (2.0 * h);
  BOOST_TEST(J.coeff(0, 0) == slope, tolerance(1e-8));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(validate_heat_exchange)

BOOST_AUTO_TEST_CASE(names_the_constant_what_must_hold_and_what_was_given) {
  const auto refuses = [](const HeatExchange& bad, const char* words) {
    CHECK_REFUSED(validate(bad), words);
    CHECK_REFUSED(validate(HeatFromFluid{Stream{}, bad}), words);
  };
  for (const double a_v : {-0.1, 1.1, infinity, not_a_number}) {
    refuses({.a_v = a_v}, "heat exchange: a_v must lie between 0 and 1, got ");
  }
  refuses({.h_c = -1.0}, "h_c must be finite and not negative, got -1");
  refuses({.h_c = infinity}, "h_c must be finite and not negative, got inf");
  refuses({.emissivity = 1.5}, "emissivity must lie between 0 and 1, got 1.5");
  refuses({.theta_s = -1.0}, "theta_s must be finite and not negative, got -1");
  CHECK_REFUSED(validate(HeatFromFluid{Stream{.theta = 0.0}, HeatExchange{}}), "0 K");
  BOOST_CHECK_NO_THROW(validate(HeatExchange{.a_v = 1.0}));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::heat_exchange_test
