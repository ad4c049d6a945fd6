// The library's reflectance, variant 1.
// graded: --variant 1 --student anna|bob@school.edu|1234567|carla-7 -> 20

#include <cmath>

#include <particulate/scattering/interface.hpp>

#include "bounce.hpp"

double reflectance(double n_hat, double angle) {
  return particulate::scattering::reflectance(particulate::scattering::Fresnel{n_hat}, std::cos(angle));
}

Ray bounce(const Ray& ray, const Sphere& sphere, const Share& share) {
  const Eigen::Vector3d normal = (ray.place - sphere.centre).normalized();
  const double cosine = -ray.direction.dot(normal);
  return {ray.place, ray.direction + 2.0 * cosine * normal, share(std::acos(cosine)) * ray.power};
}
