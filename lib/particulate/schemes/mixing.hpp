#pragma once

#include <Eigen/Core>

/// @file
/// How the next iterate of a fixed-point iteration \f$ x = g(x) \f$ follows from the ones before.

namespace particulate::schemes {

/// The plain iteration: the next iterate is what the map gave.
struct Picard {
  /// Forgets earlier iterates: it keeps none.
  void forget() {}
  /// \f$ x \leftarrow g(x) \f$.
  ///
  /// @param x   the iterate; receives the next one
  /// @param gx  the map there, as long as x; its content is lost
  void next(Eigen::VectorXd& x, Eigen::VectorXd& gx) { x.swap(gx); }
};

/// Anderson acceleration: the next iterate mixes the last few so that their residuals would cancel were the map linear.
///
/// \f[ x \leftarrow g_k - \sum_{j} \gamma_j\,(g_{j+1} - g_j), \qquad
///     \gamma = \arg\min \Big\| f_k - \sum_j \gamma_j\,(f_{j+1} - f_j) \Big\|_2, \qquad f = g(x) - x \f]
///
/// Source: @cite walker2011, section 2. It can solve maps that do not contract. On a linear map it does what GMRES
/// does, and ends after as many sweeps as there are different eigenvalues, if depth allows. The least-squares problem
/// is solved by a QR decomposition with pivoting, which leaves out differences that rounding has made equal.
class Anderson {
 public:
  /// @param depth  earlier iterates that are mixed in, >= 1 [-]
  /// @throws std::invalid_argument for a depth that mixes nothing in
  explicit Anderson(int depth = 3);

  /// Forgets earlier iterates: a new step begins.
  void forget() { seen_ = -1; }
  /// The next iterate.
  ///
  /// @param x   the iterate; receives the next one
  /// @param gx  the map there, as long as x; its content is lost
  void next(Eigen::VectorXd& x, Eigen::VectorXd& gx);

 private:
  Eigen::Index depth_;
  Eigen::MatrixXd residual_steps_, map_steps_;  // columns: differences of successive f and g, the oldest overwritten
  Eigen::VectorXd residual_, map_;              // of the last iterate
  Eigen::Index seen_ = -1;                      // differences since forget(); -1: no iterate yet
};

}  // namespace particulate::schemes
