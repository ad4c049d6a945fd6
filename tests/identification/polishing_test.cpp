#include <particulate/identification/polishing.hpp>

#include <cmath>

#include "numbers.hpp"
#include "says.hpp"

namespace tests::polishing_test {

using boost::test_tools::tolerance;
using namespace particulate::identification;

const Box square{.lower = Eigen::Vector2d(-2.0, -2.0), .upper = Eigen::Vector2d(2.0, 2.0)};

// Rosenbrock's valley, least at (1, 1).
Eigen::VectorXd valley(const Eigen::VectorXd& x) { return Eigen::Vector2d(10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]); }

const Eigen::VectorXd start = Eigen::Vector2d(-1.2, 1.0);

BOOST_AUTO_TEST_SUITE(polish_)

BOOST_AUTO_TEST_CASE(finds_the_least_sum_of_squares_from_afar) {
  for (const bool central : {false, true}) {
    const Polished one = polish(valley, square, start, {.central = central});
    BOOST_TEST((one.parameters - Eigen::Vector2d::Ones()).norm() < 1e-6);
    // 100 (1 - 1.44)^2 + 2.2^2
    BOOST_TEST(one.before == 24.2, tolerance(1e-14));
    BOOST_TEST(one.after == valley(one.parameters).squaredNorm());
    BOOST_TEST(one.after < 1e-12);
    BOOST_TEST(!one.reason.empty());
  }
}

// Rounded, the middle of a box may be off by a few eps: no length by which to judge steps.
BOOST_AUTO_TEST_CASE(sets_out_from_the_middle_of_a_box) {
  for (const double middle : {0.5, 0.6, 0.65, 0.75}) {
    const Eigen::VectorXd at = Eigen::Vector2d::Constant(middle);
    const Polished one = polish(valley, {.lower = at.array() - 1.7, .upper = at.array() + 1.7}, at);
    BOOST_TEST((one.parameters - Eigen::Vector2d::Ones()).norm() < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(counts_every_evaluation) {
  long calls = 0;
  const Residuals counted = [&](const Eigen::VectorXd& x) {
    ++calls;
    return valley(x);
  };
  const Polished forward = polish(counted, square, start);
  BOOST_TEST(forward.evaluations == calls);
  BOOST_TEST(forward.for_differences % 2 == 0);
  BOOST_TEST(forward.for_differences > 10);
  BOOST_TEST(forward.for_differences < calls);
  calls = 0;
  const Polished central = polish(counted, square, start, {.central = true});
  BOOST_TEST(central.evaluations == calls);
  BOOST_TEST(central.for_differences % 4 == 0);
}

BOOST_AUTO_TEST_CASE(ends_at_its_limit_with_what_is_best_so_far) {
  for (const long limit : {1L, 2L, 3L, 4L, 20L}) {
    const Polished one = polish(valley, square, start, {.most_evaluations = limit});
    BOOST_TEST(one.evaluations == limit);
    BOOST_TEST(one.after <= one.before);
    BOOST_TEST(one.reason == "the limit of evaluations is reached");
  }
}

// The valley's least place outside the box: with x <= 1/2 the best is (1/2, 1/4), where only 1 - x = 1/2 is left.
BOOST_AUTO_TEST_CASE(finds_a_minimum_on_a_bound_and_leaves_a_bound) {
  Box half = square;
  half.upper[0] = 0.5;
  const Polished on = polish(valley, half, start);
  BOOST_TEST(on.after == 0.25, tolerance(1e-6));
  BOOST_TEST(on.parameters[0] <= 0.5);
  BOOST_TEST(on.parameters[0] == 0.5, tolerance(1e-4));
  const Polished off = polish(valley, square, square.lower);
  BOOST_TEST((off.parameters - Eigen::Vector2d::Ones()).norm() < 1e-6);
}

// A minimum at the start on a bound: whatever it moves to is worse.
BOOST_AUTO_TEST_CASE(gives_back_its_start_if_nothing_is_better) {
  const Residuals far = [](const Eigen::VectorXd& x) { return Eigen::VectorXd(x.array() + 3.0); };
  const Polished one = polish(far, square, square.lower);
  BOOST_TEST((one.parameters == square.lower));
  BOOST_TEST(one.after == one.before);
  // Noise without any slope.
  const Residuals noise = [](const Eigen::VectorXd& x) { return Eigen::VectorXd((1e9 * x.array()).sin() + 2.0); };
  const Polished other = polish(noise, square, start);
  BOOST_TEST(other.after <= other.before);
}

BOOST_AUTO_TEST_CASE(takes_a_difference_to_the_other_side_where_one_side_has_no_residuals) {
  // Nothing beyond x = 0.9 or y = 0.9: the least place is near (0.9, 0.81), against the edge.
  const Residuals cut = [](const Eigen::VectorXd& x) {
    return x.maxCoeff() > 0.9 ? Eigen::VectorXd() : Eigen::VectorXd(valley(x));
  };
  const Eigen::VectorXd edge = Eigen::Vector2d(0.0, 0.9);
  const Polished one = polish(cut, square, edge);
  BOOST_TEST(one.failed_differences >= 1);
  // From 100 * 0.81 + 1 down to at most 0.1; 0.01 is the least.
  BOOST_TEST(one.before == 82.0, tolerance(1e-14));
  BOOST_TEST(one.after < 0.1);
  // A single place.
  const Residuals point = [](const Eigen::VectorXd& x) {
    return (x - start).norm() > 1e-9 ? Eigen::VectorXd() : Eigen::VectorXd(valley(x));
  };
  const Polished nowhere = polish(point, square, start);
  BOOST_TEST(nowhere.failed_differences == 4);
  BOOST_TEST(nowhere.after <= nowhere.before);
}

BOOST_AUTO_TEST_CASE(stays_where_it_is_allowed) {
  Box below = square;
  below.allows = [](const Eigen::VectorXd& x) { return x[0] + x[1] < 1.0; };
  const Polished one = polish(valley, below, start);
  BOOST_TEST(below.allows(one.parameters));
  BOOST_TEST(one.after < 1.0);
}

BOOST_AUTO_TEST_CASE(does_nothing_where_the_start_has_no_residuals) {
  const Polished one = polish([](const auto&) { return Eigen::VectorXd(); }, square, start);
  BOOST_TEST((one.parameters == start));
  BOOST_TEST(std::isinf(one.after));
  BOOST_TEST(one.reason == "the start has no residuals");
}

BOOST_AUTO_TEST_CASE(refuses_what_cannot_be_meant) {
  const Residuals one = [](const Eigen::VectorXd& x) { return Eigen::VectorXd(x.head(1)); };
  CHECK_REFUSED(polish(one, square, start), "there must be at least as many residuals as parameters, got 1 and 2");
  const Residuals changing = [](const Eigen::VectorXd& x) {
    return Eigen::VectorXd::Ones(x[0] == -1.2 ? 2 : 3).eval();
  };
  CHECK_REFUSED(polish(changing, square, start), "as many residuals for all parameters, got 2 and 3");
  CHECK_REFUSED(polish(valley, square, Eigen::Vector2d(3.0, 0.0)), "the start must lie in the box");
  CHECK_REFUSED(polish(valley, square, Eigen::VectorXd::Zero(3)), "the start must lie in the box");
  CHECK_REFUSED(polish(valley, {.lower = start, .upper = start}, start), "the lower below the upper");
  const auto refuses = [](const Polishing& polishing, const char* words) { CHECK_REFUSED(validate(polishing), words); };
  refuses({.step = 0.0}, "the step of differences must lie between 0 and 0.5 widths of the box, got 0");
  refuses({.step = not_a_number}, "got nan");
  refuses({.tolerance = -1.0}, "the tolerance must not be negative, got -1");
  refuses({.most_evaluations = 0}, "at least one evaluation must be allowed, got 0");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::polishing_test
