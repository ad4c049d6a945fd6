#pragma once

#include <cmath>
#include <numbers>

#include "rebound.hpp"

// What a student may well write; where one function needs another, it calls the one handed in. Submissions with one
// mistake take the rest from here; what tells the variants apart is the inverse mass of j.
namespace right {

using Eigen::Vector3d;

inline Vector3d normal(double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  return {std::cos(angle), std::sin(angle), 0.0};
}

inline double reduced_mass(const Body& i, const Body& j) { return i.m * j.m / (i.m + j.m); }

// What is often taken for the reduced mass.
inline double not_inverted(const Body& i, const Body& j) { return 1.0 / i.m + 1.0 / j.m; }

inline double normal_impulse(const Body& i, const Body& j, const Vector3d& n, double e) {
  const double u = (i.v - j.v).dot(n);
  return u > 0.0 ? -(1.0 + e) * reduced_mass(i, j) * u : 0.0;
}

inline Vector3d slip(const Body& i, const Body& j, const Vector3d& n) {
  const Vector3d relative = i.v - j.v;
  return relative - relative.dot(n) * n;
}

// What sticking needs if it may use so much, else sliding against a velocity.
inline Vector3d friction(const Body& i, const Body& j, const Vector3d& n, const Surface& surface, const Vector3d& w,
                         const Vector3d& to_stick) {
  const double J = std::abs(::normal_impulse(i, j, n, surface.e));
  if (to_stick.norm() <= surface.mu_s * J) return to_stick;
  return -surface.mu_d * J / w.norm() * w;
}

inline Vector3d friction_impulse(const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
  const Vector3d w = slip(i, j, n);
  return friction(i, j, n, surface, w, -reduced_mass(i, j) * w);
}

inline Vector3d impulse(const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
  return ::normal_impulse(i, j, n, surface.e) * n + ::friction_impulse(i, j, n, surface);
}

inline Velocities impact(const Body& i, const Body& j, const Vector3d& n, const Surface& surface) {
  const Vector3d of_i = impulse(i, j, n, surface);
  return {.i = i.v + of_i / i.m, .j = j.v - of_i / j.m};
}

}  // namespace right
