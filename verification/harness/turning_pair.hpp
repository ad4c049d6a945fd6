#pragma once

#include <cmath>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <harness/breathing.hpp>

/// @file
/// A breathing pair that also turns, of masses 1 and 3: its angular momentum stiffens the repulsion.

namespace verification::turning {

inline constexpr double m_i = 1.0;      ///< [kg]
inline constexpr double m_j = 3.0;      ///< [kg]
inline constexpr double alpha1 = 1.0;   ///< attraction [N m^2/kg^2]
inline constexpr double alpha2 = 0.25;  ///< repulsion [N m^3/kg^2]
inline constexpr double l_z = 1.5;      ///< r^2 dphi/dt [m^2/s]

/// @return direction in which the pair turns at the start, across slanted()
inline Eigen::Vector3d across() { return {3.0 / 7.0, -6.0 / 7.0, 2.0 / 7.0}; }

/// @return the force along the pair, with what its turning adds
inline particulate::kinematics::RadialForce force() {
  return particulate::kinematics::breathing_pair(alpha1, alpha2, m_i, m_j, l_z);
}

/// @return the pair, 1 m apart along slanted(), about its centre of mass at rest
inline NearFieldScene pair() {
  particulate::kinematics::Particles start = pair_at_rest(m_i, m_j, 1.0);
  particulate::kinematics::set_vector(start.velocity, 0, -m_j / (m_i + m_j) * l_z * across());
  particulate::kinematics::set_vector(start.velocity, 1, m_i / (m_i + m_j) * l_z * across());
  return {start, {}, {.alpha1 = alpha1, .alpha2 = alpha2, .beta1 = 2.0, .beta2 = 3.0}};
}

/// The angle phi = int l_z/r^2 dt of one tenth of the radial period.
///
/// @param exact  the motion along the pair @param tenth  which one, from 1 @return angle [rad]
inline double turned(const particulate::kinematics::Breathing& exact, int tenth) {
  using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
  const auto rate = [&](double t) { return l_z / std::pow(exact.at(t).r, 2); };
  return Rule::integrate(rate, exact.period() * (tenth - 1) / 10.0, exact.period() * tenth / 10.0, 0);
}

}  // namespace verification::turning
