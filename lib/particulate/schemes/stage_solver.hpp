#pragma once

#include <complex>
#include <cstddef>
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

/// Dense matrices of a Jacobian, decomposed with pivoting.
struct DenseStages {};
/// Sparse matrices, whose columns are ordered to fill in little; banded matrices too.
struct SparseStages {};

/// Simplified Newton: the Jacobian is taken at the start of a step and kept as long as the sweeps contract fast.
///
/// It solves stiff problems, whose fixed-point sweeps would need steps as small as an explicit scheme's. The Jacobian
/// is the problem's own, if it has that ability (HasJacobian, HasWholeJacobian), else made of difference quotients,
/// which are charged as evaluations: one for each unknown, or for a banded one, one for each diagonal, and one at the
/// start. Where motion and values act on each other it is that of all of (r, v, y).
/// @tparam Stages  DenseStages, or SparseStages for a problem with a sparse Jacobian or a bandwidth, which has motion
///                 or values, not both
template <class Stages = DenseStages>
struct Newton {
  using Linear = Stages;  ///< how the linear systems are solved
};

}  // namespace particulate::schemes
