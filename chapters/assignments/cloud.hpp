#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

/// @file
/// Random clouds that a check and a driver make alike, so that a question names one by a number and stays short.

namespace cloud {

/// Three numbers, one a direction: a place as a share of a box, in [0, 1), or a cell.
template <class T>
using Three = std::array<T, 3>;

/// @param seed  whose cloud
/// @param N     of how many bodies
/// @return their places, in shares of a box
inline std::vector<Three<double>> shares(std::uint64_t seed, std::size_t N) {
  std::mt19937_64 engine(seed);
  std::vector<Three<double>> all(N);
  for (Three<double>& one : all) {
    for (double& x : one) x = std::ldexp(static_cast<double>(engine() >> 11), -53);
  }
  return all;
}

/// @param share  a place
/// @param cells  how many in each direction
/// @return its cell
inline Three<int> cell(const Three<double>& share, const Three<int>& cells) {
  Three<int> at{};
  for (std::size_t k = 0; k < 3; ++k) at[k] = std::min(static_cast<int>(share[k] * cells[k]), cells[k] - 1);
  return at;
}

/// @param a       a place
/// @param b       another
/// @param length  of the box [m]
/// @param wraps   whether it repeats itself, in each direction
/// @return square of the distance to the nearest image [m^2]
template <class Lengths, class Wraps>
double squared_distance(const Three<double>& a, const Three<double>& b, const Lengths& length, const Wraps& wraps) {
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double apart = std::abs(a[k] - b[k]);
    const double d = length[k] * (wraps[k] ? std::min(apart, 1.0 - apart) : apart);
    sum += d * d;
  }
  return sum;
}

}  // namespace cloud
