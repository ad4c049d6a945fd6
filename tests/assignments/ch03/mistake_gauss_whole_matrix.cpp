// Mistake: A is taken where A A belongs.
// graded: --variant 1 --student anna -> 16
// graded: --variant 2 --student bob@school.edu -> 16
// hint: A_bar = A A, not A

#include "right.hpp"

double step_factor(const Sweeps& sweeps, int K_d) { return right::step_factor(sweeps, K_d); }

Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings) {
  return right::next_step(dt, fields, settings, step_factor);
}

State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps) {
  const double root = std::sqrt(3.0);
  std::array<double, 2> stages{};
  for (int k = 0; k < sweeps; ++k) {
    const std::array<double, 2> last = stages;
    stages = {a(from.r + (0.5 - root / 6) * dt * from.v + dt * dt * (last[0] / 4 + (0.25 - root / 6) * last[1])),
              a(from.r + (0.5 + root / 6) * dt * from.v + dt * dt * ((0.25 + root / 6) * last[0] + last[1] / 4))};
  }
  return right::gauss2_end(from, dt, stages);
}
