#include <harness/linear_algebra.hpp>

#include <Eigen/Eigenvalues>

namespace verification {
namespace {

using Complex = std::complex<double>;

// Makes zeros below the diagonal, with the largest pivots first. Columns beyond the square are carried along.
// Returns the determinant of the square.
Complex eliminate(Eigen::MatrixXcd& A) {
  Complex determinant = 1.0;
  for (Eigen::Index k = 0; k < A.rows(); ++k) {
    Eigen::Index below = 0;
    A.col(k).tail(A.rows() - k).cwiseAbs().maxCoeff(&below);
    if (below > 0) {
      A.row(k).swap(A.row(k + below));
      determinant = -determinant;
    }
    determinant *= A(k, k);
    for (Eigen::Index i = k + 1; i < A.rows(); ++i) {
      const Complex factor = A(i, k) / A(k, k);
      A.row(i) -= factor * A.row(k);
    }
  }
  return determinant;
}

}  // namespace

Modes symmetric_modes(const Eigen::MatrixXd& A) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> of(A);
  return {.values = of.eigenvalues(), .vectors = of.eigenvectors()};
}

Complex determinant(const Eigen::MatrixXcd& A) {
  Eigen::MatrixXcd eliminated = A;
  return eliminate(eliminated);
}

Eigen::VectorXcd solve(const Eigen::MatrixXcd& A, const Eigen::VectorXcd& b) {
  const Eigen::Index n = A.rows();
  Eigen::MatrixXcd both(n, n + 1);
  both << A, b;
  eliminate(both);
  Eigen::VectorXcd x = both.col(n);
  for (Eigen::Index i = n - 1; i >= 0; --i) {
    x[i] /= both(i, i);
    for (Eigen::Index j = 0; j < i; ++j) x[j] -= both(j, i) * x[i];
  }
  return x;
}

}  // namespace verification
