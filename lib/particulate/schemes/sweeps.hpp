#pragma once

#include <vector>

#include <particulate/schemes/integrate.hpp>

namespace particulate::schemes {

/// What the sweeps of one step did.
struct Sweeps {
  std::vector<State> iterates;                ///< the first guess, then the result of every sweep
  std::vector<Iteration> iterations;          ///< as the scheme reported it after every sweep
  std::vector<std::vector<Iteration>> parts;  ///< of every part of the state, likewise; empty where there is one alone
};

namespace detail {

Sweeps sweep_by_hand(void* scheme, const SchemeTable& can, const Problem& problem, const State& from, double dt,
                     int count);

}  // namespace detail

/// One step of a scheme by hand: its guess, then a given number of sweeps, whatever they do. No control looks on, and
/// the scheme of the caller stays as it was.
///
/// @param scheme   copied: what it remembers of an earlier step counts
/// @param problem  the right-hand side
/// @param from     state at the start
/// @param dt       step [s]
/// @param count    sweeps, >= 0 [-]
/// @return every iterate and every iteration
/// @throws std::invalid_argument if the scheme cannot advance all that the problem has, or the problem has no value for
///         the guess
template <Iterative S>
Sweeps sweep_by_hand(S scheme, const Problem& problem, const State& from, double dt, int count) {
  return detail::sweep_by_hand(&scheme, detail::scheme_table_of<S>, problem, from, dt, count);
}

}  // namespace particulate::schemes
