// Mistake: K = 0 is looked for, but not w_K = 0, which is 0/0 where nothing moves.
// graded: --variant 1 --student anna -> 16
// graded: --variant 1 --student bob@school.edu -> 16
// graded: --variant 2 --student anna -> 16
// graded: --variant 2 --student bob@school.edu -> 16
// hint: guard 0/0 and 1/0

#include "right.hpp"

double step_factor(const Sweeps& sweeps, int K_d) {
  if (sweeps.K == 0) return std::numeric_limits<double>::infinity();
  const double wanted = std::pow(sweeps.TOL / sweeps.w_0, 1.0 / (sweeps.p * K_d));
  return wanted / std::pow(sweeps.w_K / sweeps.w_0, 1.0 / (sweeps.p * sweeps.K));
}

Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings) {
  return right::next_step(dt, fields, settings, step_factor);
}

State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps) {
  return right::gauss2_step(a, from, dt, sweeps);
}
