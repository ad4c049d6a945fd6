#include <particulate/continuum/stress.hpp>

#include "close.hpp"

namespace tests::stress_test {

using boost::test_tools::tolerance;
using namespace particulate::continuum;

Tensor<double> simple_shear(double rate) {
  Tensor<double> L = Tensor<double>::Zero();
  L(0, 1) = rate;
  return L;
}

BOOST_AUTO_TEST_SUITE(traction_)

// On the plane across y stands the second column.
BOOST_AUTO_TEST_CASE(has_the_direction_of_the_plane_in_the_second_index) {
  Tensor<double> sigma;
  sigma << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0;
  BOOST_TEST(close(traction<double>(sigma, {0.0, 1.0, 0.0}), Vector<double>(2.0, 5.0, 8.0), {}));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(stress_)

// mu = 2, rate 3: 2 mu D has 6 across, and nothing expands.
BOOST_AUTO_TEST_CASE(of_a_simple_shear_is_mu_times_its_rate) {
  const Tensor<double> D = rate_of_deformation(simple_shear(3.0));
  Tensor<double> expected;
  expected << -7.0, 6.0, 0.0, 6.0, -7.0, 0.0, 0.0, 0.0, -7.0;
  BOOST_TEST(close(stress({.mu = 2.0, .lambda = 1.0}, 7.0, D), expected, {.relative = 1e-15}));
}

// D = I: 3 lambda + 2 mu = 3 + 4 on all planes.
BOOST_AUTO_TEST_CASE(of_an_expansion_has_both_viscosities) {
  const Tensor<double> D = Tensor<double>::Identity();
  BOOST_TEST(close(viscous_stress({.mu = 2.0, .lambda = 1.0}, D), 7.0 * D, {.relative = 1e-15}));
  BOOST_TEST(close(viscous_stress({.mu = 2.0, .lambda = -4.0 / 3.0}, D), 0.0 * D, {.absolute = 1e-15}));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(stress_power_)

BOOST_AUTO_TEST_CASE(is_entry_by_entry) {
  Tensor<double> sigma;
  sigma << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0;
  BOOST_TEST(stress_power(sigma, simple_shear(-3.0)) == -6.0);
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(dissipation_)

// mu rate^2 = 2 * 9 in shear; (lambda + 2/3 mu) 3^2 = 7/3 * 9 in expansion; nothing in a turn.
BOOST_AUTO_TEST_CASE(is_known_in_simple_flows) {
  const Newtonian law{.mu = 2.0, .lambda = 1.0};
  const Tensor<double> L = simple_shear(3.0), expansion = Tensor<double>::Identity();
  BOOST_TEST(dissipation(law, rate_of_deformation(L)) == 18.0, tolerance(1e-15));
  BOOST_TEST(dissipation(law, expansion) == 21.0, tolerance(1e-15));
  BOOST_TEST(dissipation<double>(law, rate_of_deformation<double>(spin(L))) == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(refuses_viscosities_that_would_give_energy) {
  CHECK_REFUSED(validate(Newtonian{.mu = -1.0}), "mu must be finite and not negative, got -1 Pa s");
  CHECK_REFUSED(validate(Newtonian{.mu = not_a_number}), "got nan");
  CHECK_REFUSED(validate(Newtonian{.mu = 3.0, .lambda = -2.001}), "lambda must be finite and at least -2 mu/3 = -2");
  CHECK_REFUSED(validate(Newtonian{.lambda = infinity}), "got inf");
}

BOOST_AUTO_TEST_CASE(takes_lambda_at_its_end_however_it_is_rounded) {
  for (double mu = 1e-6; mu < 1e6; mu *= 1.37) {
    BOOST_CHECK_NO_THROW(validate(Newtonian{.mu = mu, .lambda = -2.0 * mu / 3.0}));
    BOOST_CHECK_NO_THROW(validate(Newtonian{.mu = mu, .lambda = -(2.0 / 3.0) * mu}));
  }
  BOOST_CHECK_NO_THROW(validate(Newtonian{.mu = 0.0, .lambda = 0.0}));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::stress_test
