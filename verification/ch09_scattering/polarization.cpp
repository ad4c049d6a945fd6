// What is left out: the tracer takes light as unpolarized at every reflection. A tracer of this case's own carries its
// polarization from one to the next.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Dense>

#include <harness/case.hpp>
#include <harness/uniform.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/report/table.hpp>
#include <particulate/scattering/beam.hpp>
#include <particulate/scattering/placement.hpp>

namespace verification::polarization {

using namespace particulate;
using namespace particulate::scattering;
using Eigen::Matrix3d, Eigen::Vector3d;

// A ray whose field E has the mean products C = <E E^T>, across its direction; their trace is its power. Circular
// polarization is left out, as real amplitudes never turn it into power.
struct PolarizedRay {
  Vector3d place, direction;
  Matrix3d C;
};
Matrix3d unpolarized(const Vector3d& direction, double power) {
  return 0.5 * power * (Matrix3d::Identity() - direction * direction.transpose());
}

// Parts of E across and in the plane of incidence are reflected with amplitudes of their own.
void reflect(const Fresnel& law, const Vector3d& normal, PolarizedRay& ray) {
  const Vector3d d = ray.direction, turned = (d - 2.0 * d.dot(normal) * normal).normalized();
  const double cosine = std::min(-d.dot(normal), 1.0);
  // At normal incidence both parts are alike, and any direction will do.
  const Vector3d across = d.cross(normal).norm() > 1e-12 ? d.cross(normal).normalized() : d.unitOrthogonal();
  const Matrix3d E = r_perpendicular(law, cosine) * across * across.transpose() +
                     r_parallel(law, cosine) * turned.cross(across) * d.cross(across).transpose();
  ray = {ray.place, turned, E * ray.C * E.transpose()};
}

// Follows a ray until nothing is on its way. With forgetting it is unpolarized after each reflection.
template <class B>
void follow(const Cloud<B>& cloud, const Fresnel& law, bool forgets, PolarizedRay& ray) {
  for (std::int32_t left = -1;;) {
    const auto [distance, body] = cloud.first_hit(ray.place, ray.direction, left);
    if (body < 0) return;
    ray.place += distance * ray.direction;
    reflect(law, outward_normal(cloud.bodies()[static_cast<std::size_t>(body)], ray.place), ray);
    if (forgets) ray.C = unpolarized(ray.direction, ray.C.trace());
    left = body;
  }
}
double x_share(const Cloud<Sphere>& cloud, const Fresnel& law, const Rays& rays, bool forgets) {
  double x = 0.0;
  for (Eigen::Index i = 0; i < rays.size(); ++i) {
    const Vector3d d = rays.direction.row(i);
    PolarizedRay ray{rays.place.row(i), d, unpolarized(d, rays.power[i])};
    follow(cloud, law, forgets, ray);
    x += ray.C.trace() * ray.direction[0];
  }
  return x / rays.power.sum();
}

// Up at 45 degrees, back at normal incidence, and out the way it came, all in one plane.
void check_one_plane(Rows& rows) {
  const double aside = 0.1 / std::sqrt(2.0), c = std::sqrt(0.5);
  const Cloud<Sphere> cloud({{{0.5, 0.5 - aside, 0.5}, 0.1}, {{0.5 - aside, 0.9, 0.5}, 0.1}}, {});
  PolarizedRay ray{{0.0, 0.5, 0.5}, Vector3d::UnitX(), unpolarized(Vector3d::UnitX(), 1.0)};
  follow(cloud, Fresnel{1.5}, false, ray);
  const double s = std::sqrt(1.5 * 1.5 - 0.5), across = (c - s) / (c + s), along = (2.25 * c - s) / (2.25 * c + s);
  rows.compare("45 degrees, normal incidence, 45 degrees in one plane, n^ = 1.5",
               {.expected = 0.02 * (std::pow(across, 4) + std::pow(along, 4)),
                .computed = ray.C.trace(),
                .tolerance = relative(1e-12),
                .because = "roundings that a curved mirror enlarges"});
}

const Case size{
    {.name = "polarization_left_out",
     .claim = "polarization carried from one reflection to the next would change I_x by at most 6e-4 of I(0)",
     .equation = "R 9.3",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      check_one_plane(rows);
      report::Table table({"n^", "L", "I_x", "change by polarization", "standard error of the change"});
      const int clouds = rows.quick() ? 4 : 40;
      double largest = 0.0, off = 0.0;
      for (const double n_hat : {1.5, 2.0, 4.0, 10.0, 32.0}) {
        const Fresnel law{n_hat};
        for (const double L : {0.25, 0.325, 0.4}) {
          double sum = 0.0, squares = 0.0, x = 0.0;
          for (int k = 0; k < clouds; ++k) {
            Uniform uniform(rows.case_seed() + static_cast<std::uint64_t>(k));
            const auto draw = [&] { return uniform(); };
            const Cloud<Sphere> cloud(
                place_spheres(1000, 0.1 * L, {.inside = kinematics::Inside::spheres}, draw).bodies, {});
            const Rays rays = rays_of({.centre = {0.0, 0.5, 0.5}, .width = 0.5}, 1000, draw);
            const Ledger ledger = trace(cloud, law, rays).ledger;
            off = report::worse_of(off, std::abs(x_share(cloud, law, rays, true) - ledger.x / ledger.incident));
            const double change = x_share(cloud, law, rays, false) - ledger.x / ledger.incident;
            sum += change / clouds, squares += change * change / clouds, x += ledger.x / ledger.incident / clouds;
          }
          table.add({n_hat, L, x, sum, std::sqrt((squares - sum * sum) / (clouds - 1))});
          largest = report::worse_of(largest, std::abs(sum));
        }
      }
      rows.compare("the same tracer, made to forget polarization: largest difference from the library",
                   {.expected = 0.0, .computed = off, .tolerance = absolute(1e-12), .because = "rounding"});
      rows.at_most("largest change of I_x/I(0)",
                   {.limit = 6e-4, .computed = largest, .because = "what a throw-away prototype found at most"});
      rows.at_least("largest change of I_x/I(0), which is there",
                    {.limit = 1e-4, .computed = largest, .because = "else nothing was carried"});
      rows.write("polarization", table);
    }};

}  // namespace verification::polarization
