#include <particulate/schemes/stage_solver.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <type_traits>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SparseLU>

#include <particulate/schemes/sparse_stages.hpp>

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

Eigen::MatrixXcd StageEigenvalues::apart(const Eigen::Ref<const Eigen::MatrixXd>& residual) const {
  return residual * apart_;
}

Eigen::MatrixXd StageEigenvalues::together(const Eigen::MatrixXcd& solutions) const {
  return (solutions * together_).real();
}

namespace {

template <class M>
constexpr bool is_dense = std::is_same_v<M, Eigen::MatrixXd>;

using Sparse = Eigen::SparseMatrix<Complex>;

template <class M>
using System = std::conditional_t<is_dense<M>, Eigen::MatrixXcd, Sparse>;

template <class M>
using Decomposition = std::conditional_t<is_dense<M>, Eigen::PartialPivLU<Eigen::MatrixXcd>, Eigen::SparseLU<Sparse>>;

}  // namespace

template <class M>
struct LinearStages<M>::Factors {
  std::deque<Decomposition<M>> of_eigenvalue;
};

template <class M>
void LinearStages<M>::factorize(const StageEigenvalues& of, double dt, const Matrix& J, const Matrix& K) {
  const Eigen::Index n = std::max(J.rows(), K.rows());
  const auto factors = std::make_shared<Factors>();
  for (const Complex& value : of.values()) {
    const Complex shift = value * dt;
    System<M> system(n, n);
    system.setIdentity();
    if (J.rows() > 0) system -= System<M>(J.template cast<Complex>() * shift);
    if (K.rows() > 0) system -= System<M>(K.template cast<Complex>() * (shift * shift));
    factors->of_eigenvalue.emplace_back().compute(system);
  }
  factors_ = factors;
}

template <class M>
Eigen::VectorXcd LinearStages<M>::solve(std::size_t i, const Eigen::VectorXcd& right) const {
  const Decomposition<M>& lu = factors_->of_eigenvalue[i];
  if constexpr (!is_dense<M>) {
    if (lu.info() != Eigen::Success) {
      return Eigen::VectorXcd::Constant(right.size(), std::numeric_limits<double>::quiet_NaN());
    }
  }
  return lu.solve(right);
}

template <class M>
void LinearStages<M>::set(Matrix& matrix, Eigen::Index i, Eigen::Index j, double value) {
  if constexpr (is_dense<M>) {
    matrix(i, j) = value;
  } else if (value != 0.0) {
    matrix.insert(i, j) = value;
  }
}

template <class M>
bool LinearStages<M>::is_finite(const Matrix& matrix) {
  return std::isfinite((0.0 * matrix).sum());
}

template class LinearStages<Eigen::MatrixXd>;
template class LinearStages<Eigen::SparseMatrix<double>>;

}  // namespace particulate::schemes
