// Mistake: a last change below a small number counts as none.
// graded: --variant 1 --student anna -> 16
// graded: --variant 1 --student bob@school.edu -> 16
// graded: --variant 2 --student anna -> 16
// graded: --variant 2 --student bob@school.edu -> 16
// hint: a small w_K is a number like any other
// never: no small number

#include "right.hpp"

double step_factor(const Sweeps& sweeps, int K_d) {
  if (sweeps.w_K < 1e-12) return std::numeric_limits<double>::infinity();
  return right::step_factor(sweeps, K_d);
}

Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings) {
  return right::next_step(dt, fields, settings, step_factor);
}

State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps) {
  return right::gauss2_step(a, from, dt, sweeps);
}
