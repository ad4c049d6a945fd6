#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

#include <particulate/identification/cost.hpp>

/// @file
/// Functions of which the smallest value is known: 0, at a known place.

namespace verification {

/// What a search is asked to find.
struct TestFunction {
  std::string name;
  particulate::identification::Cost cost;
  particulate::identification::Residuals residuals;  ///< none: there is nothing to polish
  particulate::identification::Box box;
  double best_at;  ///< every parameter of the smallest value

  Eigen::VectorXd best() const { return Eigen::VectorXd::Constant(box.lower.size(), best_at); }
};

/// Draws places in a box, evenly.
class Places {
 public:
  explicit Places(std::uint64_t seed) : engine_(seed) {}
  Eigen::VectorXd in(const particulate::identification::Box& box) {
    const Eigen::ArrayXd u = Eigen::ArrayXd::NullaryExpr(box.lower.size(), [&] { return uniform_(engine_); });
    return box.lower.array() + u * (box.upper - box.lower).array();
  }

 private:
  boost::random::mt19937_64 engine_;
  boost::random::uniform_01<double> uniform_;
};

/// The same bounds for every parameter.
inline particulate::identification::Box cube(Eigen::Index n, double lower, double upper) {
  return {.lower = Eigen::VectorXd::Constant(n, lower), .upper = Eigen::VectorXd::Constant(n, upper)};
}

/// A sum of squares with its residuals.
inline TestFunction sum_of_squares(std::string name, const particulate::identification::Residuals& residuals,
                                   const particulate::identification::Box& box, double best_at) {
  return {.name = std::move(name),
          .cost = [residuals](const Eigen::VectorXd& x) { return residuals(x).squaredNorm(); },
          .residuals = residuals,
          .box = box,
          .best_at = best_at};
}

/// \f$ \sum_{i<n} 100 (x_{i+1} - x_i^2)^2 + (1 - x_i)^2 \f$, a bent valley; least at 1. Residuals: the roots.
inline TestFunction rosenbrock(Eigen::Index n) {
  const auto residuals = [n](const Eigen::VectorXd& x) {
    Eigen::VectorXd all(2 * (n - 1));
    all.head(n - 1) = 10.0 * (x.tail(n - 1).array() - x.head(n - 1).array().square());
    all.tail(n - 1) = 1.0 - x.head(n - 1).array();
    return all;
  };
  return sum_of_squares("Rosenbrock", residuals, cube(n, -5.0, 10.0), 1.0);
}

/// \f$ \sum x_i^2 + 10 (1 - \cos 2 \pi x_i) = \sum x_i^2 + 20 \sin^2 \pi x_i \f$, a minimum near every whole number;
/// least at 0.
inline TestFunction rastrigin(Eigen::Index n, double lower = -5.12, double upper = 5.12) {
  const auto residuals = [n](const Eigen::VectorXd& x) {
    Eigen::VectorXd all(2 * n);
    all.head(n) = x;
    all.tail(n) = std::sqrt(20.0) * (std::numbers::pi * x.array()).sin();
    return all;
  };
  return sum_of_squares(lower == -upper ? "Rastrigin" : "Rastrigin off the middle", residuals, cube(n, lower, upper),
                        0.0);
}

/// Ackley's function: ripples on a funnel with a sharp tip; least at 0. It is no sum of squares.
inline TestFunction ackley(Eigen::Index n) {
  const auto cost = [](const Eigen::VectorXd& x) {
    const double around = (2.0 * std::numbers::pi * x.array()).cos().mean();
    return -20.0 * std::expm1(-0.2 * std::sqrt(x.array().square().mean())) - std::exp(around) + std::numbers::e;
  };
  return {.name = "Ackley", .cost = cost, .residuals = {}, .box = cube(n, -32.768, 32.768), .best_at = 0.0};
}

/// \f$ \sum \lfloor 4 |x_i| \rfloor \f$: terraces, on which no difference sees a slope; 0 where all |x_i| < 1/4.
inline TestFunction terraces(Eigen::Index n) {
  const auto cost = [](const Eigen::VectorXd& x) { return (4.0 * x.array().abs()).floor().sum(); };
  return {.name = "terraces", .cost = cost, .residuals = {}, .box = cube(n, -5.12, 5.12), .best_at = 0.0};
}

/// Deceptive: every parameter falls from 0.2 towards 0, where it costs 0.1, over four fifths of its range, and towards
/// 1, where it costs nothing, over the last fifth.
inline TestFunction deceptive(Eigen::Index n) {
  const auto one = [](double x) { return x < 0.8 ? 0.1 + 0.9 * x / 0.8 : 5.0 * (1.0 - x); };
  const auto cost = [one](const Eigen::VectorXd& x) { return x.unaryExpr(one).sum(); };
  return {.name = "deceptive", .cost = cost, .residuals = {}, .box = cube(n, 0.0, 1.0), .best_at = 1.0};
}

}  // namespace verification
