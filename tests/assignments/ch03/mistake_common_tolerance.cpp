// Mistake: the first field's tolerance is taken for all.
// graded: --variant 2 --student anna -> 5
// graded: --variant 2 --student bob@school.edu -> 5
// hint: each field has a tolerance of its own

#include "right.hpp"

double step_factor(const Sweeps& sweeps, int K_d) { return right::step_factor(sweeps, K_d); }

Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings) {
  std::vector<Sweeps> alike = fields;
  for (Sweeps& field : alike) field.TOL = fields.front().TOL;
  return right::next_step(dt, alike, settings, step_factor);
}
