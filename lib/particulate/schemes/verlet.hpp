#pragma once

#include <limits>

#include <particulate/schemes/problem.hpp>
#include <particulate/schemes/scales.hpp>
#include <particulate/schemes/step_rates.hpp>

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

  /// The error that the step just made left, relative to ErrorScales and over_a_change(): of places by the change of
  /// the acceleration in the step, \f$ \tfrac16 \Delta t^2 (a^{L+1} - a^L) \f$, of velocities by that of its change
  /// since the step before, \f$ \tfrac1{12} \Delta t^3 a'' \f$.
  ///
  /// @param problem  asked once more in the first step alone
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       state at its end
  /// @return it, of order 1; infinite where the problem has no value
  Truncation truncation(const Problem& problem, const State& from, double dt, const State& to);

  /// Begins a run: goes on from the last one where that ended with the same problem, else anew.
  ///
  /// @param problem  asked once more where the last one ended
  /// @param state    the start
  void begin(const Problem& problem, const State& state) { kept_.begin(problem, state, true); }
  /// @param dt  length of the step that stands [s]
  void accept(double dt) { kept_.accept(dt); }
  /// Drops the kept accelerations: for a caller that has changed the problem itself.
  void forget() { kept_.forget(); }

 private:
  // Velocities do not count.
  static bool keep(const Problem& problem, const State& state, const Eigen::VectorXd& v, KeptRates& kept);

  StepRates kept_;
  State error_;
  ErrorScales scales_;
};

}  // namespace particulate::schemes
