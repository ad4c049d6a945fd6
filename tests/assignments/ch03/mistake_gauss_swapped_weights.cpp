// Mistake: b_bar is the wrong way round.
// graded: --variant 1 --student anna -> 16
// graded: --variant 2 --student bob@school.edu -> 16
// hint: b_bar_i = b_i (1 - c_i)

#include "right.hpp"

double step_factor(const Sweeps& sweeps, int K_d) { return right::step_factor(sweeps, K_d); }

Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings) {
  return right::next_step(dt, fields, settings, step_factor);
}

State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps) {
  const State end = right::gauss2_step(a, from, dt, sweeps);
  std::array<double, 2> stages{};
  for (int k = 0; k < sweeps; ++k) stages = right::sweep(a, from, dt, stages);
  return {.r = right::gauss2_end(from, dt, {stages[1], stages[0]}).r, .v = end.v};
}
