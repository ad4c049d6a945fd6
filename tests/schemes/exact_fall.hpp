#pragma once

#include <cmath>

#include <particulate/schemes/problem.hpp>

namespace tests {

/// A scheme that is exact for constant accelerations, and so is its dense output, but for an error put in on purpose:
/// 2 blur dt^2 theta (1 - theta)^2 on every position, which vanishes at both ends of the step, at the last with its
/// slope: as with collocation, whose last velocity is as good as its last position.
struct ExactFall {
  static constexpr int order = 4;
  double blur = 0.0;
  int accepted = 0, forgotten = 0;
  Eigen::VectorXd a{};

  static constexpr bool advances(const particulate::schemes::Traits&) { return true; }
  bool predict(const particulate::schemes::Problem& problem, const particulate::schemes::State& from, double dt,
               particulate::schemes::State& to) {
    particulate::schemes::Rates rates;
    if (!problem.rates(from, rates)) return false;
    a = rates.a;
    at(from, dt, 1.0, to);
    return true;
  }
  void accept(double) { ++accepted; }
  void forget() { ++forgotten; }
  void begin(const particulate::schemes::Problem&, const particulate::schemes::State&) {}
  void at(const particulate::schemes::State& from, double dt, double theta, particulate::schemes::State& there) const {
    const double t = theta * dt;
    there.t = from.t + t;
    there.r = from.r + t * from.v + (0.5 * t * t) * a;
    there.r.array() += 2.0 * blur * dt * dt * theta * (1.0 - theta) * (1.0 - theta);
    there.v = from.v + t * a;
  }
};

/// A scheme that knows the solution y = sin t of y' = cos t.
struct ExactSine {
  static constexpr int order = 8;
  int forgotten = 0;

  static constexpr bool advances(const particulate::schemes::Traits&) { return true; }
  bool predict(const particulate::schemes::Problem& problem, const particulate::schemes::State& from, double dt,
               particulate::schemes::State& to) {
    particulate::schemes::Rates rates;
    if (!problem.rates(from.t + dt, from.r, from.v, from.y, rates)) return false;
    at(from, dt, 1.0, to);
    return true;
  }
  void accept(double) {}
  void forget() { ++forgotten; }
  void begin(const particulate::schemes::Problem&, const particulate::schemes::State&) {}
  void at(const particulate::schemes::State& from, double dt, double theta, particulate::schemes::State& there) const {
    there.t = from.t + theta * dt;
    there.y = Eigen::VectorXd::Constant(1, std::sin(there.t));
  }
};

}  // namespace tests
