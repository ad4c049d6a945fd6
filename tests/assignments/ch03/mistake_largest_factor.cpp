// Mistake: the largest factor rules.
// graded: --variant 2 --student anna -> 8
// graded: --variant 2 --student bob@school.edu -> 8
// hint: the smallest Phi_K of all fields rules, not the largest

#include "right.hpp"

double step_factor(const Sweeps& sweeps, int K_d) { return right::step_factor(sweeps, K_d); }

Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings) {
  double largest = 0.0;
  for (const Sweeps& field : fields) {
    if (std::isfinite(field.w_K)) largest = std::max(largest, step_factor(field, settings.K_d));
  }
  const bool accepted = right::is_accepted(fields);
  return {.accepted = accepted, .next = std::min(settings.limit, right::bounded(largest, accepted, settings) * dt)};
}

State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps) {
  return right::gauss2_step(a, from, dt, sweeps);
}
