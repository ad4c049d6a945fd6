// Collocation where it must give an answer, and where it must say why not.

#include <cmath>
#include <complex>
#include <string>

#include <fmt/format.h>
#include <Eigen/Core>

#include <harness/case.hpp>
#include <harness/endings.hpp>
#include <harness/linear_algebra.hpp>
#include <harness/motions.hpp>
#include <harness/starts.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>

#include "classical_problems.hpp"
#include "linear_problems.hpp"

namespace verification::collocation_extremes {

using namespace particulate;
using namespace particulate::schemes;

using FixedPoint = Collocation<Gauss<4>>;

ErrorControl usual() { return {.TOL = 1e-9, .sweep_TOL = 1e-11, .step = 0.01, .limit = 0.5}; }

// Particles in free flight, under a near field of these strengths.
Ending flight(const kinematics::Particles& particles, double alpha, ErrorControl control) {
  NearFieldScene scene(particles, {}, {.alpha1 = alpha, .alpha2 = 0.5 * alpha});
  const State start = scenes::start(scene);
  State state = start;
  FixedPoint scheme;
  const Outcome out = integrate(scene, state, 2.0, scheme, control);
  if (out.status != Status::reached) return Ending::refused(out.reason);
  const double off = state.r.size() == 0 ? 0.0 : (state.r - start.r - 2.0 * start.v).lpNorm<Eigen::Infinity>();
  return Ending::solved({.error = off, .tolerance = 1e-14, .because = "free flight, one rounding a step"});
}

kinematics::Particles moving(Eigen::Index N) { return random_cloud({.N = N}, 7); }

void compare_few(Rows& rows) {
  rows.must_be_solved("no particle", [] { return flight(moving(0), 1.0, usual()); });
  rows.must_be_solved("one particle", [] { return flight(moving(1), 1.0, usual()); });
  rows.must_be_solved("eight particles without forces", [] { return flight(moving(8), 0.0, usual()); });
  rows.must_be_refused("two particles in one place", "no finite value smallest", [] {
    ErrorControl control = usual();
    control.smallest = 1e-6;
    return flight(pair_at_rest(1.0, 1.0, 0.0), 1.0, control);
  });
  rows.must_be_refused("tolerance of the sweeps below rounding", "TOL 2.22e-16 1e-17", [] {
    ErrorControl control = usual();
    control.sweep_TOL = 1e-17;
    return flight(moving(2), 1.0, control);
  });
  rows.must_be_refused("tolerance of the steps that is no number", "TOL nan", [] {
    ErrorControl control = usual();
    control.TOL = missing;
    return flight(moving(2), 1.0, control);
  });
  rows.must_be_refused("first step above the limit", "step limit", [] {
    ErrorControl control = usual();
    control.limit = 1e-3;
    return flight(moving(2), 1.0, control);
  });
}

// A spring that breaks: no value, or none that is a number, beyond a stretch.
struct Breaking {
  bool says_so;

  bool acceleration(double, In r, Out a) const {
    a = -r;
    if (r[0] < 0.5) a[0] = missing;
    return !says_so || r[0] >= 0.5;
  }
};

Ending break_spring(bool says_so, double t_end) {
  Breaking problem{.says_so = says_so};
  State state = motion(1.0, 0.0);
  FixedPoint scheme;
  ErrorControl control = usual();
  control.smallest = 1e-9;
  const Outcome out = integrate(problem, state, t_end, scheme, control);
  if (out.status != Status::reached) return Ending::refused(out.reason);
  return Ending::solved({.error = std::abs(state.r[0] - std::cos(t_end)),
                         .tolerance = 1e-9,
                         .because = "a few steps, each within TOL of the cosine"});
}

void compare_missing_values(Rows& rows) {
  for (const bool says_so : {true, false}) {
    const std::string which = says_so ? "a stage without a value" : "a stage whose force is NaN";
    // cos t = 1/2 at 1.047: the first tries of steps that end before it have stages beyond.
    rows.must_be_solved(which + ", before it matters", [=] { return break_spring(says_so, 1.04); });
    rows.must_be_refused(which + ", beyond", "no finite value smallest", [=] { return break_spring(says_so, 1.1); });
  }
}

// What one step of a method makes of a spring: R(z) at z = i omega dt, by the determinants of its definition.
template <class Nodes>
std::complex<double> stability(double x) {
  const CollocationTable& table = table_of<Nodes>();
  const std::complex<double> z(0.0, x);
  const Eigen::MatrixXcd system = Eigen::MatrixXcd::Identity(Nodes::stages, Nodes::stages) - z * table.A;
  const Eigen::MatrixXcd ones_b = z * table.b.transpose().template replicate<Nodes::stages, 1>();
  return determinant(system + ones_b) / determinant(system);
}

constexpr double omega = 8.0, x = 1e3;
constexpr long few = 20;

// A spring with omega dt = 1000 as y' = (v, -omega^2 r) in units in which it is a rotation.
struct StiffSpring {
  bool rate(double, In y, Out dy) const {
    dy[0] = omega * y[1];
    dy[1] = -omega * y[0];
    return true;
  }
};

// Twenty steps of at most nine sweeps: Newton needs two, and what diverges must not reach infinity.
template <class S>
Outcome twenty_steps(S scheme, State& state) {
  StiffSpring problem;
  FixedStep control{.step = x / omega, .contractions = 8};
  return integrate(problem, state, static_cast<double>(few) * x / omega, scheme, control);
}

// The largest relative error against R^n y.
template <class Nodes>
Ending stiff_by_newton() {
  State state{.t = 0.0, .y = Eigen::Vector2d{0.6, -0.8}};
  const Outcome out = twenty_steps(Collocation<Nodes, Newton<>>({.sizes = Eigen::Vector2d{1e-30, 1e-30}}), state);
  if (out.status != Status::reached) return Ending::refused(out.reason);
  // y1 - i y2 turns by R at i x.
  const std::complex<double> exact =
      std::pow(stability<Nodes>(x), static_cast<int>(few)) * std::complex<double>(0.6, 0.8);
  const std::complex<double> computed(state.y[0], -state.y[1]);
  return Ending::solved({.error = std::abs(computed - exact) / std::abs(exact),
                         .tolerance = 1e-8,
                         .because = "twenty steps of systems whose condition is 1e6, some roundings each"});
}

void compare_stiff(Rows& rows) {
  rows.must_be_solved("omega dt = 1000 by Newton, Gauss 4", [] { return stiff_by_newton<Gauss<4>>(); });
  rows.must_be_solved("omega dt = 1000 by Newton, Radau 3", [] { return stiff_by_newton<Radau<3>>(); });
  rows.compare("|R(1000 i)| of Gauss 4", {.expected = 1.0,
                                          .computed = std::abs(stability<Gauss<4>>(x)),
                                          .tolerance = relative(1e-13),
                                          .because = "symmetric: the energy is kept; two determinants near 1e9"});
  // R of Radau IIA with three stages: (1 + 2z/5 + z^2/20)/(1 - 3z/5 + 3z^2/20 - z^3/60), by hand.
  const std::complex<double> z(0.0, x);
  const std::complex<double> R = (1.0 + 0.4 * z + 0.05 * z * z) / (1.0 - 0.6 * z + 0.15 * z * z - z * z * z / 60.0);
  rows.compare("|R(1000 i)| of Radau 3", {.expected = std::abs(R),
                                          .computed = std::abs(stability<Radau<3>>(x)),
                                          .tolerance = relative(1e-13),
                                          .because = "the rational function by hand, some roundings"});
  rows.must_be_refused("omega dt = 1000 by fixed point, Gauss 4", "diverge Dt", [] {
    State state{.t = 0.0, .y = Eigen::Vector2d{0.6, -0.8}};
    return ending_of(twenty_steps(FixedPoint(), state));
  });
}

// Robertson's reactions by a method that does not damp them: right or refused, and by fixed point too.
template <class S>
Ending robertson(S scheme) {
  Robertson problem;
  State state = Robertson::start();
  ErrorControl control{
      .TOL = 1e-8, .sweep_TOL = 1e-10, .K_d = 3, .step = 1e-6, .limit = 1e3, .smallest = 1e-8, .growth = 8.0};
  long left = 20000;
  const auto watch = [&left](const State&, const State&, double, const S&) { return --left > 0; };
  const Outcome out = integrate(problem, state, 1e4, scheme, control, watch);
  if (out.status != Status::reached) return Ending::refused(out.reason);
  // The sum stays 1; y2 follows y1 and y3 on the slow curve 3e7 y2^2 + 1e4 y2 y3 = 0.04 y1.
  const double b = 1e4 * state.y[2], slow = 0.08 * state.y[0] / (b + std::sqrt(b * b + 4.8e6 * state.y[0]));
  return Ending::solved({.error = std::max(std::abs(state.y.sum() - 1.0), std::abs(state.y[1] / slow - 1.0)),
                         .tolerance = 1e-3,
                         .because = "the slow curve is left by the rate of change over that of the fast reaction"});
}

void compare_robertson(Rows& rows) {
  const Eigen::Vector3d sizes{1e-8, 1e-14, 1e-8};
  rows.must_be_solved("Robertson by Radau 3, Newton",
                      [=] { return robertson(Collocation<Radau<3>, Newton<>>({.sizes = sizes})); });
  rows.must_be_solved("Robertson by Gauss 4, Newton",
                      [=] { return robertson(Collocation<Gauss<4>, Newton<>>({.sizes = sizes})); });
  rows.must_be_refused("Robertson by Gauss 4, fixed point, more than 20000 steps", "observer",
                       [=] { return robertson(Collocation<Gauss<4>>({.sizes = sizes})); });
}

const Case collocation_extremes{
    {.name = "collocation_extremes",
     .claim = "collocation solves what has an answer, from no particle to omega dt = 1000, and refuses the rest with "
              "the reason",
     .equation = "D 3.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      compare_few(rows);
      compare_missing_values(rows);
      compare_stiff(rows);
      compare_robertson(rows);
    }};

}  // namespace verification::collocation_extremes
