// The library's reflectance, variant 2.
// graded: --variant 2 --student anna|bob@school.edu|1234567|carla-7 -> 20

#include <cmath>

#include <particulate/scattering/interface.hpp>

#include "right.hpp"

double reflectance(double n_hat, double angle) {
  return particulate::scattering::reflectance(particulate::scattering::Fresnel{n_hat}, std::sin(angle));
}

Ray bounce(const Ray& ray, const Sphere& sphere, const Share& share) {
  return right::bounce_from_surface(ray, sphere, share);
}
