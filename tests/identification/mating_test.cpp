#include <particulate/identification/mating.hpp>

#include <vector>

#include <boost/test/unit_test.hpp>

namespace tests::mating_test {

using namespace particulate::identification;

BOOST_AUTO_TEST_SUITE(mated_)

// 0.25 * 1 + 0.75 * 3 = 2.5; 0.5 * 10 + 0.5 * (-2) = 4.
BOOST_AUTO_TEST_CASE(mixes_every_component_by_a_number_of_its_own) {
  std::vector<double> phi{0.5, 0.25};
  const auto next = [&] {
    const double last = phi.back();
    phi.pop_back();
    return last;
  };
  const Eigen::VectorXd child = mated(Eigen::Vector2d(1.0, 10.0), Eigen::Vector2d(3.0, -2.0), next);
  BOOST_TEST(child[0] == 2.5);
  BOOST_TEST(child[1] == 4.0);
}

// 0.1 * 0.7 + 0.9 * 0.7 is not 0.7 in double arithmetic for every Phi.
BOOST_AUTO_TEST_CASE(never_leaves_the_span_of_its_parents_by_a_rounding) {
  for (int n = 0; n <= 1000; ++n) {
    const auto phi = [&] { return n / 1000.0; };
    const Eigen::VectorXd same = Eigen::Vector2d(0.7, 0.1);
    BOOST_REQUIRE(mated(same, same, phi) == same);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::mating_test
