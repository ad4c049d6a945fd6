#include "pair_law.hpp"

// Fill the five holes. The brief is README.md; what each function must return stands in pair_law.hpp.

double strength([[maybe_unused]] const PairLaw& law, [[maybe_unused]] double d) { return 0.0; }

double potential([[maybe_unused]] const PairLaw& law, [[maybe_unused]] double d, [[maybe_unused]] double d_ref) {
  return 0.0;
}

double equilibrium_distance([[maybe_unused]] const PairLaw& law) { return 0.0; }

double stiffness([[maybe_unused]] const PairLaw& law) { return 0.0; }

double period([[maybe_unused]] const PairLaw& law, [[maybe_unused]] double m_i, [[maybe_unused]] double m_j) {
  return 0.0;
}
