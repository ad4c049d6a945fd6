#pragma once

#include <string>

#include <harness/races.hpp>
#include <particulate/reference/fixed_point.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>

/// @file
/// Backward Euler with every step solved by KINSOL: what an independent iteration costs.

namespace verification {

/// Backward Euler as a scheme without sweeps: KINSOL's fixed point with Anderson is its guess, and its answer. One
/// earlier iterate is mixed in: of bodies that move along one line only, two differences depend on one another.
///
/// The unknown is the acceleration, \f$ a = \Psi(r_L + \Delta t\,v_L + \Delta t^2 a)/m \f$, from which places and
/// velocities follow without a difference of places.
struct KinsolEuler {
  static constexpr int order = 1;  ///< of the global error [-]
  /// @param of  what a problem has @return whether that is forces of positions alone
  static constexpr bool advances(const schemes::Traits& of) { return of.motion && !of.velocities && !of.values; }

  double tolerance;     ///< on the last change of any acceleration, > 0 [m/s^2]
  std::string unmet{};  ///< KINSOL's reason for not having solved a step

  /// The whole step.
  ///
  /// @param problem  the right-hand side
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       receives the state at its end
  /// @return whether KINSOL solved it; else unmet says why not
  bool predict(const schemes::Problem& problem, const schemes::State& from, double dt, schemes::State& to) {
    const Eigen::VectorXd flight = from.r + dt * from.v;
    const particulate::reference::Map map = [&](schemes::In a, schemes::Out g) {
      const Eigen::VectorXd place = flight + dt * dt * a;
      return problem.rates(schemes::Where{from.t + dt, view(place), view(from.v), view(from.y)},
                           schemes::Answers{{g.data(), g.size()}, {nullptr, 0}});
    };
    Eigen::VectorXd a = Eigen::VectorXd::Zero(from.r.size());
    const particulate::reference::FixedPoint point = particulate::reference::solve_fixed_point(
        map, a, {.tolerance = tolerance, .anderson = 1, .max_iterations = 50});
    unmet = point.reason;
    to.t = from.t + dt;
    to.r = flight + dt * dt * a;
    to.v = from.v + dt * a;
    return point.converged;
  }
  void accept(double) {}  ///< Keeps nothing: a one-step method.
  void forget() {}        ///< Has nothing to forget.

 private:
  static Eigen::Map<const Eigen::VectorXd> view(const Eigen::VectorXd& x) { return {x.data(), x.size()}; }
};

/// KinsolEuler at fixed steps, for competitor().
///
/// @param speed  of the motion, which makes a tolerance on displacements one on accelerations [m/s]
/// @param TOL    on the sweeps, from the step
/// @return begin(problem, start, step)
inline Begin by_kinsol(double speed, SweepTolerance TOL) {
  return [speed, TOL](const schemes::Problem& problem, const schemes::State&, double step) -> Advance {
    return [problem, scheme = KinsolEuler{.tolerance = TOL(step) * speed / step},
            control = schemes::FixedStep{.step = step}](schemes::State& state, double t_end) mutable {
      schemes::Outcome out = schemes::integrate(problem, state, t_end, scheme, control);
      if (!scheme.unmet.empty()) out.reason = scheme.unmet;
      return out;
    };
  };
}

}  // namespace verification
