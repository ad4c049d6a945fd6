#include <particulate/schemes/coupled_pair.hpp>

#include "close.hpp"

namespace tests::coupled_pair_test {

using namespace particulate::schemes;

static_assert(FirstOrderProblem<FirstOrderPair> && HasJacobian<FirstOrderPair> && StaggeredProblem<FirstOrderPair> &&
              !MeasuresFields<FirstOrderPair>);
static_assert(FirstOrderProblem<SecondOrderPair> && StaggeredProblem<SecondOrderPair> &&
              MeasuresFields<SecondOrderPair>);

const FirstOrderPair first{.a = (Eigen::Matrix2d() << 1.0, 2.0, 4.0, 3.0).finished()};
const SecondOrderPair second{.c12 = 2.0, .c21 = 4.0};

BOOST_AUTO_TEST_SUITE(FirstOrderPair_)

BOOST_AUTO_TEST_CASE(has_minus_a_times_y_for_its_rate_and_minus_a_for_its_jacobian) {
  Eigen::VectorXd dy(2);
  BOOST_TEST(first.rate(0.0, Eigen::Vector2d(1.0, -2.0), dy));
  BOOST_TEST(close(dy, Eigen::Vector2d(3.0, 2.0), {}));
  Eigen::MatrixXd J;
  first.jacobian(0.0, dy, J);
  BOOST_TEST(close(J, Eigen::Matrix2d{{-1.0, -2.0}, {-4.0, -3.0}}, {}));
}

// Dt = 1/2, other field seen as 6: w_1 = (5 - 6)/(3/2); other field seen as 7: w_2 = (2 - 14)/(5/2).
BOOST_AUTO_TEST_CASE(solves_one_field_by_backward_euler_with_the_other_frozen) {
  const State from{.t = 0.0, .y = Eigen::Vector2d(5.0, 2.0)}, seen{.t = 0.5, .y = Eigen::Vector2d(7.0, 6.0)};
  State to = seen;
  BOOST_TEST(first.solve(0, from, 0.5, seen, to));
  BOOST_TEST(close(to.y, Eigen::Vector2d(-2.0 / 3.0, 6.0), {.relative = 1e-15}));
  BOOST_TEST(first.solve(1, from, 0.5, seen, to));
  BOOST_TEST(close(to.y, Eigen::Vector2d(-2.0 / 3.0, -4.8), {.relative = 1e-15}));
}

BOOST_AUTO_TEST_CASE(has_no_value_where_its_equation_has_no_solution) {
  const FirstOrderPair growing{.a = (Eigen::Matrix2d() << -2.0, 1.0, 1.0, 0.0).finished()};
  const State from{.t = 0.0, .y = Eigen::Vector2d(5.0, 2.0)};
  State to = from;
  BOOST_TEST(!growing.solve(0, from, 0.5, from, to));
  BOOST_TEST(growing.solve(0, from, 0.25, from, to));
}

BOOST_AUTO_TEST_CASE(hands_out_the_part_of_a_field) {
  BOOST_TEST(first.fields() == 2U);
  BOOST_TEST(!first.part(1).motion);
  BOOST_TEST(first.part(1).first == 1);
  BOOST_TEST(first.part(1).size == 1);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(SecondOrderPair_)

BOOST_AUTO_TEST_CASE(has_the_rate_of_two_coupled_oscillators) {
  Eigen::VectorXd dy(4);
  BOOST_TEST(second.rate(0.0, Eigen::Vector4d(1.0, 3.0, -2.0, 5.0), dy));
  BOOST_TEST(close(dy, Eigen::Vector4d(3.0, 4.0, 5.0, -4.0), {}));
}

// Dt = 1/2: w_1' = 3 - 6, w_1 = 1 - 3/2 with the other seen as 6; w_2' = 5 - 14, w_2 = -2 - 9/2 with it seen as 7.
BOOST_AUTO_TEST_CASE(solves_one_field_by_backward_euler_with_the_other_frozen) {
  const State from{.t = 0.0, .y = Eigen::Vector4d(1.0, 3.0, -2.0, 5.0)},
      seen{.t = 0.5, .y = Eigen::Vector4d(7.0, 0.0, 6.0, 0.0)};
  State to = seen;
  BOOST_TEST(second.solve(0, from, 0.5, seen, to));
  BOOST_TEST(close(to.y, Eigen::Vector4d(-0.5, -3.0, 6.0, 0.0), {}));
  BOOST_TEST(second.solve(1, from, 0.5, seen, to));
  BOOST_TEST(close(to.y, Eigen::Vector4d(-0.5, -3.0, -6.5, -9.0), {}));
}

BOOST_AUTO_TEST_CASE(measures_values_and_not_their_rates) {
  BOOST_TEST(second.part(1).first == 2);
  BOOST_TEST(second.part(1).size == 2);
  BOOST_TEST(second.distance(1, Eigen::Vector2d(-2.0, 5.0), Eigen::Vector2d(1.0, 50.0)) == 3.0);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::coupled_pair_test
