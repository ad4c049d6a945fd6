// The Jacobians of the classical problems against differences of their rates.

#include <algorithm>
#include <cmath>
#include <string>

#include <harness/case.hpp>

#include "classical_problems.hpp"

namespace verification::classical_jacobians {

using particulate::schemes::Problem;

Eigen::VectorXd rate_at(const Problem& problem, const Eigen::VectorXd& y) {
  particulate::schemes::Rates rates;
  problem.rates({.y = y}, rates);
  return rates.dy;
}

// Central differences over h = y_j/4 and over 2 h, extrapolated: exact for polynomials of degree four, whatever h is.
Eigen::MatrixXd by_differences(const Problem& problem, const Eigen::VectorXd& y) {
  Eigen::MatrixXd J(y.size(), y.size());
  for (Eigen::Index j = 0; j < y.size(); ++j) {
    const auto difference = [&](double h) -> Eigen::VectorXd {
      const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(y.size(), j);
      return (rate_at(problem, y + step) - rate_at(problem, y - step)) / (2.0 * h);
    };
    J.col(j) = (4.0 * difference(0.25 * y[j]) - difference(0.5 * y[j])) / 3.0;
  }
  return J;
}

// Each row over its largest entry: a row holds the derivatives of one rate.
void compare(Rows& rows, const std::string& name, const Problem& problem, const Eigen::VectorXd& y) {
  Eigen::MatrixXd given;
  problem.jacobian({0.0, {nullptr, 0}, {nullptr, 0}, {y.data(), y.size()}}, given);
  const Eigen::MatrixXd seen = by_differences(problem, y);
  const Eigen::VectorXd largest = seen.rowwise().lpNorm<Eigen::Infinity>();
  const Eigen::MatrixXd error = ((given - seen).array().colwise() / largest.array()).matrix();
  rows.at_most(name + ": given Jacobian against differences, over the largest of a row",
               {.limit = 1e-13,
                .computed = error.hasNaN() ? missing : error.lpNorm<Eigen::Infinity>(),
                .because = "the rates are polynomials of degree 3 at most, for which the differences are exact but for "
                           "some hundred roundings"});
}

const Case jacobians{{.name = "classical_jacobians",
                      .claim = "the Jacobians given with the classical problems are the derivatives of their rates",
                      .equation = "R 3.2",
                      .reference = Reference::independent_method},
                     [](Rows& rows) {
                       const Robertson robertson;
                       const VanDerPol van_der_pol;
                       const Oregonator oregonator;
                       compare(rows, "Robertson", robertson, Eigen::Vector3d{0.7, 3e-5, 0.3});
                       compare(rows, "van der Pol", van_der_pol, Eigen::Vector2d{1.7, -0.9});
                       compare(rows, "Oregonator", oregonator, Eigen::Vector3d{20.0, 1200.0, 130.0});
                     }};

}  // namespace verification::classical_jacobians
