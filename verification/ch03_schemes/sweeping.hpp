#pragma once

#include <stdexcept>
#include <vector>

#include <particulate/schemes/scheme.hpp>

/// @file
/// One attempted step by hand, sweep by sweep.

namespace verification {

/// What was seen of one step.
template <class State>
struct Swept {
  std::vector<State> iterates;                              ///< the first guess, then the result of every sweep
  std::vector<particulate::schemes::Iteration> iterations;  ///< as the scheme reported it after every sweep
};

/// Sweeps a given number of times.
template <class S, class P, class State>
Swept<State> sweep(S scheme, P problem, const State& from, double dt, int sweeps) {
  Swept<State> seen;
  State to = from;
  if (!scheme.predict(problem, from, dt, to)) throw std::runtime_error("no value at the start of the step");
  seen.iterates.push_back(to);
  for (int k = 0; k < sweeps; ++k) {
    seen.iterations.push_back(scheme.sweep(problem, from, dt, to));
    seen.iterates.push_back(to);
  }
  return seen;
}

/// Sums of absolute changes of positions from iterate to iterate, over no denominator.
inline std::vector<double> changes(const std::vector<particulate::schemes::State>& iterates) {
  std::vector<double> of;
  for (std::size_t k = 1; k < iterates.size(); ++k) { of.push_back((iterates[k].r - iterates[k - 1].r).lpNorm<1>()); }
  return of;
}

/// @copydoc changes
inline std::vector<double> changes(const std::vector<particulate::schemes::State>& iterates) {
  std::vector<double> of;
  for (std::size_t k = 1; k < iterates.size(); ++k) { of.push_back((iterates[k].y - iterates[k - 1].y).lpNorm<1>()); }
  return of;
}

}  // namespace verification
