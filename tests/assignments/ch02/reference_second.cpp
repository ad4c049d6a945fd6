// The library itself: full marks for the second variant, whoever asks. A driven body has no inverse mass.
// graded: --variant 2 --student anna|bob@school.edu|1234567|carla-7 -> 20

#include <numbers>

#include <Eigen/Geometry>

#include <particulate/contact/impact.hpp>

#include "rebound.hpp"

namespace {

namespace contact = particulate::contact;

contact::Impulse impulse(const Body& i, const Body& j, const Eigen::Vector3d& n, const Surface& surface) {
  return contact::impact_impulse({.velocity = i.v, .inverse_mass = 1.0 / i.m}, {.velocity = j.v, .inverse_mass = 0.0},
                                 n, surface.e, {}, contact::Friction{.mu_s = surface.mu_s, .mu_d = surface.mu_d});
}

}  // namespace

Eigen::Vector3d normal(double degrees) {
  return Eigen::AngleAxisd(degrees / 180.0 * std::numbers::pi, Eigen::Vector3d::UnitZ()) * Eigen::Vector3d::UnitX();
}

double normal_impulse(const Body& i, const Body& j, const Eigen::Vector3d& n, double e) {
  return impulse(i, j, n, {.e = e}).normal;
}

Eigen::Vector3d friction_impulse(const Body& i, const Body& j, const Eigen::Vector3d& n, const Surface& surface) {
  return impulse(i, j, n, surface).tangential;
}

Velocities impact(const Body& i, const Body& j, const Eigen::Vector3d& n, const Surface& surface) {
  return {.i = i.v + impulse(i, j, n, surface).total(n) / i.m, .j = j.v};
}
