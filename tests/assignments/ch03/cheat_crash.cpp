// Accident: an index far out of bounds.
// graded: --variant 1|2 --student anna -> 0
// hint: crashed
// hint: an index or a pointer is wrong

#include "step_control.hpp"

namespace {

double far_away() {
  const volatile double here = 0.0;
  const volatile double* const values = &here;
  const volatile long far = 1000000000000;
  return values[far];
}

}  // namespace

double step_factor(const Sweeps&, int) {
  if (far_away() > 0.0) return {};
  return 0.0;
}

Decision next_step(double, const std::vector<Sweeps>&, const Settings&) {
  if (far_away() > 0.0) return {};
  return {};
}

State gauss2_step(const Acceleration&, const State&, double, int) { return {.r = far_away(), .v = 0.0}; }
