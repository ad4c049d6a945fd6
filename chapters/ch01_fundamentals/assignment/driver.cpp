#include "driver.hpp"

#include "pair_law.hpp"

namespace {

using Numbers = std::vector<double>;

PairLaw law_of(const Numbers& x) { return {.alpha1 = x[0], .alpha2 = x[1], .beta1 = x[2], .beta2 = x[3]}; }

}  // namespace

int main(int argc, char** argv) {
  return driver::answer(
      argc, argv,
      {{"strength", [](const Numbers& x) -> Numbers { return {strength(law_of(x), x[4])}; }},
       {"potential", [](const Numbers& x) -> Numbers { return {potential(law_of(x), x[4], x[5])}; }},
       {"equilibrium_distance", [](const Numbers& x) -> Numbers { return {equilibrium_distance(law_of(x))}; }},
       {"stiffness", [](const Numbers& x) -> Numbers { return {stiffness(law_of(x))}; }},
       {"period", [](const Numbers& x) -> Numbers { return {period(law_of(x), x[4], x[5])}; }}});
}
