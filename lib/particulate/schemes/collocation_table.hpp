#pragma once

#include <vector>

#include <Eigen/Core>

/// @file
/// Coefficients of collocation methods, computed from their nodes in extended precision.

namespace particulate::schemes {

/// Coefficients of one collocation method with s stages, for a step of length 1.
///
/// With the Lagrange polynomials \f$ l_j \f$ of the nodes,
///
/// \f[ A_{ij} = \int_0^{c_i} l_j, \qquad b_j = \int_0^1 l_j, \qquad \bar A = A A, \qquad \bar b = A^T b. \f]
///
/// Source: @cite hairer1993, sections II.7 and II.14. A and b make \f$ y' = f \f$ a step; the Nystrom form of
/// \f$ r'' = a \f$ takes positions from \f$ \bar A, \bar b \f$ and velocities from A, b, which is the same method with
/// the velocities of the stages left out.
struct CollocationCoefficients {
  Eigen::VectorXd c;      ///< nodes in (0, 1], rising [-]
  Eigen::VectorXd b;      ///< weights of the rates at the end of the step [-]
  Eigen::MatrixXd A;      ///< weights of the rates at the nodes, s x s [-]
  Eigen::VectorXd b_bar;  ///< weights of the accelerations in the position at the end [-]
  Eigen::MatrixXd A_bar;  ///< weights of the accelerations in the positions at the nodes, s x s [-]
  Eigen::VectorXd top;    ///< weights of the leading coefficient of the polynomial through the nodes [-]
  Eigen::VectorXd x;      ///< points of Gauss quadrature on [0, 1], s of them [-]
  Eigen::VectorXd w;      ///< its weights [-]
};

/// The Gauss nodes: zeros of the Legendre polynomial of degree s on [0, 1].
///
/// @param s  stages, 1 to 16 [-]
/// @return nodes, rising
/// @throws std::invalid_argument for another number of stages
std::vector<long double> gauss_nodes(int s);

/// The right Radau nodes: zeros of \f$ P_s - P_{s-1} \f$ on [0, 1], of which the last is 1.
///
/// @param s  stages, 1 to 16 [-]
/// @return nodes, rising
/// @throws std::invalid_argument for another number of stages
std::vector<long double> radau_nodes(int s);

/// The coefficients that belong to nodes.
///
/// Integrals are taken by Gauss quadrature with as many points as there are nodes, which is exact for the polynomials
/// here, in extended precision; each coefficient is rounded once.
///
/// @param nodes  distinct, rising, in (0, 1]
/// @return coefficients
/// @throws std::invalid_argument for other nodes
CollocationCoefficients collocation_coefficients(const std::vector<long double>& nodes);

/// Gauss collocation: order 2 s, symmetric, symplectic and A-stable, with stages inside the step only.
///
/// Source: @cite hairer1996, section IV.5. One stage is the implicit midpoint rule.
/// @tparam S  stages, 1 to 16
template <int S>
struct Gauss {
  static constexpr int stages = S;     ///< right-hand sides a sweep [-]
  static constexpr int order = 2 * S;  ///< of the global error [-]
  /// @return nodes in (0, 1), rising
  static std::vector<long double> nodes() { return gauss_nodes(S); }
};

/// Radau IIA collocation: order 2 s - 1, A- and L-stable; its last stage is the end of the step.
///
/// Source: @cite hairer1996, section IV.5. One stage is backward Euler, the scheme of the monograph.
/// @tparam S  stages, 1 to 16
template <int S>
struct Radau {
  static constexpr int stages = S;         ///< right-hand sides a sweep [-]
  static constexpr int order = 2 * S - 1;  ///< of the global error [-]
  /// @return nodes in (0, 1], rising; the last is 1
  static std::vector<long double> nodes() { return radau_nodes(S); }
};

/// The coefficients of one method at a size that the compiler knows, and its polynomials at any point.
///
/// @tparam Nodes  Gauss or Radau
template <class Nodes>
struct CollocationTable {
  static constexpr int S = Nodes::stages;                       ///< stages [-]
  using Row = Eigen::Matrix<double, S, 1>;                      ///< one weight a stage
  using Square = Eigen::Matrix<double, S, S, Eigen::RowMajor>;  ///< one row a stage, contiguous
  Row c;                                                        ///< nodes, see CollocationCoefficients
  Row b;                                                        ///< weights of the rates at the end
  Row b_bar;     ///< weights of the accelerations in the position at the end
  Row top;       ///< weights of the leading coefficient
  Row x;         ///< points of Gauss quadrature
  Row w;         ///< its weights
  Square A;      ///< weights of the rates at the nodes
  Square A_bar;  ///< weights of the accelerations in the positions at the nodes

  /// @return the table of this method, computed once
  static const CollocationTable& get() {
    static const CollocationTable table;
    return table;
  }

  /// The Lagrange polynomials, for a value at a point of the step, inside or beyond.
  ///
  /// @param theta  in units of the step, from its start
  /// @return \f$ l_j(\theta) \f$
  Row basis(double theta) const {
    Row l = top;
    double before = 1.0, behind = 1.0;
    for (int j = 0; j < S; ++j) {
      l[j] *= before;
      before *= theta - c[j];
      l[S - 1 - j] *= behind;
      behind *= theta - c[S - 1 - j];
    }
    return l;
  }
  /// Their integrals.
  ///
  /// @param theta  in units of the step, from its start
  /// @return \f$ \int_0^\theta l_j \f$
  Row once(double theta) const {
    Row sum = Row::Zero();
    for (int m = 0; m < S; ++m) sum += w[m] * basis(theta * x[m]);
    return theta * sum;
  }
  /// The integrals of what the method makes of their integrals, for positions in Nystrom form.
  ///
  /// @param theta  in units of the step, from its start
  /// @return \f$ A^T \int_0^\theta l \f$: row i of A A at node i, and A^T b at the end
  Row twice(double theta) const { return A.transpose() * once(theta); }

 private:
  CollocationTable() {
    const CollocationCoefficients all = collocation_coefficients(Nodes::nodes());
    c = all.c, b = all.b, b_bar = all.b_bar, top = all.top, x = all.x, w = all.w;
    A = all.A, A_bar = all.A_bar;
  }
};

}  // namespace particulate::schemes
