#include <particulate/continuum/equation_of_state.hpp>

#include <cmath>

#include "numbers.hpp"
#include "says.hpp"

namespace tests::equation_of_state_test {

using boost::test_tools::tolerance;
using namespace particulate::continuum;

const LinearizedState liquid{.P_R = 1e5, .Y = 2e9, .rho_R = 1000.0, .theta_R = 300.0, .a_th = 1e-4};

BOOST_AUTO_TEST_SUITE(pressure_)

// One part in a thousand denser: 2e6; ten kelvins warmer: 2e9 * 1e-3 = 2e6 as well.
BOOST_AUTO_TEST_CASE(of_a_liquid_grows_with_density_and_temperature) {
  BOOST_TEST(pressure(liquid, 1000.0, 300.0) == 1e5, tolerance(1e-15));
  BOOST_TEST(pressure(liquid, 1001.0, 300.0) == 2.1e6, tolerance(1e-12));
  BOOST_TEST(pressure(liquid, 1000.0, 310.0) == 2.1e6, tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(of_a_gas_is_rho_R_theta) { BOOST_TEST(pressure(IdealGas{287.0}, 2.0, 300.0) == 172200.0); }

BOOST_AUTO_TEST_CASE(of_a_barotropic_fluid_is_that_of_a_liquid_that_does_not_expand) {
  const Barotropic fluid{.P_R = 1e5, .Y = 1e5, .rho_R = 1000.0};
  const LinearizedState same{.P_R = 1e5, .Y = 1e5, .a_th = 0.0};
  BOOST_TEST(pressure(fluid, 1100.0) == 1.1e5, tolerance(1e-15));
  BOOST_TEST(pressure(fluid, 1234.5) == pressure(same, 1234.5, 777.0), tolerance(1e-15));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(speed_of_sound_)

// At half the density P = P_R - 1e9 = 1e7: Y/rho_R = 2e6, Y a_th P/(rho^2 c) = 2e9 * 1e-4 * 1e7/(500^2 * 4000) = 2000.
BOOST_AUTO_TEST_CASE(of_a_liquid_has_a_share_of_its_expansion) {
  LinearizedState pressed = liquid;
  pressed.P_R = 1.01e9;
  BOOST_TEST(speed_of_sound(pressed, 500.0, 300.0, 4000.0) == std::sqrt(2002000.0), tolerance(1e-15));
  BOOST_TEST(speed_of_sound(Barotropic{.Y = 1e5}, 1000.0) == 10.0);
}

// gamma = 1 + 287/717.5 = 1.4.
BOOST_AUTO_TEST_CASE(of_a_gas_is_that_of_laplace) {
  BOOST_TEST(speed_of_sound(IdealGas{287.0}, 1.0, 300.0, 717.5) == std::sqrt(1.4 * 287.0 * 300.0), tolerance(1e-15));
  BOOST_TEST(speed_of_sound(IdealGas{287.0}, 1.0, 0.0, 717.5) == 0.0);
}

// 2e6 + 2e5 P/4e9 is negative below P = -4e10 Pa.
BOOST_AUTO_TEST_CASE(is_none_under_a_tension_beyond_all_bounds) {
  LinearizedState torn = liquid;
  torn.P_R = -4.1e10;
  BOOST_TEST(std::isnan(speed_of_sound(torn, 1000.0, 300.0, 4000.0)));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(refuses_what_is_no_equation_of_state) {
  CHECK_REFUSED(validate(LinearizedState{.P_R = not_a_number}), "linearized equation of state: P_R must be finite");
  CHECK_REFUSED(validate(LinearizedState{.Y = 0.0}), "Y must be positive and finite, got 0");
  CHECK_REFUSED(validate(LinearizedState{.rho_R = -1.0}), "rho_R must be positive and finite, got -1");
  CHECK_REFUSED(validate(LinearizedState{.theta_R = 0.0}), "theta_R must be positive");
  CHECK_REFUSED(validate(LinearizedState{.a_th = infinity}), "a_th must be finite, got inf");
  CHECK_REFUSED(validate(IdealGas{.R = 0.0}), "ideal gas: R must be positive and finite, got 0");
  CHECK_REFUSED(validate(Barotropic{.P_R = infinity}), "barotropic fluid: P_R must be finite");
  CHECK_REFUSED(validate(Barotropic{.Y = -1.0}), "Y must be positive and finite, got -1");
  CHECK_REFUSED(validate(Barotropic{.rho_R = not_a_number}), "rho_R must be positive and finite, got nan");
}

BOOST_AUTO_TEST_CASE(takes_the_defaults_and_water_that_shrinks_below_4_C) {
  BOOST_CHECK_NO_THROW(validate(LinearizedState{.a_th = -1e-5}));
  BOOST_CHECK_NO_THROW(validate(IdealGas{}));
  BOOST_CHECK_NO_THROW(validate(Barotropic{}));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::equation_of_state_test
