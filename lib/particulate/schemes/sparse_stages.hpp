#pragma once

#include <cstddef>
#include <memory>

#include <Eigen/SparseCore>

#include <particulate/schemes/stage_solver.hpp>

namespace particulate::schemes {

/// Sparse matrices and their LU decomposition with column ordering and partial pivoting; banded matrices too.
class SparseStages {
 public:
  using Matrix = Eigen::SparseMatrix<double>;  ///< of a Jacobian

  /// Decomposes the systems. @see DenseStages::factorize
  ///
  /// @param of  eigenvalues
  /// @param dt  step h [s]
  /// @param J   of the rates; empty: none, n x n
  /// @param K   of the accelerations with respect to positions; empty: none, n x n
  void factorize(const StageEigenvalues& of, double dt, const Matrix& J, const Matrix& K);
  /// Solves one system. @see DenseStages::solve
  ///
  /// @param i      which eigenvalue
  /// @param right  n right-hand sides
  /// @return n; not finite if the system is singular
  Eigen::VectorXcd solve(std::size_t i, const Eigen::VectorXcd& right) const;

  /// Writes one entry of a matrix that is filled column by column.
  ///
  /// @param matrix  to be written, n x n, zero before
  /// @param i       row
  /// @param j       column
  /// @param value   entry
  static void set(Matrix& matrix, Eigen::Index i, Eigen::Index j, double value);
  /// @param matrix  any
  /// @return whether it holds neither NaN nor infinity
  static bool is_finite(const Matrix& matrix);

 private:
  struct Factors;
  std::shared_ptr<const Factors> factors_;  // never changed, so that copies may share them
};

}  // namespace particulate::schemes
