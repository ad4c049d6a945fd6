#include "fifty_digits.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace verification {

double equilibrium_in_fifty_digits(double alpha1, double alpha2, double beta1, double beta2) {
  using Digits50 = boost::multiprecision::cpp_bin_float_50;
  const Digits50 exponent = 1 / (Digits50(beta2) - Digits50(beta1));
  return static_cast<double>(pow(Digits50(alpha2) / Digits50(alpha1), exponent));
}

double potential_in_fifty_digits(double d, double d_ref, double beta) {
  using Digits50 = boost::multiprecision::cpp_bin_float_50;
  const Digits50 exponent = 1 - Digits50(beta);
  return static_cast<double>((pow(Digits50(d), exponent) - pow(Digits50(d_ref), exponent)) / exponent);
}

particulate::kinematics::Radial breathing_in_fifty_digits(double alpha2, double t) {
  using boost::multiprecision::sqrt;
  using Digits50 = boost::multiprecision::cpp_bin_float_50;
  const Digits50 two_depth = 2 - Digits50(alpha2);  // 2|E| for alpha1 = r_0 = 1
  const Digits50 a = 1 / two_depth, eps = 1 / a - 1, n = sqrt(2 / (a * a * a));
  const Digits50 pi = boost::math::constants::pi<Digits50>();
  // The start is the outer turning point, xi = pi.
  const Digits50 mean = n * Digits50(t) + pi;
  Digits50 low = mean - 2, high = mean + 2;
  for (int k = 0; k < 165; ++k) {
    const Digits50 xi = (low + high) / 2;
    (xi - eps * sin(xi) < mean ? low : high) = xi;
  }
  const Digits50 r = a * (1 - eps * cos(low));
  return {.r = static_cast<double>(r), .v = static_cast<double>(a * eps * sin(low) * n * a / r)};
}

}  // namespace verification
