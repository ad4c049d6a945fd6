#include <particulate/continuum/balance.hpp>

#include "close.hpp"

namespace tests::balance_test {

using boost::test_tools::tolerance;
using namespace particulate::continuum;

const Vector<double> v(1.0, 2.0, 3.0);

BOOST_AUTO_TEST_SUITE(material_rate_)

// 7 + (1, 2, 3).(4, 5, 6) = 39.
BOOST_AUTO_TEST_CASE(adds_what_the_motion_carries_along) {
  BOOST_TEST(material_rate<double>(7.0, v, {4.0, 5.0, 6.0}) == 39.0);
  Tensor<double> L;
  L << 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0;
  BOOST_TEST(close(material_rate<double>({1.0, 0.0, 0.0}, v, L), Vector<double>(3.0, 3.0, 1.0), {}));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(mass_)

// Twice the volume, half the density; growing at 3/s of itself, thinning at 3/s of itself.
BOOST_AUTO_TEST_CASE(stays) {
  const Tensor<double> F = Vector<double>(4.0, 1.0, 0.5).asDiagonal(), L = Tensor<double>::Identity();
  BOOST_TEST(mass_since_start(500.0, F, 1000.0) == 0.0);
  BOOST_TEST(mass_since_start(600.0, F, 1000.0) == 200.0);
  BOOST_TEST(mass_residual(500.0, -1500.0, L) == 0.0);
  BOOST_TEST(mass_residual(500.0, 0.0, L) == 1500.0);
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(momentum_residual_)

// A fluid at rest under gravity: div sigma = -grad P is (0, 0, 9810), f = (0, 0, -9810) N/m^3.
BOOST_AUTO_TEST_CASE(is_zero_at_rest_under_gravity) {
  const Vector<double> rest = Vector<double>::Zero(), lift(0.0, 0.0, 9810.0);
  BOOST_TEST(close(momentum_residual<double>(1000.0, rest, lift, -lift), rest, {}));
  BOOST_TEST(close(momentum_residual<double>(1000.0, v, lift, lift), Vector<double>(1e3, 2e3, -16620.0), {}));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(angular_momentum_residual_)

// sigma_yx alone turns about z: force along y, at the end of x.
BOOST_AUTO_TEST_CASE(is_the_torque_of_what_is_not_symmetric) {
  Tensor<double> sigma = Tensor<double>::Zero();
  sigma(1, 0) = 5.0;
  BOOST_TEST(close(angular_momentum_residual(sigma), Vector<double>(0.0, 0.0, 5.0), {}));
  sigma(0, 1) = 5.0;
  BOOST_TEST(close(angular_momentum_residual(sigma), Vector<double>(0.0, 0.0, 0.0), {}));
  sigma << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0;
  BOOST_TEST(close(angular_momentum_residual(sigma), Vector<double>(2.0, -4.0, 2.0), {}));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(energy_residual_)

BOOST_AUTO_TEST_CASE(has_each_term_with_its_sign) {
  BOOST_TEST(energy_residual(2.0, 10.0, 12.0, -5.0, 3.0) == 0.0);
  BOOST_TEST(energy_residual(2.0, 10.0, 1.0, 2.0, 4.0) == 17.0);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::balance_test
