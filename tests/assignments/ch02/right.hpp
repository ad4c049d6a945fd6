#pragma once

#include <cmath>
#include <numbers>

#include "rebound.hpp"

// What a student may well write. Submissions with one mistake take the rest from here; what tells the variants apart is
// the inverse mass of j.
namespace right {

using Eigen::Vector3d;

inline Vector3d normal(double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  return {std::cos(angle), std::sin(angle), 0.0};
}

inline double reduced_mass(const Body& i, const Body& j) { return i.m * j.m / (i.m + j.m); }

inline double normal_impulse(const Body& i, const Body& j, const Vector3d& n, double e) {
  const double u = (i.v - j.v).dot(n);
  return u > 0.0 ? -(1.0 + e) * right::reduced_mass(i, j) * u : 0.0;
}

// Of friction that goes with a normal impulse J.
inline Vector3d friction(const Vector3d& slip, double mass, double J, double mu_s, double mu_d) {
  const double most = mass * slip.norm();
  if (most <= mu_s * std::abs(J)) return -mass * slip;
  return -mu_d * std::abs(J) / slip.norm() * slip;
}

inline Vector3d slip(const Body& i, const Body& j, const Vector3d& n) {
  const Vector3d relative = i.v - j.v;
  return relative - relative.dot(n) * n;
}

inline Vector3d friction_impulse(const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
  const double J = right::normal_impulse(i, j, n, surface.e);
  return friction(slip(i, j, n), right::reduced_mass(i, j), J, surface.mu_s, surface.mu_d);
}

inline Velocities after(const Body& i, const Body& j, const Vector3d& impulse) {
  return {.i = i.v + impulse / i.m, .j = j.v - impulse / j.m};
}

}  // namespace right
