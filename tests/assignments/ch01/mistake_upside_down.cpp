// Mistake: the strengths are swapped in the equilibrium.
// graded: --variant 1 --student anna -> 10
// graded: --variant 1 --student bob@school.edu -> 10
// hint: more repulsion

#include "right.hpp"

double strength(const PairLaw& law, double d) { return right::strength(law, d); }

double potential(const PairLaw& law, double d, double d_ref) { return right::potential(law, d, d_ref); }

double equilibrium_distance(const PairLaw& law) {
  return std::pow(law.alpha1 / law.alpha2, 1.0 / (law.beta2 - law.beta1));
}

double stiffness(const PairLaw& law) { return right::stiffness(law); }

double period(const PairLaw& law, double m_i, double m_j) { return right::period(law, m_i, m_j); }
