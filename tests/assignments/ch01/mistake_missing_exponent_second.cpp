// Mistake, in the second variant's law: the exponent of the attraction does not become a factor of its slope.
// graded: --variant 2 --student anna -> 5
// graded: --variant 2 --student bob@school.edu -> 5
// graded: --variant 2 --student 1234567 -> 5
// hint: the factor beta1 is missing in V
// never: forty orders
// never: sign: at a stable equilibrium
// never: term by term

#include <cmath>
#include <numbers>

#include "pair_law.hpp"

namespace {

// The integral of x^exponent from d_ref to d.
double integral(double exponent, double d, double d_ref) {
  const double next = exponent + 1.0, logarithm = std::log(d / d_ref);
  return next == 0.0 ? logarithm : std::pow(d_ref, next) * std::expm1(next * logarithm) / next;
}

}  // namespace

double strength(const PairLaw& law, double d) {
  return law.alpha1 * std::pow(d, law.beta1) - law.alpha2 * std::pow(d, -law.beta2);
}

double potential(const PairLaw& law, double d, double d_ref) {
  return law.alpha1 * integral(law.beta1, d, d_ref) - law.alpha2 * integral(-law.beta2, d, d_ref);
}

double equilibrium_distance(const PairLaw& law) {
  return std::pow(law.alpha2 / law.alpha1, 1.0 / (law.beta1 + law.beta2));
}

double stiffness(const PairLaw& law) {
  const double d_e = equilibrium_distance(law);
  return law.alpha1 * std::pow(d_e, law.beta1 - 1.0) + law.alpha2 * law.beta2 * std::pow(d_e, -law.beta2 - 1.0);
}

double period(const PairLaw& law, double m_i, double m_j) {
  return 2.0 * std::numbers::pi * std::sqrt(m_i * m_j / (m_i + m_j) / stiffness(law));
}
