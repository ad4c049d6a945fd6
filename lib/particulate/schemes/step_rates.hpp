#pragma once

#include <limits>

#include <particulate/schemes/problem.hpp>
#include <particulate/schemes/scheme.hpp>

namespace particulate::schemes {

/// Rates of a problem, and the state at which they hold, so that they are used nowhere else.
struct KeptRates {
  Rates rates;                                              ///< there
  State at{.t = std::numeric_limits<double>::quiet_NaN()};  ///< where; its v may be left empty: then for any velocity

  /// @param state  any
  /// @return whether they hold there, to the last bit
  bool hold_at(const State& state) const;
  /// They hold nowhere any more.
  void forget() { at.t = std::numeric_limits<double>::quiet_NaN(); }
};

/// What one-step schemes keep of rates from step to step: those at both ends of the step made last, and a third one,
/// from which the error of a step is estimated without many further right-hand sides.
///
/// That third one is the rate at the start of the step before or, in the first step and after a jump, one inside of the
/// step by dense output. A step that is tried again, and the next one, find the rate at their start where it is known.
class StepRates {
 public:
  KeptRates start;  ///< of the step made last
  KeptRates end;    ///< likewise

  /// Begins a run: goes on where the last one ended with the same problem, else anew.
  ///
  /// @param problem  the right-hand side
  /// @param state    the start of the run
  /// @param ask      whether to ask for the rates there once more, as the problem may have changed: the same bits
  void begin(const Problem& problem, const State& state, bool ask);
  /// Begins a step.
  ///
  /// @param from  its start
  /// @return whether `start` holds there
  bool begin_step(const State& from) {
    if (end.at.t == from.t || start.at.t == from.t) return find_start(from);
    begin_anew();
    return false;
  }
  /// @param dt  length of the step that was accepted [s]
  void accept(double dt) { last_dt_ = dt; }
  /// Drops everything.
  void forget();

  /// Sees to it that there is a third rate, for an estimate of the error; what is needed for that is kept from now on.
  ///
  /// @param scheme   with dense output of the step made last
  /// @param problem  asked where no step came before
  /// @param from     start of the step
  /// @param dt       the step [s]
  /// @return whether the problem had a value
  template <class S>
  bool find_third(const S& scheme, const Problem& problem, const State& from, double dt) {
    watched_ = true;
    place_ = before_ > 0.0 ? -before_ / dt : inside;
    if (before_ > 0.0) return true;
    scheme.at(from, dt, inside, there_);
    return problem.rates(there_, third_);
  }
  /// @return the third rate
  const Rates& third() const { return third_; }
  /// @return where it holds, in units of the step, from its start [-]
  double place() const { return place_; }

 private:
  static constexpr double inside = 0.25;

  bool find_start(const State& from);
  void begin_anew() {
    start.forget();
    before_ = 0.0;
  }

  Rates third_;
  State there_;
  Problem::Identity of_{};
  double place_ = 0.0, last_dt_ = 0.0;
  double before_ = 0.0;  // length of the step before, at whose start third_ holds; 0: it does not [s]
  bool watched_ = false;
};

/// Second difference of a rate over a step: \f$ \Delta t^2 f'' \f$ from three places.
///
/// @param start  at the start of the step
/// @param end    at its end
/// @param other  at a third place
/// @param place  of that, in units of the step, neither 0 nor 1 [-]
/// @param to     receives it
void second_difference(const Eigen::VectorXd& start, const Eigen::VectorXd& end, const Eigen::VectorXd& other,
                       double place, Eigen::VectorXd& to);

/// An estimate of the error of a step.
///
/// @param error  relative [-]
/// @param order  it falls with the power order + 1 of Dt [-]
/// @return the same; infinite where it is no number
Truncation estimated(double error, int order);

/// The error of a step as that of a run, for a method of low order, whose steps are many.
///
/// \f[ \epsilon = (\Delta t/\tau)^{p+1} \quad\Rightarrow\quad \epsilon^{p/(p+1)} = (\Delta t/\tau)^p, \f]
///
/// what the steps over a time tau, in which the solution changes by as much as itself, leave together: the error of a
/// run is then a multiple of TOL, the same for every TOL. Of high order both are nearly the same.
///
/// @param error  that the step left, relative [-]
/// @param p      order of the method [-]
/// @return that power of it, of order p - 1; infinite where it is no number
Truncation over_a_change(double error, int p);

}  // namespace particulate::schemes
