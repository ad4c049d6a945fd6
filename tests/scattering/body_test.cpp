#include <particulate/scattering/body.hpp>
#include <particulate/scattering/red_cell.hpp>

#include <numbers>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

#include <particulate/scattering/placement.hpp>

#include "close.hpp"
#include "says.hpp"

namespace tests::body_test {

using boost::test_tools::tolerance;
using namespace particulate::scattering;
using Eigen::Vector3d;

class Draw {
 public:
  double operator()() { return uniform_(engine_); }
  Vector3d direction() {
    return random_direction([this] { return (*this)(); });
  }

 private:
  boost::random::mt19937_64 engine_{7};
  boost::random::uniform_01<double> uniform_;
};

BOOST_AUTO_TEST_SUITE(first_entry_)

// A ball of 2 m at (3, 4, 0): along x at y = 4 it is entered at x = 1; at y = 6 it is touched, above it missed.
BOOST_AUTO_TEST_CASE(of_a_sphere_is_known) {
  const Sphere ball{{3.0, 4.0, 0.0}, 2.0};
  BOOST_TEST(first_entry(ball, {-1.0, 4.0, 0.0}, Vector3d::UnitX()) == 2.0);
  BOOST_TEST(first_entry(ball, {-1.0, 6.0, 0.0}, Vector3d::UnitX()) == nowhere);
  BOOST_TEST(first_entry(ball, {-1.0, 6.0 - 1e-15, 0.0}, Vector3d::UnitX()) == 4.0, tolerance(1e-7));
  BOOST_TEST(first_entry(ball, {6.0, 4.0, 0.0}, Vector3d::UnitX()) == nowhere);
  BOOST_TEST(close(outward_normal(ball, {1.0, 4.0, 0.0}), -Vector3d::UnitX(), {.relative = 1e-15}));
}

// A small ball far away: of a distance of 1e8 radii eight digits of the place are left, and of those all.
BOOST_AUTO_TEST_CASE(keeps_its_digits_from_afar) {
  const Sphere ball{Vector3d::Zero(), 1.0};
  BOOST_TEST(first_entry(ball, {-1e8, 0.6, 0.0}, Vector3d::UnitX()) - 1e8 == -0.8, tolerance(1e-7));
}

// Semi-axes 2, 2, 0.5: along the axis it is entered at 0.5, across at 2, and a place that is entered lies on it.
BOOST_AUTO_TEST_CASE(of_a_spheroid_lies_on_it) {
  const Spheroid flat{.equatorial = 2.0, .polar = 0.5};
  BOOST_TEST(first_entry(flat, {0.0, 0.0, -3.0}, Vector3d::UnitZ()) == 2.5);
  BOOST_TEST(first_entry(flat, {-3.0, 0.0, 0.0}, Vector3d::UnitX()) == 1.0);
  Draw draw;
  for (const double polar : {0.002, 0.5, 2.0, 2000.0}) {
    const Spheroid body{.centre = {0.1, 0.2, 0.3}, .axis = draw.direction(), .equatorial = 2.0, .polar = polar};
    for (int k = 0; k < 200; ++k) {
      const Vector3d to = body.centre + 0.3 * std::min(polar, 2.0) * draw.direction(), d = draw.direction();
      const Vector3d from = to - 3.0 * bounding_radius(body) * d, at = from + first_entry(body, from, d) * d;
      BOOST_TEST(stretched(body, at - body.centre).norm() == 2.0,
                 tolerance(1e-12 * std::max(2.0 / polar, polar / 2.0)));
      BOOST_TEST(outward_normal(body, at).dot(d) < 0.0);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(measures)

// Oblate 4:1 and prolate 1:2: areas of the closed forms with a = 1.
BOOST_AUTO_TEST_CASE(are_known) {
  BOOST_TEST(area(Spheroid{.equatorial = 1.0, .polar = 1.0}) == 4.0 * std::numbers::pi, tolerance(1e-15));
  BOOST_TEST(area(Spheroid{.equatorial = 1.0, .polar = 0.25}) ==
                 2.0 * std::numbers::pi * (1.0 + 0.0625 * std::atanh(std::sqrt(0.9375)) / std::sqrt(0.9375)),
             tolerance(1e-15));
  BOOST_TEST(area(Spheroid{.equatorial = 1.0, .polar = 2.0}) == 21.4784, tolerance(1e-5));
  BOOST_TEST(volume(Spheroid{.equatorial = 3.0, .polar = 0.5}) == 6.0 * std::numbers::pi, tolerance(1e-15));
  BOOST_TEST(volume(RedCell{.radius = 3.91}) == 94.0910641006, tolerance(1e-11));
  BOOST_TEST(area(RedCell{.radius = 3.91}) == 134.0896866817, tolerance(1e-11));
  BOOST_TEST(2.0 * half_thickness(RedCell{.radius = 3.91}, 0.0) == 0.81, tolerance(1e-15));
  BOOST_TEST(2.0 * half_thickness(RedCell{.radius = 3.91}, 2.73781) == 2.5656737, tolerance(1e-7));
}

// A tilted spheroid reaches as far as its farthest points.
BOOST_AUTO_TEST_CASE(contain_what_they_should) {
  Draw draw;
  const Spheroid body{.axis = draw.direction(), .equatorial = 2.0, .polar = 0.5};
  const Vector3d half = half_extents(body);
  double reached = 0.0;
  for (int k = 0; k < 20000; ++k) {
    const Vector3d d = draw.direction(), place = d * (2.0 / stretched(body, d).norm());
    BOOST_TEST_REQUIRE(((place.cwiseAbs().array() <= half.array() * (1.0 + 1e-15)).all()));
    reached = std::max(reached, place[0] / half[0]);
  }
  BOOST_TEST(reached > 0.99);
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(red_cell)

// Along the axis the dimple is 0.405 um away from the middle; in the plane of the rim the rim is.
BOOST_AUTO_TEST_CASE(is_entered_where_its_thickness_says) {
  const RedCell cell{.radius = 3.91};
  BOOST_TEST(first_entry(cell, {0.0, 0.0, 5.0}, -Vector3d::UnitZ()) == 4.595, tolerance(1e-14));
  BOOST_TEST(first_entry(cell, {2.73781, 0.0, 5.0}, -Vector3d::UnitZ()) == 5.0 - 0.5 * 2.5656737, tolerance(1e-7));
  BOOST_TEST(first_entry(cell, {-5.0, 0.0, 0.0}, Vector3d::UnitX()) == 1.09, tolerance(1e-12));
  BOOST_TEST(first_entry(cell, {-5.0, 0.0, 1.3}, Vector3d::UnitX()) == nowhere);  // above it
  BOOST_TEST(close(outward_normal(cell, {0.0, 0.0, 0.405}), Vector3d::UnitZ(), {.relative = 1e-15}));
  BOOST_TEST(close(outward_normal(cell, {0.0, 3.91, 0.0}), Vector3d::UnitY(), {.relative = 1e-15}));
}

// A ray across the dimple goes through the near rim, leaves, and enters again: from the first exit, the second entry.
BOOST_AUTO_TEST_CASE(is_met_again_across_its_dimple) {
  const RedCell cell{.radius = 3.91};
  const Vector3d from(-2.0, 0.0, half_thickness(cell, 2.0)), down = Vector3d(1.0, 0.0, -0.1).normalized();
  BOOST_REQUIRE(outward_normal(cell, from).dot(down) > 0.0);
  const double t = next_entry(cell, from, down);
  const Vector3d at = from + t * down;
  BOOST_TEST(t > 0.1);
  BOOST_TEST(at[2] == half_thickness(cell, at.head<2>().norm()), tolerance(1e-13));
  BOOST_TEST(next_entry(cell, from, Vector3d::UnitZ()) == nowhere);
}

// Against marching in 2000 steps: what that finds is found, and what is found lies on the surface.
BOOST_AUTO_TEST_CASE(is_missed_by_no_ray) {
  Draw draw;
  const RedCell cell{.axis = draw.direction(), .radius = 1.0};
  for (int k = 0; k < 2000; ++k) {
    const Vector3d d = draw.direction(), aside = 1.05 * std::sqrt(draw()) * draw.direction();
    const Vector3d from = aside - aside.dot(d) * d - 2.0 * d;
    double marched = nowhere;
    for (int step = 0; step < 2000 && marched == nowhere; ++step) {
      if (contains(cell, from + 0.002 * step * d)) marched = 0.002 * step;
    }
    const double t = first_entry(cell, from, d);
    BOOST_TEST_REQUIRE(t <= marched);
    if (t == nowhere) continue;
    BOOST_TEST(!contains(cell, from + (t - 1e-9) * d));
    BOOST_TEST((contains(cell, from + (t + 1e-9) * d) || outward_normal(cell, from + t * d).dot(d) > -1e-3));
  }
}

BOOST_AUTO_TEST_SUITE_END()
BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(refuses_what_is_no_body) {
  CHECK_REFUSED(validate(Sphere{.radius = 0.0}), "sphere: its radius must be positive and finite, got 0 m");
  CHECK_REFUSED(validate(Sphere{.centre = {0.0, nowhere, 0.0}}), "its centre must be finite");
  CHECK_REFUSED(validate(Spheroid{.axis = {0.0, 0.0, 2.0}}), "its axis must be a unit vector, got (0, 0, 2)");
  CHECK_REFUSED(validate(Spheroid{.polar = -1.0}), "its polar radius must be positive and finite, got -1 m");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::body_test
