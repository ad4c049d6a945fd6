#include <particulate/schemes/stage_solver.hpp>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace particulate::schemes {

namespace {
using Complex = std::complex<double>;
}

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

Eigen::MatrixXcd StageEigenvalues::apart(const Eigen::Ref<const Eigen::MatrixXd>& residual) const {
  return residual * apart_;
}

Eigen::MatrixXd StageEigenvalues::together(const Eigen::MatrixXcd& solutions) const {
  return (solutions * together_).real();
}

}  // namespace particulate::schemes
