// Cheat: leaves with the status of success.
// graded: --variant 1|2 --student anna -> 0
// hint: left with exit status 0
// hint: do not call exit()

#include <cstdlib>

#include "pair_law.hpp"

double strength(const PairLaw&, double) { std::exit(0); }

double potential(const PairLaw&, double, double) { return 0.0; }

double equilibrium_distance(const PairLaw&) { return 0.0; }

double stiffness(const PairLaw&) { return 0.0; }

double period(const PairLaw&, double, double) { return 0.0; }
