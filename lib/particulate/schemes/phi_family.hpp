#pragma once

#include <span>

#include <particulate/schemes/iteration.hpp>
#include <particulate/schemes/mixing.hpp>
#include <particulate/schemes/problem.hpp>
#include <particulate/schemes/scales.hpp>
#include <particulate/schemes/step_rates.hpp>

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
  /// @param of  what a problem has @return whether it has motion or values
  static constexpr bool advances(const Traits& of) { return of.motion || of.values; }

  /// @param phi     weight of the end of the step, in [0, 1]; 1 is backward Euler [-]
  /// @param mixing  the iteration
  /// @throws std::invalid_argument if phi is no such weight
  explicit PhiFamily(double phi = 1.0, Mixing mixing = Mixing{});

  /// How many time scales one step may span: see Limited. Iterated to its fixed point, 1/phi; after one sweep
  /// \f$ 2/\sqrt{4\phi - 1} \f$ of an oscillation and 2 of a decay; below phi = 1/2 no oscillation is stable, and a
  /// decay is over 2 by any odd number of sweeps, over \f$ 2/(1 - 2\phi) \f$ at most by others. Waves of values no
  /// single sweep advances, and two do up to \f$ \sqrt{2\phi - 1}/\phi \f$.
  ///
  /// @param kind    of time scale
  /// @param sweeps  of every step; 0: until they have converged
  /// @return multiple of the time scale [-]
  double spans(TimeScale::Kind kind, int sweeps) const;

  /// Free flight.
  ///
  /// @param problem  the right-hand side; asked for the start's unless phi = 1
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       receives the first iterate
  /// @return whether the problem had a value where it was asked
  bool predict(const Problem& problem, const State& from, double dt, State& to);

  /// One sweep over all particles and all values.
  ///
  /// @param problem  the right-hand side
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       the iterate; receives the next one
  /// @return the iteration so far, of the worst part of the state
  Iteration sweep(const Problem& problem, const State& from, double dt, State& to);

  /// Dense output of the order of the scheme: of places the cubic Hermite through both ends, of velocities and values
  /// the parabola through both ends and the rate at the start; for phi = 1, which does not know that, the line.
  ///
  /// @param from   state at the start of the step made last
  /// @param dt     that step [s]
  /// @param theta  in units of the step; 0 its start, 1 its end [-]
  /// @param there  receives the state
  void at(const State& from, double dt, double theta, State& there) const;

  /// @return how the iteration of each part of the state went; empty where there is one part alone
  std::span<const Iteration> iterations() const { return measures_.iterations(); }

  /// The error that the step just made left, relative to ErrorScales and over_a_change(), from the rates at both ends
  /// and, unless phi = 1, at the start of the step before:
  /// \f$ (\tfrac12 - \phi)\,\Delta t\,(f^{L+1} - f^L) - \tfrac1{12} \Delta t^3 f'' \f$ of velocities and values, of
  /// places \f$ (\tfrac12 - \phi)\,\Delta t^2 a^L + (\tfrac16 - \phi^2)\,\Delta t^2 (a^{L+1} - a^L) \f$.
  ///
  /// @param problem  asked once more in the first step alone, and at phi = 0 in every one
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       state at its end
  /// @return it, of order 0, of phi = 1/2 of order 1; infinite where the problem has no value
  Truncation truncation(const Problem& problem, const State& from, double dt, const State& to);

  /// Begins a run: goes on from the last one where that ended with the same problem, else anew.
  ///
  /// @param problem  whose history alone is kept
  /// @param state    the start
  void begin(const Problem& problem, const State& state) { kept_.begin(problem, state, false); }
  /// @param dt  length of the step that stands [s]
  void accept(double dt) { kept_.accept(dt); }
  /// Drops the rates that it keeps for estimates.
  void forget() { kept_.forget(); }

 private:
  void measure_motion(const Problem& problem, const State& from, double dt, const State& to);
  void mix();
  bool find_rates(const Problem& problem, const State& from, double dt, const State& to);

  double phi_;
  Mixing mixing_;
  Rates mean_, rates_;
  StepRates kept_;
  State error_;
  ErrorScales scales_;
  Eigen::VectorXd next_;
  PartMeasures measures_;
  bool values_ = false;
};

extern template class PhiFamily<Picard>;
extern template class PhiFamily<Anderson>;

/// Backward Euler, solved by the plain iteration: the scheme of the monograph.
using BackwardEuler = PhiFamily<Picard>;

}  // namespace particulate::schemes
