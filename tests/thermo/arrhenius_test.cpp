#include <particulate/thermo/arrhenius.hpp>

#include <cmath>

#include <particulate/scenes/scene.hpp>

#include "close.hpp"
#include "says.hpp"

namespace tests::arrhenius_test {

using boost::test_tools::tolerance;
using namespace particulate;
using namespace particulate::thermo;

BOOST_AUTO_TEST_SUITE(runaway_time_)

// Known to 25 digits, by quadrature: from 300 K nothing seems to happen for most of an hour, then all in microseconds.
BOOST_AUTO_TEST_CASE(is_long_and_then_short) {
  const double warm = runaway_time(1e12, 1e4, 300.0, 1000.0), hot = runaway_time(1e12, 1e4, 300.0, 3000.0);
  BOOST_TEST(warm == 2874.42326588661, tolerance(1e-14));
  BOOST_TEST(hot == 2874.42326874214, tolerance(1e-14));
  BOOST_TEST(runaway_time(1e12, 1e4, 1000.0, 3000.0) == hot - warm, tolerance(1e-6));
  BOOST_TEST(runaway_time(1.0, 1e4, 300.0, 300.0) == 0.0);
}

BOOST_AUTO_TEST_CASE(refuses_what_does_not_run_away) {
  CHECK_REFUSED(runaway_time(1.0, 1e4, 10.0, 300.0), "T_a/700 < theta_0 <= theta");
  CHECK_REFUSED(runaway_time(1.0, 1e4, 400.0, 300.0), "theta = 300 K");
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(add_heat_)

// 2 kg of 3 J/(kg K), at 6 W/kg: a rate of 2 exp(-1e4/theta) K/s and a slope of 1e4/theta^2 times that.
BOOST_AUTO_TEST_CASE(has_a_rate_and_a_slope_at_any_temperature) {
  const auto one = kinematics::particles(
      {{.position = {0.0, 0.0, 0.0}, .mass = 2.0, .radius = 0.1, .temperature = 300.0, .heat_capacity = 3.0}});
  const scenes::Scene scene(one, kinematics::Space{}, Arrhenius{.power = 6.0, .T_a = 1e4});
  schemes::State at = scenes::start(scene);
  schemes::SparseJacobian J;
  for (const double theta : {0.0, 5e-324, 1e-306, 1e-300, 300.0, 1e5, 1e300}) {
    at.y[0] = theta;
    Eigen::VectorXd rate(1);
    BOOST_TEST(scene.temperature_rates(0.0, at.r, at.v, at.y, rate));
    scene.temperature_jacobian(0.0, at.r, at.v, at.y, J);
    const double reacts = theta > 1.0 ? 2.0 * std::exp(-1e4 / theta) : 0.0;
    BOOST_TEST(rate[0] == reacts, tolerance(1e-15));
    BOOST_TEST(J.coeff(0, 0) == (theta > 1.0 ? reacts * 1e4 / theta / theta : 0.0), tolerance(1e-14));
  }
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(refuses_what_is_no_reaction) {
  CHECK_REFUSED(validate(Arrhenius{.power = -1.0}), "power must be finite and not negative, got -1 W/kg");
  CHECK_REFUSED(validate(Arrhenius{.T_a = 0.0}), "T_a must be positive and finite, got 0 K");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::arrhenius_test
