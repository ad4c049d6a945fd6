#include <particulate/schemes/stage_solver.hpp>

#include <cmath>

#include <Eigen/SparseCore>

#include <particulate/schemes/collocation_table.hpp>
#include <particulate/schemes/newton.hpp>

#include "close.hpp"

namespace tests::stage_solver_test {

using namespace particulate::schemes;

StageEigenvalues gauss(int s) { return StageEigenvalues(collocation_table(gauss_nodes(s)).A); }

// y' = J y, with the Jacobian in both forms.
struct Decay {
  double J;
  bool rate(double, In y, Out dy) const {
    dy = J * y;
    return true;
  }
  void jacobian(double, In, Eigen::MatrixXd& of) const { of.setConstant(J); }
  void sparse_jacobian(double, In, SparseJacobian& of) const { of.coeffRef(0, 0) = J; }
};
// r'' = K r, likewise.
struct Spring {
  double K;
  bool acceleration(double, In r, Out a) const {
    a = K * r;
    return true;
  }
  void jacobian(double, In, Eigen::MatrixXd& of) const { of.setConstant(K); }
  void sparse_jacobian(double, In, SparseJacobian& of) const { of.coeffRef(0, 0) = K; }
};
// r'' = J v + K r, of which difference quotients are taken from 0 by powers of two: they are exact.
struct DampedSpring {
  double J, K;
  bool acceleration(double, In r, In v, Out a) const {
    a = J * v + K * r;
    return true;
  }
  Bandwidth bandwidth() const { return {}; }
};

// One unknown, one stage at the end of the step: 1 - h J - h^2 K.
double solved(bool sparse, const Problem& problem) {
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(1), zero = Eigen::VectorXd::Zero(1);
  State at{.y = zero};
  if (problem.traits().motion) at = {.r = zero, .v = zero};
  NewtonSteps newton(sparse);
  BOOST_REQUIRE(newton.prepare(problem, at, 0.5, {.A = Eigen::MatrixXd::Ones(1, 1), .sizes = one, .speed = 1.0}));
  return newton.solve(one)(0, 0);
}

void solves_by_velocities_and_places(bool sparse) {
  const Decay decay{-3.0};
  const Spring spring{-4.0};
  const DampedSpring both{-2.0, -8.0};
  BOOST_TEST(solved(sparse, decay) == 0.4);
  BOOST_TEST(solved(sparse, spring) == 0.5);
  BOOST_TEST(solved(sparse, both) == 0.25);
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
  const Eigen::MatrixXd A = collocation_table(radau_nodes(3)).A;
  const Decay decay{-2.0};
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(1);
  const Eigen::MatrixXd residual = Eigen::RowVector3d(1.0, -2.0, 5.0);
  NewtonSteps newton;
  BOOST_REQUIRE(newton.prepare(decay, {.y = one}, 0.5, {.A = A, .sizes = one}));
  const Eigen::MatrixXd expected = (Eigen::Matrix3d::Identity() + A) * newton.solve(residual).transpose();
  BOOST_TEST(close(expected, residual.transpose(), {.absolute = 1e-14}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(DenseStages_)

BOOST_AUTO_TEST_CASE(solve_with_the_jacobians_of_velocities_and_of_places) { solves_by_velocities_and_places(false); }

BOOST_AUTO_TEST_CASE(give_nothing_finite_where_a_system_is_singular) {
  const Decay growth{2.0};
  BOOST_TEST(!std::isfinite(solved(false, growth)));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(SparseStages_)

BOOST_AUTO_TEST_CASE(solve_what_dense_ones_solve) { solves_by_velocities_and_places(true); }

BOOST_AUTO_TEST_CASE(give_nothing_finite_where_a_system_is_singular) {
  const Decay growth{2.0};
  BOOST_TEST(!std::isfinite(solved(true, growth)));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::stage_solver_test
