// Mistake: the next step is the factor itself.
// graded: --variant 1 --student anna -> 4
// graded: --variant 1 --student bob@school.edu -> 4
// graded: --variant 2 --student anna -> 4
// graded: --variant 2 --student bob@school.edu -> 4
// hint: dt is forgotten

#include "right.hpp"

double step_factor(const Sweeps& sweeps, int K_d) { return right::step_factor(sweeps, K_d); }

Decision next_step(double, const std::vector<Sweeps>& fields, const Settings& settings) {
  return right::next_step(1.0, fields, settings, step_factor);
}

State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps) {
  return right::gauss2_step(a, from, dt, sweeps);
}
