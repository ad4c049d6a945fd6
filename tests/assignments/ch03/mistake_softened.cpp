// Mistake: a small number keeps the quotients from 0/0.
// graded: --variant 1 --student anna -> 8
// graded: --variant 1 --student bob@school.edu -> 8
// graded: --variant 2 --student anna -> 8
// graded: --variant 2 --student bob@school.edu -> 8
// hint: no small number belongs into a quotient

#include "right.hpp"

double step_factor(const Sweeps& sweeps, int K_d) {
  const double small = 1e-12;
  const double wanted = std::pow(sweeps.TOL / (sweeps.w_0 + small), 1.0 / (sweeps.p * K_d));
  return wanted / std::pow((sweeps.w_K + small) / (sweeps.w_0 + small), 1.0 / (sweeps.p * sweeps.K));
}

Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings) {
  return right::next_step(dt, fields, settings, step_factor);
}

State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps) {
  return right::gauss2_step(a, from, dt, sweeps);
}
