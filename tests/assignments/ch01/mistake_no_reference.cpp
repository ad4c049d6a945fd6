// Mistake: the potential is zero at infinity, not at d_ref.
// graded: --variant 1 --student anna -> 5
// graded: --variant 1 --student bob@school.edu -> 5
// hint: V is measured from d_ref

#include "right.hpp"

double strength(const PairLaw& law, double d) { return right::strength(law, d); }

double potential(const PairLaw& law, double d, [[maybe_unused]] double d_ref) {
  const auto term = [&](double alpha, double beta) { return alpha * std::pow(d, 1.0 - beta) / (1.0 - beta); };
  return term(law.alpha1, law.beta1) - term(law.alpha2, law.beta2);
}

double equilibrium_distance(const PairLaw& law) { return right::equilibrium_distance(law); }

double stiffness(const PairLaw& law) { return right::stiffness(law); }

double period(const PairLaw& law, double m_i, double m_j) { return right::period(law, m_i, m_j); }
