// Accident: waits for what does not come, in one line of the table.
// graded: --variant 1 --student anna -> 0
// hint: took too long

#include <unistd.h>

#include "pair_law.hpp"

double strength(const PairLaw&, double) { return 0.0; }

double potential(const PairLaw&, double, double) { return 0.0; }

double equilibrium_distance(const PairLaw&) { return 0.0; }

double stiffness(const PairLaw&) { return 0.0; }

double period(const PairLaw&, double, double m_j) {
  while (m_j > 1e20) pause();
  return 0.0;
}
