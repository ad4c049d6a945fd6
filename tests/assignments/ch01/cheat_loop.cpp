// Accident: a loop without end.
// graded: --variant 1|2 --student anna -> 0
// hint: took too long
// hint: a loop does not end

#include "pair_law.hpp"

double strength(const PairLaw&, double d) {
  volatile double x = d;
  while (x > 0.0) x = x + 1.0;
  return x;
}

double potential(const PairLaw&, double, double) { return 0.0; }

double equilibrium_distance(const PairLaw&) { return 0.0; }

double stiffness(const PairLaw&) { return 0.0; }

double period(const PairLaw&, double, double) { return 0.0; }
