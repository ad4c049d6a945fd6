#include <particulate/schemes/stage_solver.hpp>

#include <cmath>

#include <particulate/schemes/collocation_table.hpp>
#include <particulate/schemes/sparse_stages.hpp>

#include "close.hpp"

namespace tests::stage_solver_test {

using particulate::schemes::collocation_coefficients;
using particulate::schemes::DenseStages;
using particulate::schemes::gauss_nodes;
using particulate::schemes::radau_nodes;
using particulate::schemes::SparseStages;
using particulate::schemes::StageEigenvalues;

StageEigenvalues gauss(int s) { return StageEigenvalues(collocation_coefficients(gauss_nodes(s)).A); }

// One unknown, one stage at the end of the step: 1 - h J - h^2 K.
template <class Stages>
double solved(double h, double J, double K) {
  const StageEigenvalues one(Eigen::MatrixXd::Ones(1, 1));
  typename Stages::Matrix velocities(1, 1), places(1, 1);
  Stages::set(velocities, 0, 0, J);
  Stages::set(places, 0, 0, K);
  Stages stages;
  stages.factorize(one, h, velocities, places);
  return stages.solve(0, Eigen::VectorXcd::Ones(1))[0].real();
}

BOOST_AUTO_TEST_SUITE(StageEigenvalues_)

// Their product is s!/(2 s)!, the last coefficient of the Pade denominator, and their sum 1/2, the first.
BOOST_AUTO_TEST_CASE(are_those_of_gauss_with_one_two_and_three_stages) {
  const StageEigenvalues one = gauss(1), two = gauss(2), three = gauss(3);
  BOOST_TEST_REQUIRE(one.values().size() == 1U);
  BOOST_TEST(one.values()[0].real() == 0.5);
  BOOST_TEST_REQUIRE(two.values().size() == 1U);
  BOOST_TEST(std::abs(two.values()[0] - std::complex<double>(0.25, std::sqrt(3.0) / 12.0)) <= 1e-15);
  BOOST_TEST_REQUIRE(three.values().size() == 2U);
  const std::complex<double> real = three.values()[three.real()], other = three.values()[1 - three.real()];
  BOOST_TEST(real.imag() == 0.0);
  BOOST_TEST(other.imag() > 0.0);
  BOOST_TEST(std::abs(real.real() * std::norm(other) - 1.0 / 120.0) <= 1e-16);
  BOOST_TEST(std::abs(real.real() + 2.0 * other.real() - 0.5) <= 1e-15);
}

// The eigenvectors of A come near one another as stages are added, which magnifies rounding: by 1e7 for eight of them.
BOOST_AUTO_TEST_CASE(take_residuals_apart_and_put_them_together_again) {
  for (int s = 1; s <= 8; ++s) {
    const StageEigenvalues of = gauss(s);
    const Eigen::MatrixXd residual = Eigen::MatrixXd::NullaryExpr(
        2, s, [](Eigen::Index i, Eigen::Index j) { return 1.0 + std::sin(static_cast<double>(i + 7 * j)); });
    BOOST_TEST(close(of.together(of.apart(residual)), residual, {.absolute = s <= 5 ? 1e-11 : 1e-8}));
  }
}

// Delta k - h A J Delta k = g with J = -2, h = 1/2: (I + A) Delta k = g.
BOOST_AUTO_TEST_CASE(make_the_stages_one_system_each) {
  const Eigen::MatrixXd A = collocation_coefficients(radau_nodes(3)).A;
  const StageEigenvalues of(A);
  DenseStages stages;
  stages.factorize(of, 0.5, Eigen::MatrixXd::Constant(1, 1, -2.0), {});
  const Eigen::MatrixXd residual = Eigen::RowVector3d(1.0, -2.0, 5.0);
  Eigen::MatrixXcd apart = of.apart(residual);
  for (Eigen::Index i = 0; i < apart.cols(); ++i) {
    const Eigen::VectorXcd right = apart.col(i);
    apart.col(i) = stages.solve(static_cast<std::size_t>(i), right);
  }
  const Eigen::MatrixXd expected = (Eigen::Matrix3d::Identity() + A) * of.together(apart).transpose();
  BOOST_TEST(close(expected, residual.transpose(), {.absolute = 1e-14}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(DenseStages_)

BOOST_AUTO_TEST_CASE(solve_with_the_jacobians_of_velocities_and_of_places) {
  BOOST_TEST(solved<DenseStages>(0.5, -3.0, 0.0) == 0.4);
  BOOST_TEST(solved<DenseStages>(0.5, 0.0, -4.0) == 0.5);
  BOOST_TEST(solved<DenseStages>(0.5, -2.0, -8.0) == 0.25);
}

BOOST_AUTO_TEST_CASE(give_nothing_finite_where_a_system_is_singular) {
  BOOST_TEST(!std::isfinite(solved<DenseStages>(0.5, 2.0, 0.0)));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(SparseStages_)

BOOST_AUTO_TEST_CASE(solve_what_dense_ones_solve) {
  BOOST_TEST(solved<SparseStages>(0.5, -3.0, 0.0) == 0.4);
  BOOST_TEST(solved<SparseStages>(0.5, 0.0, -4.0) == 0.5);
  BOOST_TEST(solved<SparseStages>(0.5, -2.0, -8.0) == 0.25);
}

BOOST_AUTO_TEST_CASE(give_nothing_finite_where_a_system_is_singular) {
  BOOST_TEST(!std::isfinite(solved<SparseStages>(0.5, 2.0, 0.0)));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::stage_solver_test
