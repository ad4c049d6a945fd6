// Cheat: not a number compares with nothing.
// graded: --variant 1|2 --student anna -> 0
// hint: not a finite number

#include <cmath>

#include "pair_law.hpp"

double strength(const PairLaw&, double) { return std::nan(""); }

double potential(const PairLaw&, double, double) { return std::nan(""); }

double equilibrium_distance(const PairLaw&) { return std::nan(""); }

double stiffness(const PairLaw&) { return std::nan(""); }

double period(const PairLaw&, double, double) { return std::nan(""); }
