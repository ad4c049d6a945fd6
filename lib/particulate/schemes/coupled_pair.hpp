#pragma once

#include <cstddef>

#include <Eigen/Core>

#include <particulate/schemes/problem.hpp>

/// @file
/// Two linear fields that drive one another: the semi-analytical examples of staggering.

namespace particulate::schemes {

/// Two coupled equations of first order, each solved by backward Euler with the other frozen.
///
/// \f[ \dot w_1 = -a_{11} w_1 - a_{12} w_2, \qquad \dot w_2 = -a_{21} w_1 - a_{22} w_2 \f]
///
/// @equation{R 7.5.2} The monograph's first example, \f$ a\,\dot w_1 + w_2 = 0,\ b\,\dot w_2 + w_1 = 0 \f$, has
/// \f$ a_{12} = 1/a,\ a_{21} = 1/b \f$ and no others. A Gauss-Seidel sweep multiplies the error by
///
/// \f[ \frac{\Delta t^2\,a_{12}\,a_{21}}{(1 + \Delta t\,a_{11})(1 + \Delta t\,a_{22})}, \f]
///
/// a Jacobi sweep has the square roots of it as its eigenvalues. With \f$ a_{11} = a_{22} = 1,\ a_{12} = -a_{21} = 3
/// \f$ the fields decay, and yet the sweeps diverge beyond \f$ \Delta t = 1/2 \f$. The state is \f$ y = (w_1, w_2) \f$;
/// fields 0 and 1; exponents p of Dt: 2 under Gauss-Seidel, 1 under Jacobi, exactly if \f$ a_{11} = a_{22} = 0 \f$.
///
/// Satisfies FirstOrderProblem, HasJacobian and StaggeredProblem.
struct FirstOrderPair {
  Eigen::Matrix2d a = Eigen::Matrix2d::Zero();  ///< the coefficients, a(k, j) as above with k, j from 0 [1/s]

  /// The rate of both fields at once, for schemes that do not stagger. @see FirstOrderProblem
  ///
  /// @param y   both fields
  /// @param dy  receives their rates
  /// @return true
  bool rate(double, In y, Out dy) const;
  /// The matrix -a. @see HasJacobian
  ///
  /// @param J  receives it
  void jacobian(double, In, Eigen::MatrixXd& J) const { J = -a; }

  /// @return 2
  std::size_t fields() const { return 2; }
  /// Backward Euler of one field: \f$ (1 + \Delta t\,a_{kk})\,w_k = w_k^L - \Delta t\,a_{kj}\,w_j \f$.
  ///
  /// @param k     which field
  /// @param from  state at the start of the step
  /// @param dt    step [s]
  /// @param seen  where the other field is taken from
  /// @param to    receives the field
  /// @return whether the equation has a solution
  bool solve(std::size_t k, const State& from, double dt, const State& seen, State& to) const;
  /// @param k  which field
  /// @return one value
  Part part(std::size_t k) const { return {.first = static_cast<Eigen::Index>(k), .size = 1}; }
};

/// Two coupled equations of second order, each solved by backward Euler with the other frozen.
///
/// \f[ \ddot w_1 = -c_{12}\,w_2, \qquad \ddot w_2 = -c_{21}\,w_1 \f]
///
/// @equation{R 7.5.2} The monograph's second example, \f$ a\,\ddot w_1 + w_2 = 0,\ b\,\ddot w_2 + w_1 = 0 \f$, has
/// \f$ c_{12} = 1/a,\ c_{21} = 1/b \f$; of its four modes two oscillate, one decays and one grows. A Gauss-Seidel sweep
/// multiplies the error by \f$ \Delta t^4 c_{12} c_{21} \f$ (p = 4), a Jacobi sweep has the square roots of it as its
/// eigenvalues (p = 2). The state is \f$ y = (w_1, \dot w_1, w_2, \dot w_2) \f$; fields 0 and 1, each a value with its
/// rate; their distance is that of the values.
///
/// Satisfies FirstOrderProblem, StaggeredProblem and MeasuresFields.
struct SecondOrderPair {
  double c12 = 0.0;  ///< [1/s^2]
  double c21 = 0.0;  ///< [1/s^2]

  /// The rate of both fields at once, for schemes that do not stagger. @see FirstOrderProblem
  ///
  /// @param y   both fields, each a value with its rate
  /// @param dy  receives their rates
  /// @return true
  bool rate(double, In y, Out dy) const;

  /// @return 2
  std::size_t fields() const { return 2; }
  /// Backward Euler of one field: \f$ w_k = w_k^L + \Delta t\,\dot w_k^L - \Delta t^2 c_{kj}\,w_j \f$, and
  /// \f$ \dot w_k = (w_k - w_k^L)/\Delta t \f$.
  ///
  /// @param k     which field
  /// @param from  state at the start of the step
  /// @param dt    step [s]
  /// @param seen  where the other field is taken from
  /// @param to    receives the field
  /// @return true
  bool solve(std::size_t k, const State& from, double dt, const State& seen, State& to) const;
  /// @param k  which field
  /// @return a value and its rate
  Part part(std::size_t k) const { return {.first = static_cast<Eigen::Index>(2 * k), .size = 2}; }
  /// @param x  a value with its rate
  /// @param y  another
  /// @return distance of the values
  double distance(std::size_t, In x, In y) const;
};

}  // namespace particulate::schemes
