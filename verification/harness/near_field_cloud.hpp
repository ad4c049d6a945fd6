#pragma once

#include <cstdint>

#include <particulate/kinematics/domain.hpp>
#include <particulate/kinematics/particles.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/scenes/scene.hpp>

/// @file
/// Clouds of particles under near fields.

namespace verification {

using NearFieldScene = particulate::scenes::Scene<particulate::kinematics::Space, particulate::laws::NearField>;

/// What a cloud is made of.
struct Cloud {
  Eigen::Index N = 20;   ///< particles [-]
  double spacing = 1.0;  ///< of the lattice from which they are moved by up to a quarter [m]
  double speed = 0.2;    ///< largest velocity component [m/s]
  double decades = 0.3;  ///< masses are 10^x, x uniform in [-decades, decades] [-]
};

/// Particles near the points of a cubic lattice, no two nearer than half a spacing, everything else at random.
particulate::kinematics::Particles random_cloud(const Cloud& of, std::uint64_t seed);

/// The cloud on which methods are compared: unit masses near a lattice, attracted and repelled at equal strength.
///
/// It falls in upon itself within the 1 s of the races. A hundred at 1.4 m, and a thousand at 1.6 m, fall to about half
/// their size without a close encounter: whatever a method loses there it loses by its order and its work, not by the
/// luck of a step. A thousand at 1.4 m fall to a third, and the nearest to a tenth of a metre: they ask for shorter
/// steps towards the end.
///
/// @param N        particles [-]
/// @param seed     of their places and velocities
/// @param spacing  of the lattice [m]
/// @return the scene
NearFieldScene near_field_cloud(Eigen::Index N, std::uint64_t seed, double spacing);

}  // namespace verification
