#include <particulate/thermo/clusters.hpp>

#include <cmath>

#include "close.hpp"
#include "clouds.hpp"
#include "says.hpp"

namespace tests::clusters_test {

using boost::test_tools::tolerance;
using namespace particulate;
using namespace particulate::thermo;

BOOST_AUTO_TEST_SUITE(find_clusters_)

// A chain whose middle comes last, and one alone.
BOOST_AUTO_TEST_CASE(joins_what_hangs_together) {
  kinematics::Vectors r(5, 3);
  r << 0, 0, 0, 1, 0, 0, 1.5, 0, 0, 5, 0, 0, 0.5, 0, 0;
  const Clusters found = find_clusters({}, r, 0.5);
  BOOST_TEST((found.of == std::vector<Eigen::Index>{0, 0, 0, 1, 0}));
  BOOST_TEST((found.sizes == std::vector<Eigen::Index>{4, 1}));
  BOOST_TEST(found.links == 3);
  BOOST_TEST(found.largest() == 4);
  BOOST_TEST(found.linked_share() == 0.8, tolerance(1e-15));
}

// Against a flood from body to body over all pairs, so many that they are searched, in space that repeats itself too.
BOOST_AUTO_TEST_CASE(agrees_with_a_flood) {
  const auto cloud = random_cloud(300, {1.0, 1.0, 1.0}, 0.01, 0.01);
  for (const double period : {1.0, std::numeric_limits<double>::infinity()}) {
    const kinematics::Space space{.lengths = Eigen::Vector3d::Constant(period)};
    const Clusters found = find_clusters(space, cloud.position, 0.11);
    std::vector<Eigen::Index> of(300, -1);
    Eigen::Index clusters = 0;
    for (Eigen::Index seed = 0; seed < 300; ++seed) {
      if (of[static_cast<std::size_t>(seed)] >= 0) continue;
      std::vector<Eigen::Index> front{seed};
      of[static_cast<std::size_t>(seed)] = clusters;
      while (!front.empty()) {
        const Eigen::Index i = front.back();
        front.pop_back();
        for (Eigen::Index j = 0; j < 300; ++j) {
          if (of[static_cast<std::size_t>(j)] >= 0) continue;
          if (separation(space, cloud.position.row(i), cloud.position.row(j)).norm() > 0.11) continue;
          of[static_cast<std::size_t>(j)] = clusters;
          front.push_back(j);
        }
      }
      ++clusters;
    }
    BOOST_TEST((clusters > 5 && clusters < 250));
    BOOST_TEST((found.of == of));
  }
}

// 100 x 1000 bodies at 1 m in rows 2 m apart: as many clusters as rows, each a chain.
BOOST_AUTO_TEST_CASE(finds_a_hundred_thousand_bodies_in_rows) {
  kinematics::Vectors r = kinematics::Vectors::Zero(100000, 3);
  for (Eigen::Index i = 0; i < r.rows(); ++i) {
    r(i, 0) = static_cast<double>(i % 1000);
    r(i, 1) = 2.0 * static_cast<double>(i / 1000);
  }
  const Clusters found = find_clusters({}, r, 1.5);
  BOOST_TEST((found.sizes == std::vector<Eigen::Index>(100, 1000)));
  BOOST_TEST(found.links == 100 * 999);
  BOOST_TEST(found.of.back() == 99);
}

// A hundred bodies of which three coincide: as near as nothing, and in units in which squares overflow.
BOOST_AUTO_TEST_CASE(links_what_coincides_and_what_is_huge) {
  kinematics::Vectors r = random_cloud(100, {1.0, 1.0, 1.0}, 0.1, 0.1).position;
  r.row(60) = r.row(80) = r.row(3);
  const Clusters coincident = find_clusters({}, r, 0.0);
  BOOST_TEST(coincident.links == 3);
  BOOST_TEST(coincident.largest() == 3);
  BOOST_TEST((coincident.of[3] == coincident.of[60] && coincident.of[3] == coincident.of[80]));
  const Clusters near = find_clusters({}, r, 0.125), far = find_clusters({}, r * 0x1p600, std::ldexp(0.125, 600));
  BOOST_TEST(near.links > 20);
  BOOST_TEST((near.of == far.of));
  BOOST_TEST(find_clusters({}, r, 1e300).links == 100 * 99 / 2);
}

BOOST_AUTO_TEST_CASE(refuses_places_that_are_none) {
  for (const Eigen::Index N : {3, 100}) {
    kinematics::Vectors r = random_cloud(N, {1.0, 1.0, 1.0}, 0.1, 0.1).position;
    r(1, 2) = NAN;
    CHECK_REFUSED(find_clusters({}, r, 0.1), "every position must be finite");
  }
}

BOOST_AUTO_TEST_CASE(takes_nobody_and_refuses_no_length) {
  BOOST_TEST(find_clusters({}, kinematics::Vectors(0, 3), 1.0).largest() == 0);
  CHECK_REFUSED(find_clusters({}, kinematics::Vectors(0, 3), -1.0), "finite and not negative, got -1 m");
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace tests::clusters_test
