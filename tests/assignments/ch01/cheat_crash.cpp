// Accident: an index far out of bounds.
// graded: --variant 1|2 --student anna -> 0
// hint: crashed
// hint: an index or a pointer is wrong

#include "pair_law.hpp"

double strength(const PairLaw& law, double d) {
  const volatile double* const values = &law.alpha1;
  return values[static_cast<long>(d * 1e12) + 1000000000000];
}

double potential(const PairLaw&, double, double) { return 0.0; }

double equilibrium_distance(const PairLaw&) { return 0.0; }

double stiffness(const PairLaw&) { return 0.0; }

double period(const PairLaw&, double, double) { return 0.0; }
