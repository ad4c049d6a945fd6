#include <particulate/thermo/cooling.hpp>

#include <cmath>

#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/runge_kutta.hpp>

#include "close.hpp"
#include "says.hpp"

namespace tests::cooling_test {

using boost::test_tools::tolerance;
using namespace particulate;
using namespace particulate::thermo;

// A sphere of 1 mm, 2000 kg/m^3 and 1000 J/(kg K): m c/a_s = b rho c/3 = 2000/3 J/(m^2 K).
constexpr double radius = 1e-3, per_area = radius * 2000.0 * 1000.0 / 3.0;
const double k = stefan_boltzmann / per_area;

double temperature_after(const Cooling& law, double theta_0, double t) {
  const double mass = per_area * surface(radius) / 1000.0;
  const auto sphere = kinematics::particles(
      {{.position = {0.0, 0.0, 0.0}, .mass = mass, .radius = radius, .temperature = theta_0, .heat_capacity = 1000.0}});
  const scenes::Scene scene(sphere, kinematics::Space{}, law);
  schemes::State state = scenes::start(scene);
  const schemes::Outcome out = integrate(scene, state, t, schemes::RungeKutta4{}, schemes::ErrorControl{.TOL = 1e-9});
  BOOST_TEST((out.status == schemes::Status::reached));
  return state.y[0];
}

BOOST_AUTO_TEST_SUITE(heat_flux_)

// 10 (400 - 300) W/m^2 go by convection, and 0.5 B (400^4 - 300^4) = 0.5 B 1.75e10 = 496.1577616625 by radiation.
BOOST_AUTO_TEST_CASE(is_that_of_both) {
  const Cooling law{.h_c = 10.0, .emissivity = 0.5};
  BOOST_TEST(heat_flux(law, 400.0) == -1000.0 - 496.1577616625, tolerance(1e-14));
  BOOST_TEST(heat_flux(law, 300.0) == 0.0);
  const double h = 1e-3, slope = (heat_flux(law, 400.0 + h) - heat_flux(law, 400.0 - h)) / (2.0 * h);
  BOOST_TEST(heat_flux_slope(law, 400.0) == slope, tolerance(1e-8));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(equilibrium_temperature_)

BOOST_AUTO_TEST_CASE(is_where_nothing_flows) {
  const Cooling law{.h_c = 20.0, .theta_o = 350.0, .emissivity = 0.8, .theta_s = 1000.0};
  const double theta = equilibrium_temperature(law);
  BOOST_TEST((theta > 350.0 && theta < 1000.0));
  BOOST_TEST(std::abs(heat_flux(law, theta)) < 1e-12 * std::abs(heat_flux(law, 350.0)));
  BOOST_TEST(equilibrium_temperature({.h_c = 1.0, .theta_o = 310.0}) == 310.0);
  BOOST_TEST(equilibrium_temperature({.emissivity = 1.0, .theta_s = 320.0}) == 320.0);
  CHECK_REFUSED(equilibrium_temperature({}), "give h_c or emissivity");
}

// Convection alone takes 25 W/m^2 at 10 W/(m^2 K) and 2.5 K above the flow; radiation alone B (400^4 - 300^4) =
// 992.315523325 W/m^2 at 400 K, B 400^4 to nothing; and half of it with 10 (400 - 300) W/m^2 of convection beside it.
BOOST_AUTO_TEST_CASE(is_where_what_is_absorbed_goes_away) {
  BOOST_TEST(equilibrium_temperature({.h_c = 10.0, .theta_o = 290.0}, 25.0) == 292.5, tolerance(1e-15));
  BOOST_TEST(equilibrium_temperature({.emissivity = 1.0}, 992.315523325) == 400.0, tolerance(1e-14));
  BOOST_TEST(equilibrium_temperature({.emissivity = 1.0, .theta_s = 0.0},
                                     400.0 * 400.0 * 400.0 * 400.0 * stefan_boltzmann) == 400.0,
             tolerance(1e-14));
  BOOST_TEST(equilibrium_temperature({.h_c = 10.0, .emissivity = 0.5}, 1496.1577616625) == 400.0, tolerance(1e-14));
}

// Surroundings apart: what is absorbed may leave the body between them, or bring it above both.
BOOST_AUTO_TEST_CASE(is_found_between_and_above_surroundings_that_differ) {
  const Cooling law{.h_c = 20.0, .theta_o = 350.0, .emissivity = 0.8, .theta_s = 1000.0};
  for (const double absorbed : {0.0, 1e-6, 1.0, 1e4, 1e9}) {
    const double theta = equilibrium_temperature(law, absorbed), off = heat_flux(law, theta) + absorbed;
    BOOST_TEST(std::abs(off) <= 2e-15 * theta * std::abs(heat_flux_slope(law, theta)));
    BOOST_TEST((theta > 350.0 && (theta > 1000.0) == (absorbed > 20.0 * 650.0)));
  }
}

BOOST_AUTO_TEST_CASE(refuses_what_cannot_be_absorbed) {
  const Cooling law{.h_c = 1.0};
  CHECK_REFUSED(equilibrium_temperature(law, -1.0), "must be finite and not negative, got -1 W/m^2");
  CHECK_REFUSED(equilibrium_temperature(law, NAN), "must be finite and not negative, got nan W/m^2");
  CHECK_REFUSED(equilibrium_temperature(law, INFINITY), "must be finite and not negative, got inf W/m^2");
  CHECK_REFUSED(equilibrium_temperature({}, 1.0), "give h_c or emissivity");
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(radiation_time_)

// Known to 25 digits: see the verification of chapter 7.
BOOST_AUTO_TEST_CASE(is_the_time_that_a_sphere_takes) {
  BOOST_TEST(radiation_time(k, 1000.0, 500.0, 300.0) == 29.319567692972, tolerance(1e-13));
  BOOST_TEST(radiation_time(k, 1000.0, 500.0, 0.0) == 27.433030706813, tolerance(1e-13));
  const Cooling law{.emissivity = 1.0};
  BOOST_TEST(temperature_after(law, 1000.0, 29.319567692972) == 500.0, tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(is_the_time_of_warming_too) {
  const double t = radiation_time(k, 200.0, 290.0, 300.0);
  BOOST_TEST(temperature_after({.emissivity = 1.0}, 200.0, t) == 290.0, tolerance(1e-8));
}

// The differences of F lose all digits there: 3.915085382390184 s for 2.7 K, by quadrature to 30 digits.
BOOST_AUTO_TEST_CASE(keeps_its_digits_among_surroundings_near_0_K) {
  BOOST_TEST(radiation_time(k, 1e4, 1000.0, 2.7) == 3.91508538239018431, tolerance(1e-14));
  BOOST_TEST(radiation_time(k, 200.0, 290.0, 300.0) == 307.967948145498, tolerance(1e-13));
  const double dark = radiation_time(k, 1e4, 1000.0, 0.0);
  for (const double theta_s : {1e-3, 1e-120, 5e-324}) {
    BOOST_TEST(radiation_time(k, 1e4, 1000.0, theta_s) == dark, tolerance(1e-14));
  }
}

BOOST_AUTO_TEST_CASE(refuses_what_is_not_reached) {
  CHECK_REFUSED(radiation_time(k, 1000.0, 300.0, 300.0), "must lie between");
  CHECK_REFUSED(radiation_time(k, 1000.0, NAN, 300.0), "got nan K");
  CHECK_REFUSED(radiation_time(0.0, 1000.0, 500.0, 300.0), "k must be positive, got 0 1/(s K^3)");
  CHECK_REFUSED(radiation_time(k, 1000.0, 1001.0, 300.0), "got 1001 K");
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(convected_temperature_)

BOOST_AUTO_TEST_CASE(is_that_of_a_sphere) {
  const double expected = convected_temperature(1000.0, 350.0, per_area / 50.0, 10.0);
  BOOST_TEST(temperature_after({.h_c = 50.0, .theta_o = 350.0}, 1000.0, 10.0) == expected, tolerance(1e-8));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(add_heat_)

// Two seconds at 1e5 K, radiating into nothing, and a sphere near 0 K among warm surroundings.
BOOST_AUTO_TEST_CASE(has_a_value_from_near_0_K_to_1e5_K) {
  const double hot = temperature_after({.emissivity = 1.0, .theta_s = 0.0}, 1e5, 2.0);
  BOOST_TEST(hot == std::cbrt(1.0 / (1e-15 + 6.0 * k)), tolerance(1e-7));
  const double cold = temperature_after({.emissivity = 1.0, .theta_s = 300.0}, 1e-6, 2.0);
  BOOST_TEST(cold == 1e-6 + 2.0 * k * 8.1e9, tolerance(1e-7));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(refuses_what_is_no_cooling) {
  CHECK_REFUSED(validate(Cooling{.h_c = -1.0}), "h_c must be finite and not negative, got -1");
  CHECK_REFUSED(validate(Cooling{.theta_o = -1.0}), "theta_o must be finite and not negative, got -1");
  CHECK_REFUSED(validate(Cooling{.emissivity = 1.1}), "emissivity must lie between 0 and 1, got 1.1");
  CHECK_REFUSED(validate(Cooling{.theta_s = NAN}), "theta_s must be finite and not negative, got nan");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::cooling_test
