// Mistake: nothing is done about 1 - beta = 0, and 0/0 is not a number.
// graded: --variant 1 --student anna -> 15
// graded: --variant 1 --student bob@school.edu -> 15
// hint: the integral of 1/d is a logarithm

#include "right.hpp"

double strength(const PairLaw& law, double d) { return right::strength(law, d); }

double potential(const PairLaw& law, double d, double d_ref) {
  const auto term = [&](double alpha, double beta) {
    return alpha * (std::pow(d, 1.0 - beta) - std::pow(d_ref, 1.0 - beta)) / (1.0 - beta);
  };
  return term(law.alpha1, law.beta1) - term(law.alpha2, law.beta2);
}

double equilibrium_distance(const PairLaw& law) { return right::equilibrium_distance(law); }

double stiffness(const PairLaw& law) { return right::stiffness(law); }

double period(const PairLaw& law, double m_i, double m_j) { return right::period(law, m_i, m_j); }
