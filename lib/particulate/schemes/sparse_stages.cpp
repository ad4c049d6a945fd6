#include <particulate/schemes/sparse_stages.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include <Eigen/SparseLU>

namespace particulate::schemes {

namespace {

using Complex = std::complex<double>;
using SparseComplex = Eigen::SparseMatrix<Complex>;

}  // namespace

struct SparseStages::Factors {
  std::deque<Eigen::SparseLU<SparseComplex>> of_eigenvalue;
};

void SparseStages::factorize(const StageEigenvalues& of, double dt, const Matrix& J, const Matrix& K) {
  const Eigen::Index n = std::max(J.rows(), K.rows());
  SparseComplex one(n, n);
  one.setIdentity();
  const auto factors = std::make_shared<Factors>();
  for (const Complex& value : of.values()) {
    const Complex shift = value * dt;
    SparseComplex system = one;
    if (J.rows() > 0) system -= SparseComplex(J.cast<Complex>() * shift);
    if (K.rows() > 0) system -= SparseComplex(K.cast<Complex>() * (shift * shift));
    system.makeCompressed();
    factors->of_eigenvalue.emplace_back().compute(system);
  }
  factors_ = factors;
}

Eigen::VectorXcd SparseStages::solve(std::size_t i, const Eigen::VectorXcd& right) const {
  const Eigen::SparseLU<SparseComplex>& lu = factors_->of_eigenvalue[i];
  if (lu.info() != Eigen::Success) {
    return Eigen::VectorXcd::Constant(right.size(), std::numeric_limits<double>::quiet_NaN());
  }
  return lu.solve(right);
}

void SparseStages::set(Matrix& matrix, Eigen::Index i, Eigen::Index j, double value) {
  if (value != 0.0) matrix.insert(i, j) = value;
}

bool SparseStages::is_finite(const Matrix& matrix) {
  for (Eigen::Index j = 0; j < matrix.outerSize(); ++j) {
    for (Matrix::InnerIterator entry(matrix, j); entry; ++entry) {
      if (!std::isfinite(entry.value())) return false;
    }
  }
  return true;
}

}  // namespace particulate::schemes
