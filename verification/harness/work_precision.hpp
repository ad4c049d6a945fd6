#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace verification {

/// What one run cost. Counts, not seconds: they must be the same every time.
struct Counts {
  long evaluations = 0;      ///< of the right-hand side
  long iterations = 0;       ///< sweeps, nonlinear iterations; 0 for an explicit method
  std::string failure = {};  ///< why it gave no answer; empty: solved

  bool operator==(const Counts&) const = default;
};

/// Attained errors of one run, mixed relative and absolute per component: see mixed_error().
struct Errors {
  double end = 0.0;  ///< at the end time
  double max = 0.0;  ///< largest over the output times
};

/// What was to be done, told by each competitor from its own problem object, so that it can be seen to be the same.
struct Task {
  std::vector<double> start;    ///< the state it starts from, positions before velocities
  std::vector<double> rate;     ///< the right-hand side there (of a second-order problem: the accelerations)
  std::vector<double> outputs;  ///< times at which it hands out a state [s]

  bool operator==(const Task&) const = default;
};

/// One method at one setting, ready to run. Everything that is not the method's work has been done before.
struct Prepared {
  Task task;                       ///< what it does
  std::function<Counts()> run;     ///< the whole run, from the start each time; timed
  std::function<Errors()> errors;  ///< of the states that run handed out last; not timed
  std::function<Counts()> replay;  ///< the same run with the right-hand side replayed from a recording; timed
};

/// One method over its settings.
struct Competitor {
  std::string name;                                 ///< as it stands in the diagram's key
  bool tuned = false;                               ///< settings other than the method's defaults: drawn apart
  std::optional<double> slope = {};                 ///< error ~ evaluations^-slope; for methods of fixed step
  std::string steeper = {};                         ///< why errors may fall faster than that; empty: they may not
  std::vector<double> settings;                     ///< tolerances or steps, falling, at most half a decade apart
  std::function<Prepared(double setting)> prepare;  ///< sets the method up; may record, allocate, solve for a reference
};

/// Error against run time of several methods on one problem.
///
/// Every setting is run once to warm up and then at least five times, in a quick run at least twice. Runs shorter than
/// a millisecond, in a quick run a tenth of that, are timed in batches that last one. Seconds are per run: the smallest
/// and the median; those of the replay likewise, the smallest.
struct WorkPrecision {
  std::string problem;                  ///< name of the diagram: lower-case letters, digits, underscores
  std::string reference;                ///< what errors are measured against, and how good that is, in words
  double floor = 0.0;                   ///< error of that reference, > 0: points within 10 of it are marked "at floor"
  std::vector<Competitor> competitors;  ///< one of them, the ruler, with a slope
  bool timed = true;                    ///< false: evaluations alone are wanted, of problems too large to repeat them
  std::string no_ruler = {};            ///< why no method of fixed step can solve the problem; empty: one must
};

/// One line of work_precision.csv.
struct WorkPrecisionPoint {
  std::string problem, method;             ///< which diagram, which line
  double setting = 0.0;                    ///< requested tolerance or step
  bool tuned = false;                      ///< not the method's defaults
  std::optional<Errors> errors;            ///< none after a failure
  double floor = 0.0;                      ///< error of the reference
  std::string reference;                   ///< in words
  std::optional<double> seconds_min;       ///< fastest repeat of a run [s]
  std::optional<double> seconds_median;    ///< [s]
  std::optional<double> seconds_overhead;  ///< fastest repeat with the right-hand side replayed [s]
  Counts counts;                           ///< as in every repeat
  std::string status;                      ///< "solved", "at floor" or "failed: reason"
  bool timed = true;                       ///< else evaluations alone were wanted: not a line of work_precision.csv
  bool repeats = true;                     ///< every repeat, and the replay, had the same counts
};

}  // namespace verification
