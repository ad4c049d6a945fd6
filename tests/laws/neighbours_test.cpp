#include <particulate/laws/neighbours.hpp>

#include <utility>
#include <vector>

#include "close.hpp"
#include "clouds.hpp"

namespace tests::neighbours_test {

using namespace particulate::kinematics;
using namespace particulate::laws;

using Pairs = std::vector<std::pair<Eigen::Index, Eigen::Index>>;

// What a law makes of candidates: those that are near, in the order in which it meets them.
Pairs near_among(const Candidates& candidates, const Space& space, const Vectors& r, const Eigen::VectorXd& size) {
  Pairs near;
  for (Eigen::Index i = 0; i < r.rows(); ++i) {
    candidates.behind(i, [&](Eigen::Index j) {
      if (separation(space, r.row(i), r.row(j)).norm() <= size[i] + size[j]) near.emplace_back(i, j);
    });
  }
  return near;
}

Pairs near_among_all(const Space& space, const Vectors& r, const Eigen::VectorXd& size) {
  return near_among({r.rows(), nullptr, nullptr}, space, r, size);
}

const Eigen::Vector3d unit = Eigen::Vector3d::Ones();
const Space spaces[] = {Space{}, Space{.lengths = unit}, Space{.lengths = {1.0, infinity, 1.0}}};

BOOST_AUTO_TEST_SUITE(candidates_)

BOOST_AUTO_TEST_CASE(hold_all_that_are_near_in_the_same_order) {
  for (const Space& space : spaces) {
    for (const double largest : {0.03, 0.2}) {
      const Particles cloud = random_cloud(400, unit, 0.03, largest);
      Neighbours neighbours;
      const Candidates found = neighbours.candidates(space, cloud.position, cloud.radius);
      BOOST_TEST((near_among(found, space, cloud.position, cloud.radius) ==
                  near_among_all(space, cloud.position, cloud.radius)));
      BOOST_TEST(found.first != nullptr);
    }
  }
}

BOOST_AUTO_TEST_CASE(are_right_at_every_age_of_the_list) {
  for (const Space& space : spaces) {
    Particles cloud = random_cloud(150, unit, 0.02, 0.06);
    Neighbours neighbours;
    int missed = 0;
    const long steps = 100;
    for (long k = 0; k < steps; ++k) {
      // All drift together as well, many periods far.
      cloud.position += 0.002 * cloud.velocity;
      cloud.position.col(0).array() += 0.3;
      const Candidates found = neighbours.candidates(space, cloud.position, cloud.radius);
      missed +=
          near_among(found, space, cloud.position, cloud.radius) != near_among_all(space, cloud.position, cloud.radius)
              ? 1
              : 0;
    }
    BOOST_TEST(missed == 0);
    BOOST_TEST(neighbours.searches() < steps / 5);
    BOOST_TEST(neighbours.searches() > 3);
  }
}

BOOST_AUTO_TEST_CASE(are_found_anew_when_bodies_grow_or_one_jumps) {
  Particles cloud = random_cloud(300, unit, 0.02, 0.02);
  Neighbours neighbours;
  const auto right = [&] {
    return near_among(neighbours.candidates(Space{}, cloud.position, cloud.radius), Space{}, cloud.position,
                      cloud.radius) == near_among_all(Space{}, cloud.position, cloud.radius);
  };
  BOOST_TEST(right());
  BOOST_TEST(right());
  BOOST_TEST(neighbours.searches() == 1);
  cloud.radius[7] = 0.5;
  BOOST_TEST(right());
  BOOST_TEST(neighbours.searches() == 2);
  cloud.position.row(8).setConstant(0.5);
  BOOST_TEST(right());
  BOOST_TEST(neighbours.searches() == 3);
  const Space box{.lengths = unit};
  BOOST_TEST((near_among(neighbours.candidates(box, cloud.position, cloud.radius), box, cloud.position, cloud.radius) ==
              near_among_all(box, cloud.position, cloud.radius)));
  BOOST_TEST(neighbours.searches() == 4);
}

BOOST_AUTO_TEST_CASE(serve_two_laws_by_one_search) {
  Particles cloud = random_cloud(300, unit, 0.02, 0.02);
  const Eigen::VectorXd wide = Eigen::VectorXd::Constant(300, 0.05);
  Neighbours neighbours;
  const auto ask = [&](const Eigen::VectorXd& size) {
    return near_among(neighbours.candidates(Space{}, cloud.position, size), Space{}, cloud.position, size) ==
           near_among_all(Space{}, cloud.position, size);
  };
  BOOST_TEST(ask(cloud.radius));
  BOOST_TEST(ask(wide));
  BOOST_TEST(neighbours.searches() == 2);
  // From now on what is asked first is searched as wide as what follows.
  for (int k = 0; k < 4; ++k) {
    cloud.position += 0.1 * cloud.velocity;
    BOOST_TEST(ask(cloud.radius));
    BOOST_TEST(ask(wide));
  }
  BOOST_TEST(neighbours.searches() == 6);
}

BOOST_AUTO_TEST_CASE(are_all_pairs_of_a_few_or_where_most_are_near) {
  const Particles handful = random_cloud(Neighbours::few, unit, 0.01, 0.01), dense = random_cloud(100, unit, 1.0, 1.0);
  Neighbours neighbours;
  BOOST_TEST(neighbours.candidates(Space{}, handful.position, handful.radius).first == nullptr);
  BOOST_TEST(neighbours.searches() == 0);
  BOOST_TEST(neighbours.candidates(Space{}, dense.position, dense.radius).first == nullptr);
  BOOST_TEST(neighbours.candidates(Space{}, dense.position, dense.radius).first == nullptr);
  BOOST_TEST(neighbours.searches() == 1);
}

BOOST_AUTO_TEST_CASE(leave_out_what_is_nowhere_and_recover) {
  Particles cloud = random_cloud(100, unit, 0.05, 0.05);
  const Vectors places = cloud.position;
  Neighbours neighbours;
  const auto right = [&] {
    return near_among(neighbours.candidates(Space{}, cloud.position, cloud.radius), Space{}, cloud.position,
                      cloud.radius) == near_among_all(Space{}, cloud.position, cloud.radius);
  };
  for (const double nowhere : {not_a_number, infinity, 1e300}) {
    cloud.position(50, 1) = nowhere;
    BOOST_TEST(right());
    cloud.position = places;
    BOOST_TEST(right());
  }
  BOOST_TEST(neighbours.candidates(Space{}, cloud.position, cloud.radius).first != nullptr);
}

BOOST_AUTO_TEST_CASE(of_points_are_none_too_few) {
  Particles points = random_cloud(100, unit, 1.0, 1.0);
  points.radius.setZero();
  points.position.row(99) = points.position.row(3);
  Neighbours neighbours;
  const Candidates found = neighbours.candidates(Space{}, points.position, points.radius);
  BOOST_TEST((near_among(found, Space{}, points.position, points.radius) == Pairs{{3, 99}}));
}

BOOST_AUTO_TEST_CASE(of_nothing_are_none) {
  Neighbours neighbours;
  BOOST_TEST(neighbours.candidates(Space{}, Vectors(0, 3), Eigen::VectorXd()).N == 0);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::neighbours_test
