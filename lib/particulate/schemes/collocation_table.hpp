#pragma once

#include <vector>

#include <Eigen/Core>

/// @file
/// Coefficients of collocation methods, computed from their nodes in extended precision.

namespace particulate::schemes {

/// One weight a stage, without asking for memory.
using StageWeights = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 16, 1>;

/// Coefficients of one collocation method with s stages, for a step of length 1, and its polynomials at any point.
///
/// With the Lagrange polynomials \f$ l_j \f$ of the nodes,
///
/// \f[ A_{ij} = \int_0^{c_i} l_j, \qquad b_j = \int_0^1 l_j, \qquad \bar A = A A, \qquad \bar b = A^T b. \f]
///
/// Source: @cite hairer1993, sections II.7 and II.14. A and b make \f$ y' = f \f$ a step; the Nystrom form of
/// \f$ r'' = a \f$ takes positions from \f$ \bar A, \bar b \f$ and velocities from A, b, which is the same method with
/// the velocities of the stages left out.
struct CollocationTable {
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;  ///< one row a stage
  Eigen::VectorXd c;      ///< nodes in (0, 1], rising [-]
  Eigen::VectorXd b;      ///< weights of the rates at the end of the step [-]
  Square A;               ///< weights of the rates at the nodes, s x s [-]
  Eigen::VectorXd b_bar;  ///< weights of the accelerations in the position at the end [-]
  Square A_bar;           ///< weights of the accelerations in the positions at the nodes, s x s [-]
  Eigen::VectorXd top;    ///< weights of the leading coefficient of the polynomial through the nodes [-]
  Eigen::VectorXd x;      ///< points of Gauss quadrature on [0, 1], s of them [-]
  Eigen::VectorXd w;      ///< its weights [-]

  /// @return the number of stages s [-]
  Eigen::Index stages() const { return c.size(); }
  /// The Lagrange polynomials, for a value at a point of the step, inside or beyond.
  ///
  /// @param theta  in units of the step, from its start
  /// @return \f$ l_j(\theta) \f$
  StageWeights basis(double theta) const;
  /// Their integrals.
  ///
  /// @param theta  in units of the step, from its start
  /// @return \f$ \int_0^\theta l_j \f$
  StageWeights once(double theta) const;
  /// The integrals of what the method makes of their integrals, for positions in Nystrom form.
  ///
  /// @param theta  in units of the step, from its start
  /// @return \f$ A^T \int_0^\theta l \f$: row i of A A at node i, and A^T b at the end
  StageWeights twice(double theta) const;
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
CollocationTable collocation_table(const std::vector<long double>& nodes);

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

/// @tparam Nodes  Gauss or Radau
/// @return the table of this method, computed once
template <class Nodes>
const CollocationTable& table_of() {
  static const CollocationTable table = collocation_table(Nodes::nodes());
  return table;
}

}  // namespace particulate::schemes
