#pragma once

#include <array>
#include <cmath>
#include <cstddef>

/// @file
/// Numbers that carry their derivatives, so that what a formula should obey is asked of its exact derivatives.

namespace verification {

/// A function of time and place at one point: its value, its derivatives by t, x, y and z, and the second ones.
///
/// @tparam N  how many of those four there are
template <std::size_t N>
struct Jet {
  double value = 0.0;
  std::array<double, N> first{};
  std::array<std::array<double, N>, N> second{};

  Jet(double constant = 0.0) : value(constant) {}
  /// @param axis  0 for t, 1 to 3 for places
  static Jet variable(double value, std::size_t axis) {
    Jet x(value);
    x.first[axis] = 1.0;
    return x;
  }
  /// The derivative by t (0), x, y or z, with its own first ones; its second ones are not known.
  Jet derivative(std::size_t axis) const {
    Jet r(first[axis]);
    r.first = second[axis];
    return r;
  }
  /// f of it, from f and its two derivatives.
  Jet through(double f, double df, double ddf) const {
    Jet r(f);
    for (std::size_t i = 0; i < N; ++i) {
      r.first[i] = df * first[i];
      for (std::size_t j = 0; j < N; ++j) r.second[i][j] = ddf * first[i] * first[j] + df * second[i][j];
    }
    return r;
  }

  friend Jet operator+(const Jet& a, const Jet& b) {
    Jet r(a.value + b.value);
    for (std::size_t i = 0; i < N; ++i) {
      r.first[i] = a.first[i] + b.first[i];
      for (std::size_t j = 0; j < N; ++j) r.second[i][j] = a.second[i][j] + b.second[i][j];
    }
    return r;
  }
  friend Jet operator*(const Jet& a, const Jet& b) {
    Jet r(a.value * b.value);
    for (std::size_t i = 0; i < N; ++i) {
      r.first[i] = a.first[i] * b.value + a.value * b.first[i];
      for (std::size_t j = 0; j < N; ++j) {
        r.second[i][j] =
            a.second[i][j] * b.value + a.first[i] * b.first[j] + a.first[j] * b.first[i] + a.value * b.second[i][j];
      }
    }
    return r;
  }
  friend Jet operator*(double s, const Jet& a) { return a.through(s * a.value, s, 0.0); }
  friend Jet operator-(const Jet& a) { return -1.0 * a; }
  friend Jet operator-(const Jet& a, const Jet& b) { return a + -b; }
  friend Jet operator/(const Jet& a, const Jet& b) {
    const double f = 1.0 / b.value;
    return a * b.through(f, -f * f, 2.0 * f * f * f);
  }
  friend Jet sin(const Jet& a) { return a.through(std::sin(a.value), std::cos(a.value), -std::sin(a.value)); }
  friend Jet cos(const Jet& a) { return a.through(std::cos(a.value), -std::sin(a.value), -std::cos(a.value)); }
  friend Jet exp(const Jet& a) { return a.through(std::exp(a.value), std::exp(a.value), std::exp(a.value)); }
};

}  // namespace verification
