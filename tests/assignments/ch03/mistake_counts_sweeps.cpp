// Mistake: sweeps are counted, one more than contractions.
// graded: --variant 1 --student anna -> 4
// graded: --variant 1 --student bob@school.edu -> 4
// graded: --variant 2 --student anna -> 4
// graded: --variant 2 --student bob@school.edu -> 4
// hint: K counts contractions, not sweeps

#include "right.hpp"

double step_factor(const Sweeps& sweeps, int K_d) {
  Sweeps other = sweeps;
  if (sweeps.K > 0) ++other.K;
  return right::step_factor(other, K_d);
}

Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings) {
  return right::next_step(dt, fields, settings, step_factor);
}

State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps) {
  return right::gauss2_step(a, from, dt, sweeps);
}
