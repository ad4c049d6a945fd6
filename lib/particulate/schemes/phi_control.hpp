#pragma once

#include <algorithm>
#include <string_view>

#include <particulate/schemes/scheme.hpp>

namespace particulate::schemes {

/// The monograph's adaptive algorithm: the step follows from how the sweeps converge.
///
/// @equation{R 3.4} The sweeps go on until \f$ w_K \le TOL \f$, for at most \f$ K_d \f$ contractions. Then
///
/// \f[ \Delta t \leftarrow \min(\Phi_K\,\Delta t,\ \Delta t_{lim}) \f]
///
/// (see phi_K(), of K_d less what is to spare): after a success, where \f$ \Phi_K \ge 1 \f$, the next step grows; after
/// a failure, where \f$ \Phi_K < 1 \f$, the state at the start of the step is restored and the step is made again,
/// smaller. Of several staggered fields, each with its own tolerance and exponent, the smallest \f$ \Phi_K \f$ rules;
/// the scheme measures their errors in units of their tolerances, so that TOL is 1 here.
///
/// This bounds the error of the iteration, and nothing else: the error of the time discretization is bounded by
/// \f$ \Delta t_{lim} \f$ alone.
///
/// Satisfies Controller. It is a value: a copy of it is a checkpoint, `step` is all that it remembers.
struct PhiControl {
  static constexpr bool ignores_truncation = true;  ///< it is given no estimate
  static constexpr bool needs_sweeps = true;        ///< without them it would bound nothing

  double TOL = 1e-6;      ///< tolerance on w_K, at least 2.3e-16 [-]
  int K_d = 10;           ///< desired contractions, >= 1 [-]
  double step = 0.0;      ///< the step to try next, at first the first one; in (0, limit], 0: see first_step() [s]
  double limit = 0.0;     ///< Dt_lim: alone bounds the error of the time discretization [s]
  double smallest = 0.0;  ///< a step below this one is not tried, the run fails; in [0, step] [s]
  double growth = 2.0;    ///< a step is at most so many times the last one, > 1; Phi_K extrapolates a contraction seen
                          ///< at the last step, and is infinite where the sweeps met their fixed point at once [-]
  double retry = 0.9;   ///< a step that is made again is at most so many times as large, in (0, 1): with Phi_K = 0.999
                        ///< it would miss TOL by a hair again [-]
  double shrink = 0.1;  ///< and at least so many times, in (0, retry): what is measured far from the fixed point is
                        ///< no measure of how much smaller it must be [-]
  int spare = 0;  ///< of the K_d, 0 to K_d - 1: a step grows only as far as the contractions without these would do.
                  ///< With none a step that meets TOL makes the next one longer, until one does not [-]
  std::string_view controlling = {};  ///< set by judge(): the staggered field whose Phi_K was the smallest

  /// @return the step to try next [s]
  double dt() const { return step; }
  /// @return whether the first step was left out
  bool waits_for_step() const { return step == 0.0; }
  /// @param first  the step to begin with, taken within smallest and limit [s]
  void begin(double first) { step = std::min(limit, std::max(smallest, first)); }
  /// @param it  the iteration so far
  /// @return whether TOL is not met and contractions are left
  bool goes_on(const Iteration& it) const;
  /// Accepts what met TOL, and sets the next step.
  ///
  /// @param made  the attempted step; one cut short to land on the end of a run leaves a longer step alone
  /// @return accepted; refused, to be tried again with dt(); or impossible with the reason
  Decision judge(const Attempt& made);

 private:
  double factor(const Attempt& made);
  double within_bounds(double wish, bool met) const;
};

/// Refuses settings that cannot be meant. Called once, when a run starts.
///
/// @param control  the controller
/// @throws std::invalid_argument naming the setting, what must hold and what was given
void validate(const PhiControl& control);

}  // namespace particulate::schemes
