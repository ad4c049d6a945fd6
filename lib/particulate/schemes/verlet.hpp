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
  /// Keeps the acceleration at the end of the step, with the time and place where it holds.
  void accept(double);
  /// Drops the kept acceleration: for a caller that has changed the problem itself.
  void forget() { kept_ = false; }

 private:
  bool continues(const State& from) const;

  Rates start_, end_;
  State kept_at_, end_at_;  // where they hold; velocities do not count
  bool kept_ = false;
};

}  // namespace particulate::schemes
