#pragma once

#include <limits>

#include <particulate/schemes/problem.hpp>

namespace particulate::schemes {

/// Symplectic Euler: explicit, order 1, velocities first; for forces that depend on velocities too.
///
/// \f[ v^{L+1} = v^L + \Delta t\,a(t^L, r^L, v^L), \qquad r^{L+1} = r^L + \Delta t\,v^{L+1} \f]
///
/// Source: @cite hairer2006, section I.1.2. One right-hand side a step. Where forces depend on positions alone it is
/// symplectic, and its energy does not drift; linearly stable on an oscillator for \f$ \omega\,\Delta t < 2 \f$, on
/// \f$ m \dot v = -c v \f$ for \f$ \Delta t < 2m/c \f$. Values that ride along take a step of ForwardEuler.
struct SymplecticEuler {
  static constexpr int order = 1;  ///< of the global error [-]
  /// @param of  what a problem has @return whether it has motion
  static constexpr bool advances(const Traits& of) { return of.motion; }
  /// @param kind  of time scale @return how many of them one step may span: see Limited [-]
  static double spans(TimeScale::Kind kind, int) {
    using Kind = TimeScale::Kind;
    if (kind == Kind::loads) return std::numeric_limits<double>::infinity();
    return kind == Kind::waves ? 0.0 : kind == Kind::drifts ? 1.0 : 2.0;
  }

  /// One step.
  ///
  /// @param problem  the right-hand side
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       receives the state at its end
  /// @return whether the problem had a value at the start
  bool predict(const Problem& problem, const State& from, double dt, State& to);
  /// Dense output: what a step of theta Dt would give.
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
