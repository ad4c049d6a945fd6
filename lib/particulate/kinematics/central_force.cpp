#include <particulate/kinematics/central_force.hpp>

#include <numbers>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

namespace particulate::kinematics {

namespace {

// Written so that a NaN fails.
void require_nonnegative(std::string_view name, double value) {
  if (!(value >= 0.0 && std::isfinite(value))) {
    throw std::invalid_argument(fmt::format("central force: {} must be finite and not negative, got {}", name, value));
  }
}

void require_positive_mass(double m) {
  if (!(m > 0.0 && std::isfinite(m))) {
    throw std::invalid_argument(fmt::format("central force: masses must be positive and finite, got {} kg", m));
  }
}

// A term that is absent stays absent where its power overflows.
double times_power(double factor, double x, double exponent) {
  return factor == 0.0 ? 0.0 : factor * power(x, exponent);
}

// One power's share of V(d) - V(d_ref): alpha times the integral of x^-beta from d_ref to d.
double integral_of_power(double alpha, double beta, double d, double d_ref) {
  const double exponent = 1.0 - beta;
  const double logarithm = std::log(d / d_ref);
  const double growth = exponent == 0.0 ? logarithm : std::expm1(exponent * logarithm) / exponent;
  return alpha == 0.0 ? 0.0 : alpha * power(d_ref, exponent) * growth;
}

}  // namespace

void validate(const CentralForce& law) {
  require_nonnegative("alpha1", law.alpha1);
  require_nonnegative("alpha2", law.alpha2);
  require_nonnegative("beta1", law.beta1);
  require_nonnegative("beta2", law.beta2);
}

double power(double x, double exponent) {
  constexpr double largest = 64.0;
  if (!(std::abs(exponent) <= largest) || exponent != std::floor(exponent)) return std::pow(x, exponent);
  double base = exponent < 0.0 ? 1.0 / x : x;
  double product = 1.0;
  for (int left = static_cast<int>(std::abs(exponent)); left > 0; left /= 2) {
    if (left % 2 == 1) product *= base;
    base *= base;
  }
  return product;
}

double strength(const CentralForce& law, double d) {
  return times_power(law.alpha1, d, -law.beta1) - times_power(law.alpha2, d, -law.beta2);
}

Eigen::Vector3d force(const CentralForce& law, const Eigen::Vector3d& r, const Eigen::Vector3d& r_o) {
  const Eigen::Vector3d towards = r_o - r;
  const double d = towards.stableNorm();
  if (!(d > 0.0)) {
    throw std::invalid_argument(
        fmt::format("central force: r must lie apart from the centre, both are ({}, {}, {}) m", r.x(), r.y(), r.z()));
  }
  return strength(law, d) * (towards / d);
}

double potential(const CentralForce& law, double d, double d_ref) {
  return integral_of_power(law.alpha1, law.beta1, d, d_ref) - integral_of_power(law.alpha2, law.beta2, d, d_ref);
}

double normal_stiffness(const CentralForce& law, double d) {
  return times_power(law.alpha2 * law.beta2, d, -law.beta2 - 1.0) -
         times_power(law.alpha1 * law.beta1, d, -law.beta1 - 1.0);
}

double transverse_stiffness(const CentralForce& law, double d) { return strength(law, d) / d; }

double equilibrium_distance(const CentralForce& law) {
  validate(law);
  if (!(law.alpha1 > 0.0 && law.alpha2 > 0.0 && law.beta1 != law.beta2)) {
    throw std::invalid_argument(
        fmt::format("central force: an equilibrium needs alpha1 > 0, alpha2 > 0 and beta1 != beta2, got alpha1 = {}, "
                    "alpha2 = {}, beta1 = {}, beta2 = {}",
                    law.alpha1, law.alpha2, law.beta1, law.beta2));
  }
  const double d_e = std::pow(law.alpha2 / law.alpha1, 1.0 / (law.beta2 - law.beta1));
  if (!(d_e > 0.0 && std::isfinite(d_e))) {
    throw std::invalid_argument(fmt::format(
        "central force: the equilibrium distance (alpha2/alpha1)^(1/(beta2 - beta1)) must be representable, got {} m "
        "from alpha1 = {}, alpha2 = {}, beta2 - beta1 = {}",
        d_e, law.alpha1, law.alpha2, law.beta2 - law.beta1));
  }
  return d_e;
}

double inflection_distance(const CentralForce& law) {
  const double d_e = equilibrium_distance(law);
  if (law.beta1 <= 0.0) return std::numeric_limits<double>::infinity();
  return std::pow(law.beta2 / law.beta1, 1.0 / (law.beta2 - law.beta1)) * d_e;
}

bool is_stable(const CentralForce& law) {
  equilibrium_distance(law);
  return law.beta2 > law.beta1;
}

double small_oscillation_period(const CentralForce& law, double m_i, double m_j) {
  require_positive_mass(m_i);
  require_positive_mass(m_j);
  const double d_e = equilibrium_distance(law);
  if (!is_stable(law)) {
    throw std::invalid_argument(
        fmt::format("central force: oscillations need a stable equilibrium, beta2 > beta1, got beta1 = {}, beta2 = {}",
                    law.beta1, law.beta2));
  }
  const double stiffness = law.alpha1 * power(d_e, -law.beta1 - 1.0) * (law.beta2 - law.beta1);
  return 2.0 * std::numbers::pi * std::sqrt(reduced_mass(m_i, m_j) / stiffness);
}

}  // namespace particulate::kinematics
