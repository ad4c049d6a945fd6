#include <particulate/schemes/sweeps.hpp>

#include <stdexcept>

namespace particulate::schemes {

Sweeps detail::sweep_by_hand(void* scheme, const SchemeTable& can, const Problem& problem, const State& from, double dt,
                             int count) {
  if (!can.advances(problem.traits())) {
    throw std::invalid_argument(
        "sweep_by_hand: the scheme must be able to advance all that the problem has, and this one leaves something "
        "behind: take another scheme");
  }
  Sweeps seen;
  State to = from;
  if (!can.predict(scheme, problem, from, dt, to)) {
    throw std::invalid_argument(
        "sweep_by_hand: the problem must have a value for the guess of the step, and has none: start elsewhere, or "
        "take another step");
  }
  seen.iterates.push_back(to);
  for (int k = 0; k < count; ++k) {
    seen.iterations.push_back(can.sweep(scheme, problem, from, dt, to));
    seen.iterates.push_back(to);
    const std::span<const Iteration> parts = can.iterations ? can.iterations(scheme) : std::span<const Iteration>();
    seen.parts.emplace_back(parts.begin(), parts.end());
  }
  return seen;
}

}  // namespace particulate::schemes
