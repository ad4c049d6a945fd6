// Mistake: one body oscillates, the other is thought to be fixed.
// graded: --variant 1 --student anna -> 10
// graded: --variant 1 --student bob@school.edu -> 10
// hint: take the reduced mass

#include "right.hpp"

double strength(const PairLaw& law, double d) { return right::strength(law, d); }

double potential(const PairLaw& law, double d, double d_ref) { return right::potential(law, d, d_ref); }

double equilibrium_distance(const PairLaw& law) { return right::equilibrium_distance(law); }

double stiffness(const PairLaw& law) { return right::stiffness(law); }

double period(const PairLaw& law, double m_i, [[maybe_unused]] double m_j) {
  return 2.0 * std::numbers::pi * std::sqrt(m_i / right::stiffness(law));
}
