// Accident: a loop without end, in one line of the table.
// graded: --variant 1|2 --student anna -> 0
// hint: took too long
// hint: a loop does not end

#include "step_control.hpp"

double step_factor(const Sweeps&, int) { return 0.0; }

Decision next_step(double, const std::vector<Sweeps>&, const Settings&) { return {}; }

State gauss2_step(const Acceleration&, const State&, double, int) {
  for (volatile double x = 1.0; x > 0.0;) x = x + 1.0;
  return {};
}
