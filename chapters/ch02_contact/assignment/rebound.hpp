#pragma once

#include <Eigen/Core>

/// @file
/// The header to keep: write these functions in rebound.cpp, and change nothing here. Only your variant is to be coded,
/// which the head of the score table names: run the check once to learn it.

/// One body of an impact. In variant 2 the body j is driven: no impact changes its velocity, whatever its mass.
struct Body {
  double m = 1.0;                               ///< mass, > 0 [kg]
  Eigen::Vector3d v = Eigen::Vector3d::Zero();  ///< velocity before the impact [m/s]
};

/// Where the bodies touch.
struct Surface {
  double e = 0.0;     ///< restitution, 0 <= e <= 1 [-]
  double mu_s = 0.0;  ///< static friction coefficient, >= mu_d [-]
  double mu_d = 0.0;  ///< dynamic friction coefficient, >= 0 [-]
};

/// Velocities after an impact.
struct Velocities {
  Eigen::Vector3d i = Eigen::Vector3d::Zero();  ///< of i [m/s]
  Eigen::Vector3d j = Eigen::Vector3d::Zero();  ///< of j [m/s]
};

/// Unit vector in the plane of x and y.
/// @param degrees  angle from the x axis towards the y axis, in degrees
/// @return n = (cos, sin, 0)
Eigen::Vector3d normal(double degrees);

/// Impulse on i along the normal.
/// @param i  one body
/// @param j  the other
/// @param n  unit vector from i to j
/// @param e  restitution, 0 <= e <= 1 [-]
/// @return J, negative because contacts push; 0 if the bodies do not approach one another [N s]
double normal_impulse(const Body& i, const Body& j, const Eigen::Vector3d& n, double e);

/// Impulse of friction on i, at a right angle to the normal: it sticks if it can, else it slides.
/// @param i        one body
/// @param j        the other
/// @param n        unit vector from i to j
/// @param surface  restitution and friction coefficients
/// @return P [N s]
Eigen::Vector3d friction_impulse(const Body& i, const Body& j, const Eigen::Vector3d& n, const Surface& surface);

/// Velocities after the impact.
/// @param i        one body
/// @param j        the other
/// @param n        unit vector from i to j
/// @param surface  restitution and friction coefficients
/// @return both velocities [m/s]
Velocities impact(const Body& i, const Body& j, const Eigen::Vector3d& n, const Surface& surface);
