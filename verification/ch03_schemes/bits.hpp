#pragma once

#include <particulate/schemes/problem.hpp>

/// @file
/// Equality to the last bit.

namespace verification {

/// @return numbers of two states that are not equal, the time among them
inline long differing(const particulate::schemes::State& one, const particulate::schemes::State& other) {
  return static_cast<long>(one.t != other.t) + (one.r.array() != other.r.array()).count() +
         (one.v.array() != other.v.array()).count() + (one.y.array() != other.y.array()).count();
}

}  // namespace verification
