#pragma once

#include <particulate/kinematics/central_force.hpp>
#include <particulate/laws/law.hpp>

/// @file
/// A law of the cases' own: a centre that does not move, so that momenta are not conserved.

namespace verification {

/// Pulls every particle towards a fixed place, as in section 1.2 of the monograph.
struct FixedCentre {
  Eigen::Vector3d place;                      ///< [m]
  particulate::kinematics::CentralForce law;  ///< the same for every particle
};

inline bool add_force(const FixedCentre& centre, const particulate::kinematics::Space&,
                      const particulate::laws::At<>& at, particulate::laws::Forces force) {
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    force.row(i) +=
        particulate::kinematics::force(centre.law, at.position.row(i).transpose(), centre.place).transpose();
  }
  return force.allFinite();
}

}  // namespace verification
