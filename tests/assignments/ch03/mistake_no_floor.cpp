// Mistake: an accepted step may be followed by a smaller one.
// graded: --variant 1 --student anna -> 16
// graded: --variant 1 --student bob@school.edu -> 16
// graded: --variant 2 --student anna -> 16
// graded: --variant 2 --student bob@school.edu -> 16
// hint: after an accepted step the next is not smaller

#include "right.hpp"

double step_factor(const Sweeps& sweeps, int K_d) { return right::step_factor(sweeps, K_d); }

Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings) {
  const bool accepted = right::is_accepted(fields);
  const double phi = right::smallest(fields, settings, step_factor);
  const double factor = accepted ? std::min(phi, settings.growth) : right::bounded(phi, accepted, settings);
  return {.accepted = accepted, .next = std::min(settings.limit, factor * dt)};
}

State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps) {
  return right::gauss2_step(a, from, dt, sweeps);
}
