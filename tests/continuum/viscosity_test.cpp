#include <particulate/continuum/viscosity.hpp>

#include <cmath>

#include "numbers.hpp"
#include "says.hpp"

namespace tests::viscosity_test {

using boost::test_tools::tolerance;
using namespace particulate::continuum;

BOOST_AUTO_TEST_SUITE(viscosity_)

BOOST_AUTO_TEST_CASE(may_be_the_same_at_all_temperatures) {
  BOOST_TEST(viscosity(ConstantViscosity{2.0}) == 2.0);
  BOOST_TEST(viscosity(ConstantViscosity{2.0}, 1e-300) == 2.0);
}

// At twice theta_R the exponent is -c_mu/2.
BOOST_AUTO_TEST_CASE(falls_as_a_liquid_warms) {
  const ExponentialViscosity oil{.mu_R = 3.0, .c_mu = 2.0, .theta_R = 300.0};
  BOOST_TEST(viscosity(oil, 300.0) == 3.0);
  BOOST_TEST(viscosity(oil, 600.0) == 3.0 * 0.367879441171442322, tolerance(1e-15));
  BOOST_TEST(std::isinf(viscosity(oil, 0.5)));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(refuses_what_is_no_viscosity) {
  CHECK_REFUSED(validate(ConstantViscosity{-1.0}), "viscosity: mu must be finite and not negative, got -1");
  CHECK_REFUSED(validate(ExponentialViscosity{.mu_R = not_a_number}), "mu_R must be finite and not negative, got nan");
  CHECK_REFUSED(validate(ExponentialViscosity{.c_mu = infinity}), "c_mu must be finite, got inf");
  CHECK_REFUSED(validate(ExponentialViscosity{.theta_R = 0.0}), "theta_R must be positive and finite, got 0");
  BOOST_CHECK_NO_THROW(validate(ExponentialViscosity{.c_mu = -0.7}));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::viscosity_test
