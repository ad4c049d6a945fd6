// Rays through bodies of each shape, for the table of what a segment costs: scattering_cost <traces>... runs all of
// them.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <harness/counted_program.hpp>
#include <harness/uniform.hpp>
#include <particulate/scattering/beam.hpp>
#include <particulate/scattering/placement.hpp>
#include <particulate/scattering/stepped.hpp>

namespace {

using namespace particulate::scattering;
using Eigen::Vector3d;
using verification::CountedRun;
using verification::CountedScene;

constexpr Fresnel law{10.0};
constexpr Eigen::Index N = 200;
constexpr double fraction = 0.1;
const particulate::kinematics::Addition within{.inside = particulate::kinematics::Inside::spheres};

// The size of a body of which so many fill the fraction of the unit cube, if one of size 1 has a volume.
double size_of(double volume) { return std::cbrt(fraction / (static_cast<double>(N) * volume)); }

template <class Place>
auto cloud_of(const Place& place) {
  verification::Uniform uniform(1);
  return Cloud(place([&] { return uniform(); }).bodies, particulate::kinematics::Box{});
}
const double radius = size_of(volume(Sphere{})), equatorial = size_of(0.25 * volume(Sphere{})),
             cell_radius = size_of(volume(RedCell{.radius = 1.0}));
const Cloud<Sphere> spheres = cloud_of([](const auto& draw) { return place_spheres(N, radius, within, draw); });
const Cloud<Spheroid> oblates = cloud_of([](const auto& draw) {
  return place_spheroids(N, {.equatorial = equatorial, .polar = 0.25 * equatorial}, within, draw);
});
const Cloud<RedCell> cells =
    cloud_of([](const auto& draw) { return place_red_cells(N, {.radius = cell_radius}, within, draw); });

// Spheroids that are the spheres of the other cloud.
Cloud<Spheroid> round_spheroids() {
  std::vector<Spheroid> all;
  for (const Sphere& one : spheres.bodies()) {
    all.push_back({.centre = one.centre, .equatorial = one.radius, .polar = one.radius});
  }
  return Cloud<Spheroid>(std::move(all), spheres.box());
}
const Cloud<Spheroid> rounds = round_spheroids();

const Rays rays = [] {
  verification::Uniform uniform(2);
  return rays_of({.centre = {0.0, 0.5, 0.5}, .width = 0.5}, 128, [&] { return uniform(); });
}();

// The same rays, time and again, by any tracer.
template <class Trace>
CountedRun traced(long times, const Trace& trace_rays) {
  CountedRun run;
  for (long k = 0; k < times; ++k) {
    const Traced one = trace_rays();
    run.particles = one.ledger.segments, run.impacts += one.ledger.hits;
    run.sum += one.ledger.x + static_cast<double>(one.paths.size());
  }
  return run;
}
template <class B>
CountedRun exact(long times, const Cloud<B>& cloud, const TraceSettings& settings = {}) {
  return traced(times, [&] { return trace(cloud, law, rays, settings); });
}
CountedRun in_steps(long times) {
  return traced(times, [] { return trace_in_steps(spheres, law, rays, {.xi = 0.5}); });
}

// What no tracer can leave out, and nothing else: the next hit, the reflection, and the sum of what is asked for.
CountedRun bare(long times) {
  CountedRun run;
  for (long k = 0; k < times; ++k) {
    run.particles = 0;
    for (Eigen::Index i = 0; i < rays.size(); ++i) {
      Vector3d place = rays.place.row(i), d = rays.direction.row(i);
      double power = rays.power[i];
      for (auto hit = spheres.first_hit(place, d);; hit = spheres.first_hit(place, d, hit.body)) {
        ++run.particles;
        if (hit.body < 0) break;
        place += hit.distance * d;
        const Vector3d normal = outward_normal(spheres.bodies()[static_cast<std::size_t>(hit.body)], place);
        const double approach = -d.dot(normal);
        power *= reflectance(law, std::min(approach, 1.0));
        d = (d + 2.0 * approach * normal).normalized();
        ++run.impacts;
      }
      run.sum += power * d[0];
    }
  }
  return run;
}

const std::array all{CountedScene{"bare", bare},
                     CountedScene{"spheres", [](long n) { return exact(n, spheres); }},
                     CountedScene{"paths", [](long n) { return exact(n, spheres, {.keeps_paths = true}); }},
                     CountedScene{"rounds", [](long n) { return exact(n, rounds); }},
                     CountedScene{"oblates", [](long n) { return exact(n, oblates); }},
                     CountedScene{"red_cells", [](long n) { return exact(n, cells); }},
                     CountedScene{"stepped", in_steps}};

}  // namespace

int main(int argc, char** argv) { return verification::counted_program(argc, argv, all); }
