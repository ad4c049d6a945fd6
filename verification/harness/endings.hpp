#pragma once

#include <limits>

#include <harness/rows.hpp>
#include <particulate/schemes/scheme.hpp>

/// @file
/// How runs end that should not get to their end.

namespace verification {

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();  ///< what nobody can mean
inline constexpr double infinite = std::numeric_limits<double>::infinity();       ///< what hardly anybody can mean

/// What ends an attempt that should not have got so far.
inline Ending accepted() { return Ending::solved({.error = 0.0, .tolerance = 0.0, .because = "it was accepted"}); }

/// A refusal with its reason, or an acceptance that should not have been.
inline Ending ending_of(const particulate::schemes::Outcome& outcome) {
  return outcome.status == particulate::schemes::Status::failed ? Ending::refused(outcome.reason) : accepted();
}

/// How far a step is from the equation of backward Euler, \f$ r' = r + \Delta t\,v + \Delta t^2 a(r') \f$.
inline double defect(const particulate::schemes::Problem& problem, const particulate::schemes::State& from,
                     const particulate::schemes::State& to, double dt) {
  particulate::schemes::Rates rates;
  if (!problem.rates(to, rates)) return missing;
  const Eigen::VectorXd residual = to.r - from.r - dt * from.v - dt * dt * rates.a;
  return residual.lpNorm<Eigen::Infinity>();
}

}  // namespace verification
