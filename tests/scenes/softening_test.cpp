#include <cmath>

#include <particulate/contact/restitution.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/verlet.hpp>

#include "close.hpp"
#include "says.hpp"

namespace tests::softening_test {

using boost::test_tools::tolerance;
using namespace particulate;
using contact::SofteningRestitution;

BOOST_AUTO_TEST_SUITE(softening_)

BOOST_AUTO_TEST_CASE(falls_from_1_at_the_reference_to_0) {
  const SofteningRestitution law;
  BOOST_TEST(softening(law, 450.0) == 0.5, tolerance(1e-15));
  for (const double cold : {0.0, 299.0, 300.0}) BOOST_TEST(softening(law, cold) == 1.0);
  for (const double hot : {600.0, 1e5}) BOOST_TEST(softening(law, hot) == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(restitution_at_softened)

// 0.8 (1 - 2/8) 0.5 = 0.3; where that falls below the floor, the floor.
BOOST_AUTO_TEST_CASE(is_the_product_of_both_down_to_the_floor) {
  const SofteningRestitution law{.cold = {.e_o = 0.8, .v_star = 8.0, .e_minus = 0.1}};
  BOOST_TEST(restitution_at(law, 2.0, 0.5) == 0.3, tolerance(1e-15));
  BOOST_TEST(restitution_at(law, 2.0, 0.0) == 0.1);
  BOOST_TEST(restitution_at(law, 80.0, 1.0) == 0.1);
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(Contact_)

// Equal bodies of 400 and 500 K, of whose 2 m/s restitution leaves 0.8 (1 - 150/300).
BOOST_AUTO_TEST_CASE(softens_with_the_mean_temperature_of_a_pair) {
  const auto pair = kinematics::particles({{.position = {0.0, 0.0, 0.0},
                                            .velocity = {1.0, 0.0, 0.0},
                                            .mass = 1.0,
                                            .radius = 0.5,
                                            .temperature = 400.0,
                                            .heat_capacity = 1.0},
                                           {.position = {1.0, 0.0, 0.0},
                                            .velocity = {-1.0, 0.0, 0.0},
                                            .mass = 1.0,
                                            .radius = 0.5,
                                            .temperature = 500.0,
                                            .heat_capacity = 1.0}});
  for (const auto resolution : {contact::Resolution::sequential, contact::Resolution::summed}) {
    const scenes::Scene scene(
        pair, kinematics::Space{},
        contact::Contact<SofteningRestitution>{.restitution = {.cold = {.e_o = 0.8}}, .resolution = resolution});
    static_assert(decltype(scene)::values_by_jumps);
    schemes::State state = scenes::start(scene);
    (void)integrate(scene, state, 1e-9, schemes::VelocityVerlet{}, schemes::FixedStep{.step = 1e-9});
    BOOST_TEST(state.v[1] - state.v[0] == 0.8, tolerance(1e-14));
    BOOST_TEST((state.y == pair.temperature));
  }
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(validate_softening)

BOOST_AUTO_TEST_CASE(refuses_to_be_soft_at_the_reference) {
  CHECK_REFUSED(validate(SofteningRestitution{.theta_star = 300.0}), "must be finite and above theta_r = 300 K");
  CHECK_REFUSED(validate(SofteningRestitution{.theta_r = -1.0}), "theta_r must be finite and not negative, got -1 K");
  CHECK_REFUSED(validate(SofteningRestitution{.cold = {.e_o = 2.0}}), "e_o must lie in [0, 1]");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::softening_test
