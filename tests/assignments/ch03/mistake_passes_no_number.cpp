// Mistake: a field whose last change is no number is refused, but its factor is passed by.
// graded: --variant 1 --student anna -> 15
// graded: --variant 1 --student bob@school.edu -> 15
// graded: --variant 2 --student anna -> 15
// graded: --variant 2 --student bob@school.edu -> 15
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
