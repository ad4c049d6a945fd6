#include <particulate/kinematics/central_force.hpp>

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "close.hpp"

namespace tests::central_force_test {

using namespace particulate::kinematics;

// The monograph's exponents: equilibrium at 0.25/0.5 = 0.5, all powers there exact.
const CentralForce exact{.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.0, .beta2 = 2.0};
const CentralForce generic{.alpha1 = 0.7, .alpha2 = 0.3, .beta1 = 1.3, .beta2 = 4.0};

// Fourth-order central difference; its error h^4 f^(5)/30 is below 1e-9 for what stands here.
template <class F>
double slope(const F& f, double x) {
  const double h = 1e-3;
  return (8.0 * (f(x + h) - f(x - h)) - (f(x + 2.0 * h) - f(x - 2.0 * h))) / (12.0 * h);
}

BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(accepts_the_defaults_and_zeros) {
  BOOST_CHECK_NO_THROW(validate(CentralForce{}));
  BOOST_CHECK_NO_THROW(validate(CentralForce{.beta1 = 0.0, .beta2 = 0.0}));
}

BOOST_AUTO_TEST_CASE(names_the_constant_what_must_hold_and_what_was_given) {
  CHECK_REFUSED(validate(CentralForce{.alpha1 = -1.0}), "alpha1 must be finite and not negative, got -1");
  CHECK_REFUSED(validate(CentralForce{.alpha2 = not_a_number}), "alpha2 must be finite and not negative, got nan");
  CHECK_REFUSED(validate(CentralForce{.beta1 = infinity}), "beta1 must be finite and not negative, got inf");
  CHECK_REFUSED(validate(CentralForce{.beta2 = -0.5}), "beta2 must be finite and not negative, got -0.5");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(power_)

// n - 1 products and the reciprocal's share of n halves of eps each stay below n eps; std::pow adds one.
BOOST_AUTO_TEST_CASE(agrees_with_the_library_for_whole_exponents) {
  for (const double x : {0.3, 0.97, 1.7, 3.1}) {
    for (int n = -64; n <= 64; ++n) {
      BOOST_TEST_CONTEXT("x = " << x << ", n = " << n) {
        BOOST_TEST(power(x, n) == std::pow(x, n), tolerance((std::abs(n) + 1) * eps));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(is_the_librarys_for_other_exponents) {
  for (const double exponent : {0.5, -1.3, 63.5, 65.0, -65.0, 1e3}) {
    BOOST_TEST(power(1.1, exponent) == std::pow(1.1, exponent));
  }
}

BOOST_AUTO_TEST_CASE(of_a_power_of_two_is_exact) {
  for (const int k : {-5, -1, 0, 3}) {
    for (const int n : {-64, -13, -2, -1, 0, 1, 3, 13, 64, 65}) {
      BOOST_TEST(power(std::ldexp(1.0, k), n) == std::ldexp(1.0, k * n));
    }
  }
}

BOOST_AUTO_TEST_CASE(keeps_its_bits_when_the_base_is_scaled_by_a_power_of_two) {
  int kept = 0;
  for (int k = 0; k < 1000; ++k) {
    const double x = 1.0 + k / 1009.0;
    kept += power(8.0 * x, 13.0) == 0x1p39 * power(x, 13.0) && power(0.25 * x, -3.0) == 64.0 * power(x, -3.0);
  }
  BOOST_TEST(kept == 1000);
}

BOOST_AUTO_TEST_CASE(is_formed_by_multiplication_where_the_exponent_is_small_and_whole) {
  for (int k = 0; k < 100; ++k) {
    const double x = 1.0 + k / 101.0, square = x * x, fourth = square * square;
    BOOST_TEST(power(x, 5.0) == x * fourth);
    BOOST_TEST(power(x, 64.0) == power(power(fourth, 4.0), 4.0));
  }
}

// 3^13 = 1594323.
BOOST_AUTO_TEST_CASE(of_a_small_whole_number_is_exact) {
  BOOST_TEST(power(3.0, 13.0) == 1594323.0);
  BOOST_TEST(power(7.3, 1.0) == 7.3);
  BOOST_TEST(power(7.3, 0.0) == 1.0);
}

BOOST_AUTO_TEST_CASE(has_the_limits_at_zero_and_at_the_largest_numbers) {
  BOOST_TEST(power(0.0, 2.0) == 0.0);
  BOOST_TEST(power(0.0, 0.0) == 1.0);
  BOOST_TEST(power(0.0, -2.0) == infinity);
  BOOST_TEST(power(1e200, 1.0) == 1e200);
  BOOST_TEST(power(1e200, 2.0) == infinity);
  BOOST_TEST(power(1e200, -2.0) == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(strength_)

// 0.5/d - 0.25/d^2 at 1 and at 1/4.
BOOST_AUTO_TEST_CASE(is_attraction_minus_repulsion) {
  BOOST_TEST(strength(exact, 1.0) == 0.25);
  BOOST_TEST(strength(exact, 0.25) == -2.0);
}

BOOST_AUTO_TEST_CASE(vanishes_at_equilibrium) { BOOST_TEST(strength(exact, 0.5) == 0.0); }

BOOST_AUTO_TEST_CASE(does_not_depend_on_distance_for_exponents_of_zero) {
  const CentralForce constant{.alpha1 = 3.0, .alpha2 = 1.0, .beta1 = 0.0, .beta2 = 0.0};
  BOOST_TEST(strength(constant, 1e-300) == 2.0);
  BOOST_TEST(strength(constant, 1e300) == 2.0);
}

// 1e-30^-13 overflows, but nothing repels here: C = d^-1.
BOOST_AUTO_TEST_CASE(leaves_out_what_has_no_strength_even_where_its_power_overflows) {
  const CentralForce pull{.alpha1 = 1.0, .alpha2 = 0.0, .beta1 = 1.0, .beta2 = 13.0};
  BOOST_TEST(strength(pull, 1e-30) == 1e30, tolerance(1e-15));
  BOOST_TEST(normal_stiffness(pull, 1e-30) == -1e60, tolerance(1e-15));
  BOOST_TEST(std::isfinite(potential(pull, 1e-30)));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(force_)

// d = 5: C = 0.5/5 - 0.25/25 = 0.09, and n = (3, 0, 4)/5.
BOOST_AUTO_TEST_CASE(points_to_the_centre_where_it_attracts) {
  const Eigen::Vector3d r(1.0, 1.0, 1.0), r_o(4.0, 1.0, 5.0);
  BOOST_TEST(close(force(exact, r, r_o), Eigen::Vector3d(0.054, 0.0, 0.072), {.relative = 4.0 * eps}));
}

BOOST_AUTO_TEST_CASE(points_away_where_it_repels) {
  BOOST_TEST(close(force(exact, Eigen::Vector3d(0.25, 0.0, 0.0), Eigen::Vector3d::Zero()),
                   Eigen::Vector3d(2.0, 0.0, 0.0), {}));
}

BOOST_AUTO_TEST_CASE(keeps_its_direction_at_the_largest_and_smallest_distances) {
  const CentralForce constant{.alpha1 = 5.0, .beta1 = 0.0, .beta2 = 0.0};
  for (const double d : {1e-300, 1e300}) {
    BOOST_TEST(close(force(constant, Eigen::Vector3d::Zero(), Eigen::Vector3d(3.0 * d, 4.0 * d, 0.0)),
                     Eigen::Vector3d(3.0, 4.0, 0.0), {.relative = 4.0 * eps}));
  }
}

BOOST_AUTO_TEST_CASE(is_minus_the_gradient_of_the_potential) {
  const Eigen::Vector3d r(0.4, -0.9, 0.7), r_o(-0.2, 0.1, 0.3);
  Eigen::Vector3d downhill;
  for (int c = 0; c < 3; ++c) {
    const auto along = [&](double x) {
      Eigen::Vector3d there = r;
      there[c] = x;
      return potential(generic, (there - r_o).norm());
    };
    downhill[c] = -slope(along, r[c]);
  }
  BOOST_TEST(close(force(generic, r, r_o), downhill, {.relative = 1e-9}));
}

BOOST_AUTO_TEST_CASE(has_no_curl) {
  const Eigen::Vector3d r(0.4, -0.9, 0.7), r_o = Eigen::Vector3d::Zero();
  Eigen::Matrix3d gradient;  // gradient(i, j) = dPsi_i/dx_j
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      const auto along = [&](double x) {
        Eigen::Vector3d there = r;
        there[j] = x;
        return force(generic, there, r_o)[i];
      };
      gradient(i, j) = slope(along, r[j]);
    }
  }
  BOOST_TEST(std::abs(gradient(0, 1)) > 0.1);
  BOOST_TEST(close(gradient, gradient.transpose(), {.absolute = 1e-10}));
}

BOOST_AUTO_TEST_CASE(refuses_the_centre_itself) {
  const Eigen::Vector3d here(1.0, 2.0, -0.5);
  CHECK_REFUSED(force(exact, here, here), "r must lie apart from the centre, both are (1, 2, -0.5) m");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(potential_)

// beta = (2, 3), unit strengths: (1 - 1/d) + (1/d^2 - 1)/2 at d = 1/2 is -1 + 3/2.
BOOST_AUTO_TEST_CASE(is_the_integral_of_the_strength) {
  const CentralForce law{.alpha1 = 1.0, .alpha2 = 1.0, .beta1 = 2.0, .beta2 = 3.0};
  BOOST_TEST(potential(law, 0.5) == 0.5, tolerance(8.0 * eps));
  BOOST_TEST(potential({.alpha1 = 1.0, .beta1 = 2.0}, 0.5) == -1.0, tolerance(4.0 * eps));
}

BOOST_AUTO_TEST_CASE(has_the_strength_as_its_slope) {
  for (const double d : {0.6, 1.0, 2.3}) {
    BOOST_TEST(slope([](double x) { return potential(generic, x, 0.9); }, d) == strength(generic, d), tolerance(1e-8));
  }
}

BOOST_AUTO_TEST_CASE(vanishes_at_the_reference_distance) {
  for (const double d : {1e-3, 0.7, 1e3}) BOOST_TEST(potential(generic, d, d) == 0.0);
}

BOOST_AUTO_TEST_CASE(with_another_reference_differs_by_a_constant) {
  const double shift = potential(generic, 2.0, 0.5);
  BOOST_TEST(potential(generic, 0.8, 0.5) == potential(generic, 0.8, 2.0) + shift, tolerance(1e-14));
}

// ln(0.5/0.75) = -0.405465108108164; the derivative by beta is -(ln^2 0.5 - ln^2 0.75)/2 = -0.2, and 0.2e-12 is lost in
// the tolerance. The printed form loses twelve digits here.
BOOST_AUTO_TEST_CASE(joins_the_logarithm_smoothly_at_an_exponent_of_one) {
  for (const double beta : {1.0 - 1e-12, 1.0, 1.0 + 1e-12}) {
    BOOST_TEST(potential({.alpha1 = 1.0, .beta1 = beta}, 0.5, 0.75) == -0.405465108108164, tolerance(1e-12));
    BOOST_TEST(potential({.alpha2 = 2.0, .beta2 = beta}, 0.5, 0.75) == 2.0 * 0.405465108108164, tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(normal_stiffness_)

// -0.5/d^2 + 0.25 2/d^3 at 1/2.
BOOST_AUTO_TEST_CASE(is_the_slope_of_the_strength) {
  BOOST_TEST(normal_stiffness(exact, 0.5) == 2.0);
  for (const double d : {0.6, 1.0, 2.3}) {
    BOOST_TEST(slope([](double x) { return strength(generic, x); }, d) == normal_stiffness(generic, d),
               tolerance(1e-8));
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(transverse_stiffness_)

BOOST_AUTO_TEST_CASE(is_the_strength_over_the_distance) {
  BOOST_TEST(transverse_stiffness(exact, 2.0) == (0.25 - 0.0625) / 2.0);
}

BOOST_AUTO_TEST_CASE(is_neutral_at_equilibrium_only) {
  BOOST_TEST(transverse_stiffness(exact, 0.5) == 0.0);
  BOOST_TEST(transverse_stiffness(exact, 0.5 - 1e-6) < 0.0);
  BOOST_TEST(transverse_stiffness(exact, 0.5 + 1e-6) > 0.0);
}

// Across x the distance is sqrt(d^2 + y^2).
BOOST_AUTO_TEST_CASE(is_the_second_derivative_across_the_line_of_centres) {
  const double d = 0.8;
  const auto across = [&](double y) { return potential(generic, std::hypot(d, y)); };
  const auto tilt = [&](double y) { return slope(across, y); };
  BOOST_TEST(slope(tilt, 0.0) == transverse_stiffness(generic, d), tolerance(1e-6));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(equilibrium_distance_)

// (0.25/0.5)^(1/1), and (27/1)^(1/(5 - 2)).
BOOST_AUTO_TEST_CASE(balances_attraction_and_repulsion) {
  BOOST_TEST(equilibrium_distance(exact) == 0.5);
  const CentralForce cubic{.alpha1 = 1.0, .alpha2 = 27.0, .beta1 = 2.0, .beta2 = 5.0};
  BOOST_TEST(equilibrium_distance(cubic) == 3.0, tolerance(2.0 * eps));
  BOOST_TEST(std::abs(strength(generic, equilibrium_distance(generic))) < 1e-14);
}

BOOST_AUTO_TEST_CASE(refuses_a_law_that_balances_nowhere_or_everywhere) {
  CHECK_REFUSED(equilibrium_distance({.alpha1 = 1.0}),
                "needs alpha1 > 0, alpha2 > 0 and beta1 != beta2, got alpha1 = 1, alpha2 = 0");
  CHECK_REFUSED(equilibrium_distance({.alpha2 = 1.0}), "got alpha1 = 0");
  const CentralForce parallel{.alpha1 = 1.0, .alpha2 = 1.0, .beta1 = 2.0, .beta2 = 2.0};
  CHECK_REFUSED(equilibrium_distance(parallel), "beta1 = 2, beta2 = 2");
  CHECK_REFUSED(equilibrium_distance({.alpha1 = not_a_number}), "got nan");
}

// 1e10^(1/0.001) = 1e10000 and its inverse.
BOOST_AUTO_TEST_CASE(refuses_a_distance_that_no_double_holds) {
  const CentralForce far{.alpha1 = 1.0, .alpha2 = 1e10, .beta1 = 1.0, .beta2 = 1.001};
  const CentralForce near{.alpha1 = 1e10, .alpha2 = 1.0, .beta1 = 1.0, .beta2 = 1.001};
  CHECK_REFUSED(equilibrium_distance(far), "must be representable, got inf m");
  CHECK_REFUSED(equilibrium_distance(near), "must be representable, got 0 m");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(is_stable_)

BOOST_AUTO_TEST_CASE(says_whether_repulsion_is_the_steeper) {
  const CentralForce turned{.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 2.0, .beta2 = 1.0};
  BOOST_TEST(is_stable(exact));
  BOOST_TEST(!is_stable(turned));
  BOOST_TEST(normal_stiffness(exact, equilibrium_distance(exact)) > 0.0);
  BOOST_TEST(normal_stiffness(turned, equilibrium_distance(turned)) < 0.0);
}

BOOST_AUTO_TEST_CASE(refuses_a_law_without_equilibrium) {
  CHECK_REFUSED(is_stable({.alpha1 = 1.0}), "an equilibrium needs");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(small_oscillation_period_)

// m* = 1/2, V'' = 0.5 0.5^-2 (2 - 1) = 2: 2 pi sqrt(1/4).
BOOST_AUTO_TEST_CASE(of_the_monographs_pair_is_pi) {
  BOOST_TEST(small_oscillation_period(exact, 1.0, 1.0) == std::numbers::pi);
}

BOOST_AUTO_TEST_CASE(grows_with_the_root_of_the_mass_and_is_symmetric) {
  BOOST_TEST(small_oscillation_period(exact, 4.0, 4.0) == 2.0 * std::numbers::pi);
  BOOST_TEST(small_oscillation_period(exact, 3.0, 5.0) == small_oscillation_period(exact, 5.0, 3.0));
}

BOOST_AUTO_TEST_CASE(follows_the_normal_stiffness) {
  const double stiffness = normal_stiffness(generic, equilibrium_distance(generic));
  BOOST_TEST(small_oscillation_period(generic, 1.0, 1.0) == 2.0 * std::numbers::pi * std::sqrt(0.5 / stiffness),
             tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(refuses_what_does_not_oscillate) {
  const CentralForce turned{.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 2.0, .beta2 = 1.0};
  CHECK_REFUSED(small_oscillation_period(turned, 1.0, 1.0),
                "need a stable equilibrium, beta2 > beta1, got beta1 = 2, beta2 = 1");
  for (const double m : {0.0, -1.0, infinity, not_a_number}) {
    CHECK_REFUSED(small_oscillation_period(exact, m, 1.0), "masses must be positive and finite, got");
    CHECK_REFUSED(small_oscillation_period(exact, 1.0, m), "masses must be positive and finite, got");
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(reduced_mass_)

// 2 3/(2 + 3).
BOOST_AUTO_TEST_CASE(is_the_product_over_the_sum) { BOOST_TEST(reduced_mass(2.0, 3.0) == 1.2, tolerance(2.0 * eps)); }

BOOST_AUTO_TEST_CASE(is_the_lighter_mass_beside_a_much_heavier_one) {
  BOOST_TEST(reduced_mass(1e300, 7.0) == 7.0, tolerance(2.0 * eps));
}

BOOST_AUTO_TEST_CASE(does_not_overflow) { BOOST_TEST(reduced_mass(1e300, 1e300) == 5e299, tolerance(2.0 * eps)); }

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::central_force_test
