// Mistake: the repulsion is added.
// graded: --variant 1 --student anna -> 5
// graded: --variant 1 --student bob@school.edu -> 5
// hint: repulsion is subtracted from attraction
// never: sign of the whole: attraction

#include "right.hpp"

double strength(const PairLaw& law, double d) {
  return law.alpha1 * std::pow(d, -law.beta1) + law.alpha2 * std::pow(d, -law.beta2);
}

double potential(const PairLaw& law, double d, double d_ref) { return right::potential(law, d, d_ref); }

double equilibrium_distance(const PairLaw& law) { return right::equilibrium_distance(law); }

double stiffness(const PairLaw& law) { return right::stiffness(law); }

double period(const PairLaw& law, double m_i, double m_j) { return right::period(law, m_i, m_j); }
