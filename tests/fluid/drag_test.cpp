#include <particulate/fluid/drag.hpp>

#include <cmath>
#include <stdexcept>

#include <particulate/contact/contact.hpp>
#include <particulate/laws/gravity.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/symplectic_euler.hpp>
#include <particulate/schemes/verlet.hpp>

#include "close.hpp"
#include "contact/moment.hpp"

namespace tests::drag_test {

using namespace particulate;
using namespace particulate::fluid;
using Eigen::Vector3d;
using kinematics::Space, kinematics::Vectors;

const Stream water{.rho = 1000.0, .mu = 1e-3};

// A field that is the same at all places and times, and is no Stream.
const auto still_water = [](double, const Vector3d&) { return water; };

using Dragged = scenes::Scene<Space, Drag<Stream>>;
using Lifted = scenes::Scene<Space, Buoyancy<Stream>>;
static_assert(!schemes::Advances<schemes::VelocityVerlet, Dragged>);
static_assert(schemes::Advances<schemes::VelocityVerlet, Lifted>, "buoyancy asks for no velocity");
static_assert(schemes::Advances<schemes::RungeKutta4, Dragged> && schemes::Advances<schemes::SymplecticEuler, Dragged>);
static_assert(!laws::Conservative<Drag<Stream>, Space>);
static_assert(StreamField<Stream> && StreamField<decltype(still_water)> && !StreamField<double>);

// Along x at 2 m/s, and at rest.
kinematics::Particles two(double radius) {
  return kinematics::particles(
      {{.position = {1.0, 2.0, 3.0}, .velocity = {2.0, 0.0, 0.0}, .mass = 0.5, .radius = radius},
       {.position = {-1.0, 0.5, 0.0}, .mass = 4.0, .radius = radius}});
}

template <class L>
Vectors force_of(const L& law, const Moment& moment) {
  Vectors force = Vectors::Zero(moment.particles.size(), 3);
  BOOST_TEST_REQUIRE(add_force(law, Space{}, moment.at(), laws::Forces(force.data(), force.rows(), 3)));
  return force;
}

BOOST_AUTO_TEST_SUITE(drag_coefficient_)

// 24/0.5; 24/10^(2 * 0.646); 0.5; 0.000366 * 10^(6 * 0.4275); 0.18.
BOOST_AUTO_TEST_CASE(has_five_branches) {
  BOOST_TEST(drag_coefficient(0.5) == 48.0);
  BOOST_TEST(drag_coefficient(100.0) == 1.225211999940975, tolerance(1e-14));
  BOOST_TEST(drag_coefficient(1e4) == 0.5);
  BOOST_TEST(drag_coefficient(1e6) == 0.13442532198229884, tolerance(1e-14));
  BOOST_TEST(drag_coefficient(3e6) == 0.18);
  BOOST_TEST(drag_coefficient(infinity) == 0.18);
  BOOST_TEST(drag_coefficient(0.0) == infinity);
  BOOST_TEST(std::isnan(drag_coefficient(not_a_number)));
}

BOOST_AUTO_TEST_CASE(is_continuous_at_one_and_jumps_down_at_the_other_ends_of_its_branches) {
  const auto jump = [](double Re) {
    return drag_coefficient(std::nextafter(Re, infinity)) / drag_coefficient(Re) - 1.0;
  };
  BOOST_TEST(std::abs(jump(1.0)) < 1e-15);
  BOOST_TEST(jump(400.0) == -7.146579863833686e-4, tolerance(1e-11));
  BOOST_TEST(jump(drag_crisis) == -0.8393131203114517, tolerance(1e-13));
  BOOST_TEST(jump(2e6) == -4.362841781680669e-3, tolerance(1e-11));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(drag_rate_)

// rho = 2, mu = 1/2, b = 1/4: Re = 2 u. Stokes: 6 pi/2/4; else C_D 2 u pi/16/2.
BOOST_AUTO_TEST_CASE(is_that_of_stokes_from_rest_on_and_follows_the_coefficient) {
  const Stream fluid{.rho = 2.0, .mu = 0.5};
  for (const double u : {0.0, 1e-300, 0.3, 0.5}) BOOST_TEST(drag_rate(fluid, 0.25, u) == 0.75 * pi, tolerance(1e-15));
  BOOST_TEST(drag_rate(fluid, 0.25, 50.0) == 3.125 * pi * 1.225211999940975, tolerance(1e-14));
  BOOST_TEST(drag_rate(fluid, 0.25, 5e3) == 0.5 * 5e3 * pi / 16.0, tolerance(1e-14));
  BOOST_TEST(drag_rate(fluid, 0.0, 1.0) == 0.0);
}

BOOST_AUTO_TEST_CASE(is_finite_where_the_reynolds_number_is_not) {
  const Stream thin{.rho = 1.0, .mu = 1e-300};
  BOOST_TEST(drag_rate(thin, 1.0, 1e200) == 0.09e200 * pi, tolerance(1e-14));
  BOOST_TEST(drag_rate({.rho = 1.0, .mu = 1e-3}, 1.0, 1e5) == 0.09e5 * pi, tolerance(1e-14));
}

// (3, 4, 0) past a sphere that moves at (1, 1, 1): 5 m/s of slip.
BOOST_AUTO_TEST_CASE(times_the_slip_is_the_drag_in_every_frame) {
  Stream fluid{.v = {4.0, 5.0, 1.0}, .rho = 2.0, .mu = 0.5};
  const double Re = 10.0, xi = 0.5 * 24.0 * std::pow(Re, -0.646) * 2.0 * 5.0 * pi / 16.0;
  const Vector3d expected = xi * Vector3d(3.0, 4.0, 0.0);
  BOOST_TEST(close(drag(fluid, 0.25, {1.0, 1.0, 1.0}), expected, {.relative = 1e-14}));
  fluid.v -= Vector3d(64.0, 0.0, -32.0);
  BOOST_TEST(close(drag(fluid, 0.25, {-63.0, 1.0, 33.0}), expected, {.relative = 1e-14}));
  BOOST_TEST(drag(fluid, 0.25, fluid.v).norm() == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(steady_speeds_)

// F = 6 pi mu b u = 6 pi 1e-9 for 1 mm/s past 1 mum.
BOOST_AUTO_TEST_CASE(are_those_of_stokes_under_small_forces) {
  const std::vector<double> speeds = steady_speeds(water, 1e-6, 6.0 * pi * 1e-12);
  BOOST_TEST_REQUIRE(speeds.size() == 1);
  BOOST_TEST(speeds[0] == 1e-3, tolerance(1e-14));
  BOOST_TEST((steady_speeds(water, 1e-6, 0.0) == std::vector<double>{0.0}));
}

// On every branch the drag at the speed is the force, and only where C_D jumps down there are two. They are two
// wherever C_D Re^2 lies between its values on both sides: 8e4 (1 - 0.07 %), 4.5e10 (1 - 84 %), 7.2e11 (1 + 0.4 %).
BOOST_AUTO_TEST_CASE(balance_the_force_and_are_two_beside_a_jump) {
  const double b = 0.05;
  const auto force = [&](double G) { return G * pi * 1e-6 / (8.0 * 1000.0); };
  for (double exponent = -12.0; exponent < 16.0; exponent += 0.0625) {
    const double G = std::pow(10.0, exponent);
    const std::vector<double> speeds = steady_speeds(water, b, force(G));
    const auto within = [&](double low, double high) { return G > low && G < high; };
    const bool both = within(8e4, 0.5003575845438417 * 1.6e5) || within(0.08034343984427415 * 9e10, 4.5e10) ||
                      within(7.2e11, 0.180788752724042 * 4e12);
    BOOST_TEST_CONTEXT("C_D Re^2 = " << G) {
      BOOST_TEST(speeds.size() == (both ? 2 : 1));
      for (const double u : speeds) BOOST_TEST(drag_rate(water, b, u) * u == force(G), tolerance(1e-13));
      BOOST_TEST(std::is_sorted(speeds.begin(), speeds.end()));
    }
  }
  BOOST_TEST(steady_speeds(water, b, force(8.003e4)).size() == 2);
  BOOST_TEST(steady_speeds(water, b, force(7.21e11)).size() == 2);
}

// Of the last branch: u = (F/(0.09 pi rho))^(1/2)/b.
BOOST_AUTO_TEST_CASE(are_those_of_the_last_branch_however_thin_the_fluid) {
  for (const double mu : {1e-6, 1e-100, 1e-200, 1e-300}) {
    const std::vector<double> speeds = steady_speeds({.rho = 1.0, .mu = mu}, 1.0, 0.09 * pi * 1e4);
    BOOST_TEST_REQUIRE(speeds.size() == 1);
    BOOST_TEST(speeds[0] == 100.0, tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(refuse_what_is_no_force_no_sphere_and_no_fluid) {
  CHECK_REFUSED(steady_speeds(water, 0.0, 1.0),
                "the radius must be positive, the force not negative, and both finite, "
                "got 0 m and 1 N");
  CHECK_REFUSED(steady_speeds(water, infinity, 1.0), "got inf m");
  CHECK_REFUSED(steady_speeds(water, 1.0, -1.0), "got 1 m and -1 N");
  CHECK_REFUSED(steady_speeds(water, 1.0, infinity), "got 1 m and inf N");
  CHECK_REFUSED(steady_speeds(water, 1.0, not_a_number), "got 1 m and nan N");
  CHECK_REFUSED(steady_speeds({.mu = 0.0}, 1.0, 1.0), "must be positive, and all finite, got 1.2 kg/m^3, 0 Pa s");
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(validate_drag)

BOOST_AUTO_TEST_CASE(refuses_a_uniform_stream_that_is_none) {
  const auto refuses = [](const Stream& bad, const char* words) {
    CHECK_REFUSED(validate(Drag{bad}), words);
    CHECK_REFUSED(validate(Buoyancy{bad}), words);
    CHECK_REFUSED(scenes::Scene(two(0.1), Space{}, Drag{bad}), words);
  };
  refuses({.rho = 0.0}, "stream: density, viscosity and temperature must be positive, and all finite, got 0 kg/m^3");
  refuses({.rho = -1.0}, "got -1 kg/m^3");
  refuses({.mu = 0.0}, "0 Pa s");
  refuses({.mu = infinity}, "inf Pa s");
  refuses({.theta = 0.0}, "0 K");
  refuses({.theta = not_a_number}, "nan K");
  refuses({.v = {0.0, not_a_number, 0.0}}, "(0, nan, 0) m/s");
  CHECK_REFUSED(validate(Buoyancy{still_water, Vector3d(0.0, 0.0, infinity)}),
                "buoyancy: g must be finite, got (0, 0, inf) m/s^2");
  BOOST_CHECK_NO_THROW(validate(Drag{water}));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(add_force_)

// At t = 3 and (1, 2, 3), (-1, 0.5, 0) the stream is (3, 2, 0) and (3, 0.5, 0) m/s; 6 pi mu b = 1 kg/s.
BOOST_AUTO_TEST_CASE(asks_the_field_at_its_time_and_at_each_place) {
  const double b = 1.0 / (6.0 * pi);
  const auto field = [](double t, const Vector3d& x) { return Stream{.v = {t, x[1], 0.0}, .rho = 0.1, .mu = 1.0}; };
  const Moment moment{two(b)};
  BOOST_TEST(close(force_of(Drag{field}, moment), Vectors{{1.0, 2.0, 0.0}, {3.0, 0.5, 0.0}}, {.relative = 1e-14}));
}

// 4/3 pi (1/2)^3 1000 * 9.81, upwards, or along what g is against.
BOOST_AUTO_TEST_CASE(of_buoyancy_is_the_weight_of_the_fluid_displaced) {
  const double weight = pi / 6.0 * 9810.0;
  const Vectors up{{0.0, 0.0, weight}, {0.0, 0.0, weight}};
  BOOST_TEST(close(force_of(Buoyancy{water}, {two(0.5)}), up, {.relative = 1e-14}));
  BOOST_TEST(close(force_of(Buoyancy{still_water}, {two(0.5)}), up, {.relative = 1e-14}));
  const Vectors aside = force_of(Buoyancy{water, Vector3d(-9.81, 0.0, 0.0)}, {two(0.5)});
  BOOST_TEST(close(aside.col(0), up.col(2), {.relative = 1e-14}));
}

BOOST_AUTO_TEST_CASE(of_a_point_is_nothing) {
  BOOST_TEST(force_of(Drag{water}, {two(0.0)}).isZero(0.0));
  BOOST_TEST(force_of(Buoyancy{water}, {two(0.0)}).isZero(0.0));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(scenes_with_drag)

// Stokes: v = v_0 exp(-t) of 1 kg, with 6 pi mu b = 1 kg/s.
const Stream thick{.rho = 1e-3, .mu = 1.0};
kinematics::Particles slow() {
  return kinematics::particles(
      {{.position = {0.0, 0.0, 0.0}, .velocity = {1.0, 0.0, -2.0}, .mass = 1.0, .radius = 1.0 / (6.0 * pi)}});
}

BOOST_AUTO_TEST_CASE(run_with_every_scheme_that_takes_velocities) {
  const scenes::Scene scene(slow(), Space{}, Drag{thick});
  const auto off = [&](auto scheme, double step) {
    schemes::State at = scenes::start(scene);
    const schemes::Outcome out = integrate(scene, at, 1.0, scheme, schemes::FixedStep{.step = step});
    BOOST_TEST_REQUIRE((out.status == schemes::Status::reached), out);
    return (schemes::velocity(at, 0) - std::exp(-1.0) * Vector3d(1.0, 0.0, -2.0)).norm();
  };
  BOOST_TEST(off(schemes::RungeKutta4{}, 0.01) < 1e-9);
  BOOST_TEST(off(schemes::Collocation<schemes::Gauss<2>>{}, 0.01) < 1e-9);
  BOOST_TEST(off(schemes::PhiFamily(0.5), 0.01) < 1e-4);
  BOOST_TEST(off(schemes::ForwardEuler{}, 0.01) < 0.02);
  BOOST_TEST(off(schemes::SymplecticEuler{}, 0.01) < 0.02);
}

// Two equal spheres meet at 2 m/s of approach, with e = 0, in a stream that pushes the left one alone: 4 N by Stokes at
// a slip of 4 m/s. A constant force of as much must do to them what the drag does.
struct Push {
  double force;
};
template <kinematics::Domain D>
bool add_force(const Push& law, const D&, const laws::At<>& at, laws::Forces force) {
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    if (at.position(i, 0) < 0.0) force(i, 0) += law.force;
  }
  return true;
}
BOOST_AUTO_TEST_CASE(count_it_among_the_forces_of_an_impact) {
  const double b = 1.0 / (6.0 * pi);
  const auto left = [](double, const Vector3d& x) {
    return Stream{.v = {x[0] < 0.0 ? 5.0 : -1.0, 0.0, 0.0}, .rho = 1e-3, .mu = 1.0};
  };
  const kinematics::Particles both = kinematics::particles(
      {{.position = {-b, 0.0, 0.0}, .velocity = {1.0, 0.0, 0.0}, .mass = 1.0, .radius = b},
       {.position = {0.999 * b, 0.0, 0.0}, .velocity = {-1.0, 0.0, 0.0}, .mass = 1.0, .radius = b}});
  const contact::Contact<> inelastic{.restitution = {.e = 0.0}, .gamma = 0.5};
  const auto after = [&](const auto& scene) {
    schemes::State at = scenes::start(scene);
    BOOST_TEST(scene.jump(at, 0.1).impacts == 1);
    return at.v;
  };
  const Eigen::VectorXd dragged = after(scenes::Scene(both, Space{}, Drag{left}, inelastic));
  BOOST_TEST(close(dragged, after(scenes::Scene(both, Space{}, Push{4.0}, inelastic)), {.absolute = 1e-15}));
  BOOST_TEST((dragged - after(scenes::Scene(both, Space{}, Push{0.0}, inelastic))).norm() > 1e-2);
}

BOOST_AUTO_TEST_CASE(say_where_a_field_has_no_value) {
  const auto ends = [](double t, const Vector3d&) { return Stream{.v = {t > 0.5 ? not_a_number : 0.0, 0.0, 0.0}}; };
  const auto says_so = [](const auto& scene) {
    schemes::State at = scenes::start(scene);
    const schemes::Outcome out = integrate(scene, at, 1.0, schemes::RungeKutta4{}, schemes::FixedStep{.step = 0.0625});
    BOOST_TEST((out.status != schemes::Status::reached));
    BOOST_TEST(contains(out.reason, "particle 0 at ("));
    BOOST_TEST(contains(out.reason,
                        "is where there is no fluid, or none that can be: 1.2 kg/m^3, 1.8e-05 Pa s, 300 K "
                        "and (nan, 0, 0) m/s"));
    BOOST_TEST(at.t == 0.5);
  };
  says_so(scenes::Scene(slow(), Space{}, Drag{ends}));
  says_so(scenes::Scene(slow(), Space{}, Buoyancy{ends}));
}

BOOST_AUTO_TEST_CASE(let_what_a_field_throws_through) {
  const auto throws = [](double, const Vector3d&) -> Stream { throw std::domain_error("no fluid here"); };
  const scenes::Scene scene(slow(), Space{}, Drag{throws});
  schemes::State at = scenes::start(scene);
  BOOST_CHECK_THROW(
      static_cast<void>(integrate(scene, at, 1.0, schemes::RungeKutta4{}, schemes::FixedStep{.step = 0.1})),
      std::domain_error);
}

// 1 mm of 2650 kg/m^3 in water, from rest: it settles where weight, buoyancy and drag balance.
BOOST_AUTO_TEST_CASE(settle_at_the_terminal_speed) {
  const double b = 0.5e-3, volume = 4.0 / 3.0 * pi * b * b * b;
  const scenes::Scene scene(
      kinematics::particles({{.position = {0.0, 0.0, 0.0}, .mass = 2650.0 * volume, .radius = b}}), Space{},
      Drag{still_water}, laws::Gravity{}, Buoyancy{still_water});
  schemes::State at = scenes::start(scene);
  (void)integrate(scene, at, 2.0, schemes::RungeKutta4{}, schemes::FixedStep{.step = 4e-3});
  BOOST_TEST(at.v[2] == -0.151913231804, tolerance(1e-10));
  BOOST_TEST(steady_speeds(water, b, 1650.0 * volume * 9.81).back() == 0.151913231804, tolerance(1e-11));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::drag_test
