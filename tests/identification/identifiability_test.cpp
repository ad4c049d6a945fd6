#include <particulate/identification/identifiability.hpp>

#include <cmath>
#include <stdexcept>

#include <Eigen/LU>

#include "close.hpp"

namespace tests::identifiability_test {

using namespace particulate::identification;

// A straight line a + b x at x = 0, 1, 2.
Eigen::MatrixXd line() {
  Eigen::MatrixXd J(3, 2);
  J << 1.0, 0.0,  //
      1.0, 1.0,   //
      1.0, 2.0;
  return J;
}

BOOST_AUTO_TEST_SUITE(sensitivities_)

// Central differences have no error in a square: y = (p0^2, p0 p1), J = (2 p0, 0; p1, p0).
BOOST_AUTO_TEST_CASE(are_exact_up_to_squares) {
  const SampledModel model = [](const Eigen::VectorXd& p) -> Eigen::VectorXd {
    return Eigen::Vector2d(p[0] * p[0], p[0] * p[1]);
  };
  const Sensitivities found = sensitivities(model, Eigen::Vector2d(2.0, -4.0), {.step = 0x1p-10});
  BOOST_TEST(close(found.jacobian, (Eigen::Matrix2d() << 4.0, 0.0, -4.0, 2.0).finished(), {}));
  BOOST_TEST(found.evaluations == 4);
  BOOST_TEST(found.failures == 0);
  BOOST_TEST(found.reason == "");
}

// (e^h - e^-h)/(2 h) = 1 + h^2/6 + ..., with h = step times size.
BOOST_AUTO_TEST_CASE(move_parameters_by_the_step_times_their_size) {
  const SampledModel model = [](const Eigen::VectorXd& p) -> Eigen::VectorXd { return p.array().exp(); };
  const auto at_zero = [&](double step, double size) {
    return sensitivities(model, Eigen::VectorXd::Zero(1), {.step = step, .size = Eigen::VectorXd::Constant(1, size)})
        .jacobian(0, 0);
  };
  BOOST_TEST(at_zero(0.01, 3.0) == std::sinh(0.03) / 0.03, tolerance(1e-14));
  const Sensitivities by_itself = sensitivities(model, Eigen::VectorXd::Constant(1, 2.0), {.step = 0.01});
  BOOST_TEST(by_itself.jacobian(0, 0) == std::exp(2.0) * std::sinh(0.02) / 0.02, tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(count_and_name_what_has_no_value) {
  const SampledModel model = [](const Eigen::VectorXd& p) -> Eigen::VectorXd {
    if (p[1] > 1.0) throw std::runtime_error("too much");
    return p[0] < 1.0 ? Eigen::VectorXd() : p;
  };
  const Sensitivities found = sensitivities(model, Eigen::Vector2d(1.0, 1.0), {.step = 0.1});
  BOOST_TEST(found.jacobian.size() == 0);
  BOOST_TEST(found.evaluations == 4);
  BOOST_TEST(found.failures == 2);
  BOOST_TEST(found.reason == "parameter 1 has no value at 1.1: move it by less");
}

BOOST_AUTO_TEST_CASE(refuse_steps_that_move_nothing) {
  const SampledModel same = [](const Eigen::VectorXd& p) { return p; };
  const Eigen::Vector2d zero{1.0, 0.0}, one{1.0, 1.0};
  CHECK_REFUSED(sensitivities(same, zero), "the least 0: give sizes where a parameter is 0");
  CHECK_REFUSED(sensitivities(same, one, {.step = 0.0}), "got a step of 0");
  CHECK_REFUSED(sensitivities(same, one, {.size = Eigen::VectorXd::Ones(1)}), "for each of 2 parameters");
  const SampledModel grows = [](const Eigen::VectorXd& p) -> Eigen::VectorXd {
    return Eigen::VectorXd::Ones(p[0] > 1.0 ? 2 : 1);
  };
  CHECK_REFUSED(sensitivities(grows, one), "as many numbers for all parameters");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(to_other_parameters_)

// q = (p0 + p1, p0 - p1): p0 = (q0 + q1)/2, p1 = (q0 - q1)/2.
BOOST_AUTO_TEST_CASE(follows_the_chain_rule) {
  const Eigen::Matrix2d derivative = (Eigen::Matrix2d() << 1.0, 1.0, 1.0, -1.0).finished();
  const Eigen::Matrix<double, 3, 2> expected =
      (Eigen::Matrix<double, 3, 2>() << 0.5, 0.5, 1.0, 0.0, 1.5, -0.5).finished();
  BOOST_TEST(close(to_other_parameters(line(), derivative), expected, {.relative = 1e-15, .absolute = 1e-16}));
}

BOOST_AUTO_TEST_CASE(refuses_parameters_that_do_not_determine_the_first) {
  CHECK_REFUSED(to_other_parameters(line(), Eigen::Matrix2d::Ones()), "square and invertible, got 2 x 2 of rank 1");
  CHECK_REFUSED(to_other_parameters(line(), Eigen::Matrix3d::Identity()), "determine the 2 of the Jacobian");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(uncertainty_)

// J^T J = (3, 3; 3, 5), its inverse (5, -3; -3, 3)/6; noise 0.2 makes it 0.04 times as large.
BOOST_AUTO_TEST_CASE(of_a_straight_line_is_known) {
  const Uncertainty found = uncertainty(line(), Eigen::VectorXd::Constant(3, 0.2));
  const Eigen::Matrix2d expected = 0.04 / 6.0 * (Eigen::Matrix2d() << 5.0, -3.0, -3.0, 3.0).finished();
  BOOST_TEST(found.rank == 2);
  BOOST_TEST(close(found.covariance, expected, {.relative = 1e-13}));
  BOOST_TEST(
      close(found.deviation, Eigen::Vector2d(0.2 * std::sqrt(5.0 / 6.0), 0.2 * std::sqrt(0.5)), {.relative = 1e-14}));
  BOOST_TEST(found.correlation(0, 1) == -3.0 / std::sqrt(15.0), tolerance(1e-14));
  BOOST_TEST(found.correlation(0, 0) == 1.0);
  // Eigenvalues of J^T J: 4 +- sqrt(10), over the noise squared.
  BOOST_TEST(found.singular_values[0] == std::sqrt(4.0 + std::sqrt(10.0)) / 0.2, tolerance(1e-14));
  BOOST_TEST(found.singular_values[1] == std::sqrt(4.0 - std::sqrt(10.0)) / 0.2, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(weighs_each_datum_by_its_own_noise) {
  const Uncertainty found = uncertainty(Eigen::Matrix2d::Identity(), Eigen::Vector2d(0.5, 0.25));
  BOOST_TEST(close(found.deviation, Eigen::Vector2d(0.5, 0.25), {.relative = 1e-15}));
  BOOST_TEST(std::abs(found.directions(0, 1)) == 1.0);  // the weakest is the first parameter
}

// The data see p0 + p1 and p2 alone.
BOOST_AUTO_TEST_CASE(is_infinite_without_a_nan_along_what_is_not_seen) {
  const Eigen::MatrixXd J = (Eigen::MatrixXd(3, 3) << 1.0, 1.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 2.0).finished();
  const Uncertainty found = uncertainty(J, Eigen::VectorXd::Ones(3));
  BOOST_TEST(found.rank == 2);
  BOOST_TEST(found.deviation[0] == infinity);
  BOOST_TEST(found.deviation[1] == infinity);
  BOOST_TEST(found.deviation[2] == 0.5, tolerance(1e-15));
  BOOST_TEST(found.covariance(0, 1) == -infinity);
  BOOST_TEST(std::abs(found.covariance(0, 2)) <= 1e-15);
  BOOST_TEST(found.correlation(0, 1) == -1.0, tolerance(1e-14));
  BOOST_TEST(found.correlation(0, 2) == 0.0);
  BOOST_TEST(std::abs(found.directions(0, 2)) == std::sqrt(0.5), tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(is_infinite_where_there_are_fewer_data_than_parameters_or_none_is_seen) {
  const Uncertainty few = uncertainty(Eigen::RowVector2d(3.0, 0.0), Eigen::VectorXd::Ones(1));
  BOOST_TEST(few.rank == 1);
  BOOST_TEST(few.deviation[0] == 1.0 / 3.0, tolerance(1e-15));
  BOOST_TEST(few.deviation[1] == infinity);
  const Uncertainty none = uncertainty(Eigen::Matrix2d::Zero(), Eigen::VectorXd::Ones(2));
  BOOST_TEST(none.rank == 0);
  BOOST_TEST((none.deviation.array() == infinity).all());
  BOOST_TEST(none.correlation(0, 1) == 0.0);
}

BOOST_AUTO_TEST_CASE(takes_a_weak_direction_for_unseen_where_it_is_told_to) {
  const Eigen::Matrix2d J = Eigen::Vector2d(1.0, 1e-6).asDiagonal();
  BOOST_TEST(uncertainty(J, Eigen::VectorXd::Ones(2)).deviation[1] == 1e6, tolerance(1e-14));
  BOOST_TEST(uncertainty(J, Eigen::VectorXd::Ones(2), 1e-5).deviation[1] == infinity);
}

BOOST_AUTO_TEST_CASE(refuses_noise_and_jacobians_that_are_none) {
  CHECK_REFUSED(uncertainty(line(), Eigen::VectorXd::Ones(2)),
                "each of the 3 data, positive and finite, got 2 numbers");
  CHECK_REFUSED(uncertainty(line(), Eigen::Vector3d(1.0, 0.0, 1.0)), "the least is 0");
  CHECK_REFUSED(uncertainty(line() * not_a_number, Eigen::VectorXd::Ones(3)), "all of them finite");
  CHECK_REFUSED(uncertainty(Eigen::MatrixXd(3, 0), Eigen::VectorXd::Ones(3)), "must have entries");
  CHECK_REFUSED(uncertainty(line(), Eigen::VectorXd::Ones(3), 1.0), "unseen must lie in [0, 1), got 1");
}

BOOST_AUTO_TEST_SUITE_END()

const Eigen::Vector3d measured{1.0, 2.0, 4.0};
const SampledModel on_a_line = [](const Eigen::VectorXd& p) -> Eigen::VectorXd { return line() * p; };

BOOST_AUTO_TEST_SUITE(in_deviations_)

BOOST_AUTO_TEST_CASE(counts_differences_in_noise) {
  const Residuals residuals = in_deviations(on_a_line, measured, Eigen::Vector3d(0.5, 1.0, 2.0));
  BOOST_TEST(close(residuals(Eigen::Vector2d(2.0, 1.0)), Eigen::Vector3d(2.0, 1.0, 0.0), {}));
}

BOOST_AUTO_TEST_CASE(has_none_where_the_model_has_none) {
  const Residuals none = in_deviations([](const auto&) { return Eigen::VectorXd(); }, measured, measured);
  BOOST_TEST(none(Eigen::Vector2d::Ones()).size() == 0);
}

BOOST_AUTO_TEST_CASE(refuses_other_lengths) {
  CHECK_REFUSED(in_deviations(on_a_line, measured, Eigen::VectorXd::Ones(2)), "each of the 3 data");
  const Residuals two = in_deviations(on_a_line, Eigen::VectorXd::Ones(2), Eigen::VectorXd::Ones(2));
  CHECK_REFUSED(two(Eigen::Vector2d::Ones()), "as many numbers as there are data, 2, got 3");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(profile_)

// One step of Gauss and Newton, all that a model linear in its parameters needs.
Eigen::VectorXd linear_fit(const Residuals& residuals, const Box&, const Eigen::VectorXd& start) {
  const Eigen::MatrixXd J =
      sensitivities(residuals, start, {.step = 0.1, .size = Eigen::VectorXd::Ones(start.size())}).jacobian;
  return start - (J.transpose() * J).inverse() * (J.transpose() * residuals(start));
}

// The line through (0, 1), (1, 2), (2, 4): b = 3/2, a = 7/3 - 3/2 = 5/6, left over 1/6.
const Eigen::Vector2d best{5.0 / 6.0, 1.5};
const Box box{.lower = Eigen::Vector2d(-10.0, -10.0), .upper = Eigen::Vector2d(10.0, 10.0)};

// Of b the sum of squares is 1/6 + 2 (b - 3/2)^2 with a = 7/3 - b: the ends lie sqrt(rise/2) from the best.
BOOST_AUTO_TEST_CASE(of_a_straight_line_is_a_parabola_with_the_interval_of_its_covariance) {
  const Residuals residuals = in_deviations(on_a_line, measured, Eigen::VectorXd::Ones(3));
  const Eigen::VectorXd at = Eigen::VectorXd::LinSpaced(5, -1.0, 4.0);
  const Profile found = profile(residuals, box, best, 1, at, linear_fit);
  for (Eigen::Index k = 0; k < at.size(); ++k) {
    const double off = at[k] - 1.5;
    BOOST_TEST(found.cost[k] == 1.0 / 6.0 + 2.0 * off * off, tolerance(1e-11));
    BOOST_TEST(close(found.parameters.col(k), Eigen::Vector2d(7.0 / 3.0 - at[k], at[k]), {.absolute = 1e-12}));
  }
  const double half = std::sqrt(rise_of_95_percent / 2.0);
  BOOST_TEST(found.lower == 1.5 - half, tolerance(1e-11));
  BOOST_TEST(found.upper == 1.5 + half, tolerance(1e-11));
  BOOST_TEST(found.evaluations == 1 + 5 * 4);
}

// 1.959963984540054 standard deviations of the normal distribution hold 95 %.
BOOST_AUTO_TEST_CASE(rises_by_chi_square_of_95_percent) {
  BOOST_TEST(std::sqrt(rise_of_95_percent) == 1.959963984540054, tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(is_flat_and_without_ends_where_another_parameter_makes_up) {
  const Residuals sum = [](const Eigen::VectorXd& p) -> Eigen::VectorXd {
    return Eigen::VectorXd::Constant(1, 3.0 * (p[0] + p[1] - 2.0));
  };
  const Profile found =
      profile(sum, box, Eigen::Vector2d::Ones(), 0, Eigen::VectorXd::LinSpaced(7, -9.0, 9.0), linear_fit);
  BOOST_TEST(found.cost.maxCoeff() < 1e-20);
  BOOST_TEST(found.lower == -infinity);
  BOOST_TEST(found.upper == infinity);
}

// Of one parameter there is nothing to fit. Where it has no value the interval ends at the last that has one.
BOOST_AUTO_TEST_CASE(ends_where_there_is_no_value) {
  const Residuals root = [](const Eigen::VectorXd& p) -> Eigen::VectorXd {
    return p[0] > 1.2 ? Eigen::VectorXd() : Eigen::VectorXd::Constant(1, p[0] - 1.0);
  };
  const Box one{.lower = Eigen::VectorXd::Constant(1, -5.0), .upper = Eigen::VectorXd::Constant(1, 5.0)};
  const Eigen::VectorXd at = (Eigen::VectorXd(4) << -5.0, 0.5, 1.1, 1.5).finished();
  const Refit never = [](const Residuals&, const Box&, const Eigen::VectorXd&) -> Eigen::VectorXd {
    throw std::logic_error("nothing to fit");
  };
  const Profile found = profile(root, one, Eigen::VectorXd::Ones(1), 0, at, never);
  BOOST_TEST(found.upper == 1.1);
  BOOST_TEST(found.cost[3] == infinity);
  BOOST_TEST(found.lower == 1.0 - std::sqrt(rise_of_95_percent), tolerance(1e-14));
  BOOST_TEST(found.evaluations == 5);
}

BOOST_AUTO_TEST_CASE(hands_bounds_and_conditions_of_the_others_on) {
  Box conditional = box;
  conditional.lower[0] = -3.0;
  conditional.allows = [](const Eigen::VectorXd& p) { return p[1] > p[0]; };
  const Refit checks = [](const Residuals&, const Box& others, const Eigen::VectorXd& start) {
    BOOST_TEST(others.lower.size() == 1);
    BOOST_TEST(others.lower[0] == -3.0);
    BOOST_TEST(others.allows(Eigen::VectorXd::Constant(1, 0.9)));
    BOOST_TEST(!others.allows(Eigen::VectorXd::Constant(1, 2.1)));
    return start;
  };
  const Residuals residuals = in_deviations(on_a_line, measured, Eigen::VectorXd::Ones(3));
  (void)profile(residuals, conditional, best, 1, Eigen::Vector2d(1.0, 2.0), checks);
}

// A fit that adds 1 to what it is given shows where it started.
BOOST_AUTO_TEST_CASE(starts_each_fit_where_its_neighbour_ended) {
  const Residuals residuals = in_deviations(on_a_line, measured, Eigen::VectorXd::Ones(3));
  const Refit adds = [](const Residuals&, const Box&, const Eigen::VectorXd& start) -> Eigen::VectorXd {
    return start.array() + 1.0;
  };
  const Profile found = profile(residuals, box, best, 1, Eigen::Vector4d(0.5, 1.0, 2.0, 2.5), adds);
  const Eigen::VectorXd others = found.parameters.row(0).transpose().array() - best[0];
  BOOST_TEST(close(others, Eigen::Vector4d(2.0, 1.0, 1.0, 2.0), {.relative = 1e-15}));
}

BOOST_AUTO_TEST_CASE(refuses_what_it_cannot_follow) {
  const Residuals residuals = in_deviations(on_a_line, measured, Eigen::VectorXd::Ones(3));
  const auto of = [&](Eigen::Index which, const Eigen::VectorXd& at, double rise = 1.0) {
    return profile(residuals, box, best, which, at, linear_fit, rise);
  };
  CHECK_REFUSED(of(2, Eigen::Vector2d(1.0, 2.0)), "one of the box's 2 parameters, got number 2 of 2");
  CHECK_REFUSED(of(1, Eigen::Vector2d(1.6, 2.0)), "from below the best, 1.5, to above it");
  CHECK_REFUSED(of(1, Eigen::Vector3d(1.0, 1.0, 2.0)), "must rise within the bounds [-10, 10]");
  CHECK_REFUSED(of(1, Eigen::Vector2d(1.0, 11.0)), "within the bounds");
  CHECK_REFUSED(of(1, Eigen::Vector2d(1.0, not_a_number)), "must rise");
  CHECK_REFUSED(of(1, Eigen::Vector2d(1.0, 2.0), 0.0), "rise of a profile must be positive, got 0");
  const Residuals none = [](const Eigen::VectorXd&) { return Eigen::VectorXd(); };
  CHECK_REFUSED(profile(none, box, best, 1, Eigen::Vector2d(1.0, 2.0), linear_fit), "must have residuals");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::identifiability_test
