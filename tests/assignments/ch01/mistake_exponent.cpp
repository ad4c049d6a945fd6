// Mistake: integrated powers keep their exponent.
// graded: --variant 1 --student anna -> 0
// graded: --variant 1 --student bob@school.edu -> 0
// hint: integrating a power raises it by one

#include "right.hpp"

double strength(const PairLaw& law, double d) { return right::strength(law, d); }

double potential(const PairLaw& law, double d, double d_ref) {
  const auto term = [](double alpha, double beta, double at) { return alpha * std::pow(at, -beta) / (1.0 - beta); };
  return term(law.alpha1, law.beta1, d) - term(law.alpha1, law.beta1, d_ref) -
         (term(law.alpha2, law.beta2, d) - term(law.alpha2, law.beta2, d_ref));
}

double equilibrium_distance(const PairLaw& law) { return right::equilibrium_distance(law); }

double stiffness(const PairLaw& law) { return right::stiffness(law); }

double period(const PairLaw& law, double m_i, double m_j) { return right::period(law, m_i, m_j); }
