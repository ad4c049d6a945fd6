// Cheat: not a number compares with nothing, and is no step with which sweeps meet a tolerance.
// graded: --variant 1|2 --student anna -> 0
// hint: not a finite number
// hint: the next step must be positive and finite

#include <cmath>

#include "step_control.hpp"

double step_factor(const Sweeps&, int) { return std::nan(""); }

Decision next_step(double, const std::vector<Sweeps>&, const Settings&) {
  return {.accepted = true, .next = std::nan("")};
}

State gauss2_step(const Acceleration&, const State&, double, int) { return {.r = std::nan(""), .v = std::nan("")}; }
