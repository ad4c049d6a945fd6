#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <vector>

#include <Eigen/Core>

/// @file
/// How the equations of the stages of a collocation method are solved: a choice by type. Picard and Anderson make
/// sweeps over all stages at once, from the rates of the sweep before; what else there is stands here.

namespace particulate::schemes {

/// Sweeps through the stages in turn, each of which uses the newest rates of those before it.
///
/// Source: @cite everhart1985. It contracts faster than sweeps over all stages at once. In the first step, and after a
/// jump, its first sweep draws for each stage the polynomial through the rate at the start and those found so far.
struct Sequential {};

/// The linear systems \f$ (I - \lambda_i\,h J - \lambda_i^2\,h^2 K)\,w_i = g_i \f$ of simplified Newton, one for each
/// eigenvalue of the matrix A of a collocation method.
///
/// @equation{D 3.4} The systems of all stages, \f$ \Delta k - h A \otimes J\,\Delta k - h^2 A^2 \otimes K\,\Delta k = g
/// \f$, fall apart in the eigenvectors of A, of which the complex ones come in pairs: s systems of n unknowns are
/// decomposed in place of one of s n. Source: @cite hairer1996, section IV.8.
class StageEigenvalues {
 public:
  /// @param A  s x s
  explicit StageEigenvalues(const Eigen::MatrixXd& A);

  /// @return those with an imaginary part >= 0, each standing for its conjugate too
  const std::vector<std::complex<double>>& values() const { return values_; }
  /// @return which of values() is real; the first, if none is
  std::size_t real() const { return real_; }
  /// The right-hand sides of the systems.
  ///
  /// @param residual  n x s, one column a stage
  /// @return one column for each of values()
  Eigen::MatrixXcd apart(const Eigen::Ref<const Eigen::MatrixXd>& residual) const;
  /// Their solutions put together.
  ///
  /// @param solutions  one column for each of values()
  /// @return n x s, one column a stage
  Eigen::MatrixXd together(const Eigen::MatrixXcd& solutions) const;

 private:
  std::vector<std::complex<double>> values_;
  std::size_t real_ = 0;
  Eigen::MatrixXcd apart_, together_;
};

/// Decomposes and solves the systems of StageEigenvalues by LU decomposition with pivoting.
///
/// @tparam M  matrix of a Jacobian: Eigen::MatrixXd, or Eigen::SparseMatrix<double> (banded ones too)
template <class M>
class LinearStages {
 public:
  using Matrix = M;  ///< of a Jacobian

  /// Decomposes the systems.
  ///
  /// @param of  eigenvalues
  /// @param dt  step h [s]
  /// @param J   of the rates; empty: none, n x n
  /// @param K   of the accelerations with respect to positions; empty: none, n x n
  void factorize(const StageEigenvalues& of, double dt, const Matrix& J, const Matrix& K);
  /// Solves one system.
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

/// Dense matrices.
using DenseStages = LinearStages<Eigen::MatrixXd>;
extern template class LinearStages<Eigen::MatrixXd>;

/// Simplified Newton: the Jacobian is taken at the start of a step and kept as long as the sweeps contract fast.
///
/// It solves stiff problems, whose fixed-point sweeps would need steps as small as an explicit scheme's. The Jacobian
/// is the problem's own, if it has that ability (`jacobian(t, y, J)`; of a PositionProblem, of the accelerations with
/// respect to the positions), else made of difference quotients, which are charged as evaluations: one for each
/// unknown, or for a banded one, one for each diagonal, and one at the start.
/// @tparam Stages  DenseStages, or SparseStages (sparse_stages.hpp) for a problem with a sparse Jacobian or a bandwidth
template <class Stages = DenseStages>
struct Newton {
  using Linear = Stages;  ///< how the linear systems are solved
};

}  // namespace particulate::schemes
