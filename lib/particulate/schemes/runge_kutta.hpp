#pragma once

#include <particulate/schemes/problem.hpp>

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
    return kind == TimeScale::Kind::oscillates ? 2.8284271247461903 : 2.785293563405282;
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
  void accept(double) {}  ///< Keeps nothing: a one-step method.
  void forget() {}        ///< Has nothing to forget.

 private:
  Rates k1_, k2_, k3_, k4_;
  State stage_;
};

}  // namespace particulate::schemes
