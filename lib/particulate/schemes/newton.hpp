#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include <Eigen/Core>

#include <particulate/schemes/problem.hpp>
#include <particulate/schemes/runge_kutta.hpp>
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

/// A Jacobian by forward difference quotients, as many unknowns at once as no row sees two of.
///
/// @tparam Linear  DenseStages or SparseStages
/// @param rate   `rate(x, f)` gives the rates at x and returns whether there are any
/// @param x      where; each entry is moved and put back
/// @param f      the rates there
/// @param sizes  of the unknowns, > 0
/// @param band   diagonals outside which the Jacobian is zero; none: n - 1 on either side
/// @param J      receives the Jacobian, n x n
/// @return whether all rates had a value
template <class Linear, class Rate>
bool difference_jacobian(const Rate& rate, Eigen::VectorXd x, const Eigen::VectorXd& f, const Eigen::VectorXd& sizes,
                         std::optional<Bandwidth> band, typename Linear::Matrix& J) {
  const Eigen::Index n = x.size();
  const Bandwidth within = band.value_or(Bandwidth{.lower = n - 1, .upper = n - 1});
  const Eigen::Index together = std::min(n, within.lower + within.upper + 1);
  const Eigen::VectorXd at = x;
  std::vector<Eigen::VectorXd> moved(static_cast<std::size_t>(together), Eigen::VectorXd(n));
  for (Eigen::Index group = 0; group < together; ++group) {
    for (Eigen::Index j = group; j < n; j += together) x[j] += difference_step(at[j], sizes[j]);
    if (!rate(x, moved[static_cast<std::size_t>(group)])) return false;
    for (Eigen::Index j = group; j < n; j += together) x[j] = at[j];
  }
  J.resize(n, n);
  J.setZero();
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::VectorXd& there = moved[static_cast<std::size_t>(j % together)];
    const double step = (at[j] + difference_step(at[j], sizes[j])) - at[j];
    for (Eigen::Index i = std::max<Eigen::Index>(0, j - within.upper); i <= std::min(n - 1, j + within.lower); ++i) {
      Linear::set(J, i, j, (there[i] - f[i]) / step);
    }
  }
  return true;
}

/// What the stage equations of one step are, for Newton.
struct StageEquations {
  const Eigen::MatrixXd& A;      ///< of the method, s x s
  const Eigen::VectorXd& sizes;  ///< of the unknowns, > 0
  bool bad = false;              ///< whether the Jacobian in hand has shown itself no good
};

/// Simplified Newton between the steps: Jacobians, their decomposition for a step size, and whether they still serve.
///
/// @tparam Linear  DenseStages or SparseStages
template <class Linear>
class NewtonSteps {
 public:
  /// Sees to it that the linear systems are decomposed for a step.
  ///
  /// @param problem  asked for a Jacobian, or for the rates that make one
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param step     the equations
  /// @return whether the problem had a finite Jacobian there
  template <class P, class State>
  bool prepare(P& problem, const State& from, double dt, const StageEquations& step) {
    if (!eigenvalues_) eigenvalues_.emplace(step.A);
    if (!known_ || (step.bad && known_at_ != from.t)) {
      known_ = false;
      if (!renew(problem, from, step.sizes)) return false;
      known_ = true;
      known_at_ = from.t;
      factorized_ = 0.0;
    }
    if (dt != factorized_) linear_.factorize(*eigenvalues_, dt, J_, K_);
    factorized_ = dt;
    return true;
  }

  /// One step of Newton.
  ///
  /// @param residual  f(stage) - k, n x s
  /// @return change of the rates k, n x s; not finite if a system is singular
  Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& residual) const {
    Eigen::MatrixXcd apart = eigenvalues_->apart(residual);
    for (Eigen::Index i = 0; i < apart.cols(); ++i) {
      const Eigen::VectorXcd right = apart.col(i);
      apart.col(i) = linear_.solve(static_cast<std::size_t>(i), right);
    }
    return eigenvalues_->together(apart);
  }

  /// A defect as the stiff part of the problem damps it.
  ///
  /// @param defect  of the rates
  /// @param dt      step [s]
  /// @return \f$ \mathrm{Re}\,(I - \lambda h J)^{-1} \lambda h \f$ of it, with the real eigenvalue if there is one
  Eigen::VectorXd filtered(const Eigen::VectorXd& defect, double dt) const {
    const std::size_t i = eigenvalues_->real();
    const Eigen::VectorXcd right = (eigenvalues_->values()[i] * dt) * defect;
    return linear_.solve(i, right).real();
  }

  /// Drops everything.
  void forget() { known_ = false; }

 private:
  template <class P>
  static std::optional<Bandwidth> band(const P& problem) {
    if constexpr (Banded<P>) return problem.bandwidth();
    return std::nullopt;
  }

  template <class P>
  bool given(P& problem, double t, const Eigen::VectorXd& x, typename Linear::Matrix& J) {
    constexpr bool dense = std::is_same_v<typename Linear::Matrix, Eigen::MatrixXd>;
    if constexpr (dense && HasJacobian<P>) {
      J.resize(x.size(), x.size());
      problem.jacobian(t, x, J);
      return true;
    } else if constexpr (!dense && HasSparseJacobian<P, typename Linear::Matrix>) {
      J.resize(x.size(), x.size());
      problem.sparse_jacobian(t, x, J);
      return true;
    } else {
      static_assert(dense || Banded<P>, "a sparse solver needs a problem with sparse_jacobian() or bandwidth()");
      return false;
    }
  }

  template <FirstOrderProblem P>
  bool renew(P& problem, const Values& from, const Eigen::VectorXd& sizes) {
    if (given(problem, from.t, from.y, J_)) return Linear::is_finite(J_);
    const auto rate = [&](const Eigen::VectorXd& y, Eigen::VectorXd& f) { return problem.rate(from.t, y, f); };
    Eigen::VectorXd f(from.y.size());
    return rate(from.y, f) && difference_jacobian<Linear>(rate, from.y, f, sizes, band(problem), J_) &&
           Linear::is_finite(J_);
  }
  template <SecondOrderProblem P>
  bool renew(P& problem, const Motion& from, const Eigen::VectorXd& sizes) {
    if constexpr (PositionProblem<P>) {
      if (given(problem, from.t, from.r, K_)) return Linear::is_finite(K_);
    }
    const auto by_place = [&](const Eigen::VectorXd& r, Eigen::VectorXd& a) {
      return acceleration_of(problem, from.t, r, from.v, a);
    };
    Eigen::VectorXd a(from.r.size());
    if (!by_place(from.r, a) || !difference_jacobian<Linear>(by_place, from.r, a, sizes, band(problem), K_))
      return false;
    if constexpr (MotionProblem<P>) {
      const auto by_speed = [&](const Eigen::VectorXd& v, Eigen::VectorXd& there) {
        return problem.acceleration(from.t, from.r, v, there);
      };
      if (!difference_jacobian<Linear>(by_speed, from.v, a, sizes, band(problem), J_)) return false;
    }
    return Linear::is_finite(K_) && Linear::is_finite(J_);
  }
  std::optional<StageEigenvalues> eigenvalues_;
  Linear linear_;
  typename Linear::Matrix J_, K_;
  double known_at_ = 0.0, factorized_ = 0.0;
  bool known_ = false;
};

/// What a stage solver keeps from step to step: nothing, but for Newton.
template <class Solver>
struct NewtonOf {
  struct type {};  ///< nothing
};
/// @copydoc NewtonOf
template <class Linear>
struct NewtonOf<Newton<Linear>> {
  using type = NewtonSteps<Linear>;  ///< Jacobians and decompositions
};

}  // namespace particulate::schemes
