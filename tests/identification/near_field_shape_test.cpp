#include <particulate/identification/near_field_shape.hpp>

#include "close.hpp"

namespace tests::near_field_shape_test {

using namespace particulate::identification;
using particulate::kinematics::CentralForce;

BOOST_AUTO_TEST_SUITE(shape_of_)

// d_e = (0.25/0.5)^(1/1) = 0.5, V'' = 0.5 0.5^-2 (2 - 1) = 2.
BOOST_AUTO_TEST_CASE(is_where_a_force_balances_and_how_stiff_it_is_there) {
  const NearFieldShape shape = shape_of({.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.0, .beta2 = 2.0});
  BOOST_TEST(shape.d_e == 0.5);
  BOOST_TEST(shape.stiffness == 2.0);
  BOOST_TEST(shape.beta1 == 1.0);
  BOOST_TEST(shape.beta2 == 2.0);
}

BOOST_AUTO_TEST_CASE(refuses_what_has_no_stable_equilibrium) {
  CHECK_REFUSED(shape_of({.alpha1 = 0.0, .alpha2 = 0.25}), "an equilibrium needs alpha1 > 0");
  CHECK_REFUSED(shape_of({.alpha1 = 1.0, .alpha2 = 1.0, .beta1 = 2.0, .beta2 = 1.0}),
                "beta2 above beta1 for a stable equilibrium, got beta1 = 2, beta2 = 1");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(force_of_)

// alpha1 = 3 2^3/(4 - 2) = 12, alpha2 = 12 2^2 = 48.
BOOST_AUTO_TEST_CASE(has_the_strengths_that_the_shape_asks_for) {
  const CentralForce law = force_of({.d_e = 2.0, .stiffness = 3.0, .beta1 = 2.0, .beta2 = 4.0});
  BOOST_TEST(law.alpha1 == 12.0);
  BOOST_TEST(law.alpha2 == 48.0);
}

BOOST_AUTO_TEST_CASE(leads_back_to_its_shape) {
  const NearFieldShape given{.d_e = 0.37, .stiffness = 5.1, .beta1 = 0.8, .beta2 = 3.3};
  const NearFieldShape back = shape_of(force_of(given));
  BOOST_TEST(back.d_e == given.d_e, tolerance(1e-14));
  BOOST_TEST(back.stiffness == given.stiffness, tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(refuses_what_is_no_shape) {
  CHECK_REFUSED(force_of({.d_e = 0.0}), "d_e must be positive and finite, got 0");
  CHECK_REFUSED(force_of({.d_e = infinity}), "d_e must be positive and finite, got inf");
  CHECK_REFUSED(force_of({.stiffness = -1.0}), "the stiffness V''(d_e) must be positive and finite, got -1");
  CHECK_REFUSED(force_of({.beta1 = 2.0, .beta2 = 2.0}), "beta2 above beta1");
  CHECK_REFUSED(force_of({.beta1 = -1.0}), "not negative");
  CHECK_REFUSED(force_of({.beta1 = not_a_number}), "got beta1 = nan");
  CHECK_REFUSED(force_of({.beta2 = infinity}), "beta2 = inf");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(derivative_of_log_shape_)

Eigen::Vector4d log_shape(const Eigen::Vector4d& p) {
  const NearFieldShape shape =
      shape_of({.alpha1 = std::exp(p[0]), .alpha2 = std::exp(p[1]), .beta1 = p[2], .beta2 = p[3]});
  return {std::log(shape.d_e), std::log(shape.stiffness), shape.beta1, shape.beta2};
}

BOOST_AUTO_TEST_CASE(is_that_of_differences) {
  const Eigen::Vector4d p{std::log(0.5), std::log(0.3), 1.2, 2.7};
  Eigen::Matrix4d differences;
  constexpr double h = 1e-5;
  for (int j = 0; j < 4; ++j) {
    const Eigen::Vector4d moved = h * Eigen::Vector4d::Unit(j);
    differences.col(j) = (log_shape(p + moved) - log_shape(p - moved)) / (2.0 * h);
  }
  const Eigen::Matrix4d derivative =
      derivative_of_log_shape({.alpha1 = 0.5, .alpha2 = 0.3, .beta1 = 1.2, .beta2 = 2.7});
  BOOST_TEST(close(derivative, differences, {.absolute = 1e-9}));
}

// Of (1, 1, 1, 2): d_e = 1, so that d ln d_e = d ln alpha2 - d ln alpha1, and
// d ln V'' = d ln alpha1 - 2 d ln d_e + d beta2 - d beta1.
BOOST_AUTO_TEST_CASE(is_simple_where_the_equilibrium_is_at_1_m) {
  Eigen::Matrix4d expected;
  expected << -1.0, 1.0, 0.0, 0.0,  //
      3.0, -2.0, -1.0, 1.0,         //
      0.0, 0.0, 1.0, 0.0,           //
      0.0, 0.0, 0.0, 1.0;
  const Eigen::Matrix4d derivative = derivative_of_log_shape({.alpha1 = 1.0, .alpha2 = 1.0});
  BOOST_TEST(close(derivative, expected, {}));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::near_field_shape_test
