#pragma once

#include <cmath>
#include <numbers>

#include "pair_law.hpp"

// What a student may well write for the first variant; where one function needs another, it calls the one handed in.
// Submissions with one mistake take the rest from here.
namespace right {

inline double strength(const PairLaw& law, double d) {
  return law.alpha1 * std::pow(d, -law.beta1) - law.alpha2 * std::pow(d, -law.beta2);
}

inline double term(double alpha, double beta, double d, double d_ref) {
  const double x = 1.0 - beta, logarithm = std::log(d / d_ref);
  return x == 0.0 ? alpha * logarithm : alpha * std::pow(d_ref, x) * std::expm1(x * logarithm) / x;
}

inline double potential(const PairLaw& law, double d, double d_ref) {
  return term(law.alpha1, law.beta1, d, d_ref) - term(law.alpha2, law.beta2, d, d_ref);
}

inline double equilibrium_distance(const PairLaw& law) {
  return std::pow(law.alpha2 / law.alpha1, 1.0 / (law.beta2 - law.beta1));
}

// The slope of the strength at d_e.
inline double stiffness_at(const PairLaw& law, double d_e) {
  return -law.alpha1 * law.beta1 * std::pow(d_e, -law.beta1 - 1.0) +
         law.alpha2 * law.beta2 * std::pow(d_e, -law.beta2 - 1.0);
}

inline double stiffness(const PairLaw& law) { return stiffness_at(law, ::equilibrium_distance(law)); }

inline double period(const PairLaw& law, double m_i, double m_j) {
  return 2.0 * std::numbers::pi * std::sqrt(m_i * m_j / (m_i + m_j) / ::stiffness(law));
}

}  // namespace right
