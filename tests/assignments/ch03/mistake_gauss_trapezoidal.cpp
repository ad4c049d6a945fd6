// Mistake: the nodes and weights of the trapezoidal rule.
// graded: --variant 1 --student anna -> 16
// graded: --variant 2 --student bob@school.edu -> 16
// hint: the trapezoidal rule

#include "right.hpp"

double step_factor(const Sweeps& sweeps, int K_d) { return right::step_factor(sweeps, K_d); }

Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings) {
  return right::next_step(dt, fields, settings, step_factor);
}

State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps) {
  double end = 0.0, start = 0.0;
  for (int k = 0; k < sweeps; ++k) {
    const double place = from.r + dt * from.v + 0.25 * dt * dt * (start + end);
    start = a(from.r);
    end = a(place);
  }
  return {.r = from.r + dt * from.v + 0.25 * dt * dt * (start + end), .v = from.v + 0.5 * dt * (start + end)};
}
