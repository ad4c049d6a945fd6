#pragma once

#include <algorithm>
#include <limits>
#include <particulate/schemes/scheme.hpp>

namespace particulate::schemes {

/// Step control by both errors of a step: that of its iteration, after the monograph's Phi_K, and the scheme's own
/// estimate of what the step as such leaves.
///
/// @equation{D 3.4} The step to make next is the smaller of
///
/// \f[ \Phi_K\,\Delta t \qquad\text{and}\qquad
///     \text{safety} \left(\frac{TOL}{\text{truncation}}\right)^{1/(p+1)} \Delta t \f]
///
/// with p the order of the estimate, within the bounds below. The sweeps go on until what they leave is at most
/// `sweep_TOL`, for at most `allowed` contractions, of which Phi_K aims at \f$ K_d \f$: a contraction that has become
/// slower since the last step costs a sweep, and no refusal. What sweeps leave is the last change times
/// \f$ \theta/(1 - \theta) \f$, where \f$ \theta \f$ is the contraction seen, after the first sweep that of the last
/// step: one sweep less than the monograph's \f$ w_K \le TOL \f$ makes for the same error.
///
/// For a scheme without sweeps the estimate alone decides. A scheme without an estimate does not compile, and a step of
/// which there is none is refused.
///
/// Satisfies Controller. It is a value: a copy of it is a checkpoint.
struct ErrorControl {
  static constexpr bool needs_truncation = true;  ///< without an estimate it would bound nothing

  double TOL = 1e-6;        ///< on the scheme's estimate, at least 2.3e-16 [-]
  double sweep_TOL = 1e-6;  ///< on what the sweeps leave, in the measure of w_K, at least 2.3e-16 [-]
  int K_d = 2;              ///< desired contractions, >= 1 [-]
  int allowed = 8;          ///< contractions after which a step is refused, >= K_d [-]
  double step = 0.0;        ///< the step to try next, at first the first one; in (0, limit], 0: see first_step() [s]
  double limit =
      std::numeric_limits<double>::infinity();  ///< the largest step: no estimate sees what happens between its nodes,
                                                ///< so give one where forces act suddenly; left out: none [s]
  double smallest = 0.0;                        ///< a step below this one is not tried, the run fails; in [0, step] [s]
  double safety = 0.9;  ///< aims below TOL, in (0, 1]: an estimate that grows by the way would be refused [-]
  double growth = 3.0;  ///< a step is at most so many times the last one, > 1: the guess of its sweeps is
                        ///< extrapolated over so much more than the last polynomial saw [-]
  double worth = 1.1;   ///< growth by less than this is not made, >= 1: equal steps keep a decomposition [-]
  double retry = 0.9;   ///< a step that is made again is at most so many times as large, in (0, 1) [-]
  double shrink = 0.1;  ///< and at least so many times, in (0, retry) [-]

  double last_error = 0.0;  ///< set by judge(): the estimate of the step accepted last; 0: none [-]
  double last_step = 0.0;   ///< set by judge(): that step [s]
  bool refused = false;     ///< set by judge(): whether the step tried last was refused

  /// @return the step to try next [s]
  double dt() const { return step; }
  /// @return whether the first step was left out
  bool waits_for_step() const { return step == 0.0; }
  /// @param first  the step to begin with, taken within smallest and limit [s]
  void begin(double first) { step = std::min(limit, std::max(smallest, first)); }
  /// @param it  the iteration so far
  /// @return whether the sweeps have still to go on
  bool goes_on(const Iteration& it) const;
  /// Accepts what met both tolerances, and sets the next step. After a refusal the next step does not grow: what
  /// refused it is still near.
  ///
  /// @param made  the attempted step; one cut short to land on the end of a run leaves a longer step alone
  /// @return accepted; refused, to be tried again with dt(); or impossible with the reason
  Decision judge(const Attempt& made);
  /// Drops what was set by judge(), but for the step. @see Forgets
  void forget() {
    last_error = last_step = 0.0;
    refused = false;
  }

 private:
  bool settled(const Iteration& it) const;
  double wish(const Attempt& made) const;
  Decision refuse(const Attempt& made);
};

/// Refuses settings that cannot be meant. Called once, when a run starts.
///
/// @param control  the controller
/// @throws std::invalid_argument naming the setting, what must hold and what was given
void validate(const ErrorControl& control);

}  // namespace particulate::schemes
