#pragma once

#include <limits>

#include <particulate/schemes/problem.hpp>

namespace particulate::schemes {

/// Velocity Verlet: explicit, symmetric and symplectic, order 2, for forces that depend on positions only.
///
/// \f[ r^{L+1} = r^L + \Delta t\, v^L + \tfrac12 \Delta t^2 a^L, \qquad
///     v^{L+1} = v^L + \tfrac12 \Delta t\,(a^L + a^{L+1}) \f]
///
/// Source: @cite hairer2006, section I.1.4 (after @cite verlet1967). One right-hand side a step, because the
/// acceleration at the end of a step is kept for the next one; it is computed afresh where the next step does not start
/// there. Linearly stable on an oscillator for \f$ \omega\,\Delta t < 2 \f$.
struct VelocityVerlet {
  static constexpr int order = 2;  ///< of the global error [-]
  /// @param of  what a problem has @return whether it is a motion whose forces ignore velocities, and no more
  static constexpr bool advances(const Traits& of) { return of.motion && !of.velocities && !of.values; }
  /// @param kind  of time scale @return how many of them one step may span: see Limited [-]
  static double spans(TimeScale::Kind kind, int) {
    return kind == TimeScale::Kind::oscillates ? 2.0 : std::numeric_limits<double>::infinity();
  }

  /// One step.
  ///
  /// @param problem  the right-hand side
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       receives the state at its end
  /// @return whether the problem had a value at both ends
  bool predict(const Problem& problem, const State& from, double dt, State& to);
  /// Dense output of order 2: cubic Hermite, of places from velocities, of velocities from accelerations.
  ///
  /// \f[ r(\theta) = r^L + \theta\,\Delta t\,v^L + \tfrac12 \theta^2 \Delta t^2 \left(a^L + (\theta - 1)(a^{L+1} -
  ///     a^L)\right), \qquad v(\theta) = v^L + \theta\,\Delta t\,a^L + \tfrac12 \theta^2 \Delta t\,(a^{L+1} - a^L) \f]
  ///
  /// @param from   state at the start of the step made last
  /// @param dt     that step [s]
  /// @param theta  in units of the step; 0 its start, 1 its end [-]
  /// @param there  receives the state
  void at(const State& from, double dt, double theta, State& there) const;

  void accept(double) {}  ///< Keeps what it has: it knows where its accelerations hold.
  /// Drops the kept accelerations: for a caller that has changed the problem itself.
  void forget() { start_.at.t = end_.at.t = std::numeric_limits<double>::quiet_NaN(); }

 private:
  // Accelerations, and where they hold; velocities do not count.
  struct Kept {
    Rates rates;
    State at{.t = std::numeric_limits<double>::quiet_NaN()};
    bool holds_at(const State& state) const;
    bool renew(const Problem& problem, const State& state, const Eigen::VectorXd& v);
  };

  Kept start_, end_;  // of the step made last
};

}  // namespace particulate::schemes
