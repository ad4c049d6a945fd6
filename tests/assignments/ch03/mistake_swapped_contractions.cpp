// Mistake: K_d and K are swapped.
// graded: --variant 1 --student anna -> 4
// graded: --variant 1 --student bob@school.edu -> 4
// graded: --variant 2 --student anna -> 4
// graded: --variant 2 --student bob@school.edu -> 4
// hint: K_d and K are swapped

#include "right.hpp"

double step_factor(const Sweeps& sweeps, int K_d) {
  if (sweeps.w_K == 0.0 || sweeps.K == 0) return std::numeric_limits<double>::infinity();
  Sweeps other = sweeps;
  other.K = K_d;
  return right::step_factor(other, sweeps.K);
}

Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings) {
  return right::next_step(dt, fields, settings, step_factor);
}

State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps) {
  return right::gauss2_step(a, from, dt, sweeps);
}
