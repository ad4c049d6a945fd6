#include <particulate/continuum/deformation.hpp>

#include <complex>

#include "close.hpp"

namespace tests::deformation_test {

using boost::test_tools::tolerance;
using namespace particulate::continuum;
using Complex = std::complex<double>;

Tensor<double> rows(const Vector<double>& a, const Vector<double>& b, const Vector<double>& c) {
  Tensor<double> result;
  result << a.transpose(), b.transpose(), c.transpose();
  return result;
}
// By cofactors along the first row: 2 (3*4 - 1*1) - 1 (0*4 - 1*1) + 0 = 23.
const Tensor<double> F = rows({2.0, 1.0, 0.0}, {0.0, 3.0, 1.0}, {1.0, 1.0, 4.0});

BOOST_AUTO_TEST_SUITE(gradient_)

// x = (X Y, Z^2, X + 3 Z) at (2, 5, 7): rows (5, 2, 0), (0, 0, 14), (1, 0, 3).
BOOST_AUTO_TEST_CASE(has_a_component_in_each_row) {
  const auto motion = [](const Vector<Complex>& X) {
    return Vector<Complex>(X[0] * X[1], X[2] * X[2], X[0] + 3.0 * X[2]);
  };
  const Tensor<double> expected = rows({5.0, 2.0, 0.0}, {0.0, 0.0, 14.0}, {1.0, 0.0, 3.0});
  BOOST_TEST(close(gradient(motion, {2.0, 5.0, 7.0}), expected, {.relative = 1e-15}));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(jacobian_)

BOOST_AUTO_TEST_CASE(is_the_determinant) {
  BOOST_TEST(jacobian(F) == 23.0);
  BOOST_TEST(deformed_volume(F, 2.0) == 46.0);
}

// d det(F + s I)/ds at s = 0 is the sum of the principal minors: 11 + 8 + 6.
BOOST_AUTO_TEST_CASE(can_be_differentiated_by_a_complex_step) {
  const Tensor<Complex> beside = F.cast<Complex>() + Complex(0.0, 1e-50) * Tensor<Complex>::Identity();
  BOOST_TEST(jacobian(beside).imag() / 1e-50 == 25.0, tolerance(1e-15));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(cofactor_)

// Minors with their signs: of (0, 1), for instance, -(0*4 - 1*1) = 1.
BOOST_AUTO_TEST_CASE(is_that_of_textbooks) {
  BOOST_TEST(close(cofactor(F), rows({11.0, 1.0, -3.0}, {-4.0, 8.0, -1.0}, {1.0, -2.0, 6.0}), {.relative = 1e-15}));
}

BOOST_AUTO_TEST_CASE(is_there_without_an_inverse) {
  // Everything is pressed into the plane across z.
  const Tensor<double> flat = Vector<double>(2.0, 3.0, 0.0).asDiagonal();
  BOOST_TEST(close(cofactor(flat), rows({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 6.0}), {.relative = 1e-15}));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(deformed_area_)

// The first column of the cofactors.
BOOST_AUTO_TEST_CASE(is_by_cofactors) {
  BOOST_TEST(close(deformed_area<double>(F, {2.0, 0.0, 0.0}), Vector<double>(22.0, -8.0, 2.0), {.relative = 1e-15}));
}

// A simple shear tilts the planes across x, and leaves those that slide on one another.
BOOST_AUTO_TEST_CASE(is_normal_to_lines_in_it) {
  const Tensor<double> shear = rows({1.0, 0.5, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0});
  BOOST_TEST(close(deformed_area<double>(shear, {1.0, 0.0, 0.0}), Vector<double>(1.0, -0.5, 0.0), {.relative = 1e-15}));
  BOOST_TEST(close(deformed_area<double>(shear, {0.0, 1.0, 0.0}), Vector<double>(0.0, 1.0, 0.0), {.relative = 1e-15}));
  BOOST_TEST(close(deformed_line<double>(shear, {0.0, 1.0, 0.0}), Vector<double>(0.5, 1.0, 0.0), {.relative = 1e-15}));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(green_lagrange_)

// Squares of lengths 4 and 9 to 1, and a quarter turn, which makes no strain.
BOOST_AUTO_TEST_CASE(sees_lengths_and_no_rotation) {
  const Tensor<double> stretch = Vector<double>(2.0, 3.0, 1.0).asDiagonal();
  const Tensor<double> turn = rows({0.0, -1.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
  const Tensor<double> both = turn * stretch, expected = Vector<double>(1.5, 4.0, 0.0).asDiagonal();
  BOOST_TEST(close(green_lagrange(both), expected, {.relative = 1e-15}));
  BOOST_TEST(close(green_lagrange(turn), Tensor<double>::Zero(), {}));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(velocity_gradient_)

// F = diag(e^{2t}, 1, 1) times anything: L = diag(2, 0, 0).
BOOST_AUTO_TEST_CASE(does_not_know_the_start) {
  const Tensor<double> L = Vector<double>(2.0, 0.0, 0.0).asDiagonal(), rate = L * F;
  BOOST_TEST(close(velocity_gradient(F, rate), L, {.absolute = 1e-15}));
  BOOST_TEST(jacobian_rate(F, L) == 46.0);
}

BOOST_AUTO_TEST_CASE(refuses_what_no_motion_does) {
  const Tensor<double> mirror = Vector<double>(-1.0, 1.0, 1.0).asDiagonal();
  CHECK_REFUSED(velocity_gradient(mirror, F),
                "J = det F must be positive, and above the rounding of its terms, got -1");
  const Tensor<double> flat = rows({1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}, {0.7, 0.8, 0.9});
  CHECK_REFUSED(velocity_gradient(flat, F), "give the gradient of a motion that neither flattens");
  CHECK_REFUSED(validate_deformation(Tensor<double>::Constant(not_a_number)), "got nan");
  CHECK_REFUSED(validate_deformation(Tensor<double>::Identity() * infinity), "J = det F must be positive");
}

// J = 1e-24 and 1e-17, of one term: small, but not lost.
BOOST_AUTO_TEST_CASE(takes_what_is_small_or_thin) {
  const Tensor<double> small = 1e-8 * Tensor<double>::Identity(), thin = Vector<double>(1.0, 1.0, 1e-17).asDiagonal();
  BOOST_TEST(close(velocity_gradient(small, small), Tensor<double>::Identity(), {.relative = 1e-15}));
  BOOST_TEST(close(velocity_gradient(thin, thin), Tensor<double>::Identity(), {.relative = 1e-15}));
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(spin_)

// A turn at (1, 2, 3) 1/s about an axis through the origin, v = omega x r, has this gradient, and no D.
BOOST_AUTO_TEST_CASE(is_all_of_a_rotation) {
  const Tensor<double> L = rows({0.0, -3.0, 2.0}, {3.0, 0.0, -1.0}, {-2.0, 1.0, 0.0});
  BOOST_TEST(close(spin(L), L, {}));
  BOOST_TEST(close(rate_of_deformation(L), Tensor<double>::Zero(), {}));
}

BOOST_AUTO_TEST_CASE(is_half_of_a_simple_shear) {
  const Tensor<double> L = rows({0.0, 4.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0});
  BOOST_TEST(close(spin(L), rows({0.0, 2.0, 0.0}, {-2.0, 0.0, 0.0}, {0.0, 0.0, 0.0}), {}));
  BOOST_TEST(close(rate_of_deformation(L), rows({0.0, 2.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 0.0, 0.0}), {}));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::deformation_test
