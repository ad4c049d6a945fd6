// Mistake: the strengths are swapped in the equilibrium, and stiffness and period are taken there.
// graded: --variant 1 --student anna -> 5
// graded: --variant 1 --student bob@school.edu -> 5
// hint: d_e is upside down
// never: term by term

#include "right.hpp"

double strength(const PairLaw& law, double d) { return right::strength(law, d); }

double potential(const PairLaw& law, double d, double d_ref) { return right::potential(law, d, d_ref); }

double equilibrium_distance(const PairLaw& law) {
  return std::pow(law.alpha1 / law.alpha2, 1.0 / (law.beta2 - law.beta1));
}

double stiffness(const PairLaw& law) {
  const double d_e = equilibrium_distance(law);
  return law.alpha2 * law.beta2 * std::pow(d_e, -law.beta2 - 1.0) -
         law.alpha1 * law.beta1 * std::pow(d_e, -law.beta1 - 1.0);
}

double period(const PairLaw& law, double m_i, double m_j) {
  return 2.0 * std::numbers::pi * std::sqrt(m_i * m_j / (m_i + m_j) / stiffness(law));
}
