#pragma once

#include <limits>

#include <particulate/schemes/problem.hpp>
#include <particulate/schemes/scales.hpp>
#include <particulate/schemes/step_rates.hpp>

namespace particulate::schemes {

/// The classical Runge-Kutta method of order 4, the ruler that every other scheme is held against.
///
/// \f[ k_1 = f(t, y),\quad k_2 = f(t + \tfrac{\Delta t}{2}, y + \tfrac{\Delta t}{2} k_1),\quad
///     k_3 = f(t + \tfrac{\Delta t}{2}, y + \tfrac{\Delta t}{2} k_2),\quad k_4 = f(t + \Delta t, y + \Delta t\, k_3),
///     \qquad y^{L+1} = y^L + \tfrac{\Delta t}{6}(k_1 + 2 k_2 + 2 k_3 + k_4) \f]
///
/// Source: @cite hairer1993, section II.1. Four right-hand sides a step, explicit, linearly stable on an oscillator for
/// \f$ \omega\,\Delta t < 2\sqrt2 \f$ and on a decay for \f$ \lambda\,\Delta t < 2.785 \f$. Motions are taken as
/// \f$ (r, v) \f$, with the velocity stages written out.
struct RungeKutta4 {
  static constexpr int order = 4;  ///< of the global error [-]
  /// @param of  what a problem has @return whether it has motion or values
  static constexpr bool advances(const Traits& of) { return of.motion || of.values; }
  /// @param kind  of time scale @return how many of them one step may span: see Limited [-]
  static double spans(TimeScale::Kind kind, int) {
    using Kind = TimeScale::Kind;
    if (kind == Kind::drifts || kind == Kind::loads) return std::numeric_limits<double>::infinity();
    return kind == Kind::decays || kind == Kind::relaxes ? 2.785293563405282 : 2.8284271247461903;
  }

  /// One step.
  ///
  /// @param problem  the right-hand side
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       receives the state at its end
  /// @return whether the problem had a value at all four stages
  bool predict(const Problem& problem, const State& from, double dt, State& to);
  /// Dense output of order 3 from the stages of the step made last, without a further right-hand side.
  ///
  /// \f[ y(\theta) = y^L + \Delta t \sum_i b_i(\theta)\, k_i, \qquad b_1 = \theta - \tfrac32 \theta^2 +
  ///     \tfrac23 \theta^3, \quad b_2 = b_3 = \theta^2 - \tfrac23 \theta^3, \quad
  ///     b_4 = -\tfrac12 \theta^2 + \tfrac23 \theta^3 \f]
  ///
  /// Source: @cite hairer1993, section II.6.
  ///
  /// @param from   state at the start of that step
  /// @param dt     that step [s]
  /// @param theta  in units of the step; 0 its start, 1 its end [-]
  /// @param there  receives the state
  void at(const State& from, double dt, double theta, State& there) const;
  /// The error that the step just made left, relative to what ErrorScales sees; the larger of two
  /// estimates. One is the method of order 3 with the rate at the end of the step in place of the last stage,
  /// \f$ \tfrac16 \Delta t\,(k_4 - f^{L+1}) \f$; the other \f$ \tfrac1{96} \Delta t^4 f''' \f$ of the rates over this
  /// step and the last one, as the first is blind where they depend on time alone. On \f$ y' = \lambda y \f$ both are
  /// \f$ (\lambda\,\Delta t)^4/72 \f$.
  ///
  /// @param problem  asked at the end, which is the start of the next step, and once more in the first step
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       state at its end
  /// @return the error and its order 3; infinite where the problem has no value
  Truncation truncation(const Problem& problem, const State& from, double dt, const State& to);

  /// Begins a run: goes on from the last one where that ended with the same problem, else anew.
  ///
  /// @param problem  asked once more where the last one ended, if that was asked for errors
  /// @param state    the start
  void begin(const Problem& problem, const State& state) { kept_.begin(problem, state, true); }
  /// @param dt  length of the step that stands [s]
  void accept(double dt) { kept_.accept(dt); }
  /// Drops the rates that it keeps for estimates.
  void forget() { kept_.forget(); }

 private:
  StepRates kept_;  // the first stage is the start's
  Rates k2_, k3_, k4_;
  State stage_, error_;
  ErrorScales scales_;
};

}  // namespace particulate::schemes
