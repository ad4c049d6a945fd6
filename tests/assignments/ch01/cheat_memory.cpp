// Accident: takes memory until there is none.
// graded: --variant 1|2 --student anna -> 0
// hint: memory ran out

#include <memory>
#include <vector>

#include "pair_law.hpp"

double strength(const PairLaw&, double d) {
  // It is not written to: what the first touch of a page takes is the machine's.
  std::vector<std::unique_ptr<char[]>> all;
  while (d > 0.0) all.push_back(std::make_unique_for_overwrite<char[]>(1 << 20));
  return 0.0;
}

double potential(const PairLaw&, double, double) { return 0.0; }

double equilibrium_distance(const PairLaw&) { return 0.0; }

double stiffness(const PairLaw&) { return 0.0; }

double period(const PairLaw&, double, double) { return 0.0; }
