// Accident: a loop without end, in two lines of the table.
// graded: --variant 1|2 --student anna -> 0
// hint: took too long
// hint: a loop does not end

#include "pair_law.hpp"

double strength(const PairLaw&, double) { return 0.0; }

double potential(const PairLaw&, double, double) { return 0.0; }

double equilibrium_distance(const PairLaw&) {
  for (volatile double x = 1.0; x > 0.0;) x = x + 1.0;
  return 0.0;
}

double stiffness(const PairLaw&) { return 0.0; }

double period(const PairLaw&, double, double) { return 0.0; }
