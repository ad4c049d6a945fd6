// Mistake: the position ends with half the mean acceleration.
// graded: --variant 1 --student anna -> 16
// graded: --variant 2 --student bob@school.edu -> 16
// hint: not with dt^2/2 times the mean acceleration

#include "right.hpp"

double step_factor(const Sweeps& sweeps, int K_d) { return right::step_factor(sweeps, K_d); }

Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings) {
  return right::next_step(dt, fields, settings, step_factor);
}

State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps) {
  std::array<double, 2> stages{};
  for (int k = 0; k < sweeps; ++k) stages = right::sweep(a, from, dt, stages);
  const double mean = 0.5 * (stages[0] + stages[1]);
  return {.r = from.r + dt * from.v + 0.5 * dt * dt * mean, .v = from.v + dt * mean};
}
