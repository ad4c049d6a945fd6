// Mistake: a reduced mass with a factor 1/2 that is right nowhere.
// graded: --variant 1 --student anna -> 5
// graded: --variant 1 --student bob@school.edu -> 5
// hint: factor sqrt 2

#include "right.hpp"

double strength(const PairLaw& law, double d) { return right::strength(law, d); }

double potential(const PairLaw& law, double d, double d_ref) { return right::potential(law, d, d_ref); }

double equilibrium_distance(const PairLaw& law) { return right::equilibrium_distance(law); }

double stiffness(const PairLaw& law) { return right::stiffness(law); }

double period(const PairLaw& law, double m_i, double m_j) {
  return 2.0 * std::numbers::pi * std::sqrt(0.5 * m_i * m_j / (m_i + m_j) / right::stiffness(law));
}
