// Mistake: the first field alone is looked at.
// graded: --variant 2 --student anna -> 4
// graded: --variant 2 --student bob@school.edu -> 4
// hint: every field counts, not the first alone

#include "right.hpp"

double step_factor(const Sweeps& sweeps, int K_d) { return right::step_factor(sweeps, K_d); }

Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings) {
  return right::next_step(dt, {fields.front()}, settings, step_factor);
}

State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps) {
  return right::gauss2_step(a, from, dt, sweeps);
}
