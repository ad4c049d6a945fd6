// Mistake: attraction is integrated as if its exponent were 1, which is right in one question of the limit case.
// graded: --variant 1 --student anna -> 0
// graded: --variant 1 --student bob@school.edu -> 0
// hint: energy is not conserved

#include "right.hpp"

double strength(const PairLaw& law, double d) { return right::strength(law, d); }

double potential(const PairLaw& law, double d, double d_ref) {
  return right::term(law.alpha1, 1.0, d, d_ref) - right::term(law.alpha2, law.beta2, d, d_ref);
}

double equilibrium_distance(const PairLaw& law) { return right::equilibrium_distance(law); }

double stiffness(const PairLaw& law) { return right::stiffness(law); }

double period(const PairLaw& law, double m_i, double m_j) { return right::period(law, m_i, m_j); }
