#pragma once

#include <cmath>
#include <utility>

#include <particulate/schemes/integrate.hpp>

namespace tests {

using particulate::schemes::In, particulate::schemes::Out;

/// r'' = -r.
struct Spring {
  bool acceleration(double, In r, Out a) const {
    a = -r;
    return true;
  }
};

/// r'' = -r - v.
struct Damped {
  bool acceleration(double, In r, In v, Out a) const {
    a = -r - v;
    return true;
  }
};

/// Falls at 2 m/s^2.
struct Falling {
  bool acceleration(double, In, Out a) const {
    a.setConstant(-2.0);
    return true;
  }
};

/// y' = -y.
struct Decay {
  bool rate(double, In y, Out dy) const {
    dy = -y;
    return true;
  }
};

/// y = sin t.
struct Sine {
  bool rate(double t, In, Out dy) const {
    dy[0] = std::cos(t);
    return true;
  }
};

/// integrate() of what a test does not look at afterwards: problem, scheme and control may be made in the call.
template <class P, class S, class C, class... Rest>
particulate::schemes::Outcome run(P&& problem, particulate::schemes::State& state, double t_end, S&& scheme,
                                  C&& control, Rest&&... rest) {
  return particulate::schemes::integrate(problem, state, t_end, scheme, control, std::forward<Rest>(rest)...);
}

/// A body at r = 1 and at rest, at t = 0.
inline particulate::schemes::State displaced() {
  return {.t = 0.0, .r = Eigen::VectorXd::Ones(1), .v = Eigen::VectorXd::Zero(1)};
}

/// One value, at a time.
inline particulate::schemes::State one(double y = 1.0, double t = 0.0) {
  return {.t = t, .y = Eigen::VectorXd::Constant(1, y)};
}

/// The value of Sine at a time.
inline particulate::schemes::State sine_start(double t = 0.5) { return one(std::sin(t), t); }

}  // namespace tests
