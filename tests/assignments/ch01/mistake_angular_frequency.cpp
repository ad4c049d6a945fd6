// Mistake: the angular frequency is inverted and 2 pi forgotten.
// graded: --variant 1 --student anna -> 5
// graded: --variant 1 --student bob@school.edu -> 5
// hint: factor 2 pi

#include "right.hpp"

double strength(const PairLaw& law, double d) { return right::strength(law, d); }

double potential(const PairLaw& law, double d, double d_ref) { return right::potential(law, d, d_ref); }

double equilibrium_distance(const PairLaw& law) { return right::equilibrium_distance(law); }

double stiffness(const PairLaw& law) { return right::stiffness(law); }

double period(const PairLaw& law, double m_i, double m_j) {
  return std::sqrt(m_i * m_j / (m_i + m_j) / right::stiffness(law));
}
