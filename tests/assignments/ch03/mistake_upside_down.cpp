// Mistake: the factor is upside down.
// graded: --variant 1 --student anna -> 4
// graded: --variant 1 --student bob@school.edu -> 4
// graded: --variant 2 --student anna -> 4
// graded: --variant 2 --student bob@school.edu -> 4
// hint: the ratio is inverted

#include "right.hpp"

double step_factor(const Sweeps& sweeps, int K_d) {
  return sweeps.w_K == 0.0 || sweeps.K == 0 ? std::numeric_limits<double>::infinity()
                                            : 1.0 / right::step_factor(sweeps, K_d);
}

Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings) {
  return right::next_step(dt, fields, settings, step_factor);
}

State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps) {
  return right::gauss2_step(a, from, dt, sweeps);
}
