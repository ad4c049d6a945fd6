// Mistake: the first field's tolerance is taken for all.
// graded: --variant 2 --student anna -> 8
// graded: --variant 2 --student bob@school.edu -> 8
// hint: each field has a tolerance of its own

#include "right.hpp"

double step_factor(const Sweeps& sweeps, int K_d) { return right::step_factor(sweeps, K_d); }

Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings) {
  std::vector<Sweeps> alike = fields;
  for (Sweeps& field : alike) field.TOL = fields.front().TOL;
  return right::next_step(dt, alike, settings, step_factor);
}

State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps) {
  return right::gauss2_step(a, from, dt, sweeps);
}
