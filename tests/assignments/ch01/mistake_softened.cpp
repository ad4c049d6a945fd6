// Mistake: a small number keeps the distance from zero.
// graded: --variant 1 --student anna -> 15
// graded: --variant 1 --student bob@school.edu -> 15
// hint: add no small number to d

#include "right.hpp"

double strength(const PairLaw& law, double d) { return right::strength(law, d + 1e-13); }

double potential(const PairLaw& law, double d, double d_ref) { return right::potential(law, d, d_ref); }

double equilibrium_distance(const PairLaw& law) { return right::equilibrium_distance(law); }

double stiffness(const PairLaw& law) { return right::stiffness(law); }

double period(const PairLaw& law, double m_i, double m_j) { return right::period(law, m_i, m_j); }
