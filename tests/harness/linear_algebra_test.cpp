#include <harness/linear_algebra.hpp>

#include "close.hpp"

namespace tests::linear_algebra_test {

using Complex = std::complex<double>;

BOOST_AUTO_TEST_SUITE(linear_algebra)

// A = ((2, 1), (1, 2)) stretches (1, -1) by 1 and (1, 1) by 3; the 7 above its diagonal is not read.
BOOST_AUTO_TEST_CASE(finds_the_modes_of_a_symmetric_matrix_in_ascending_order) {
  const verification::Modes of = verification::symmetric_modes(Eigen::Matrix2d{{2.0, 7.0}, {1.0, 2.0}});
  BOOST_TEST(close(of.values, Eigen::Vector2d(1.0, 3.0), {.relative = 1e-15}));
  BOOST_TEST(std::abs(of.vectors.col(0).dot(Eigen::Vector2d(1.0, -1.0)) / std::sqrt(2.0)) == 1.0,
             boost::test_tools::tolerance(1e-15));
  BOOST_TEST(std::abs(of.vectors.col(1).dot(Eigen::Vector2d(1.0, 1.0)) / std::sqrt(2.0)) == 1.0,
             boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(solves_complex_equations_whose_rows_must_be_exchanged) {
  const Complex i(0.0, 1.0);
  Eigen::Matrix2cd A;
  A << 0.0, 2.0 * i, i, 1.0;
  // det = 0 * 1 - 2 i * i = 2. From 2 i y = 4 i and i x + y = 2 + 3 i follow y = 2 and x = 3.
  BOOST_TEST(std::abs(verification::determinant(A) - 2.0) == 0.0);
  const Eigen::VectorXcd x = verification::solve(A, Eigen::Vector2cd(4.0 * i, 2.0 + 3.0 * i));
  BOOST_TEST(std::abs(x[0] - 3.0) == 0.0);
  BOOST_TEST(std::abs(x[1] - 2.0) == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::linear_algebra_test
