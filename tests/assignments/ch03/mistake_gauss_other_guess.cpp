// Mistake: the first guess is the acceleration at the start.
// graded: --variant 1 --student anna -> 16
// graded: --variant 2 --student bob@school.edu -> 16
// hint: a_1 = a_2 = 0

#include "right.hpp"

double step_factor(const Sweeps& sweeps, int K_d) { return right::step_factor(sweeps, K_d); }

Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings) {
  return right::next_step(dt, fields, settings, step_factor);
}

State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps) {
  std::array<double, 2> stages{a(from.r), a(from.r)};
  for (int k = 0; k < sweeps; ++k) stages = right::sweep(a, from, dt, stages);
  return right::gauss2_end(from, dt, stages);
}
