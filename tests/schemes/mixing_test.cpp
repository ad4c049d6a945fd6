#include <particulate/schemes/mixing.hpp>

#include "close.hpp"

namespace tests::mixing_test {

using namespace particulate::schemes;

// x = M x + c with M = diag(2, -3, 0.5): no contraction. The fixed point is (-1, 1/4, 2).
const Eigen::Vector3d slopes(2.0, -3.0, 0.5), constant(1.0, 1.0, 1.0), fixed_point(-1.0, 0.25, 2.0);

template <class Mixing>
Eigen::VectorXd after(Mixing mixing, int sweeps) {
  Eigen::VectorXd x = Eigen::Vector3d(0.3, -0.7, 0.9);
  for (int k = 0; k < sweeps; ++k) {
    Eigen::VectorXd gx = slopes.cwiseProduct(x) + constant;
    mixing.next(x, gx);
  }
  return x;
}

BOOST_AUTO_TEST_SUITE(Picard_)

BOOST_AUTO_TEST_CASE(takes_what_the_map_gives) {
  BOOST_TEST(close(after(Picard{}, 1), Eigen::Vector3d(1.6, 3.1, 1.45), {.relative = 1e-15}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(Anderson_)

BOOST_AUTO_TEST_CASE(begins_with_what_the_map_gives) {
  BOOST_TEST(close(after(Anderson(3), 1), after(Picard{}, 1), {}));
}

// Three eigenvalues: the fourth iterate mixes all that there is to know of a linear map, contracting or not.
BOOST_AUTO_TEST_CASE(solves_a_linear_map_in_one_sweep_more_than_it_has_eigenvalues) {
  BOOST_TEST((after(Anderson(3), 3) - fixed_point).norm() > 0.01);
  BOOST_TEST(close(after(Anderson(3), 4), fixed_point, {.absolute = 1e-12}));
}

// Depth 1 is the secant method in the direction of the last difference, written out here.
BOOST_AUTO_TEST_CASE(mixes_one_earlier_iterate_in_at_depth_one) {
  const Eigen::Vector3d x_0(0.3, -0.7, 0.9), g_0 = slopes.cwiseProduct(x_0) + constant, x_1 = g_0;
  const Eigen::Vector3d g_1 = slopes.cwiseProduct(x_1) + constant, f_0 = g_0 - x_0, f_1 = g_1 - x_1;
  const double gamma = f_1.dot(f_1 - f_0) / (f_1 - f_0).squaredNorm();
  BOOST_TEST(close(after(Anderson(1), 2), g_1 - gamma * (g_1 - g_0), {.relative = 1e-14}));
}

BOOST_AUTO_TEST_CASE(overwrites_the_oldest_difference) {
  BOOST_TEST((after(Anderson(2), 4) - fixed_point).norm() > 1e-3);
  BOOST_TEST((after(Anderson(2), 4) - after(Anderson(3), 4)).norm() > 1e-3);
}

BOOST_AUTO_TEST_CASE(stays_where_nothing_changes_any_more) {
  Anderson mixing(2);
  Eigen::VectorXd x = fixed_point;
  for (int k = 0; k < 5; ++k) {
    Eigen::VectorXd gx = fixed_point;
    mixing.next(x, gx);
    BOOST_TEST(close(x, fixed_point, {}));
  }
}

BOOST_AUTO_TEST_CASE(forgets_the_last_step) {
  Anderson used(3);
  Eigen::VectorXd x = Eigen::Vector2d(5.0, 6.0), gx = Eigen::Vector2d(-7.0, 8.0);
  used.next(x, gx);
  used.forget();
  BOOST_TEST(close(after(used, 3), after(Anderson(3), 3), {}));
}

BOOST_AUTO_TEST_CASE(refuses_to_mix_nothing_in) {
  CHECK_REFUSED(Anderson(0), "depth must be at least 1, got 0; Picard is");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::mixing_test
