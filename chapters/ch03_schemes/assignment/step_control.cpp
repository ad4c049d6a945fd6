#include "step_control.hpp"

// Fill the three holes. The brief is README.md; what each function must return stands in step_control.hpp.

double step_factor([[maybe_unused]] const Sweeps& sweeps, [[maybe_unused]] int K_d) { return 0.0; }

Decision next_step([[maybe_unused]] double dt, [[maybe_unused]] const std::vector<Sweeps>& fields,
                   [[maybe_unused]] const Settings& settings) {
  return {};
}

State gauss2_step([[maybe_unused]] const Acceleration& a, [[maybe_unused]] const State& from,
                  [[maybe_unused]] double dt, [[maybe_unused]] int sweeps) {
  return {};
}
