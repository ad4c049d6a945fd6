#include "driver.hpp"

#include <cmath>

#include "bounce.hpp"

namespace {

using Numbers = std::vector<double>;

// Inputs: n_hat angle.
Numbers of_reflectance(const Numbers& x) { return {reflectance(x[0], x[1])}; }

// Inputs: direction[3] place[3] centre[3] radius power a b. The share that is reflected is a + b angle.
Ray bounced(const Numbers& x) {
  const auto vector = [&](std::size_t k) { return Eigen::Vector3d(x[k], x[k + 1], x[k + 2]); };
  return bounce({vector(3), vector(0), x[10]}, {vector(6), x[9]}, [&](double angle) { return x[11] + x[12] * angle; });
}
Numbers of_direction(const Numbers& x) {
  const Ray ray = bounced(x);
  return {ray.direction[0], ray.direction[1], ray.direction[2]};
}
Numbers of_power(const Numbers& x) { return {bounced(x).power}; }

// Inputs: n_hat. A beam along x meets a sphere: F, and what is left of its x component. Rays are at the nodes of
// Gauss's rule of three points, in so many parts of cos theta that its error does not count, each at another place of
// its ring.
Numbers of_sphere(const Numbers& x) {
  constexpr int parts = 200;
  const Sphere sphere{{3.0, -2.0, 1.0}, 0.5};
  double F = 0.0, along = 0.0;
  for (int k = 0; k < parts; ++k) {
    for (const int node : {-1, 0, 1}) {
      const double c = (k + 0.5 + 0.5 * node * std::sqrt(0.6)) / parts, s = std::sqrt((1.0 - c) * (1.0 + c));
      const double around = 2.4 * k + node, weight = 2.0 * c * (node == 0 ? 8.0 : 5.0) / (18.0 * parts);
      const Eigen::Vector3d normal(-c, s * std::cos(around), s * std::sin(around));
      const Ray ray = bounce({sphere.centre + sphere.radius * normal, Eigen::Vector3d::UnitX(), weight}, sphere,
                             [&](double angle) { return reflectance(x[0], angle); });
      F += ray.power;
      along += ray.power * ray.direction[0];
    }
  }
  return {F, along};
}

}  // namespace

int main(int argc, char** argv) {
  return driver::answer(argc, argv,
                        {{"reflectance", of_reflectance},
                         {"direction_after", of_direction},
                         {"power_after", of_power},
                         {"sphere", of_sphere}});
}
