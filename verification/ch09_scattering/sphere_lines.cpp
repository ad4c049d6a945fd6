// Straight lines through a cloud of spheres that repeats itself: chords of the spheres, and of what is between them.

#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/uniform.hpp>
#include <particulate/scattering/placement.hpp>
#include <particulate/scattering/trace.hpp>

namespace verification::sphere_lines {

using namespace particulate;
using namespace particulate::scattering;
using Eigen::Vector3d;

// Spheres in the unit cube that repeats itself, and all of their images about it that a line of length 1 may meet.
Cloud<Sphere> periodic_cloud(Eigen::Index N, double radius, Uniform& uniform) {
  const kinematics::Addition to{.domain = {.lengths = Vector3d::Ones()}};
  std::vector<Sphere> all;
  for (const Sphere& one : place_spheres(N, radius, to, [&] { return uniform(); }).bodies) {
    for (int image = 0; image < 27; ++image) {
      const Vector3d shift(image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1);
      all.push_back({one.centre + shift, radius});
    }
  }
  return Cloud<Sphere>(std::move(all), {.lengths = Vector3d::Constant(3.5), .corner = Vector3d::Constant(-1.25)});
}

// What a line of length 1 passes; whole pieces inside alone.
struct Passed {
  double between = 0.0, inside = 0.0;
  double entered = 0.0;
};
Passed along(const Cloud<Sphere>& cloud, Vector3d place, const Vector3d& d) {
  Passed passed;
  double t = 0.0;
  std::int32_t left = cloud.body_at(place);
  // The rest of the sphere in which the line starts.
  if (left >= 0) {
    const Sphere& body = cloud.bodies()[static_cast<std::size_t>(left)];
    const Vector3d from = place - body.centre;
    const double middle = -from.dot(d);
    t = middle + std::sqrt(middle * middle - from.squaredNorm() + body.radius * body.radius);
  }
  while (t < 1.0) {
    const auto [distance, body] = cloud.first_hit(place + t * d, d, left);
    passed.between += std::min(distance, 1.0 - t);
    t += distance;
    if (!(t < 1.0)) break;
    const Sphere& hit = cloud.bodies()[static_cast<std::size_t>(body)];
    const double chord = -2.0 * hit.radius * outward_normal(hit, place + t * d).dot(d);
    passed.entered += 1.0, passed.inside += chord;
    t += chord;
    left = body;
  }
  return passed;
}

// A ratio of two sums of pairs, and its standard error if it is r.
struct Ratio {
  double n = 0.0, above = 0.0, below = 0.0, squares = 0.0;

  void add(double a, double b, double r) { n += 1.0, above += a, below += b, squares += (a - r * b) * (a - r * b); }
  double value() const { return above / below; }
  double error() const { return std::sqrt(squares) / below; }
};

const Case lines{{.name = "chords_of_a_cloud",
                  .claim = "lines through a cloud of spheres that repeats itself are 4a/3 long inside of a sphere, and "
                           "4a(1 - phi)/(3 phi) between them, however dense it is",
                  .equation = "D 9.3",
                  .reference = Reference::closed_form},
                 [](Rows& rows) {
                   for (const double phi : {0.03, 0.3}) {
                     Uniform uniform(rows.case_seed());
                     const Eigen::Index N = 300;
                     const double a = std::cbrt(0.75 * phi / (std::numbers::pi * static_cast<double>(N)));
                     const double void_chord = 4.0 * a * (1.0 - phi) / (3.0 * phi), chord = 4.0 * a / 3.0;
                     const auto draw = [&] { return uniform(); };
                     const Cloud<Sphere> cloud = periodic_cloud(N, a, uniform);
                     Ratio between, inside;
                     for (long k = 0; k < (rows.quick() ? 20000 : 500000); ++k) {
                       const Vector3d place(draw(), draw(), draw());
                       const Passed passed = along(cloud, place, random_direction(draw));
                       between.add(passed.between, passed.entered, void_chord);
                       inside.add(passed.inside, passed.entered, chord);
                     }
                     const auto row = [&](const char* what, double expected, const Ratio& found) {
                       rows.compare(fmt::format("{}, phi = {} [radii]", what, phi),
                                    {.expected = expected / a,
                                     .computed = found.value() / a,
                                     .tolerance = absolute(4.0 * found.error() / a),
                                     .because = "four standard errors of a ratio"});
                     };
                     row("mean chord between spheres", void_chord, between);
                     row("mean chord inside of a sphere", chord, inside);
                   }
                 }};

}  // namespace verification::sphere_lines
