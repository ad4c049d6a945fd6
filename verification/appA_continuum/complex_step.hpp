#pragma once

#include <algorithm>
#include <cmath>
#include <complex>

#include <particulate/continuum/deformation.hpp>

/// @file
/// Derivatives to rounding, what a case draws at random, and the largest of its errors.

namespace verification {

using Complex = std::complex<double>;
inline constexpr double complex_step = 1e-50;

inline double over_step(const Complex& z) { return z.imag() / complex_step; }
template <int Rows, int Columns>
Eigen::Matrix<double, Rows, Columns> over_step(const Eigen::Matrix<Complex, Rows, Columns>& z) {
  return z.imag() / complex_step;
}
/// @param f  analytic: takes a Complex and returns one, or a matrix of them
/// @return its derivative at s
template <class Function>
auto derivative(const Function& f, double s) {
  return over_step(f(Complex(s, complex_step)));
}

/// Keeps the larger of two sizes, and NaN once there is one.
inline void keep_larger(double& worst, double error, double size = 1.0) {
  const double relative = std::abs(error) / size;
  worst = std::isnan(relative) ? relative : std::max(worst, relative);
}

/// Entries evenly distributed from -1 to 1.
template <class Draw>
particulate::continuum::Tensor<double> random_tensor(Draw& uniform) {
  particulate::continuum::Tensor<double> result;
  for (int k = 0; k < 9; ++k) result(k / 3, k % 3) = 2.0 * uniform() - 1.0;
  return result;
}
/// A rotation about the axis (1, 1, 1)/sqrt(3), after Rodrigues.
/// @param angle  [rad]
inline particulate::continuum::Tensor<double> rotation(double angle) {
  using particulate::continuum::Tensor;
  Tensor<double> K;
  K << 0.0, -1.0, 1.0, 1.0, 0.0, -1.0, -1.0, 1.0, 0.0;
  K /= std::sqrt(3.0);
  return Tensor<double>::Identity() + std::sin(angle) * K + (1.0 - std::cos(angle)) * K * K;
}

}  // namespace verification
