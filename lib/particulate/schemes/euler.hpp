#pragma once

#include <limits>

#include <particulate/schemes/problem.hpp>

namespace particulate::schemes {

/// Forward Euler: explicit, order 1.
///
/// \f[ y^{L+1} = y^L + \Delta t\,f(t^L, y^L) \f]
///
/// @equation{M 3.3} The number is about. One right-hand side a step. For \f$ m \dot v = -c v \f$ the factor of a step
/// is \f$ 1 - c\,\Delta t/m \f$, stable for \f$ \Delta t < 2m/c \f$; an oscillator gains energy in every step.
/// Motions are taken as \f$ (r, v) \f$. Backward Euler (M 3.5) is PhiFamily with phi = 1.
struct ForwardEuler {
  static constexpr int order = 1;  ///< of the global error [-]
  /// @param of  what a problem has @return whether it has motion or values
  static constexpr bool advances(const Traits& of) { return of.motion || of.values; }
  /// @param kind  of time scale @return how many of them one step may span: see Limited [-]
  static double spans(TimeScale::Kind kind, int) {
    using Kind = TimeScale::Kind;
    if (kind == Kind::loads) return std::numeric_limits<double>::infinity();
    return kind == Kind::decays || kind == Kind::relaxes ? 2.0 : kind == Kind::drifts ? 1.0 : 0.0;
  }

  /// One step.
  ///
  /// @param problem  the right-hand side
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       receives the state at its end
  /// @return whether the problem had a value at the start
  bool predict(const Problem& problem, const State& from, double dt, State& to);
  /// Dense output: the straight line, which is what a step of theta Dt would give.
  ///
  /// @param from   state at the start of the step made last
  /// @param dt     that step [s]
  /// @param theta  in units of the step; 0 its start, 1 its end [-]
  /// @param there  receives the state
  void at(const State& from, double dt, double theta, State& there) const;
  void accept(double) {}  ///< Keeps nothing: a one-step method.
  void forget() {}        ///< Has nothing to forget.

 private:
  Rates rates_;
};

}  // namespace particulate::schemes
