#pragma once

#include <cmath>
#include <utility>

#include <boost/test/unit_test.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>

namespace tests {

using particulate::schemes::In, particulate::schemes::Out;

/// r'' = -k r.
struct Spring {
  double stiffness = 1.0;
  bool acceleration(double, In r, Out a) const {
    a = -stiffness * r;
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

/// y' = -c y.
struct Decay {
  double c = 1.0;
  bool rate(double, In y, Out dy) const {
    dy = -c * y;
    return true;
  }
};

/// r_0 = 1/(1 + t) and r_1 = cos t.
struct Driven {
  bool acceleration(double t, In r, Out a) const {
    a[0] = 2.0 * r[0] * r[0] * r[0];
    a[1] = 3.0 * std::cos(t) - 4.0 * r[1];
    return true;
  }
  static particulate::schemes::State at(double t) {
    const double s = 1.0 / (1.0 + t);
    return {.t = t, .r = Eigen::Vector2d(s, std::cos(t)), .v = Eigen::Vector2d(-s * s, -std::sin(t))};
  }
};

/// r'' = -r, without a value from its n-th call on.
struct Failing {
  int n;
  bool acceleration(double, In r, Out a) {
    a = -r;
    return --n > 0;
  }
};

/// y = sin t.
struct Sine {
  bool rate(double t, In, Out dy) const {
    dy[0] = std::cos(t);
    return true;
  }
};

// Equal steps, whose sweeps leave TOL where a scheme makes any.
template <class S>
particulate::schemes::FixedStep equal_steps(double step, double TOL) {
  particulate::schemes::FixedStep control{.step = step};
  if constexpr (particulate::schemes::Iterative<S>) control.TOL = TOL;
  return control;
}

/// integrate() of what a test does not look at afterwards: problem, scheme and control may be made in the call.
template <class P, class S, class C, class... Rest>
particulate::schemes::Outcome run(P&& problem, particulate::schemes::State& state, double t_end, S&& scheme,
                                  C&& control, Rest&&... rest) {
  return particulate::schemes::integrate(problem, state, t_end, scheme, control, std::forward<Rest>(rest)...);
}

/// First iterate of a step, or all of it where a scheme makes no sweeps.
template <class S, class P>
particulate::schemes::State predicted(S&& scheme, P&& problem, const particulate::schemes::State& from, double dt) {
  particulate::schemes::State to = from;
  BOOST_TEST_REQUIRE(scheme.predict(problem, from, dt, to));
  return to;
}

/// A step after so many sweeps, not accepted.
template <class S, class P>
particulate::schemes::State swept(S&& scheme, P&& problem, const particulate::schemes::State& from, double dt,
                                  int sweeps = 60) {
  particulate::schemes::State to = predicted(scheme, problem, from, dt);
  for (int k = 0; k < sweeps; ++k) scheme.sweep(problem, from, dt, to);
  return to;
}

/// One body on a line.
inline particulate::schemes::State body(double r, double v, double t = 0.0) {
  return {.t = t, .r = Eigen::VectorXd::Constant(1, r), .v = Eigen::VectorXd::Constant(1, v)};
}

/// The same at r = 1 and at rest, at t = 0.
inline particulate::schemes::State displaced() { return body(1.0, 0.0); }

/// The same, with values.
inline particulate::schemes::State displaced(const Eigen::VectorXd& y) {
  particulate::schemes::State state = displaced();
  state.y = y;
  return state;
}

/// One value, at a time.
inline particulate::schemes::State one(double y = 1.0, double t = 0.0) {
  return {.t = t, .y = Eigen::VectorXd::Constant(1, y)};
}

/// The value of Sine at a time.
inline particulate::schemes::State sine_start(double t = 0.5) { return one(std::sin(t), t); }

}  // namespace tests
