#pragma once

#include <particulate/report/spread.hpp>

/// @file
/// What runs change of what a fluid holds.

namespace verification {

/// Of mass, momentum and energy, each over what its case says.
struct Change {
  double mass = 0.0, momentum = 0.0, energy = 0.0;
  /// Keeps the larger of each. @param other  another run's
  void see(const Change& other) {
    using particulate::report::worse_of;
    mass = worse_of(mass, other.mass), momentum = worse_of(momentum, other.momentum);
    energy = worse_of(energy, other.energy);
  }
};

}  // namespace verification
