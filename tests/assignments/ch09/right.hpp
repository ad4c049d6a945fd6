#pragma once

#include <cmath>
#include <numbers>

#include "bounce.hpp"

// What a student may well write, for both variants.
namespace right {

using Eigen::Vector3d;

// Of both polarizations, given cosine and sine of the angle of incidence.
struct Amplitudes {
  double along, across;
};
inline Amplitudes amplitudes(double n, double cosine, double root) {
  return {(n * n * cosine - root) / (n * n * cosine + root), (cosine - root) / (cosine + root)};
}

inline double mean_of_squares(const Amplitudes& r) { return 0.5 * (r.along * r.along + r.across * r.across); }

template <auto share = mean_of_squares>
double share_of(double n, double cosine, double sine) {
  if (sine >= n) return 1.0;
  return share(amplitudes(n, cosine, std::sqrt(n * n - sine * sine)));
}

inline double from_normal(double n, double angle) { return share_of(n, std::cos(angle), std::sin(angle)); }
inline double from_surface(double n, double angle) { return share_of(n, std::sin(angle), std::cos(angle)); }

inline Vector3d normal(const Ray& ray, const Sphere& sphere) { return (ray.place - sphere.centre).normalized(); }

inline Vector3d mirrored(const Ray& ray, const Sphere& sphere) {
  const Vector3d n = normal(ray, sphere);
  return ray.direction - 2.0 * ray.direction.dot(n) * n;
}

inline double incidence(const Ray& ray, const Sphere& sphere) {
  return std::acos(-ray.direction.dot(normal(ray, sphere)));
}

inline Ray bounce(const Ray& ray, const Sphere& sphere, const Share& share) {
  return {ray.place, mirrored(ray, sphere), share(incidence(ray, sphere)) * ray.power};
}

inline Ray bounce_from_surface(const Ray& ray, const Sphere& sphere, const Share& share) {
  return {ray.place, mirrored(ray, sphere), share(0.5 * std::numbers::pi - incidence(ray, sphere)) * ray.power};
}

}  // namespace right
