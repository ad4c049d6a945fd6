// Mistake: a step that meets TOL exactly is refused.
// graded: --variant 1 --student anna -> 16
// graded: --variant 1 --student bob@school.edu -> 16
// graded: --variant 2 --student anna -> 16
// graded: --variant 2 --student bob@school.edu -> 16
// hint: a step that meets TOL exactly stands

#include "right.hpp"

double step_factor(const Sweeps& sweeps, int K_d) { return right::step_factor(sweeps, K_d); }

Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings) {
  const bool accepted =
      std::all_of(fields.begin(), fields.end(), [](const Sweeps& field) { return field.w_K < field.TOL; });
  const double phi = right::smallest(fields, settings, step_factor);
  return {.accepted = accepted, .next = std::min(settings.limit, right::bounded(phi, accepted, settings) * dt)};
}

State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps) {
  return right::gauss2_step(a, from, dt, sweeps);
}
