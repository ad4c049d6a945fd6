#pragma once

#include <particulate/schemes/problem.hpp>
#include <particulate/schemes/runge_kutta.hpp>

namespace particulate::schemes {

/// Forward Euler: explicit, order 1.
///
/// \f[ y^{L+1} = y^L + \Delta t\,f(t^L, y^L) \f]
///
/// @equation{M 3.3} The number is about. One right-hand side a step. For \f$ m \dot v = -c v \f$ the factor of a step
/// is \f$ 1 - c\,\Delta t/m \f$, stable for \f$ \Delta t < 2m/c \f$; an oscillator gains energy in every step.
/// Second-order problems are taken as \f$ y = (r, v) \f$. Backward Euler (M 3.5) is PhiFamily with phi = 1.
struct ForwardEuler {
  static constexpr int order = 1;  ///< of the global error [-]

  /// One step of a second-order problem.
  ///
  /// @param problem  the right-hand side
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       receives the state at its end
  /// @return whether the problem had a value at the start
  template <SecondOrderProblem P>
  bool predict(P& problem, const Motion& from, double dt, Motion& to) {
    rate_.resize(from.r.size());
    if (!acceleration_of(problem, from.t, from.r, from.v, rate_)) return false;
    to.t = from.t + dt;
    to.r = from.r + dt * from.v;
    to.v = from.v + dt * rate_;
    return true;
  }

  /// One step of a first-order problem.
  ///
  /// @param problem  the right-hand side
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       receives the state at its end
  /// @return whether the problem had a value at the start
  template <FirstOrderProblem P>
  bool predict(P& problem, const Values& from, double dt, Values& to) {
    rate_.resize(from.y.size());
    if (!problem.rate(from.t, from.y, rate_)) return false;
    to.t = from.t + dt;
    to.y = from.y + dt * rate_;
    return true;
  }

  void accept(double) {}  ///< Keeps nothing: a one-step method.
  void forget() {}        ///< Has nothing to forget.

 private:
  Eigen::VectorXd rate_;
};

}  // namespace particulate::schemes
