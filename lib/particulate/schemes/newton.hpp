#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <Eigen/Core>

#include <particulate/schemes/problem.hpp>
#include <particulate/schemes/stage_solver.hpp>

/// @file
/// Jacobians of a problem, and what simplified Newton keeps of them from step to step.

namespace particulate::schemes {

/// Increment of a difference quotient: sqrt(epsilon) of a size, a power of two with the sign of the value.
///
/// @param value  of the unknown
/// @param size   below which its changes count as absolute, > 0
/// @return increment, not zero
double difference_step(double value, double size);

/// Rates at unknowns x: `rates(x, f)` writes f and returns whether there are any.
using RatesOf = std::function<bool(const Eigen::VectorXd& x, Eigen::VectorXd& f)>;

/// A Jacobian by forward difference quotients, as many unknowns at once as no row sees two of.
///
/// @param rates  asked as often as there are diagonals in the band, or unknowns
/// @param x      where; n of them
/// @param f      the rates there
/// @param sizes  of the unknowns, > 0
/// @param band   diagonals outside which the Jacobian is zero; none: n - 1 on either side
/// @param J      receives the Jacobian, one row a rate, one column an unknown
/// @return whether all rates had a value
bool difference_jacobian(const RatesOf& rates, const Eigen::VectorXd& x, const Eigen::VectorXd& f,
                         const Eigen::VectorXd& sizes, std::optional<Bandwidth> band, Eigen::MatrixXd& J);
/// @copydoc difference_jacobian(const RatesOf&, const Eigen::VectorXd&, const Eigen::VectorXd&, const Eigen::VectorXd&,
/// std::optional<Bandwidth>, Eigen::MatrixXd&)
bool difference_jacobian(const RatesOf& rates, const Eigen::VectorXd& x, const Eigen::VectorXd& f,
                         const Eigen::VectorXd& sizes, std::optional<Bandwidth> band, SparseJacobian& J);

/// What the stage equations of one step are, for Newton.
struct StageEquations {
  const Eigen::MatrixXd& A;      ///< of the method, s x s
  const Eigen::VectorXd& sizes;  ///< of the unknowns (r, y), > 0
  double speed = 0.0;            ///< of velocities, > 0 where rates depend on them [m/s]
  bool bad = false;              ///< whether the Jacobian in hand has shown itself no good
};

/// Simplified Newton between the steps: Jacobians, their decomposition for a step size, and whether they still serve.
///
/// The unknowns of a stage are its rates k = (a, dy). With J the derivatives of the rates by (v, y) and K those by r it
/// solves, for each eigenvalue lambda of A,
///
/// \f[ (I - \lambda h J - \lambda^2 h^2 K)\,w = g \f]
///
/// @equation{D 3.4} A value: its copy is a checkpoint, and shares what is never changed.
class NewtonSteps {
 public:
  /// @param sparse  whether Jacobians are sparse matrices
  explicit NewtonSteps(bool sparse = false) : sparse_(sparse) {}

  /// Sees to it that the linear systems are decomposed for a step.
  ///
  /// @param problem  asked for a Jacobian, or for the rates that make one
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param step     the equations
  /// @return whether the problem had a finite Jacobian there
  /// @throws std::invalid_argument if the Jacobian is to be sparse and the problem gives none, or has motion and values
  bool prepare(const Problem& problem, const State& from, double dt, const StageEquations& step);

  /// One step of Newton.
  ///
  /// @param residual  f(stage) - k, one column a stage
  /// @return change of the rates k, as large; not finite if a system is singular
  Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& residual) const;

  /// A defect as the stiff part of the problem damps it.
  ///
  /// @param defect  of the rates
  /// @param dt      step [s]
  /// @return \f$ \mathrm{Re}\,(I - \lambda h J - \lambda^2 h^2 K)^{-1} \lambda h \f$ of it, with the real eigenvalue if
  ///         there is one
  Eigen::VectorXd filtered(const Eigen::VectorXd& defect, double dt) const;

  /// Drops everything.
  void forget() { jacobians_.reset(); }

 private:
  struct Jacobians;
  struct Factors;

  bool take(const Problem& problem);

  bool sparse_;
  std::shared_ptr<const StageEigenvalues> eigenvalues_;
  std::shared_ptr<const Jacobians> jacobians_;  // none: unknown
  std::shared_ptr<const Factors> factors_;
  State known_at_;
  Eigen::VectorXd sizes_;
  double speed_ = 0.0, factorized_ = 0.0;
};

}  // namespace particulate::schemes
