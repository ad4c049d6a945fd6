#include <particulate/schemes/stage_solver.hpp>

#include <algorithm>
#include <limits>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace particulate::schemes {

using Complex = std::complex<double>;

StageEigenvalues::StageEigenvalues(const Eigen::MatrixXd& A) {
  // Delta K A^T = W L T^T with Delta K = W T^T and A = T L T^-1.
  const Eigen::ComplexEigenSolver<Eigen::MatrixXcd> eigen(A.cast<Complex>());
  const Eigen::MatrixXcd& T = eigen.eigenvectors();
  const Eigen::MatrixXcd inverse = T.inverse();
  const Eigen::Index s = A.rows();
  const double real = 1e-10 * eigen.eigenvalues().cwiseAbs().maxCoeff();
  apart_.resize(s, s);
  together_.resize(s, s);
  Eigen::Index kept = 0;
  for (Eigen::Index i = 0; i < s; ++i) {
    const Complex value = eigen.eigenvalues()[i];
    if (value.imag() < -real) continue;
    const bool pair = value.imag() > real;
    if (!pair) real_ = values_.size();
    values_.push_back(pair ? value : Complex(value.real()));
    apart_.col(kept) = inverse.row(i).transpose();
    together_.row(kept) = (pair ? 2.0 : 1.0) * T.col(i).transpose();
    ++kept;
  }
  apart_.conservativeResize(s, kept);
  together_.conservativeResize(kept, s);
}

struct DenseStages::Factors {
  std::vector<Eigen::PartialPivLU<Eigen::MatrixXcd>> of_eigenvalue;
};

void DenseStages::factorize(const StageEigenvalues& of, double dt, const Matrix& J, const Matrix& K) {
  const Eigen::Index n = std::max(J.rows(), K.rows());
  const auto factors = std::make_shared<Factors>();
  for (const Complex& value : of.values()) {
    const Complex shift = value * dt;
    Eigen::MatrixXcd system = Eigen::MatrixXcd::Identity(n, n);
    if (J.size() > 0) system -= shift * J;
    if (K.size() > 0) system -= (shift * shift) * K;
    factors->of_eigenvalue.emplace_back(system);
  }
  factors_ = factors;
}

Eigen::VectorXcd DenseStages::solve(std::size_t i, const Eigen::VectorXcd& right) const {
  return factors_->of_eigenvalue[i].solve(right);
}

void DenseStages::set(Matrix& matrix, Eigen::Index i, Eigen::Index j, double value) { matrix(i, j) = value; }

bool DenseStages::is_finite(const Matrix& matrix) { return matrix.allFinite(); }

}  // namespace particulate::schemes
