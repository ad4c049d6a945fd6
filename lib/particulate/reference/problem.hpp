#pragma once

#include <functional>

#include <Eigen/Core>

#include <particulate/schemes/problem.hpp>

/// @file
/// What SUNDIALS gets of a problem: its right-hand side and its abilities, with the problem's type erased.

namespace particulate::reference {

/// A right-hand side \f$ y' = f(t, y) \f$ with its problem's type erased: `rate(t, y, dy)` as in FirstOrderProblem.
using Rate = std::function<bool(double t, schemes::In y, schemes::Out dy)>;

/// A problem with its type erased. What it cannot do is empty; slow and fast are there together or not at all.
struct ErasedProblem {
  Rate whole;      ///< its whole rate
  Rate slow = {};  ///< the slow part of it, from schemes::Splits
  Rate fast = {};  ///< the rest
  std::function<void(double t, schemes::In y, Eigen::MatrixXd& J)> jacobian = {};  ///< from schemes::HasJacobian
};

/// What SUNDIALS gets of a first-order problem.
///
/// @param problem  the right-hand side; it must outlive what is returned
/// @return its rate, and its parts and its Jacobian if it offers them
template <schemes::FirstOrderProblem P>
ErasedProblem erased(P& problem, const schemes::Values&) {
  ErasedProblem all{.whole = [&problem](double t, schemes::In y, schemes::Out dy) { return problem.rate(t, y, dy); }};
  if constexpr (schemes::Splits<P>) {
    all.slow = [&problem](double t, schemes::In y, schemes::Out dy) { return problem.rate_slow(t, y, dy); };
    all.fast = [&problem](double t, schemes::In y, schemes::Out dy) { return problem.rate_fast(t, y, dy); };
  }
  if constexpr (schemes::HasJacobian<P>) {
    all.jacobian = [&problem](double t, schemes::In y, Eigen::MatrixXd& J) { problem.jacobian(t, y, J); };
  }
  return all;
}

/// What SUNDIALS gets of a second-order problem: its rate as \f$ y = (r, v) \f$ and no more, since parts and a Jacobian
/// are those of a first-order problem.
///
/// @param problem  the right-hand side; it must outlive what is returned
/// @return its rate
template <schemes::SecondOrderProblem P>
ErasedProblem erased(P& problem, const schemes::Motion&) {
  return {.whole = [&problem](double t, schemes::In y, schemes::Out dy) {
    return schemes::FirstOrderForm<P>{problem}.rate(t, y, dy);
  }};
}

}  // namespace particulate::reference
