#include <particulate/schemes/collocation_table.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "close.hpp"

namespace tests::collocation_table_test {

using namespace particulate::schemes;

// By how much sum_j weights_j c_j^(k-1) misses upto^k/k, the integral of x^(k-1), for k up to `order`.
double defect(const Eigen::VectorXd& weights, const Eigen::VectorXd& c, double upto, int order) {
  double worst = 0.0;
  for (int k = 1; k <= order; ++k) {
    const double sum = (weights.array() * c.array().pow(k - 1)).sum();
    worst = std::max(worst, std::abs(sum - std::pow(upto, k) / k));
  }
  return worst;
}

constexpr double rounding = 4e-16;

BOOST_AUTO_TEST_SUITE(gauss_nodes_)

BOOST_AUTO_TEST_CASE(are_the_zeros_of_the_legendre_polynomials) {
  BOOST_TEST(gauss_nodes(1) == std::vector<long double>{0.5L});
  BOOST_TEST(std::abs(static_cast<double>(gauss_nodes(2)[0] - (0.5L - std::sqrt(3.0L) / 6.0L))) <= 1e-18);
  BOOST_TEST(std::abs(static_cast<double>(gauss_nodes(3)[2] - (0.5L + std::sqrt(15.0L) / 10.0L))) <= 1e-18);
}

BOOST_AUTO_TEST_CASE(lie_as_far_from_the_start_as_from_the_end) {
  for (int s = 1; s <= 16; ++s) {
    const std::vector<long double> c = gauss_nodes(s);
    BOOST_TEST_REQUIRE(static_cast<int>(c.size()) == s);
    for (std::size_t j = 0; j < c.size(); ++j) BOOST_TEST(c[j] + c[c.size() - 1 - j] == 1.0L);
  }
}

BOOST_AUTO_TEST_CASE(refuse_a_number_of_stages_that_is_not_offered) {
  CHECK_REFUSED(gauss_nodes(0), "stages must be 1 to 16, got 0");
  CHECK_REFUSED(gauss_nodes(17), "stages must be 1 to 16, got 17");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(radau_nodes_)

// P_3 - P_2 = (x - 1)(5 x^2 + 2 x - 1)/2 on [-1, 1]: x = (-1 -+ sqrt 6)/5, c = (4 -+ sqrt 6)/10.
BOOST_AUTO_TEST_CASE(end_at_the_end_of_the_step) {
  BOOST_TEST(radau_nodes(1) == std::vector<long double>{1.0L});
  const std::vector<long double> three = radau_nodes(3);
  BOOST_TEST(std::abs(static_cast<double>(three[0] - (4.0L - std::sqrt(6.0L)) / 10.0L)) <= 1e-18);
  BOOST_TEST(std::abs(static_cast<double>(three[1] - (4.0L + std::sqrt(6.0L)) / 10.0L)) <= 1e-18);
  for (int s = 1; s <= 16; ++s) {
    const std::vector<long double> c = radau_nodes(s);
    BOOST_TEST(static_cast<int>(c.size()) == s);
    BOOST_TEST(c.back() == 1.0L);
  }
}

BOOST_AUTO_TEST_CASE(refuse_a_number_of_stages_that_is_not_offered) {
  CHECK_REFUSED(radau_nodes(17), "stages must be 1 to 16, got 17");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(collocation_table_)

// @cite hairer1993, tables II.7.3 and 7.7.
BOOST_AUTO_TEST_CASE(are_those_of_the_literature_for_two_stages) {
  const double root = std::sqrt(3.0) / 6.0;
  const CollocationTable gauss = collocation_table(gauss_nodes(2));
  BOOST_TEST(close(gauss.A, Eigen::Matrix2d{{0.25, 0.25 - root}, {0.25 + root, 0.25}}, {.absolute = 1e-16}));
  BOOST_TEST(close(gauss.b, Eigen::Vector2d(0.5, 0.5), {.absolute = 1e-16}));
  const CollocationTable radau = collocation_table(radau_nodes(2));
  BOOST_TEST(close(radau.A, Eigen::Matrix2d{{5.0 / 12.0, -1.0 / 12.0}, {0.75, 0.25}}, {.absolute = 1e-16}));
  BOOST_TEST(close(radau.b, Eigen::Vector2d(0.75, 0.25), {.absolute = 1e-16}));
}

// A A = A/2 - I/12 for two Gauss stages: the characteristic polynomial of A is x^2 - x/2 + 1/12. What a rate adds to
// the velocity at c_j moves the body for the rest of the step: b_bar_j = b_j (1 - c_j).
BOOST_AUTO_TEST_CASE(of_the_nystrom_form_are_those_of_the_method_applied_twice) {
  const CollocationTable gauss = collocation_table(gauss_nodes(2));
  const Eigen::Matrix2d twice = 0.5 * gauss.A - Eigen::Matrix2d::Identity() / 12.0;
  BOOST_TEST(close(gauss.A_bar, twice, {.absolute = 1e-16}));
  const Eigen::Vector2d by_parts = gauss.b.array() * (1.0 - gauss.c.array());
  BOOST_TEST(close(gauss.b_bar, by_parts, {.absolute = 1e-16}));
  const CollocationTable euler = collocation_table(radau_nodes(1));
  BOOST_TEST(euler.A_bar(0, 0) == 1.0);
  BOOST_TEST(euler.b_bar[0] == 1.0);
}

BOOST_AUTO_TEST_CASE(integrate_polynomials_up_to_the_nodes_and_to_the_end) {
  for (int s = 1; s <= 16; ++s) {
    const CollocationTable gauss = collocation_table(gauss_nodes(s));
    const CollocationTable radau = collocation_table(radau_nodes(s));
    BOOST_TEST(defect(gauss.b, gauss.c, 1.0, 2 * s) <= rounding);
    BOOST_TEST(defect(radau.b, radau.c, 1.0, 2 * s - 1) <= rounding);
    BOOST_TEST(defect(gauss.w, gauss.x, 1.0, 2 * s) <= rounding);
    for (Eigen::Index i = 0; i < s; ++i) {
      BOOST_TEST(defect(gauss.A.row(i).transpose(), gauss.c, gauss.c[i], s) <= rounding);
      BOOST_TEST(defect(radau.A.row(i).transpose(), radau.c, radau.c[i], s) <= rounding);
    }
  }
}

// b_i a_ij + b_j a_ji = b_i b_j: @cite hairer2006, section IV.2.1.
BOOST_AUTO_TEST_CASE(make_gauss_symplectic) {
  for (int s = 1; s <= 16; ++s) {
    const CollocationTable of = collocation_table(gauss_nodes(s));
    const Eigen::MatrixXd weighted = of.b.asDiagonal() * of.A;
    const Eigen::MatrixXd sum = weighted + weighted.transpose(), product = of.b * of.b.transpose();
    BOOST_TEST(close(sum, product, {.absolute = 1e-16}));
  }
}

BOOST_AUTO_TEST_CASE(refuse_nodes_that_do_not_rise_within_the_step) {
  const auto refuses = [](const std::vector<long double>& nodes, const char* words) {
    CHECK_REFUSED(collocation_table(nodes), words);
  };
  refuses({0.0L, 1.0L}, "nodes must rise within (0, 1], got 0 as number 1");
  refuses({0.5L, 0.5L}, "got 0.5 as number 2");
  refuses({0.5L, 1.5L}, "got 1.5 as number 2");
  refuses({std::numeric_limits<long double>::quiet_NaN()}, "got nan as number 1");
  refuses({}, "stages must be 1 to 16, got 0");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(CollocationTable_)

BOOST_AUTO_TEST_CASE(has_polynomials_that_are_one_at_their_own_node) {
  const auto& of = table_of<Radau<3>>();
  for (int i = 0; i < 3; ++i) { BOOST_TEST(close(of.basis(of.c[i]), Eigen::Vector3d::Unit(i), {.absolute = 1e-15})); }
}

// x^2 - 3 x through its values at three nodes, inside and well beyond.
BOOST_AUTO_TEST_CASE(runs_polynomials_on_and_integrates_them_once_and_twice) {
  const auto& of = table_of<Gauss<3>>();
  const Eigen::Vector3d values = of.c.array() * (of.c.array() - 3.0);
  for (const double x : {0.0, 0.3, 1.0, 2.5}) {
    BOOST_TEST(std::abs(of.basis(x).dot(values) - x * (x - 3.0)) <= 1e-14);
    BOOST_TEST(std::abs(of.once(x).dot(values) - (x * x * x / 3.0 - 1.5 * x * x)) <= 1e-14);
  }
  const Eigen::Vector3d line = 3.0 - 2.0 * of.c.array();
  BOOST_TEST(std::abs(of.twice(0.3).dot(line) - (1.5 * 0.09 - 0.027 / 3.0)) <= 1e-15);
}

BOOST_AUTO_TEST_CASE(has_its_weights_at_the_nodes_and_at_the_end) {
  const auto& of = table_of<Gauss<3>>();
  BOOST_TEST(close(of.once(1.0), of.b, {.absolute = 4e-16}));
  BOOST_TEST(close(of.twice(1.0), of.b_bar, {.absolute = 4e-16}));
  for (int i = 0; i < 3; ++i) {
    BOOST_TEST(close(of.once(of.c[i]), of.A.row(i).transpose(), {.absolute = 4e-16}));
    BOOST_TEST(close(of.twice(of.c[i]), of.A_bar.row(i).transpose(), {.absolute = 4e-16}));
  }
  BOOST_TEST(of.once(0.0).isZero(0.0));
}

// The leading coefficient of 2 - x + 5 x^2 is 5.
BOOST_AUTO_TEST_CASE(knows_the_leading_coefficient) {
  const auto& of = table_of<Gauss<3>>();
  const Eigen::Vector3d values = 2.0 - of.c.array() + 5.0 * of.c.array().square();
  BOOST_TEST(std::abs(of.top.dot(values) - 5.0) <= 1e-13);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::collocation_table_test
