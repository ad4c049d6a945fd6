#pragma once

#include <algorithm>
#include <utility>

#include "mating.hpp"

// What a student may well write, for both variants, in parts: submissions with one mistake replace one of them.
namespace right {

using Eigen::Index;
using Parents = std::pair<Index, Index> (*)(Index child, Index K);

inline std::pair<Index, Index> by_twos(Index child, Index) { return {child - child % 2, child - child % 2 + 1}; }

inline std::pair<Index, Index> in_a_row(Index child, Index K) { return {child, (child + 1) % K}; }

inline double between(double a, double b, double phi) {
  return std::clamp(phi * a + (1.0 - phi) * b, std::min(a, b), std::max(a, b));
}

// Makes each parameter k of each child of those of its parents.
template <class Make>
void mate_where(Eigen::MatrixXd& strings, Index K, Parents parents, const Make& make) {
  for (Index child = 0; child < K; ++child) {
    const auto [i, j] = parents(child, K);
    for (Index k = 0; k < strings.rows(); ++k) strings(k, K + child) = make(child, k, strings(k, i), strings(k, j));
  }
}

template <Parents parents>
void mate(Eigen::MatrixXd& strings, Index K, const Uniform& uniform) {
  mate_where(strings, K, parents, [&](Index, Index, double a, double b) { return between(a, b, uniform()); });
}

}  // namespace right
