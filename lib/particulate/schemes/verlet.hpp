#pragma once

#include <utility>

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

  /// One step.
  ///
  /// @param problem  the right-hand side
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       receives the state at its end
  /// @return whether the problem had a value at both ends
  template <PositionProblem P>
  bool predict(P& problem, const Motion& from, double dt, Motion& to) {
    if (!(kept_ && from.t == kept_t_ && from.r.size() == kept_r_.size() && from.r == kept_r_)) {
      kept_ = false;
      start_.resize(from.r.size());
      if (!problem.acceleration(from.t, from.r, start_)) return false;
    }
    to.t = from.t + dt;
    to.r = from.r + dt * from.v + (0.5 * dt * dt) * start_;
    end_.resize(from.r.size());
    if (!problem.acceleration(to.t, to.r, end_)) return false;
    to.v = from.v + (0.5 * dt) * (start_ + end_);
    end_t_ = to.t;
    end_r_ = to.r;
    return true;
  }

  /// Keeps the acceleration at the end of the step, with the time and place where it holds.
  void accept(double) {
    std::swap(start_, end_);
    std::swap(kept_r_, end_r_);
    kept_t_ = end_t_;
    kept_ = true;
  }

  /// Drops the kept acceleration: for a caller that has changed the problem itself.
  void forget() { kept_ = false; }

 private:
  Eigen::VectorXd start_, end_, kept_r_, end_r_;
  double kept_t_ = 0.0, end_t_ = 0.0;
  bool kept_ = false;
};

}  // namespace particulate::schemes
