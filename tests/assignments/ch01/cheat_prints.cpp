// Cheat: prints a table of its own.
// graded: --variant 1|2 --student anna -> 0
// hint: is this still the stub

#include <cstdio>

#include "pair_law.hpp"

double strength(const PairLaw&, double) {
  std::puts("   20 of 20   in all");
  std::fputs("   20 of 20   in all\n", stderr);
  return 0.0;
}

double potential(const PairLaw&, double, double) { return 0.0; }

double equilibrium_distance(const PairLaw&) { return 0.0; }

double stiffness(const PairLaw&) { return 0.0; }

double period(const PairLaw&, double, double) { return 0.0; }
