// Right, without the library: plain powers as the brief writes them.
// graded: --variant 1 --student anna|bob@school.edu|1234567 -> 20

#include "right.hpp"

double strength(const PairLaw& law, double d) { return right::strength(law, d); }

double potential(const PairLaw& law, double d, double d_ref) { return right::potential(law, d, d_ref); }

double equilibrium_distance(const PairLaw& law) { return right::equilibrium_distance(law); }

double stiffness(const PairLaw& law) { return right::stiffness(law); }

double period(const PairLaw& law, double m_i, double m_j) { return right::period(law, m_i, m_j); }
