#pragma once

#include <complex>
#include <vector>

/// @file
/// Pade approximations of the exponential function, from their factorials alone.

namespace verification {

/// Coefficients of the numerator of the (k, j) Pade approximation of exp, k the degree of the numerator:
/// \f$ (j + k - i)!\,k!/((j + k)!\,i!\,(k - i)!) \f$; the denominator is that of (j, k) at -z.
///
/// @param k  degree, >= 0 [-]
/// @param j  degree of the denominator, >= 0 [-]
/// @return k + 1 coefficients, of 1, z, z^2, ...
inline std::vector<long double> pade_numerator(int k, int j) {
  std::vector<long double> of{1.0L};
  for (int i = 1; i <= k; ++i) of.push_back(of.back() * (k - i + 1) / (static_cast<long double>(i) * (j + k - i + 1)));
  return of;
}

/// @param of  coefficients of 1, z, z^2, ...
/// @param z   where
/// @return the polynomial there
inline std::complex<long double> polynomial(const std::vector<long double>& of, std::complex<long double> z) {
  std::complex<long double> sum = 0.0L;
  for (auto coefficient = of.rbegin(); coefficient != of.rend(); ++coefficient) sum = sum * z + *coefficient;
  return sum;
}

/// The (k, j) Pade approximation of exp.
///
/// @param k  degree of the numerator [-]
/// @param j  degree of the denominator [-]
/// @param z  where
/// @return its value
inline std::complex<double> pade(int k, int j, std::complex<double> z) {
  const std::complex<long double> at(z);
  return std::complex<double>(polynomial(pade_numerator(k, j), at) / polynomial(pade_numerator(j, k), -at));
}

}  // namespace verification
