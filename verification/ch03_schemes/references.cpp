// The references themselves: KINSOL's fixed point and ARKODE's additive pairs.

#include <cmath>
#include <string>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/near_field_cloud.hpp>
#include <particulate/reference/fixed_point.hpp>
#include <particulate/reference/integrator.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/phi_family.hpp>

namespace verification::references {

using namespace particulate;

// One step of backward Euler, solved by our iterations and by KINSOL: the same equations, another program.

constexpr int depth = 3;  // earlier iterates that either Anderson mixes in

// Where a step ends, and what that took.
struct Solved {
  schemes::State state;
  long evaluations;
  schemes::Failure failure;
  std::string reason;
  double contraction = missing;  // the largest seen; KINSOL does not tell
};

template <class Mixing>
Solved by_sweeps(const NearFieldScene& scene, const schemes::State& from, double dt, Mixing mixing) {
  schemes::State state = from;
  schemes::PhiFamily<Mixing> scheme(1.0, mixing);
  schemes::FixedStep control{.step = dt};
  const schemes::Outcome out = schemes::integrate(scene, state, from.t + dt, scheme, control);
  return {.state = state,
          .evaluations = out.evaluations,
          .failure = out.failure,
          .reason = out.reason,
          .contraction = out.contraction};
}

// KINSOL knows nothing of our scheme but its map, r -> r_L + dt v_L + dt^2 a(r), and starts where it does.
Solved by_kinsol(const NearFieldScene& scene, const schemes::State& from, double dt, int anderson, double tolerance) {
  const Eigen::VectorXd flight = from.r + dt * from.v;
  const reference::Map map = [&](schemes::In r, schemes::Out g) {
    const bool value = scene.acceleration(from.t + dt, r, g);
    g = flight + dt * dt * g;
    return value;
  };
  Eigen::VectorXd r = flight;
  const reference::FixedPoint point =
      reference::solve_fixed_point(map, r, {.tolerance = tolerance, .anderson = anderson, .max_iterations = 200});
  return {.state = {.t = from.t + dt, .r = r, .v = (r - from.r) / dt},
          .evaluations = point.evaluations,
          .failure = point.converged ? schemes::Failure::none : schemes::Failure::diverging,
          .reason = point.reason};
}

double apart(const Solved& one, const Solved& other, const schemes::State& from) {
  return (one.state.r - other.state.r).lpNorm<Eigen::Infinity>() / (other.state.r - from.r).lpNorm<Eigen::Infinity>();
}

void solved(Rows& rows, const std::string& who, const Solved& by) {
  rows.equal(who + ": solved", {.expected = "solved",
                                .computed = by.reason.empty() ? "solved" : by.reason,
                                .because = "only what is solved can agree"});
}

void same_point(Rows& rows, const std::string& who, const Solved& by, const Solved& judge, const schemes::State& from,
                double limit, const std::string& because) {
  solved(rows, who, by);
  rows.at_most(who + " and KINSOL with Anderson, apart over the displacement",
               {.limit = limit, .computed = apart(by, judge, from), .because = because});
}

// A cloud of twenty, and a step whose sweeps still contract.
const Case cloud{
    {.name = "reference_fixed_point",
     .claim = "our sweeps and KINSOL solve a step of backward Euler to the same point, with as many evaluations",
     .equation = "R 3.3",
     .reference = Reference::sundials},
    [](Rows& rows) {
      const NearFieldScene scene(random_cloud({.N = 20}, 1), {},
                                 {.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.0, .beta2 = 2.0});
      const schemes::State from = scenes::start(scene);
      constexpr double dt = 0.15, tolerance = 1e-14;
      const Solved judge = by_kinsol(scene, from, dt, depth, tolerance);
      solved(rows, "KINSOL with Anderson", judge);
      const Solved picard = by_sweeps(scene, from, dt, schemes::Picard{});
      const Solved anderson = by_sweeps(scene, from, dt, schemes::Anderson(depth));
      const Solved plain = by_kinsol(scene, from, dt, 0, tolerance);
      const std::string because = "either stops within some roundings of places of size 3, moved by 0.1";
      same_point(rows, "Picard", picard, judge, from, 3e-13, because);
      same_point(rows, "Anderson", anderson, judge, from, 3e-13, because);
      same_point(rows, "KINSOL without Anderson", plain, judge, from, 3e-13, because);
      rows.compare("evaluations of Picard against KINSOL's without Anderson",
                   {.expected = static_cast<double>(plain.evaluations),
                    .computed = static_cast<double>(picard.evaluations),
                    .tolerance = absolute(1.0),
                    .because = "the same iterates; one ends by the largest change, the other by their sum"});
      rows.compare("evaluations of Anderson against KINSOL's",
                   {.expected = static_cast<double>(judge.evaluations),
                    .computed = static_cast<double>(anderson.evaluations),
                    .tolerance = absolute(2.0),
                    .because = "KINSOL tests the change of the mixture, we that of the map"});
      rows.at_most("evaluations of Anderson against Picard's",
                   {.limit = static_cast<double>(picard.evaluations - 1),
                    .computed = static_cast<double>(anderson.evaluations),
                    .because = "mixing that saves nothing is not worth its cost"});
    }};

// A pair that oscillates about d_e = 0.5 with omega = 2 once it is released one part in a million away from it.
const Case beyond{
    {.name = "reference_fixed_point_beyond_contraction",
     .claim = "at omega Dt = 1.001 the plain iteration diverges, and Anderson's finds what KINSOL's finds",
     .equation = "R 3.3",
     .reference = Reference::sundials},
    [](Rows& rows) {
      constexpr double d_e = 0.5, omega = 2.0, off = 1e-5, dt = 1.001 / omega;
      kinematics::Particles pair{.position = kinematics::Vectors::Zero(2, 3),
                                 .velocity = kinematics::Vectors::Zero(2, 3),
                                 .mass = Eigen::VectorXd::Ones(2),
                                 .radius = Eigen::VectorXd::Zero(2)};
      pair.position.col(0) << -0.5 * d_e * (1.0 + off), 0.5 * d_e * (1.0 + off);
      const NearFieldScene scene(pair, {}, {.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = 1.0, .beta2 = 2.0});
      const schemes::State from = scenes::start(scene);
      const Solved judge = by_kinsol(scene, from, dt, 1, 1e-15);
      solved(rows, "KINSOL with Anderson", judge);
      const Solved anderson = by_sweeps(scene, from, dt, schemes::Anderson(1));
      const Solved picard = by_sweeps(scene, from, dt, schemes::Picard{});
      same_point(rows, "Anderson", anderson, judge, from, 1e-8,
                 "the tolerance 1e-15 over a displacement of 1e-6, with some roundings");
      rows.equal("Picard: ended by divergence", {.expected = true,
                                                 .computed = picard.failure == schemes::Failure::diverging,
                                                 .because = "(omega Dt)^2 is above 1 by two in a thousand"});
      rows.compare("Picard: contraction", {.expected = 1.001 * 1.001,
                                           .computed = picard.contraction,
                                           .tolerance = relative(2e-4),
                                           .because = "(omega Dt)^2 of small oscillations; their frequency changes by "
                                                      "some 1e-5 with an amplitude of 1e-5"});
      const Eigen::VectorXd& r = judge.state.r;
      rows.compare("KINSOL with Anderson: what is left of the displacement",
                   {.expected = 1.0 / (1.0 + 1.001 * 1.001),
                    .computed = (r[1] - r[0] - d_e) / (d_e * off),
                    .tolerance = relative(1e-4),
                    .because = "backward Euler of small oscillations, from rest; likewise"});
    }};

// The additive Runge-Kutta pairs of ARKODE on a problem in two parts, against its closed form.

// An oscillator under strong drag, r'' = -r - c r': the drag is fast, the rest slow.
struct DraggedOscillator {
  double c = 100.0;  // drag [1/s]

  bool rate(double t, schemes::In y, schemes::Out dy) const {
    Eigen::VectorXd fast(2);
    rate_slow(t, y, dy);
    rate_fast(t, y, fast);
    dy += fast;
    return true;
  }
  bool rate_slow(double, schemes::In y, schemes::Out dy) const {
    dy[0] = y[1];
    dy[1] = -y[0];
    return true;
  }
  bool rate_fast(double, schemes::In y, schemes::Out dy) const {
    dy[0] = 0.0;
    dy[1] = -c * y[1];
    return true;
  }

  // Released at rest from r = 1: r = (s2 exp(s1 t) - s1 exp(s2 t))/(s2 - s1), s^2 + c s + 1 = 0, with the small root
  // s1 = 1/s2 formed without cancellation.
  Eigen::Vector2d released(double t) const {
    const double s2 = -0.5 * (c + std::sqrt(c * c - 4.0)), s1 = 1.0 / s2;
    return {(s2 * std::exp(s1 * t) - s1 * std::exp(s2 * t)) / (s2 - s1),
            (std::exp(s1 * t) - std::exp(s2 * t)) / (s2 - s1)};
  }
};

const Case implicit_explicit{
    {.name = "reference_implicit_explicit",
     .claim = "the additive pairs of ARKODE follow an oscillator under strong drag to its closed form",
     .equation = "R 3.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      constexpr double t_end = 10.0, tolerance = 1e-8;
      DraggedOscillator problem;
      for (const reference::AdditiveTable table : reference::additive_tables) {
        schemes::State state{.t = 0.0, .y = Eigen::Vector2d{1.0, 0.0}};
        const schemes::Outcome out = reference::integrate(
            problem, state, t_end,
            reference::ImplicitExplicit{.table = table, .relative = tolerance, .absolute = 1e-3 * tolerance});
        rows.equal(fmt::format("{}: ended", name(table)), {.expected = "reached",
                                                           .computed = out.reason.empty() ? "reached" : out.reason,
                                                           .because = "there is an answer at the end only"});
        const Eigen::Vector2d exact = problem.released(t_end);
        rows.at_most(fmt::format("{}: error of both unknowns, each relative", name(table)),
                     {.limit = 100.0 * tolerance,
                      .computed = mixed_error({state.y.data(), 2}, {exact.data(), 2}, 1e-12),
                      .because = "a hundred tolerances of a step; drag damps what a step leaves in the velocity"});
      }
    }};

}  // namespace verification::references
