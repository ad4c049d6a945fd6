#include <particulate/schemes/newton.hpp>

#include <cmath>
#include <functional>

#include <Eigen/SparseCore>

#include "close.hpp"

namespace tests::newton_test {

using namespace particulate::schemes;

// Each value sees its neighbours: dy_i = y_{i-1} - 3 y_i + 2 y_{i+1}.
struct Chain {
  mutable long asked = 0;
  bool operator()(const Eigen::VectorXd& y, Eigen::VectorXd& dy) const {
    ++asked;
    dy = -3.0 * y;
    dy.tail(y.size() - 1) += y.head(y.size() - 1);
    dy.head(y.size() - 1) += 2.0 * y.tail(y.size() - 1);
    return true;
  }
};

Eigen::MatrixXd of_chain(Eigen::Index n) {
  Eigen::MatrixXd J = -3.0 * Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index i = 1; i < n; ++i) J(i, i - 1) = 1.0, J(i - 1, i) = 2.0;
  return J;
}

// y' = slope y, with the slope as it is said to be.
struct Linear {
  double slope = -2.0;
  mutable long jacobians = 0;
  bool rate(double, In y, Out dy) const {
    dy = slope * y;
    return true;
  }
  void jacobian(double, In, Eigen::MatrixXd& J) const {
    ++jacobians;
    J.setConstant(slope);
  }
};

// The same in as many values as there are, of which it may be said that none acts on another.
struct Apart : Linear {
  Bandwidth bandwidth() const { return {}; }
};

const Eigen::VectorXd one = Eigen::VectorXd::Ones(1);
const Eigen::MatrixXd backward_euler = Eigen::MatrixXd::Ones(1, 1);

BOOST_AUTO_TEST_SUITE(difference_step_)

// sqrt(epsilon) = 2^-26; 3 of it rounds up to 2^-24 in the logarithm.
BOOST_AUTO_TEST_CASE(is_a_power_of_two_near_the_root_of_rounding) {
  BOOST_TEST(difference_step(0.0, 1.0) == std::exp2(-26));
  BOOST_TEST(difference_step(-3.0, 1.0) == -std::exp2(-24));
  BOOST_TEST(difference_step(0.5, 8.0) == std::exp2(-23));
  BOOST_TEST(difference_step(1e-9, 1e-20) == std::exp2(-56));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(difference_jacobian_)

BOOST_AUTO_TEST_CASE(is_exact_for_linear_rates_and_asks_once_for_each_unknown) {
  const Chain chain;
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(7, -2.0, 4.0), sizes = Eigen::VectorXd::Ones(7);
  Eigen::VectorXd f(7);
  chain(x, f);
  Eigen::MatrixXd J;
  BOOST_TEST(difference_jacobian(std::ref(chain), x, f, sizes, {}, J));
  BOOST_TEST(chain.asked == 8);
  BOOST_TEST(close(J, of_chain(7), {.absolute = 1e-7}));
}

BOOST_AUTO_TEST_CASE(asks_once_for_each_diagonal_of_a_band) {
  const Chain chain;
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(7, -2.0, 4.0), sizes = Eigen::VectorXd::Ones(7);
  Eigen::VectorXd f(7);
  chain(x, f);
  Eigen::MatrixXd J;
  SparseJacobian sparse;
  BOOST_TEST(difference_jacobian(std::ref(chain), x, f, sizes, Bandwidth{.lower = 1, .upper = 1}, J));
  BOOST_TEST(chain.asked == 4);
  BOOST_TEST(close(J, of_chain(7), {.absolute = 1e-7}));
  BOOST_TEST(difference_jacobian(std::ref(chain), x, f, sizes, Bandwidth{.lower = 1, .upper = 1}, sparse));
  BOOST_TEST(close(Eigen::MatrixXd(sparse), J, {}));
}

// (x^2)' = 2 x + h by a forward quotient.
BOOST_AUTO_TEST_CASE(is_off_by_half_the_second_derivative_times_the_step) {
  const auto square = [](const Eigen::VectorXd& x, Eigen::VectorXd& f) {
    f = x.cwiseAbs2();
    return true;
  };
  Eigen::MatrixXd J;
  BOOST_TEST(difference_jacobian(square, one, one, one, {}, J));
  BOOST_TEST(J(0, 0) == 2.0 + std::exp2(-26));
}

BOOST_AUTO_TEST_CASE(is_none_where_a_rate_has_no_value) {
  const auto nothing = [](const Eigen::VectorXd&, Eigen::VectorXd&) { return false; };
  Eigen::MatrixXd J;
  BOOST_TEST(!difference_jacobian(nothing, one, one, one, {}, J));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(NewtonSteps_)

BOOST_AUTO_TEST_CASE(takes_a_jacobian_once_and_again_where_it_was_bad_at_another_time) {
  const Linear problem;
  long evaluations = 0;
  const Problem counted(problem, &evaluations);
  NewtonSteps newton;
  const auto prepare = [&](double t, bool bad) {
    return newton.prepare(counted, State{.t = t, .y = one}, 0.5, {.A = backward_euler, .sizes = one, .bad = bad});
  };
  BOOST_TEST(prepare(0.0, false));
  BOOST_TEST(prepare(1.0, false));
  BOOST_TEST(problem.jacobians == 1);
  BOOST_TEST(prepare(2.0, true));
  BOOST_TEST(problem.jacobians == 2);
  BOOST_TEST(prepare(2.0, true));
  BOOST_TEST(problem.jacobians == 2);
  newton.forget();
  BOOST_TEST(prepare(2.0, false));
  BOOST_TEST(problem.jacobians == 3);
  BOOST_TEST(evaluations == 0);
}

// (1 - h lambda J) Delta k = g with lambda = 1, J = -2: 1/(1 + 1) and, with another step, 1/(1 + 4).
BOOST_AUTO_TEST_CASE(solves_with_the_step_that_it_was_prepared_for) {
  Linear problem;
  NewtonSteps newton;
  newton.prepare(problem, State{.t = 0.0, .y = one}, 0.5, {.A = backward_euler, .sizes = one});
  BOOST_TEST(newton.solve(one)(0, 0) == 0.5);
  BOOST_TEST(newton.filtered(one, 0.5)[0] == 0.25);
  newton.prepare(problem, State{.t = 0.0, .y = one}, 2.0, {.A = backward_euler, .sizes = one});
  BOOST_TEST(newton.solve(one)(0, 0) == 0.2);
}

// The Jacobian in hand, and its decomposition, belong to as many unknowns as they were made for.
BOOST_AUTO_TEST_CASE(takes_a_jacobian_anew_for_another_number_of_unknowns) {
  Linear problem;
  NewtonSteps newton;
  const Eigen::MatrixXd A = backward_euler;
  for (const Eigen::Index n : {2, 3, 1, 5}) {
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(n);
    BOOST_TEST(newton.prepare(problem, {.y = ones}, 0.5, {.A = A, .sizes = ones}));
    BOOST_TEST(newton.solve(ones).rows() == n);
  }
  BOOST_TEST(problem.jacobians == 4);
}

BOOST_AUTO_TEST_CASE(solves_for_no_unknown) {
  Apart problem;
  const Eigen::VectorXd none(0);
  for (const bool sparse : {false, true}) {
    NewtonSteps newton(sparse);
    BOOST_TEST(newton.prepare(problem, State{.t = 0.0, .y = none}, 0.5, {.A = backward_euler, .sizes = none}));
    BOOST_TEST(newton.solve(none).size() == 0);
    BOOST_TEST(newton.filtered(none, 0.5).size() == 0);
  }
}

BOOST_AUTO_TEST_CASE(has_no_system_where_the_jacobian_is_not_finite) {
  Linear problem{.slope = not_a_number};
  NewtonSteps newton;
  BOOST_TEST(!newton.prepare(problem, State{.t = 0.0, .y = one}, 0.5, {.A = backward_euler, .sizes = one}));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::newton_test
