#pragma once

#include <span>
#include <vector>

#include <particulate/schemes/scheme.hpp>

/// @file
/// The error measure of the iteration, and what can be told from it: section 3.3.

namespace particulate::schemes {

/// Keeps the normalized error of the sweeps of one attempted step.
///
/// \f[ w_K = \frac{\sum_i \|r_i^{K+1} - r_i^K\|}{\sum_i \|r_i^1 - r_i^L\|} \f]
///
/// @equation{R 3.3} The denominator is the displacement of the first sweep, frozen, so that the ratio of two errors is
/// the ratio of two changes: an error over the latest displacement would mix both. Of a problem that HasScales it is
/// the displacement relative to the motion that its bodies share, or a frame's motion would loosen every tolerance. Of
/// a motion that has all but come to rest (Iteration::rests: by less than 1e-8 of the size of the state, the sum of the
/// distances from zero) rounding is all that can be asked for: see met(). No change over no displacement counts as 0.
/// Sweeps that change
/// nothing at all (a staggered field whose partners have not moved yet) do not count: the first is the first that
/// changes anything.
class IterationMeasure {
 public:
  /// Forgets the last step.
  ///
  /// @param p      the exponent of Dt in the contraction, >= 1 [-]
  /// @param field  name of the field, where several are staggered; it must outlive the measure
  void begin(int p, std::string_view field = {});

  /// Whether record() still waits for the first sweep, with its displacement and size.
  ///
  /// @return true until a sweep was recorded that changed something
  bool waits_for_first() const { return it_.w_0 == 0.0; }

  /// Sets what the sweeps are measured by. Called before record() as long as it waits for the first sweep.
  ///
  /// @param displacement  distance of the sweep's result from the start of the step, in the problem's measure
  /// @param size          distance of the start of the step from zero: with the displacement it sets what rounding is
  void normalize(double displacement, double size);

  /// Books one sweep.
  ///
  /// @param change  distance of its result from what it started from, in the problem's measure
  /// @return the iteration so far; not evaluated if the change is not finite, and then w_K and K stay those of the last
  ///         finite sweep
  const Iteration& record(double change);

  /// Books that the problem had no value.
  ///
  /// @return the iteration so far, not evaluated
  const Iteration& no_value();

  /// @return the iteration so far
  const Iteration& iteration() const { return it_; }
  /// @return the displacement by which changes are divided
  double unit() const { return denominator_; }

 private:
  Iteration it_;
  double denominator_ = 0.0;
};

/// The measures of every part of a state, for a scheme that sweeps over all of it at once.
///
/// The motion is one part; each named range of y is another, measured by the problem's distance where it is all that
/// the problem has, else by the sum of absolute values: metres and kelvins are never added. Each has its own
/// displacement, rounding and exponent p, and the worst, in units of its tolerance, stands for all.
class PartMeasures {
 public:
  /// Forgets the last step.
  ///
  /// @param problem  says what there is
  /// @param from     the start of the step
  /// @param p        of the motion: the exponent of Dt in its contraction [-]
  void begin(const Problem& problem, const State& from, int p);

  /// Forgets the last step, of a scheme whose changes are relative to sizes, so that one measure does for all.
  void begin_as_one();

  /// The measure of the motion, for the scheme to fill in.
  ///
  /// @return it; without motion that of the first range
  IterationMeasure& motion() { return measures_.front(); }

  /// Sets what the sweeps over the motion are measured by: see IterationMeasure::normalize.
  ///
  /// @param problem  measures, and knows the motion that its bodies share, if it HasScales
  /// @param from     the start of the step
  /// @param dt       the step [s]
  /// @param after    places after the first sweep [m]
  /// @param scale    of velocities to places, where the sweeps are measured by these; else 1 [s]
  void normalize_motion(const Problem& problem, const State& from, double dt, const Eigen::VectorXd& after,
                        double scale);

  /// Books a sweep over all ranges of y.
  ///
  /// @param problem  measures
  /// @param start    y at the start of the step
  /// @param before   y before the sweep
  /// @param after    y after it
  void record_values(const Problem& problem, const Eigen::VectorXd& start, const Eigen::VectorXd& before,
                     const Eigen::VectorXd& after);
  /// The same with other changes, of which the larger counts: see Collocation.
  ///
  /// @param problem       measures
  /// @param start         y at the start of the step
  /// @param before        y before the sweep
  /// @param after         y after it
  /// @param other_before  another combination of rates before the sweep
  /// @param other_after   the same after it
  void record_values(const Problem& problem, const Eigen::VectorXd& start, const Eigen::VectorXd& before,
                     const Eigen::VectorXd& after, const Eigen::VectorXd& other_before,
                     const Eigen::VectorXd& other_after);

  /// Books that the problem had no value.
  ///
  /// @return the iteration so far, not evaluated
  Iteration no_value();
  /// @return the iteration of the part with the largest error, in units of its tolerance
  Iteration worst();
  /// @return how each part's iteration went, in units of its tolerance; empty where there is one part alone
  std::span<const Iteration> iterations() const { return iterations_; }

 private:
  double distance(const Problem& problem, const Range& range, const Eigen::VectorXd& x, const Eigen::VectorXd& y) const;

  std::vector<IterationMeasure> measures_{1};  // the motion's first, where there is one, then one a range
  Eigen::VectorXd zero_, drifted_;
  std::vector<Range> ranges_;
  std::vector<Iteration> iterations_;
  bool moves_ = true;
};

/// Of several iterations the one with the largest error; one without a value is the worst, one at rest that rounding
/// keeps from coming closer the least, the first of equals counts.
///
/// @param all  at least one, in units of their tolerances
/// @return it
const Iteration& worst_of(std::span<const Iteration> all);

/// An iteration in units of a tolerance.
///
/// @param it   an iteration
/// @param TOL  > 0 [-]
/// @return the same, with w and rounding over TOL
Iteration in_units(Iteration it, double TOL);

/// The monograph's factor between the step that was made and the one that would have met a tolerance exactly.
///
/// \f[ \Phi_K = \frac{(TOL/w_0)^{1/(p K_d)}}{(w_K/w_0)^{1/(p K)}} \f]
///
/// @equation{R 3.3} It follows from \f$ w_K = (S\,\Delta t^p)^K w_0 \f$: the step \f$ \Phi_K\,\Delta t \f$ would have
/// met TOL after exactly \f$ K_d \f$ contractions.
///
/// @param it   the iteration of the step that was made
/// @param TOL  tolerance on w, > 0 [-]
/// @param K_d  desired contractions, >= 1 [-]
/// @return the factor; infinite if the sweeps met their fixed point exactly; NaN if no contraction was seen [-]
double phi_K(const Iteration& it, double TOL, int K_d);

/// Refuses a tolerance that rounding can never meet.
///
/// @param whose  the setting's owner, for the message
/// @param TOL    tolerance on a normalized error, at least 2.3e-16 and finite [-]
/// @throws std::invalid_argument saying what must hold and what was given
void validate_tolerance(std::string_view whose, double TOL);

/// Whether rounding keeps the sweeps from coming any closer to their fixed point.
///
/// Sweeps that contract by q repeat the rounding of each by 1/(1 - q).
///
/// @param it  an iteration
/// @return true if the last change is one rounding of the state, or falls no more and is some of these repeated ones
bool at_rounding(const Iteration& it);

/// Whether the sweeps have met a tolerance.
///
/// @param it   an iteration
/// @param TOL  on w [-]
/// @return true if w_K is at most TOL, or the state is all but at rest and rounding keeps it from coming closer
inline bool met(const Iteration& it, double TOL) { return it.w_K <= TOL || (it.rests && at_rounding(it)); }

/// Whether the ratio of the last two changes is good to three digits.
///
/// @param it  an iteration
/// @return true if its last change is above a thousand roundings of the state, or was not finite
bool shows_contraction(const Iteration& it);

/// What to report of an iteration that did not meet its tolerance.
///
/// @param made     the attempted step
/// @param TOL      the tolerance on w [-]
/// @param allowed  contractions that were allowed [-]
/// @return not accepted; impossible says what was seen and what would have worked, with its Failure and step
Decision unmet(const Attempt& made, double TOL, int allowed);

}  // namespace particulate::schemes
