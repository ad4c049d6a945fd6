// Mistake: the limit of the step is forgotten.
// graded: --variant 1 --student anna -> 15
// graded: --variant 1 --student bob@school.edu -> 15
// graded: --variant 2 --student anna -> 15
// graded: --variant 2 --student bob@school.edu -> 15
// hint: cap forgotten: no step is larger than limit

#include "right.hpp"

double step_factor(const Sweeps& sweeps, int K_d) { return right::step_factor(sweeps, K_d); }

Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings) {
  Settings other = settings;
  other.limit = std::numeric_limits<double>::infinity();
  return right::next_step(dt, fields, other, step_factor);
}
