#pragma once

#include <particulate/schemes/problem.hpp>

namespace particulate::schemes {

/// Acceleration of either kind of second-order problem; velocities are ignored where the forces ignore them.
///
/// @param problem  the right-hand side
/// @param t        time [s]
/// @param r        positions [m]
/// @param v        velocities, as long as r [m/s]
/// @param a        receives accelerations, as long as r [m/s^2]
/// @return whether the problem has a value there
template <SecondOrderProblem P>
bool acceleration_of(P& problem, double t, In r, [[maybe_unused]] In v, Out a) {
  if constexpr (PositionProblem<P>) {
    return problem.acceleration(t, r, a);
  } else {
    return problem.acceleration(t, r, v, a);
  }
}

/// The classical Runge-Kutta method of order 4, the ruler that every other scheme is held against.
///
/// \f[ k_1 = f(t, y),\quad k_2 = f(t + \tfrac{\Delta t}{2}, y + \tfrac{\Delta t}{2} k_1),\quad
///     k_3 = f(t + \tfrac{\Delta t}{2}, y + \tfrac{\Delta t}{2} k_2),\quad k_4 = f(t + \Delta t, y + \Delta t\, k_3),
///     \qquad y^{L+1} = y^L + \tfrac{\Delta t}{6}(k_1 + 2 k_2 + 2 k_3 + k_4) \f]
///
/// Source: @cite hairer1993, section II.1. Four right-hand sides a step, explicit, linearly stable on an oscillator for
/// \f$ \omega\,\Delta t < 2\sqrt2 \f$. Second-order problems are taken as \f$ y = (r, v) \f$, with the velocity stages
/// written out.
struct RungeKutta4 {
  static constexpr int order = 4;  ///< of the global error [-]

  /// One step of a second-order problem.
  ///
  /// @param problem  the right-hand side
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       receives the state at its end
  /// @return whether the problem had a value at all four stages
  template <SecondOrderProblem P>
  bool predict(P& problem, const Motion& from, double dt, Motion& to) {
    const double half = 0.5 * dt;
    const double middle = from.t + half;
    for (Eigen::VectorXd* k : {&k1_, &k2_, &k3_, &k4_}) k->resize(from.r.size());

    if (!acceleration_of(problem, from.t, from.r, from.v, k1_)) return false;
    stage_ = from.r + half * from.v;
    speed_ = from.v + half * k1_;
    if (!acceleration_of(problem, middle, stage_, speed_, k2_)) return false;
    stage_ = from.r + half * speed_;
    speed_ = from.v + half * k2_;
    if (!acceleration_of(problem, middle, stage_, speed_, k3_)) return false;
    stage_ = from.r + dt * speed_;
    speed_ = from.v + dt * k3_;
    if (!acceleration_of(problem, from.t + dt, stage_, speed_, k4_)) return false;

    to.t = from.t + dt;
    to.r = from.r + dt * from.v + (dt * dt / 6.0) * (k1_ + k2_ + k3_);
    to.v = from.v + (dt / 6.0) * (k1_ + 2.0 * (k2_ + k3_) + k4_);
    return true;
  }

  /// One step of a first-order problem.
  ///
  /// @param problem  the right-hand side
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       receives the state at its end
  /// @return whether the problem had a value at all four stages
  template <FirstOrderProblem P>
  bool predict(P& problem, const Values& from, double dt, Values& to) {
    const double half = 0.5 * dt;
    const double middle = from.t + half;
    for (Eigen::VectorXd* k : {&k1_, &k2_, &k3_, &k4_}) k->resize(from.y.size());

    if (!problem.rate(from.t, from.y, k1_)) return false;
    stage_ = from.y + half * k1_;
    if (!problem.rate(middle, stage_, k2_)) return false;
    stage_ = from.y + half * k2_;
    if (!problem.rate(middle, stage_, k3_)) return false;
    stage_ = from.y + dt * k3_;
    if (!problem.rate(from.t + dt, stage_, k4_)) return false;

    to.t = from.t + dt;
    to.y = from.y + (dt / 6.0) * (k1_ + 2.0 * (k2_ + k3_) + k4_);
    return true;
  }

  void accept(double) {}  ///< Keeps nothing: a one-step method.
  void forget() {}        ///< Has nothing to forget.

 private:
  Eigen::VectorXd k1_, k2_, k3_, k4_, stage_, speed_;
};

}  // namespace particulate::schemes
