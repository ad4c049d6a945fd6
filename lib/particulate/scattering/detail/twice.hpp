#pragma once

#include <cmath>

namespace particulate::scattering::detail {

// A number with twice the digits of a double, as the sum of two of them: differences of nearly equal amplitudes then
// keep all that a double has. Dekker's and Knuth's operations; numbers from some 1e-140 to 1e140.
struct Twice {
  double hi = 0.0, lo = 0.0;

  Twice() = default;
  Twice(double x) : hi(x) {}
  Twice(double high, double low) : hi(high + low), lo(low - (hi - high)) {}  // of which the first is much larger
  double value() const { return hi + lo; }
};

inline Twice exact_sum(double a, double b) {
  const double sum = a + b, of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

inline Twice exact_product(double a, double b) {
  constexpr double splitter = 134217729.0;  // 2^27 + 1
  const double wide_a = splitter * a, a_hi = wide_a - (wide_a - a), a_lo = a - a_hi;
  const double wide_b = splitter * b, b_hi = wide_b - (wide_b - b), b_lo = b - b_hi;
  const double product = a * b;
  return {product, ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo};
}

inline Twice operator+(const Twice& a, const Twice& b) {
  const Twice high = exact_sum(a.hi, b.hi), low = exact_sum(a.lo, b.lo);
  const Twice sum{high.hi, high.lo + low.hi};
  return {sum.hi, sum.lo + low.lo};
}
inline Twice operator-(const Twice& a, const Twice& b) { return a + Twice{-b.hi, -b.lo}; }

inline Twice operator*(const Twice& a, const Twice& b) {
  const Twice high = exact_product(a.hi, b.hi);
  return {high.hi, high.lo + (a.hi * b.lo + a.lo * b.hi)};
}

inline Twice operator/(const Twice& a, const Twice& b) {
  const double first = a.hi / b.hi;
  const Twice left = a - b * Twice{first};
  return {first, left.value() / b.hi};
}

inline Twice root(const Twice& a) {
  const double first = std::sqrt(a.hi);
  if (!(first > 0.0)) return first;
  return {first, (a - exact_product(first, first)).value() / (2.0 * first)};
}

}  // namespace particulate::scattering::detail
