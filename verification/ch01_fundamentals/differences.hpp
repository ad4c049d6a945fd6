#pragma once

#include <array>

/// @file
/// Derivatives by central differences of order 8, for checks that must not use the library's own derivatives.

namespace verification {

/// f'(0) from f(+-h) ... f(+-4h): the truncation error is h^8 f^(9)/630.
template <class F>
double slope_at_zero(const F& f, double h) {
  constexpr std::array weights{4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0};
  double sum = 0.0;
  for (int k = 4; k > 0; --k) sum += weights[static_cast<unsigned>(k - 1)] * (f(k * h) - f(-k * h));
  return sum / h;
}

/// f''(0) from f(0), f(+-h) ... f(+-4h): the truncation error is h^8 f^(10)/3150.
template <class F>
double curvature_at_zero(const F& f, double h) {
  constexpr std::array weights{8.0 / 5.0, -1.0 / 5.0, 8.0 / 315.0, -1.0 / 560.0};
  const double middle = f(0.0);
  double sum = 0.0;
  for (int k = 4; k > 0; --k) {
    sum += weights[static_cast<unsigned>(k - 1)] * ((f(k * h) - middle) + (f(-k * h) - middle));
  }
  return sum / (h * h);
}

}  // namespace verification
