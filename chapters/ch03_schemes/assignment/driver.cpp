#include "driver.hpp"

#include "step_control.hpp"

namespace {

using Numbers = std::vector<double>;

Sweeps sweeps_at(const Numbers& x, std::size_t k) {
  return {
      .w_0 = x[k], .w_K = x[k + 1], .K = static_cast<int>(x[k + 2]), .p = static_cast<int>(x[k + 3]), .TOL = x[k + 4]};
}

}  // namespace

int main(int argc, char** argv) {
  return driver::answer(
      argc, argv,
      {{"step_factor",
        [](const Numbers& x) -> Numbers { return {step_factor(sweeps_at(x, 0), static_cast<int>(x[5]))}; }},
       {"next_step",
        [](const Numbers& x) -> Numbers {
          const Settings settings{
              .K_d = static_cast<int>(x[1]), .limit = x[2], .growth = x[3], .retry = x[4], .shrink = x[5]};
          std::vector<Sweeps> fields;
          for (std::size_t k = 6; k < x.size(); k += 5) fields.push_back(sweeps_at(x, k));
          const Decision decision = next_step(x[0], fields, settings);
          return {decision.accepted ? 1.0 : 0.0, decision.next};
        }},
       {"gauss2_step", [](const Numbers& x) -> Numbers {
          const auto acceleration = [&](double r) { return (x[5] / r - x[4]) / (r * r) - x[6] * r; };
          const State end = gauss2_step(acceleration, {.r = x[0], .v = x[1]}, x[2], static_cast<int>(x[3]));
          return {end.r, end.v};
        }}});
}
