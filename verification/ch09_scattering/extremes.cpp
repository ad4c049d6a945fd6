// Clouds, rays and settings that must be borne, however extreme, and those that must be refused.

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <harness/uniform.hpp>
#include <particulate/scattering/beam.hpp>
#include <particulate/scattering/placement.hpp>
#include <particulate/scattering/stepped.hpp>

namespace verification::scattering_extremes {

using namespace particulate;
using namespace particulate::scattering;
using Eigen::Vector3d;

Ending within(double error, double tolerance, const char* because) {
  return Ending::solved({.error = error, .tolerance = tolerance, .because = because});
}

Rays one_ray(const Vector3d& place, const Vector3d& direction) {
  return {.place = place.transpose(), .direction = direction.transpose(), .power = Eigen::VectorXd::Ones(1)};
}
constexpr Fresnel law{2.0};
constexpr double at_normal = 1.0 / 9.0;  // R of that law
const kinematics::Box about_origin{.lengths = Vector3d::Constant(16.0), .corner = Vector3d::Constant(-8.0)};

double whole(const Ledger& ledger) {
  return std::accumulate(ledger.left.begin(), ledger.left.end(), ledger.absorbed + ledger.cut_off + ledger.inside);
}

// Two balls of radius 1 that touch at the origin.
const std::vector<Sphere> touching{{{0.0, 1.0, 0.0}, 1.0}, {{0.0, -1.0, 0.0}, 1.0}};

void solve_touching(Rows& rows) {
  rows.must_be_solved("a ray between two balls that touch, through the point of contact", [] {
    const Ledger ledger =
        trace(Cloud(touching, about_origin), law, one_ray({-4.0, 0.0, 0.0}, Vector3d::UnitX())).ledger;
    return within(std::abs(ledger.x - 1.0) + std::abs(whole(ledger) - 1.0), 1e-7,
                  "grazing to the root of a rounding, it keeps all of its power");
  });
  rows.must_be_solved("a ray along the line of the centres of both", [] {
    const Ledger ledger =
        trace(Cloud(touching, about_origin), law, one_ray({0.0, -4.0, 0.0}, Vector3d::UnitY())).ledger;
    return within(std::abs(ledger.left[2] - at_normal) + std::abs(whole(ledger) - 1.0), 1e-15, "normal incidence");
  });
  rows.must_be_solved("a ray into the wedge of both, aimed at the point of contact", [] {
    const Vector3d d = Vector3d(1.0, 1e-3, 0.0).normalized();
    const Traced traced = trace(Cloud(touching, about_origin), Fresnel{1e4}, one_ray(-4.0 * d, d));
    // A wedge that no ray gets through in its plane: it must come back, having met both.
    const bool back = traced.rays.direction(0, 0) < 0.0 && traced.absorbed.minCoeff() > 0.0;
    return within(back ? std::abs(whole(traced.ledger) - 1.0) : 1.0, 1e-14, "rounding of some hundred reflections");
  });
}

// What rays in the places of symmetry must do: to keep their direction or turn about.
void solve_symmetric(Rows& rows) {
  const auto solve = [&](const std::string& name, const auto& body, const Vector3d& from, const Vector3d& d, double x,
                         double tolerance, const char* because) {
    rows.must_be_solved(name, [&, from, d, x, tolerance, because] {
      const Traced traced = trace(Cloud(std::vector{body}, about_origin), law, one_ray(from, d));
      const double along = traced.rays.direction.row(0).dot(d.transpose()), left = x < 0.0 ? at_normal : 1.0;
      return within(std::abs(along - x) + std::abs(traced.rays.power[0] - left), tolerance, because);
    });
  };
  const Spheroid oblate{.equatorial = 1.0, .polar = 0.25}, prolate{.equatorial = 0.25, .polar = 1.0};
  const RedCell cell{.radius = 1.0};
  const Vector3d x = Vector3d::UnitX(), z = Vector3d::UnitZ(), y = Vector3d::UnitY();
  const char *turns = "normal incidence", *grazes = "a tangent to the root of a rounding, met or not";
  solve("a ray along the axis of an oblate", oblate, -4.0 * z, z, -1.0, 1e-15, turns);
  solve("a ray along the axis of a prolate", prolate, -4.0 * z, z, -1.0, 1e-15, turns);
  solve("a ray in the plane of an oblate's rim", oblate, -4.0 * x, x, -1.0, 1e-15, turns);
  solve("a ray in the plane of an oblate's rim, along it", oblate, y - 4.0 * x, x, 1.0, 1e-7, grazes);
  solve("a ray along the axis of a red cell", cell, -4.0 * z, z, -1.0, 1e-14, turns);
  solve("a ray in the plane of a red cell's rim", cell, -4.0 * x, x, -1.0, 1e-14, turns);
  solve("a ray in the plane of a red cell's rim, along it", cell, y - 4.0 * x, x, 1.0, 1e-7, grazes);
  solve("a ray along the axis of a red cell, past its rim", cell, x - 4.0 * z, z, 1.0, 1e-7, grazes);
}

// d_x = 1 - 2 cos^2 of the incidence, at a place whose normal is known.
void solve_slender(Rows& rows) {
  const auto solve = [&](const std::string& name, const Spheroid& body, double y, const Vector3d& normal) {
    rows.must_be_solved(name, [=] {
      const double cosine = normal[0] / normal.norm();
      const Traced traced =
          trace(Cloud(std::vector{body}, about_origin), law, one_ray({-4.0, y, 0.0}, Vector3d::UnitX()));
      return within(std::abs(traced.rays.direction(0, 0) - (1.0 - 2.0 * cosine * cosine)), 1e-12,
                    "a place that is rounded at a curvature of a thousand");
    });
  };
  solve("an oblate of 1000:1, face-on", {.axis = Vector3d::UnitX(), .equatorial = 1.0, .polar = 1e-3}, 0.6,
        {0.8e3, 0.6, 0.0});
  solve("an oblate of 1000:1, edge-on", {.axis = Vector3d::UnitY(), .equatorial = 1.0, .polar = 1e-3}, 0.6e-3,
        {0.8, 0.6e3, 0.0});
  solve("a prolate of 1000:1, end-on", {.axis = Vector3d::UnitX(), .equatorial = 1e-3, .polar = 1.0}, 0.6e-3,
        {0.8, 0.6e3, 0.0});
  solve("a prolate of 1000:1, from aside", {.axis = Vector3d::UnitY(), .equatorial = 1e-3, .polar = 1.0}, 0.6,
        {0.8e3, 0.6, 0.0});
}

const Beam beam{.centre = {0.0, 0.5, 0.5}, .width = 0.5};

void solve_counts(Rows& rows) {
  rows.must_be_solved("no body", [] {
    Uniform uniform(1);
    const Ledger ledger = trace(Cloud<Sphere>({}, {}), law, rays_of(beam, 100, [&] { return uniform(); })).ledger;
    return within(std::abs(ledger.forward_face() / 0.25 - 1.0), 1e-14, "rounding of a hundred sums");
  });
  rows.must_be_solved("no ray", [] {
    const Ledger ledger = trace(Cloud<Sphere>({{{0.5, 0.5, 0.5}, 0.1}}, {}), law, Rays{}).ledger;
    return within(ledger.incident + std::abs(ledger.x) + whole(ledger), 0.0, "nothing comes of nothing");
  });
  rows.must_be_solved("one ray", [] {
    const Ledger ledger =
        trace(Cloud<Sphere>({{{0.5, 0.5, 0.5}, 0.1}}, {}), law, one_ray({0.0, 0.5, 0.5}, Vector3d::UnitX())).ledger;
    return within(std::abs(ledger.backward_face() - at_normal), 1e-15, "normal incidence");
  });
  rows.must_be_solved("many bodies", [&] {
    Uniform uniform(2);
    const auto draw = [&] { return uniform(); };
    const Eigen::Index N = rows.quick() ? 20000 : 1000000;
    const double radius = 0.3 / std::cbrt(static_cast<double>(N));
    const Cloud<Sphere> cloud(place_spheres(N, radius, {.inside = kinematics::Inside::spheres}, draw).bodies, {});
    long wrong = 0;
    for (int k = 0; k < 100; ++k) {
      const Vector3d d = random_direction(draw), from = Vector3d(0.5, 0.5, 0.5) - 2.0 * d;
      double nearest = nowhere;
      for (const Sphere& body : cloud.bodies()) nearest = std::min(nearest, first_entry(body, from, d));
      wrong += cloud.first_hit(from, d).distance == nearest ? 0 : 1;
    }
    return within(static_cast<double>(wrong), 0.0, "the nearest of all that were asked, one by one");
  });
}

// I_x of one cloud in another unit of length.
double in_units_of(double length) {
  Uniform uniform(3);
  const auto draw = [&] { return uniform(); };
  std::vector<Sphere> spheres = place_spheres(300, 0.04, {.inside = kinematics::Inside::spheres}, draw).bodies;
  for (Sphere& each : spheres) each.centre *= length, each.radius *= length;
  Beam scaled = beam;
  scaled.centre *= length, scaled.width *= length;
  const Cloud<Sphere> cloud(std::move(spheres), {.lengths = Vector3d::Constant(length)});
  const Ledger ledger = trace(cloud, law, rays_of(scaled, 1024, draw)).ledger;
  return ledger.x / ledger.incident;
}

void solve_units(Rows& rows) {
  const auto solve = [&](const std::string& name, double length, double tolerance, const char* because) {
    rows.must_be_solved(name,
                        [=] { return within(std::abs(in_units_of(length) - in_units_of(1.0)), tolerance, because); });
  };
  solve("a box of 2^-30 m", std::ldexp(1.0, -30), 0.0, "a power of two changes no bit");
  solve("a box of 2^30 m", std::ldexp(1.0, 30), 0.0, "a power of two changes no bit");
  solve("a box of 1e-9 m", 1e-9, 1e-10, "a reflection enlarges roundings some 25 times and keeps a sixth");
  solve("a box of 1e9 m", 1e9, 1e-10, "a reflection enlarges roundings some 25 times and keeps a sixth");
}

const Case solved{{.name = "scattering_extremes_solved",
                   .claim = "bodies that touch, rays in planes of symmetry, slender bodies, none and many of them, and "
                            "boxes of any size are traced",
                   .equation = "R 9.3",
                   .reference = Reference::closed_form},
                  [](Rows& rows) {
                    solve_touching(rows);
                    solve_symmetric(rows);
                    solve_slender(rows);
                    solve_counts(rows);
                    solve_units(rows);
                  }};

// A call that must not come to its end.
void refuse(Rows& rows, const std::string& name, const std::string& key_words, const std::function<void()>& call) {
  rows.must_be_refused(name, key_words, [&] {
    call();
    return accepted();
  });
}

void refuse_clouds(Rows& rows) {
  const auto spheres = [](const Sphere& one, const Sphere& other) {
    return [=] { (void)Cloud<Sphere>({{{-4.0, 0.0, 0.0}, 1.0}, one, other}, about_origin); };
  };
  const Sphere ball;
  refuse(rows, "balls that overlap by 1e-9", "overlap bodies 1 and 2 move",
         spheres(ball, {{2.0 - 2e-9, 0.0, 0.0}, 1.0}));
  refuse(rows, "a ball in a ball", "overlap bodies 1 and 2", spheres(ball, {{0.1, 0.0, 0.0}, 0.2}));
  refuse(rows, "a ball twice", "overlap bodies 1 and 2", spheres(ball, ball));
  refuse(rows, "oblates that cross", "overlap bodies 0 and 1", [] {
    const Spheroid flat{.equatorial = 1.0, .polar = 0.25}, upright{{1.2, 0.0, 0.0}, Vector3d::UnitX(), 1.0, 0.25};
    (void)Cloud<Spheroid>({flat, upright}, about_origin);
  });
  refuse(rows, "red cells that cross", "overlap bodies 0 and 1", [] {
    (void)Cloud<RedCell>({{.radius = 1.0}, {{1.2, 0.0, 0.0}, Vector3d::UnitX(), 1.0}}, about_origin);
  });
  refuse(rows, "a ball beyond the box", "box body 2 larger", spheres(ball, {{7.5, 0.0, 0.0}, 1.0}));
  refuse(rows, "a ball of no size", "sphere radius positive 0", spheres(ball, {{3.0, 0.0, 0.0}, 0.0}));
  refuse(rows, "a ball at nan", "sphere centre finite nan", spheres(ball, {{not_a_number, 0.0, 0.0}, 1.0}));
  refuse(rows, "a spheroid without an axis", "spheroid axis unit",
         [] { (void)Cloud<Spheroid>({{.axis = Vector3d::Zero()}}, about_origin); });
  refuse(rows, "a red cell of nan m", "radius positive nan",
         [] { (void)Cloud<RedCell>({{.radius = not_a_number}}, about_origin); });
  refuse(rows, "a box of nan m", "box finite nan",
         [] { (void)Cloud<Sphere>({}, {.lengths = Vector3d::Constant(not_a_number)}); });
  refuse(rows, "a box of 0 m", "box positive 0", [] { (void)Cloud<Sphere>({}, {.lengths = Vector3d::Zero()}); });
  refuse(rows, "oblates at a fraction of 0.5", "fraction 0.28 oblates", [] {
    Uniform uniform(1);
    const kinematics::Addition to{.inside = kinematics::Inside::spheres, .most_attempts = 20000};
    (void)place_spheroids(119, {.equatorial = 0.16, .polar = 0.04}, to, [&] { return uniform(); });
  });
}

void refuse_rays(Rows& rows) {
  const auto from = [](const Vector3d& place, const Vector3d& direction, double power = 1.0) {
    return [=] {
      Rays rays = one_ray(place, direction);
      rays.power[0] = power;
      (void)trace(Cloud<Sphere>({Sphere{}}, about_origin), law, rays);
    };
  };
  const Vector3d before(-4.0, 0.0, 0.0), x = Vector3d::UnitX(), nan = Vector3d::Constant(not_a_number);
  refuse(rows, "a ray that starts inside of a body", "outside ray 0 body 0", from({0.9, 0.0, 0.0}, x));
  refuse(rows, "a ray without a direction", "directions unit ray 0", from(before, Vector3d::Zero()));
  refuse(rows, "a ray with a direction of nan", "directions unit ray 0 nan", from(before, nan));
  refuse(rows, "a ray with a direction of length 1 + 1e-9", "directions unit ray 0", from(before, (1.0 + 1e-9) * x));
  refuse(rows, "a ray at nan", "places finite ray 0 nan", from(nan, x));
  refuse(rows, "a ray of no power", "powers positive ray 0", from(before, x, 0.0));
  refuse(rows, "a ray of infinite power", "powers finite ray 0 inf", from(before, x, infinite));
}

void refuse_settings(Rows& rows) {
  const auto under = [](const auto& any_law, const TraceSettings& settings = {}) {
    return [=] { (void)trace(Cloud<Sphere>({}, {}), any_law, Rays{}, settings); };
  };
  refuse(rows, "n^ = 0", "n_hat positive 0", under(Fresnel{0.0}));
  refuse(rows, "n^ = -1.5", "n_hat positive -1.5", under(Fresnel{-1.5}));
  refuse(rows, "n^ = nan", "n_hat finite nan", under(Fresnel{not_a_number}));
  refuse(rows, "mu^ = 0", "mu_hat positive 0", under(Fresnel{1.5, 0.0}));
  refuse(rows, "Z^ = inf", "Z_hat finite inf", under(FluidFluid{infinite, 1.0}));
  refuse(rows, "a solid that a sound wave cannot be in", "c_l c_s", under(FluidSolid{.c_l = 3300.0, .c_s = 3200.0}));
  refuse(rows, "no thread", "threads 0", under(law, {.threads = 0}));
  refuse(rows, "a least share of 1", "least_share 1", under(law, {.least_share = 1.0}));
  refuse(rows, "a path of nan m", "path_length positive nan", under(law, {.path_length = not_a_number}));
  for (const double xi : {0.0, -0.1, 0.51, not_a_number, infinite}) {
    refuse(rows, fmt::format("xi = {}", xi), fmt::format("xi (0, 0.5] {}", xi),
           [=] { (void)trace_in_steps(Cloud<Sphere>({}, {}), law, Rays{}, {.xi = xi}); });
  }
}

void refuse_beams(Rows& rows) {
  const auto rays = [](const Beam& any, Eigen::Index n = 100) {
    return [=] { (void)rays_of(any, n, [] { return 0.5; }); };
  };
  refuse(rows, "a beam that misses the box", "beam meet box move centre", [] {
    (void)before({.centre = {-1.0, 3.0, 0.5}, .width = 0.5}, {});
  });
  refuse(rows, "a beam that points away from the box, seen from aside", "beam meet box", [] {
    (void)before({.centre = {-1.0, 0.5, 0.5}, .direction = Vector3d::UnitY(), .width = 0.5}, {});
  });
  refuse(rows, "a beam of no width", "width positive 0", rays({.width = 0.0}));
  refuse(rows, "a beam without a direction", "direction unit", rays({.direction = Vector3d::Zero()}));
  refuse(rows, "a beam of nan W/m^2", "irradiance finite nan", rays({.irradiance = not_a_number}));
  refuse(rows, "ten regular rays", "square 9 10", rays({.points = Beam::Points::regular}, 10));
  refuse(rows, "-1 rays", "negative -1", rays({}, -1));
}

const Case refused{{.name = "scattering_extremes_refused",
                    .claim = "bodies, rays, interfaces, settings and beams that cannot be meant are refused, with the "
                             "reason",
                    .equation = "R 9.3",
                    .reference = Reference::design},
                   [](Rows& rows) {
                     refuse_clouds(rows);
                     refuse_rays(rows);
                     refuse_settings(rows);
                     refuse_beams(rows);
                   }};

}  // namespace verification::scattering_extremes
