#pragma once

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include <particulate/schemes/iteration.hpp>
#include <particulate/schemes/mixing.hpp>
#include <particulate/schemes/problem.hpp>
#include <particulate/schemes/runge_kutta.hpp>

namespace particulate::schemes {

/// The monograph's implicit one-step schemes, solved by its fixed-point iteration.
///
/// \f[ v_i^{L+1} = v_i^L + \frac{\Delta t}{m_i}\left(\phi\,\Psi_i^{L+1} + (1 - \phi)\,\Psi_i^L\right), \qquad
///     r_i^{L+1} = r_i^L + \Delta t \left(\phi\,v_i^{L+1} + (1 - \phi)\,v_i^L\right) \f]
///
/// @equation{R 3.3} With phi = 1 it is backward Euler, the monograph's scheme
/// \f$ r^{L+1} = r^L + \Delta t\,v^L + \Delta t^2\,\Psi(r^{L+1})/m \f$; with phi = 1/2 the trapezoidal rule, of order
/// 2; with phi = 0 forward Euler, which ForwardEuler does without a sweep.
///
/// The first iterate is free flight, \f$ r^0 = r^L + \Delta t\,v^L,\ v^0 = v^L \f$. A sweep takes the accelerations at
/// the last iterate, then the velocities, then the positions. Where forces depend on positions only it contracts by
/// \f$ \phi^2\,\Delta t^2 \|\partial\Psi/\partial r\|/m \f$, on a spring by \f$ (\phi\,\omega\,\Delta t)^2 \f$: so phi
/// = 1 needs \f$ \omega\,\Delta t < 1 \f$ and phi = 1/2 needs \f$ \omega\,\Delta t < 2 \f$, no more than the explicit
/// VelocityVerlet does, and the unconditional stability of the implicit scheme is out of reach of its iteration. Where
/// forces depend on velocities, and for a first-order problem \f$ y' = f \f$, solved likewise from the first iterate
/// \f$ y^0 = y^L \f$, the factor is \f$ \sim \phi\,\Delta t \f$ and the exponent p is 1.
///
/// The error of a sweep is that of positions (of the values of a first-order problem), in the problem's measure, over
/// the displacement of the first sweep; see IterationMeasure. Where forces depend on velocities it is taken as
/// \f$ \phi\,\Delta t \f$ times that of the velocities: the same number, which positions far from the origin would
/// round away.
///
/// @tparam Mixing  how the next iterate follows from the last ones: Picard or Anderson
template <class Mixing = Picard>
class PhiFamily {
 public:
  static constexpr int order = 1;  ///< of the global error for every phi; 2 at phi = 1/2 [-]

  /// @param phi     weight of the end of the step, in [0, 1]; 1 is backward Euler [-]
  /// @param mixing  the iteration
  /// @throws std::invalid_argument if phi is no such weight
  explicit PhiFamily(double phi = 1.0, Mixing mixing = Mixing{}) : phi_(phi), mixing_(std::move(mixing)) {
    if (!(phi >= 0.0 && phi <= 1.0)) {
      throw std::invalid_argument(fmt::format("phi family: phi must be in [0, 1], got {}", phi));
    }
  }

  /// Free flight.
  ///
  /// @param problem  the right-hand side; asked for the start's unless phi = 1
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       receives the first iterate
  /// @return whether the problem had a value where it was asked
  template <SecondOrderProblem P>
  bool predict(P& problem, const Motion& from, double dt, Motion& to) {
    begin(from.r.size(), PositionProblem<P> ? 2 : 1);
    if (phi_ < 1.0 && !acceleration_of(problem, from.t, from.r, from.v, start_)) return false;
    to.t = from.t + dt;
    to.r = from.r + dt * from.v;
    to.v = from.v;
    return true;
  }

  /// One sweep over all particles.
  ///
  /// @param problem  the right-hand side
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       the iterate; receives the next one
  /// @return the iteration so far
  template <SecondOrderProblem P>
  Iteration sweep(P& problem, const Motion& from, double dt, Motion& to) {
    if (!acceleration_of(problem, to.t, to.r, to.v, rate_)) return measure_.no_value();
    weigh();
    const auto place = [&](const Eigen::VectorXd& mean) { next_ = from.r + dt * from.v + (phi_ * dt * dt) * mean; };
    place(rate_);
    double change = 0.0;
    if constexpr (PositionProblem<P>) {
      change = distance(problem, next_, to.r);
      normalize(problem, from.r, 1.0, from.r);
    } else {
      speed_ = from.v + dt * rate_;
      change = phi_ * dt * distance(problem, speed_, to.v);
      normalize(problem, from.r, phi_ * dt, from.v);
    }
    mixing_.next(mean_, rate_);
    place(mean_);
    to.r.swap(next_);
    to.v = from.v + dt * mean_;
    return measure_.record(change);
  }

  /// The values at the start, for the first iterate of a first-order problem.
  ///
  /// @param problem  the right-hand side; asked for the start's unless phi = 1
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       receives the first iterate
  /// @return whether the problem had a value where it was asked
  template <FirstOrderProblem P>
  bool predict(P& problem, const Values& from, double dt, Values& to) {
    begin(from.y.size(), 1);
    if (phi_ < 1.0 && !problem.rate(from.t, from.y, start_)) return false;
    to.t = from.t + dt;
    to.y = from.y;
    return true;
  }

  /// One sweep over all values.
  ///
  /// @param problem  the right-hand side
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       the iterate; receives the next one
  /// @return the iteration so far
  template <FirstOrderProblem P>
  Iteration sweep(P& problem, const Values& from, double dt, Values& to) {
    if (!problem.rate(to.t, to.y, rate_)) return measure_.no_value();
    weigh();
    next_ = from.y + dt * rate_;
    const double change = distance(problem, next_, to.y);
    normalize(problem, from.y, 1.0, from.y);
    mixing_.next(mean_, rate_);
    to.y = from.y + dt * mean_;
    return measure_.record(change);
  }

  void accept(double) {}  ///< Keeps nothing: a one-step method.
  void forget() {}        ///< Has nothing to forget.

 private:
  // Every iterate is the start moved on with a mean rate over the step, phi of the end's and 1 - phi of the start's.
  // The iteration is one for this mean; it begins with 0.
  void begin(Eigen::Index n, int p) {
    measure_.begin(p);
    mixing_.forget();
    mean_.setZero(n);
    rate_.resize(n);
    start_.resize(n);
  }
  void weigh() {
    if (phi_ < 1.0) rate_ = phi_ * rate_ + (1.0 - phi_) * start_;
  }
  // What is measured is `scale` times a vector that is `measured` at the start of the step.
  template <class P>
  void normalize(const P& problem, const Eigen::VectorXd& start, double scale, const Eigen::VectorXd& measured) {
    if (!measure_.waits_for_first()) return;
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(start.size());
    measure_.normalize(distance(problem, next_, start), scale * distance(problem, measured, zero));
  }

  double phi_;
  Mixing mixing_;
  Eigen::VectorXd mean_, rate_, start_, next_, speed_;
  IterationMeasure measure_;
};

/// Backward Euler, solved by the plain iteration: the scheme of the monograph.
using BackwardEuler = PhiFamily<Picard>;

}  // namespace particulate::schemes
