#include <particulate/reference/fixed_point.hpp>

#include <cmath>
#include <stdexcept>
#include <string>

#include "close.hpp"

namespace tests::fixed_point_test {

using namespace particulate::reference;
using namespace particulate::schemes;

Map affine(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  return [A, b](In x, Out g) {
    g = A * x + b;
    return true;
  };
}

// g_i = 0.45 (x_(i-1) + x_(i+1)) + 0.3 cos x_i: its derivative reaches 0.9 + 0.3, it is no contraction.
bool chain(In x, Out g) {
  const Eigen::Index n = x.size();
  for (Eigen::Index i = 0; i < n; ++i) {
    g[i] = 0.45 * ((i > 0 ? x[i - 1] : 0.0) + (i + 1 < n ? x[i + 1] : 0.0)) + 0.3 * std::cos(x[i]);
  }
  return true;
}

BOOST_AUTO_TEST_SUITE(solve_fixed_point_)

// x = x/2 + 1 from 0: x^K = 2 - 2^(1-K), so that the change of iteration K is 2^(1-K), and 2^-10 that of iteration 11.
BOOST_AUTO_TEST_CASE(a_halving_map_ends_in_the_iteration_and_with_the_change_that_its_closed_form_has) {
  const Map halving = affine(Eigen::MatrixXd::Constant(1, 1, 0.5), Eigen::VectorXd::Ones(1));
  Eigen::VectorXd x = Eigen::VectorXd::Zero(1);
  const FixedPoint at = solve_fixed_point(halving, x, {.tolerance = 1.0 / 1024});
  BOOST_TEST(at.converged);
  BOOST_TEST(at.reason == "");
  BOOST_TEST(at.iterations == 11);
  BOOST_TEST(at.evaluations == 11);
  BOOST_TEST(at.change == 1.0 / 1024, tolerance(0.0));
  BOOST_TEST(x[0] == 2.0 - 1.0 / 1024, tolerance(0.0));
}

// Two unknowns that halve, from 2 and 1 above their fixed points: the largest change, 1, 1/2 ..., is that of the first.
BOOST_AUTO_TEST_CASE(the_change_is_that_of_the_unknown_that_changes_most) {
  const Map halving = affine(0.5 * Eigen::Matrix2d::Identity(), Eigen::Vector2d(1.0, -3.0));
  Eigen::VectorXd x = Eigen::Vector2d(4.0, -5.0);
  const FixedPoint at = solve_fixed_point(halving, x, {.tolerance = 0.126});
  BOOST_TEST(at.iterations == 4);
  BOOST_TEST(at.change == 0.125, tolerance(0.0));
  BOOST_TEST(close(x, Eigen::Vector2d(2.125, -5.9375), {}));
}

BOOST_AUTO_TEST_CASE(started_at_the_fixed_point_it_takes_one_iteration) {
  const Map halving = affine(Eigen::MatrixXd::Constant(1, 1, 0.5), Eigen::VectorXd::Ones(1));
  for (const int anderson : {0, 1}) {
    Eigen::VectorXd x = Eigen::VectorXd::Constant(1, 2.0);
    const FixedPoint at = solve_fixed_point(halving, x, {.anderson = anderson});
    BOOST_TEST((at.converged && at.iterations == 1 && at.change == 0.0 && x[0] == 2.0));
  }
}

// x = 3 - 2 x from 0 oscillates away: 0, 3, -3, 9. Through two points Anderson's mixture is the secant's, here exact.
BOOST_AUTO_TEST_CASE(anderson_solves_a_line_with_two_evaluations_where_plain_iteration_diverges) {
  const Map line = affine(Eigen::MatrixXd::Constant(1, 1, -2.0), Eigen::VectorXd::Constant(1, 3.0));
  Eigen::VectorXd x = Eigen::VectorXd::Zero(1);
  const FixedPoint plain = solve_fixed_point(line, x, {.max_iterations = 3});
  BOOST_TEST(!plain.converged);
  BOOST_TEST(plain.iterations == 3);
  BOOST_TEST(plain.change == 12.0, tolerance(0.0));
  BOOST_TEST(x[0] == 9.0, tolerance(0.0));
  BOOST_TEST(
      contains(plain.reason, "max_iterations = 3 were not enough, the last changed an unknown by 12; allow more"));

  x.setZero();
  const FixedPoint mixed = solve_fixed_point(line, x, {.anderson = 1});
  BOOST_TEST(mixed.converged);
  BOOST_TEST(mixed.iterations == 3);
  BOOST_TEST(x[0] == 1.0, tolerance(1e-15));
}

// Depth m solves an affine map of m unknowns with m + 2 evaluations, the last of which shows that nothing changes; less
// depth does not.
BOOST_AUTO_TEST_CASE(the_depth_is_the_one_asked_for) {
  Eigen::Matrix3d A;
  A << 0.0, -2.0, 0.5, 1.0, 0.3, 0.0, 0.2, 0.7, -1.5;
  const Eigen::Vector3d exact(1.0, -1.0, 2.0);
  const Eigen::Vector3d b = exact - A * exact;
  for (const int anderson : {1, 2, 3}) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(3);
    const FixedPoint at = solve_fixed_point(affine(A, b), x, {.tolerance = 1e-10, .anderson = anderson});
    BOOST_TEST((at.converged && at.iterations == 5) == (anderson == 3), at.iterations);
    if (anderson == 3) BOOST_TEST(close(x, exact, {.relative = 1e-12}));
  }
}

BOOST_AUTO_TEST_CASE(a_map_that_is_no_contraction_converges_with_anderson_alone) {
  Eigen::VectorXd plain = Eigen::VectorXd::Zero(20);
  const FixedPoint never = solve_fixed_point(chain, plain, {.tolerance = 1e-13, .max_iterations = 2000});
  BOOST_TEST(!never.converged);
  BOOST_TEST(never.iterations == 2000);
  BOOST_TEST(never.evaluations == 2000);
  BOOST_TEST(never.change > 1e-3);
  for (const int anderson : {1, 2, 3, 5}) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(20), g(20);
    const FixedPoint at = solve_fixed_point(chain, x, {.tolerance = 1e-13, .anderson = anderson});
    BOOST_TEST(at.converged);
    BOOST_TEST(at.evaluations == at.iterations);
    BOOST_TEST(at.iterations < 100);
    chain(x, g);
    BOOST_TEST(close(x, g, {.absolute = 1e-12}));
  }
}

BOOST_AUTO_TEST_CASE(no_unknowns_converge_at_once) {
  Eigen::VectorXd nothing(0);
  const FixedPoint at =
      solve_fixed_point([](In, Out) -> bool { throw std::logic_error("nobody asks for this map"); }, nothing);
  BOOST_TEST((at.converged && at.iterations == 0 && at.evaluations == 0 && at.change == 0.0));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(solve_fixed_point_without_a_value)

BOOST_AUTO_TEST_CASE(a_map_without_one_ends_the_iteration_where_it_started) {
  for (const bool says_so : {true, false}) {
    // sqrt(x) - 1 from 9: 2, 0.41, then -0.36.
    const Map root = [says_so](In x, Out g) {
      g[0] = std::sqrt(x[0]) - 1.0;
      return !says_so || x[0] >= 0.0;
    };
    Eigen::VectorXd x = Eigen::VectorXd::Constant(1, 9.0);
    const FixedPoint at = solve_fixed_point(root, x);
    BOOST_TEST(!at.converged);
    BOOST_TEST(at.evaluations == 4);
    BOOST_TEST(at.reason == "the map had no finite value in iteration 4; start closer to the fixed point");
    BOOST_TEST(x[0] == 9.0);
  }
}

BOOST_AUTO_TEST_CASE(an_iteration_that_leaves_the_range_of_a_double_has_none) {
  const Map doubling = affine(Eigen::MatrixXd::Constant(1, 1, 2.0), Eigen::VectorXd::Zero(1));
  Eigen::VectorXd x = Eigen::VectorXd::Ones(1);
  const FixedPoint at = solve_fixed_point(doubling, x, {.max_iterations = 5000});
  BOOST_TEST(!at.converged);
  BOOST_TEST(at.evaluations == 1024);  // 2^1024 is too large
  BOOST_TEST(contains(at.reason, "no finite value in iteration 1024"));
}

// x = x + 1 has no fixed point. Two values of g(x) - x that are equal leave Anderson's mixture undetermined: 0/0, which
// KINSOL's norm takes for no change at all.
BOOST_AUTO_TEST_CASE(a_mixture_that_is_undetermined_is_no_fixed_point) {
  const Map shift = affine(Eigen::Matrix2d::Identity(), Eigen::Vector2d(1.0, 1.0));
  for (const int anderson : {1, 2}) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(2);
    const FixedPoint at = solve_fixed_point(shift, x, {.anderson = anderson});
    BOOST_TEST(!at.converged);
    BOOST_TEST(contains(at.reason, "iteration 2 led to a value that is not finite"));
    BOOST_TEST(contains(at.reason, "take a smaller anderson, or another start"));
    BOOST_TEST(close(x, Eigen::Vector2d::Zero(), {}));
  }
}

BOOST_AUTO_TEST_CASE(what_the_map_throws_comes_out_at_once_and_the_start_stays) {
  long after = 0;
  bool thrown = false;
  const Map mistaken = [&](In x, Out g) -> bool {
    if (thrown) ++after;
    g = 0.5 * x;
    if (x[0] < 0.2) {
      thrown = true;
      throw std::domain_error("this map knows no small numbers");
    }
    return true;
  };
  Eigen::VectorXd x = Eigen::VectorXd::Ones(1);
  BOOST_CHECK_EXCEPTION((void)solve_fixed_point(mistaken, x), std::domain_error,
                        says("this map knows no small numbers"));
  BOOST_TEST(after == 0);
  BOOST_TEST(x[0] == 1.0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(solve_fixed_point_mistakes)

BOOST_AUTO_TEST_CASE(a_bad_setting_or_start_is_refused) {
  const Map halving = affine(0.5 * Eigen::Matrix2d::Identity(), Eigen::Vector2d::Zero());
  const auto refused = [&](const FixedPointSettings& settings, const std::string& words) {
    Eigen::VectorXd x = Eigen::VectorXd::Ones(2);
    CHECK_REFUSED(solve_fixed_point(halving, x, settings), words);
  };
  for (const double bad : {0.0, -1.0, infinity, not_a_number}) {
    refused({.tolerance = bad}, "fixed point: tolerance must be positive and finite, got ");
  }
  refused({.anderson = -1}, "anderson must lie in 0 ... 2, the number of unknowns");
  refused({.anderson = 3}, "depend on one another), got 3");
  refused({.max_iterations = 0}, "max_iterations must be positive, got 0");
  for (const double bad : {infinity, not_a_number}) {
    Eigen::VectorXd x = Eigen::Vector2d(1.0, bad);
    CHECK_REFUSED(solve_fixed_point(halving, x), "the start must be finite");
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::fixed_point_test
