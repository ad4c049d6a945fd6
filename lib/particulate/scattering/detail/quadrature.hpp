#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace particulate::scattering::detail {

// Gauss and Legendre's rule of ten points; a half of them, the others are their mirror images.
template <class F>
double ten_points(const F& f, double from, double to) {
  constexpr std::array<double, 5> nodes{0.14887433898163121088, 0.43339539412924719080, 0.67940956829902440623,
                                        0.86506336668898451073, 0.97390652851717172008};
  constexpr std::array<double, 5> weights{0.29552422471475287017, 0.26926671930999635509, 0.21908636251598204400,
                                          0.14945134915058059315, 0.06667134430868813759};
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  double sum = 0.0;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    sum += weights[k] * (f(middle - half * nodes[k]) + f(middle + half * nodes[k]));
  }
  return half * sum;
}

// The integral of f, whose size is about 1, in intervals that are halved until two halves agree with the whole: towards
// the root of a kink they shrink.
template <class F>
double integral(const F& f, double from, double to, double whole, int depth) {
  const double middle = 0.5 * (from + to);
  const double left = ten_points(f, from, middle), right = ten_points(f, middle, to);
  if (depth == 0 || std::abs(left + right - whole) <= 1e-15 * (to - from)) return left + right;
  return integral(f, from, middle, left, depth - 1) + integral(f, middle, to, right, depth - 1);
}
template <class F>
double integral(const F& f, double from, double to) {
  return integral(f, from, to, ten_points(f, from, to), 40);
}

}  // namespace particulate::scattering::detail
