#pragma once

#include <functional>

#include <Eigen/Core>

/// @file
/// The header to keep: write these functions in bounce.cpp, and change nothing here. Only your variant is to be coded,
/// which the head of the score table names: run the check once to learn it.

/// Share of unpolarized light that is reflected where it comes to an interface.
/// @param n_hat  refractive index behind the interface over that before it, > 0 [-]
/// @param angle  between the ray and the normal (variant 1), or the surface (variant 2), 0 to pi/2 [rad]
/// @return R, 0 to 1 [-]
double reflectance(double n_hat, double angle);

/// A ray of light.
struct Ray {
  Eigen::Vector3d place;      ///< where it is [m]
  Eigen::Vector3d direction;  ///< where it goes, a unit vector [-]
  double power = 0.0;         ///< what it carries, > 0 [W]
};

/// A ball.
struct Sphere {
  Eigen::Vector3d centre;  ///< [m]
  double radius = 0.0;     ///< > 0 [m]
};

/// Share of the light that is reflected, at an angle of your variant [rad].
using Share = std::function<double(double angle)>;

/// What becomes of a ray that has just come to a sphere from outside.
/// @param ray     its place is on the surface
/// @param sphere  keeps what it does not reflect
/// @param share   which part of the power is reflected
/// @return the reflected ray, at the same place
Ray bounce(const Ray& ray, const Sphere& sphere, const Share& share);
