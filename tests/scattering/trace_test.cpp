#include <particulate/scattering/trace.hpp>

#include <numeric>

#include <particulate/scattering/beam.hpp>
#include <particulate/scattering/placement.hpp>
#include <particulate/scattering/stepped.hpp>

#include "close.hpp"
#include "says.hpp"

namespace tests::trace_test {

using boost::test_tools::tolerance;
using namespace particulate;
using namespace particulate::scattering;
using Eigen::Vector3d;

double whole(const Ledger& ledger) {
  return std::accumulate(ledger.left.begin(), ledger.left.end(), ledger.absorbed + ledger.cut_off + ledger.inside);
}

// The first entries of all bodies.
template <class B>
double nearest(const std::vector<B>& bodies, const Vector3d& from, const Vector3d& direction) {
  double t = nowhere;
  for (const B& body : bodies) t = std::min(t, first_entry(body, from, direction));
  return t;
}

Rays one_ray(const Vector3d& place, const Vector3d& direction) {
  return {.place = place.transpose(), .direction = direction.transpose(), .power = Eigen::VectorXd::Constant(1, 2.0)};
}

const Beam across_the_middle{.centre = {0.0, 0.5, 0.5}, .width = 0.5};

BOOST_AUTO_TEST_SUITE(Cloud_)

// The grid finds what a look at every body finds: from inside and outside, along edges and planes of cells.
BOOST_AUTO_TEST_CASE(finds_the_first_of_all_bodies) {
  const auto draw = kinematics::uniform_from(1);
  const std::vector<Sphere> spheres = place_spheres(200, 0.03, {.inside = kinematics::Inside::spheres}, draw).bodies;
  const Cloud<Sphere> cloud(spheres, {});
  long hits = 0;
  for (int k = 0; k < 20000; ++k) {
    Vector3d from(3.0 * draw() - 1.0, 3.0 * draw() - 1.0, 3.0 * draw() - 1.0), d = random_direction(draw);
    if (k % 3 == 1) d = Vector3d::Unit(k % 9 / 3), from[k % 9 / 3] = -0.5;
    if (k % 9 == 1) d[1] = 5e-324;                              // whose inverse is no number
    if (k % 5 == 0) from = (from * 6.0).array().round() / 6.0;  // on the planes between cells
    if (cloud.body_at(from) >= 0) continue;
    const auto hit = cloud.first_hit(from, d);
    BOOST_TEST_REQUIRE(hit.distance == nearest(spheres, from, d));
    hits += hit.body >= 0 ? 1 : 0;
  }
  BOOST_TEST(hits > 500);
}

BOOST_AUTO_TEST_CASE(refuses_bodies_beyond_its_box) {
  CHECK_REFUSED(Cloud<Sphere>({{{0.5, 0.95, 0.5}, 0.1}}, {}),
                "body 0 reaches from 0.85 to 1.05 m in direction y, the box from 0 to 1 m: take a larger box");
}

BOOST_AUTO_TEST_CASE(refuses_bodies_that_overlap_and_takes_those_that_touch) {
  const double b = 0.1, below = b * (1.0 - 1e-9);
  const auto sphere = [&](double y) { return Sphere{{0.5, 0.3 + y, 0.5}, b}; };
  BOOST_CHECK_NO_THROW(Cloud<Sphere>({sphere(0.0), sphere(2.0 * b), sphere(4.0 * b)}, {}));
  CHECK_REFUSED(Cloud<Sphere>({sphere(4.0 * b), sphere(0.0), sphere(2.0 * below)}, {}),
                "bodies must not overlap, though they may touch, and bodies 1 and 2, whose centres are");
  const auto oblate = [&](double x) { return Spheroid{{0.5 + x, 0.5, 0.5}, Vector3d::UnitX(), 4.0 * b, b}; };
  BOOST_CHECK_NO_THROW(Cloud<Spheroid>({oblate(-b), oblate(b)}, {}));
  CHECK_REFUSED(Cloud<Spheroid>({oblate(-below), oblate(below)}, {}), "bodies 0 and 1");
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(trace_)

// Convex mirrors enlarge roundings. A ball met at 45 degrees sends the ray off at a right angle, with R of its power;
// another one up there sends it back.
BOOST_AUTO_TEST_CASE(follows_mirrors) {
  const double aside = 0.1 / std::sqrt(2.0);
  const Cloud<Sphere> cloud({{{0.5, 0.5 - aside, 0.5}, 0.1}, {{0.5 - aside, 0.9, 0.5}, 0.1}}, {});
  const Fresnel law{2.0};
  const Traced traced = trace(cloud, law, one_ray({-1.0, 0.5, 0.5}, Vector3d::UnitX()));
  const double R = reflectance(law, std::sqrt(0.5)), R_0 = reflectance(law, 1.0);
  BOOST_TEST(traced.ledger.hits == 3);
  BOOST_TEST(traced.ledger.segments == 4);
  BOOST_TEST(traced.absorbed[1] == 2.0 * R * (1.0 - R_0), tolerance(1e-14));
  BOOST_TEST(traced.ledger.backward_face() == 2.0 * R * R_0 * R, tolerance(1e-12));
  BOOST_TEST(traced.ledger.x == -2.0 * R * R_0 * R, tolerance(1e-12));
  BOOST_TEST(close(Vector3d(traced.rays.place.row(0)), Vector3d(0.0, 0.5, 0.5), {.relative = 1e-12}));
}

BOOST_AUTO_TEST_CASE(keeps_the_books) {
  const auto draw = kinematics::uniform_from(2);
  const Cloud<Sphere> cloud(place_spheres(1000, 0.0325, {.inside = kinematics::Inside::spheres}, draw).bodies, {});
  const Rays rays = rays_of(across_the_middle, 1000, draw);
  for (const TraceSettings& settings : {TraceSettings{}, TraceSettings{.most_hits = 2},
                                        TraceSettings{.least_share = 0.3}, TraceSettings{.path_length = 0.4}}) {
    const Traced exact = trace(cloud, Fresnel{10.0}, rays, settings);
    const Traced stepped = trace_in_steps(cloud, Fresnel{10.0}, rays, {.xi = 0.3, .bounds = settings});
    for (const Ledger* ledger : {&exact.ledger, &stepped.ledger}) {
      BOOST_TEST(whole(*ledger) == ledger->incident, tolerance(1e-13));
      BOOST_TEST(ledger->accounted() == whole(*ledger), tolerance(1e-15));
    }
    BOOST_TEST(exact.rays.direction.rowwise().norm().minCoeff() == 1.0, tolerance(1e-14));
  }
  BOOST_TEST(trace(cloud, Fresnel{10.0}, rays, {.path_length = 0.4}).ledger.inside > 0.0);
  BOOST_TEST(trace(cloud, Fresnel{10.0}, rays, {.most_hits = 2}).ledger.cut_off > 0.0);
}

BOOST_AUTO_TEST_CASE(gives_the_same_bits_for_any_number_of_threads) {
  const auto draw = kinematics::uniform_from(3);
  const Cloud<Sphere> cloud(place_spheres(300, 0.04, {.inside = kinematics::Inside::spheres}, draw).bodies, {});
  const Rays rays = rays_of(across_the_middle, 3000, draw);
  const Traced one = trace(cloud, Fresnel{4.0}, rays, {.keeps_paths = true});
  for (const int threads : {2, 5}) {
    const Traced many = trace(cloud, Fresnel{4.0}, rays, {.keeps_paths = true, .threads = threads});
    BOOST_TEST((many.absorbed == one.absorbed && many.rays.place == one.rays.place));
    BOOST_TEST((many.ledger.x == one.ledger.x && many.ledger.left == one.ledger.left));
    BOOST_TEST(many.paths.size() == one.paths.size());
  }
}

// The whole tracer against the reflectance of a sphere: stratified rays converge to it.
BOOST_AUTO_TEST_CASE(finds_the_reflectance_of_a_sphere) {
  const Cloud<Sphere> cloud({{{0.5, 0.5, 0.5}, 0.25}}, {});
  Beam beam{.shape = Beam::Shape::disc, .centre = {0.0, 0.5, 0.5}, .width = 0.5, .points = Beam::Points::stratified};
  const Ledger ledger = trace(cloud, Fresnel{2.0}, rays_of(beam, 40000, kinematics::uniform_from(4))).ledger;
  BOOST_TEST(1.0 - ledger.absorbed / ledger.incident == sphere_reflectance(Fresnel{2.0}), tolerance(1e-3));
  BOOST_TEST(ledger.x / ledger.incident == sphere_x_irradiance({2.0}), tolerance(1e-2));
  BOOST_TEST(ledger.incident == area(beam), tolerance(1e-12));
}

// Between bodies that touch a ray never ends, but its power does; without a body it passes.
BOOST_AUTO_TEST_CASE(ends_at_a_point_of_contact_and_without_bodies) {
  const Cloud<Sphere> touching({{{0.5, 0.4, 0.5}, 0.1}, {{0.5, 0.6, 0.5}, 0.1}}, {});
  const Ledger ledger = trace(touching, Fresnel{2.0}, one_ray({0.0, 0.5, 0.5}, Vector3d::UnitX())).ledger;
  BOOST_TEST(whole(ledger) == 2.0, tolerance(1e-14));
  BOOST_TEST(
      trace(Cloud<Sphere>({}, {}), Fresnel{}, one_ray({0.0, 0.5, 0.5}, Vector3d::UnitX())).ledger.forward_face() ==
      2.0);
  BOOST_TEST(
      trace(touching, Fresnel{}, Rays{.place = kinematics::Vectors(0, 3), .direction = kinematics::Vectors(0, 3)})
          .ledger.incident == 0.0);
}

BOOST_AUTO_TEST_CASE(refuses_rays_and_settings_that_cannot_be_meant) {
  const Cloud<Sphere> cloud({{{0.5, 0.5, 0.5}, 0.25}}, {});
  const Vector3d x = Vector3d::UnitX(), outside(-1.0, 0.5, 0.5);
  CHECK_REFUSED(trace(cloud, Fresnel{}, one_ray({0.5, 0.5, 0.6}, x)), "ray 0 starts inside of body 0");
  // Of several the first is named, by however many threads.
  const Eigen::Index N = 2000;
  const Rays inside{.place = Vector3d(0.5, 0.5, 0.6).transpose().replicate(N, 1),
                    .direction = x.transpose().replicate(N, 1),
                    .power = Eigen::VectorXd::Ones(N)};
  CHECK_REFUSED(trace(cloud, Fresnel{}, inside, {.threads = 2}), "ray 0 starts inside of body 0");
  CHECK_REFUSED(trace(cloud, Fresnel{}, one_ray(outside, 2.0 * x)),
                "that of ray 0 is (2, 0, 0): divide it by its length");
  CHECK_REFUSED(trace(cloud, Fresnel{}, one_ray({nowhere, 0.0, 0.0}, x)), "places must be finite, ray 0");
  CHECK_REFUSED(trace(cloud, Fresnel{-1.0}, one_ray(outside, x)), "n_hat must be positive");
  CHECK_REFUSED(trace(cloud, Fresnel{}, one_ray(outside, x), {.path_length = 0.0}), "path_length must be positive");
  CHECK_REFUSED(trace(cloud, Fresnel{}, one_ray(outside, x), {.threads = 0}), "threads must be from 1 to 1024, got 0");
  CHECK_REFUSED(trace_in_steps(cloud, Fresnel{}, one_ray(outside, x), {.xi = 0.6}), "xi must lie in (0, 0.5], got 0.6");
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(rays_of_)

// Four strata of a square of 2 m, and of a disc: as many rays in each, whose power is that of a quarter.
BOOST_AUTO_TEST_CASE(fills_its_cross_section_evenly) {
  for (const auto shape : {Beam::Shape::square, Beam::Shape::disc}) {
    const Beam beam{
        .shape = shape, .direction = Vector3d(1.0, 2.0, 2.0) / 3.0, .width = 2.0, .points = Beam::Points::stratified};
    const Rays rays = rays_of(beam, 10000, kinematics::uniform_from(5));
    BOOST_TEST((rays.place * beam.direction).cwiseAbs().maxCoeff() < 1e-15);
    BOOST_TEST(rays.power.sum() == area(beam), tolerance(1e-12));
    // The mean square of a uniform square is 2/3, of a disc 1/2.
    BOOST_TEST(rays.place.rowwise().squaredNorm().mean() == (shape == Beam::Shape::square ? 2.0 / 3.0 : 0.5),
               tolerance(1e-3));
  }
  CHECK_REFUSED(rays_of({.points = Beam::Points::regular}, 10, {}), "must be a square, such as 9, got 10");
  CHECK_REFUSED(rays_of({.width = -1.0}, 1, {}), "width must be positive and finite, got -1");
}

BOOST_AUTO_TEST_CASE(begins_before_the_box) {
  const Beam beam = before({.centre = {0.5, 0.5, 0.5}, .width = 0.5}, {});
  BOOST_TEST(beam.centre[0] < 0.0);
  BOOST_TEST(beam.centre[0] > -1e-8);
  CHECK_REFUSED(before({.centre = {0.0, 5.0, 0.5}, .width = 0.5}, {}),
                "it must meet the box, and passes its middle at 4.5 m");
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(are_apart_)

// Flat ones that lie on one another, side by side, and crossed.
BOOST_AUTO_TEST_CASE(knows_plain_cases) {
  const Spheroid flat{.equatorial = 2.0, .polar = 0.5},
      upright{.axis = Vector3d::UnitX(), .equatorial = 2.0, .polar = 0.5};
  BOOST_TEST(are_apart(flat, flat, {0.0, 0.0, 1.0 + 1e-12}));
  BOOST_TEST(!are_apart(flat, flat, {0.0, 0.0, 1.0 - 1e-12}));
  BOOST_TEST(are_apart(flat, flat, {0.0, 4.0 + 1e-12, 0.0}));
  BOOST_TEST(!are_apart(flat, flat, {0.0, 4.0 - 1e-12, 0.0}));
  BOOST_TEST(are_apart(flat, upright, {2.5 + 1e-12, 0.0, 0.0}));
  BOOST_TEST(!are_apart(flat, upright, {2.5 - 1e-12, 0.0, 0.0}));
  BOOST_TEST(!are_apart(flat, upright, Vector3d::Zero()));
}

BOOST_AUTO_TEST_CASE(holds_of_all_that_are_placed) {
  const auto draw = kinematics::uniform_from(6);
  const auto bodies = place_spheroids(200, {.equatorial = 0.1, .polar = 0.025}, {}, draw).bodies;
  // No point of a surface lies in another body.
  for (const Spheroid& one : bodies) {
    for (int k = 0; k < 50; ++k) {
      const Vector3d d = random_direction(draw), place = one.centre + d * (one.equatorial / stretched(one, d).norm());
      for (const Spheroid& other : bodies) {
        if (&other != &one) BOOST_TEST_REQUIRE(!contains(other, place));
      }
    }
  }
  CHECK_REFUSED(place_spheroids(400, {.equatorial = 0.2, .polar = 0.05}, {.most_attempts = 20000}, draw),
                "of 400 bodies found a place in 20000 attempts, a fraction of");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::trace_test
