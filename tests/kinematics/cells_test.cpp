#include <particulate/kinematics/cells.hpp>

#include <cmath>
#include <vector>

#include "close.hpp"
#include "clouds.hpp"

namespace tests::cells_test {

using namespace particulate::kinematics;

struct Cloud {
  std::vector<Eigen::Vector3d> place;
  std::vector<double> size;

  Eigen::Index N() const { return static_cast<Eigen::Index>(place.size()); }
};

Cloud cloud(int N, const Eigen::Vector3d& box, double smallest, double largest, unsigned seed = 1) {
  const Particles all = random_cloud(N, box, smallest, largest, seed);
  Cloud c;
  for (Eigen::Index i = 0; i < N; ++i) {
    c.place.push_back(vector(all.position, i));
    c.size.push_back(all.radius[i]);
  }
  return c;
}

Cells filled(const Space& space, const Cloud& c, const Eigen::Vector3d& extent, double edge) {
  Cells cells(space, extent, edge, c.N());
  for (std::size_t i = 0; i < c.place.size(); ++i) cells.insert(static_cast<Eigen::Index>(i), c.place[i], c.size[i]);
  return cells;
}

// How often each body is visited from a place.
std::vector<int> visits(const Cells& cells, const Cloud& c, const Eigen::Vector3d& place, double size, int level = 0) {
  std::vector<int> times(c.place.size(), 0);
  cells.near(place, size, level, [&](const Cells::Body& body) { ++times[static_cast<std::size_t>(body.index)]; });
  return times;
}

// Of all bodies, those that are not visited though they are near another, and those that are visited twice.
struct Mistakes {
  int missed = 0, repeated = 0;
  long visited = 0, near = 0;
};

Mistakes mistakes(const Space& space, const Cloud& c, const Eigen::Vector3d& extent, double edge) {
  const Cells cells = filled(space, c, extent, edge);
  Mistakes found;
  for (std::size_t i = 0; i < c.place.size(); ++i) {
    const std::vector<int> times = visits(cells, c, c.place[i], c.size[i]);
    for (std::size_t j = 0; j < c.place.size(); ++j) {
      const bool near = separation(space, c.place[i], c.place[j]).norm() <= c.size[i] + c.size[j];
      found.missed += near && times[j] == 0 ? 1 : 0;
      found.repeated += times[j] > 1 ? 1 : 0;
      found.visited += times[j];
      found.near += near ? 1 : 0;
    }
  }
  return found;
}

const Eigen::Vector3d unit = Eigen::Vector3d::Ones();

BOOST_AUTO_TEST_SUITE(near_)

BOOST_AUTO_TEST_CASE(visits_all_that_are_near_once_and_few_that_are_not) {
  const Mistakes equal = mistakes(Space{}, cloud(1000, unit, 0.04, 0.04), unit, 0.08);
  BOOST_TEST(equal.missed == 0);
  BOOST_TEST(equal.repeated == 0);
  BOOST_TEST(equal.near > 2500);
  // (3 cells)^3 against the sphere of one edge: 27/(4 pi/3) = 6.4.
  BOOST_TEST(equal.visited < 7 * equal.near);
}

BOOST_AUTO_TEST_CASE(serves_bodies_of_very_different_sizes) {
  const Mistakes sizes = mistakes(Space{}, cloud(1000, unit, 1e-4, 0.2), unit, 2e-4);
  BOOST_TEST(sizes.missed == 0);
  BOOST_TEST(sizes.repeated == 0);
  BOOST_TEST(sizes.near > 2000);
}

BOOST_AUTO_TEST_CASE(repeats_itself_with_the_periods_of_space) {
  // Places up to three periods out; the last box is two cells wide in x, and less than one in z.
  const Eigen::Vector3d boxes[] = {{1.0, 1.0, 1.0}, {1.0, infinity, 1.0 / 3.0}, {0.2, 40.0, 0.09}};
  for (const Eigen::Vector3d& lengths : boxes) {
    Cloud c = cloud(600, {1.0, 1.0, 1.0}, 0.02, 0.05);
    for (Eigen::Vector3d& place : c.place) place = 3.0 * (place - Eigen::Vector3d(0.3, 0.9, 0.5));
    const Mistakes found = mistakes(Space{.lengths = lengths}, c, unit, 0.1);
    BOOST_TEST(found.missed == 0);
    BOOST_TEST(found.repeated == 0);
    BOOST_TEST(found.near > 600);
  }
}

BOOST_AUTO_TEST_CASE(finds_images_after_a_million_periods) {
  Cloud c = cloud(200, unit, 0.05, 0.05);
  for (std::size_t i = 0; i < c.place.size(); i += 2) c.place[i].x() += 1e6;
  const Mistakes found = mistakes(Space{.lengths = unit}, c, unit, 0.1);
  BOOST_TEST(found.missed == 0);
  BOOST_TEST(found.near > 300);
}

BOOST_AUTO_TEST_CASE(needs_no_true_extent) {
  for (const double extent : {0.0, 0.1, 1e300, infinity, not_a_number}) {
    const Mistakes found = mistakes(Space{}, cloud(300, unit, 0.05, 0.1), Eigen::Vector3d::Constant(extent), 0.1);
    BOOST_TEST(found.missed == 0);
    BOOST_TEST(found.repeated == 0);
  }
}

BOOST_AUTO_TEST_CASE(finds_what_is_near_to_the_last_bit) {
  // Neighbours at exactly the sum of their sizes, on the borders of cells.
  Cloud line;
  for (int i = -40; i < 40; ++i) line.place.emplace_back(0.1 * i, 1.0, -1.0), line.size.push_back(0.05 + 1e-16);
  const Mistakes found = mistakes(Space{}, line, {8.0, 0.0, 0.0}, 0.1);
  BOOST_TEST(found.missed == 0);
  BOOST_TEST(found.near > 80 + 100);
}

BOOST_AUTO_TEST_CASE(costs_no_more_with_one_body_far_away) {
  Cloud c = cloud(1000, unit, 0.04, 0.04);
  const long before = mistakes(Space{}, c, unit, 0.08).visited;
  c.place[500] = {1e12, -1e30, 1e250};
  const Mistakes after = mistakes(Space{}, c, {1e12, 1e30, 1e250}, 0.08);
  BOOST_TEST(after.missed == 0);
  BOOST_TEST(after.visited < before + before / 2);
}

BOOST_AUTO_TEST_CASE(leaves_out_lower_levels) {
  const Cloud c{.place = {{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}}, .size = {0.5, 2.0}};
  const Cells cells = filled(Space{}, c, unit, 1.0);
  BOOST_TEST(cells.level(0.0) == 0);
  BOOST_TEST(cells.level(0.5) == 0);
  BOOST_TEST(cells.level(0.51) == 1);
  BOOST_TEST(cells.level(2.0) == 2);
  BOOST_TEST(cells.level(2.1) == 3);
  BOOST_TEST((visits(cells, c, c.place[0], 0.5) == std::vector<int>{1, 1}));
  BOOST_TEST((visits(cells, c, c.place[0], 0.5, 1) == std::vector<int>{0, 1}));
  BOOST_TEST((visits(cells, c, c.place[0], 0.5, 3) == std::vector<int>{0, 0}));
}

BOOST_AUTO_TEST_CASE(finds_nothing_near_what_is_nowhere) {
  Cloud c = cloud(20, unit, 0.3, 0.3);
  c.place[3].y() = not_a_number;
  c.place[4].z() = infinity;
  c.size[5] = infinity;
  const Cells cells = filled(Space{}, c, unit, 0.6);
  const std::vector<int> times = visits(cells, c, {0.5, 0.5, 0.5}, 10.0);
  BOOST_TEST(times[2] == 1);
  BOOST_TEST(times[3] + times[4] + times[5] == 0);
  for (const int each : visits(cells, c, c.place[3], 0.3)) BOOST_TEST(each == 0);
}

BOOST_AUTO_TEST_CASE(has_no_body_at_first) {
  const Cells none(Space{}, unit, 1.0, 0);
  BOOST_TEST(visits(none, {}, unit, 1.0).empty());
}

BOOST_AUTO_TEST_CASE(reaches_all_with_an_infinite_size) {
  const Cloud c = cloud(100, unit, 0.01, 0.02);
  for (const int each : visits(filled(Space{}, c, unit, 0.02), c, unit, infinity)) BOOST_TEST(each == 1);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(constructor)

BOOST_AUTO_TEST_CASE(says_what_an_edge_must_be) {
  CHECK_REFUSED(Cells(Space{}, unit, 0.0, 1), "cells: their edge must be positive and finite, got 0 m");
  CHECK_REFUSED(Cells(Space{}, unit, infinity, 1), "got inf m");
  CHECK_REFUSED(Cells(Space{}, unit, 1.0, 3000000000), "cells: they hold up to 2147483647 bodies, asked for were 3000");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::cells_test
