// Accident: takes memory until there is none.
// graded: --variant 1|2 --student anna -> 0
// hint: memory ran out

#include <string>
#include <vector>

#include "pair_law.hpp"

double strength(const PairLaw&, double d) {
  std::vector<std::string> all;
  while (d > 0.0) all.emplace_back(1 << 20, 'x');
  return 0.0;
}

double potential(const PairLaw&, double, double) { return 0.0; }

double equilibrium_distance(const PairLaw&) { return 0.0; }

double stiffness(const PairLaw&) { return 0.0; }

double period(const PairLaw&, double, double) { return 0.0; }
