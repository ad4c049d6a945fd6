// Mistake: a field whose last change is no number is refused, but its factor is passed by.
// graded: --variant 1 --student anna -> 16
// graded: --variant 1 --student bob@school.edu -> 16
// graded: --variant 2 --student anna -> 16
// graded: --variant 2 --student bob@school.edu -> 16
// hint: a field whose w_K is NaN or infinite counts with Phi_K = 0
// never: not the largest

#include "right.hpp"

double step_factor(const Sweeps& sweeps, int K_d) { return right::step_factor(sweeps, K_d); }

Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings) {
  const bool accepted = right::is_accepted(fields);
  double phi = std::numeric_limits<double>::infinity();
  for (const Sweeps& field : fields) phi = std::min(phi, step_factor(field, settings.K_d));
  return {.accepted = accepted, .next = std::min(settings.limit, right::bounded(phi, accepted, settings) * dt)};
}

State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps) {
  return right::gauss2_step(a, from, dt, sweeps);
}
