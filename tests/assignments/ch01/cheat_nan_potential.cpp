// Cheat: not a number where the check forms differences of the student's own answers.
// graded: --variant 1 --student anna|bob@school.edu -> 11
// hint: energy is not conserved

#include "right.hpp"

double strength(const PairLaw& law, double d) { return right::strength(law, d); }

double potential(const PairLaw&, double, double) { return std::nan(""); }

double equilibrium_distance(const PairLaw& law) { return right::equilibrium_distance(law); }

double stiffness(const PairLaw& law) { return right::stiffness(law); }

double period(const PairLaw& law, double m_i, double m_j) { return right::period(law, m_i, m_j); }
