#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <harness/claims.hpp>
#include <harness/work_precision.hpp>
#include <particulate/report/output.hpp>

namespace verification {

/// One line of rows.csv, without what all rows of a case share.
struct Row {
  std::string quantity;                      ///< what was compared, with its unit
  particulate::report::Cell expected = {};   ///< by the reference; the bound of a one-sided claim
  particulate::report::Cell computed = {};   ///< by the library
  particulate::report::Cell error = {};      ///< in the unit of the tolerance
  std::string metric = {};                   ///< relative, absolute, mixed, at most, at least, equal, order, verdict
  particulate::report::Cell tolerance = {};  ///< the row passes if the error does not exceed it
  std::string because = {};                  ///< why it has this size
  bool passed = false;                       ///< the verdict
  std::string failure = {};                  ///< what is wrong, beyond the numbers
  double seconds = 0.0;                      ///< since the row before
};

/// Metric of a row that was not judged.
inline constexpr const char* left_out = "left out";

/// One line of stability.csv.
struct Stability {
  std::string name;     ///< the extreme case
  std::string must;     ///< solved or refused
  std::string verdict;  ///< solved, refused or wrong
  std::string reason;   ///< of a refusal; what is wrong
};

/// What a case writes its results to, and what it may ask about the run.
class Rows {
 public:
  /// What the run was asked for.
  struct Settings {
    bool quick = false;                                   ///< smaller sizes, no claim dropped
    std::uint64_t seed = 1;                               ///< of the whole run
    int threads = 1;                                      ///< to hand on
    const particulate::report::Output* output = nullptr;  ///< where results go
  };
  /// @param case_name  whose rows these are
  /// @param settings   what the run was asked for
  Rows(std::string case_name, Settings settings);

  /// One number against its reference.
  /// @param quantity    what it is, with its unit: "v_n after [m/s]"
  /// @param comparison  expected, computed, tolerance and its reason
  void compare(const std::string& quantity, const Comparison& comparison);
  /// A number that must not exceed a bound. @param quantity what it is @param bound limit, computed, reason
  void at_most(const std::string& quantity, const Bound& bound);
  /// A number that must reach a bound. @param quantity what it is @param bound limit, computed, reason
  void at_least(const std::string& quantity, const Bound& bound);
  /// A count or a text. @param quantity what it is @param equality expected, computed, reason
  void equal(const std::string& quantity, const Equality& equality);
  /// A count that must be 0. @param quantity what it counts @param count of the library @param because why there is
  /// none
  void none(const std::string& quantity, const Exactly& count, const std::string& because) {
    equal(quantity, {.expected = 0, .computed = count, .because = because});
  }
  /// A bound that is not claimed of what is at hand, such as another version of a competitor: shown, not judged. A case
  /// needs another row that is.
  /// @param quantity  what it is
  /// @param bound     limit, computed, why it is left out
  void leave_out(const std::string& quantity, const Bound& bound);
  /// An order of accuracy, two-sided: |fitted - nominal| <= 0.2.
  /// @param quantity     what converges
  /// @param convergence  nominal order, steps, errors, floor, reason
  void order(const std::string& quantity, const Convergence& convergence);
  /// An order of accuracy that theory only bounds from below: fitted >= nominal - 0.2.
  /// @param quantity     what converges
  /// @param convergence  least order, steps, errors, floor, reason
  void order_at_least(const std::string& quantity, const Convergence& convergence);

  /// An extreme case that must give an answer.
  /// @param name     what is extreme
  /// @param attempt  runs it; an exception counts as a refusal
  void must_be_solved(const std::string& name, const std::function<Ending()>& attempt);
  /// An extreme case that must be refused.
  /// @param name       what is extreme
  /// @param key_words  separated by blanks, at least one; the reason must contain each of them
  /// @param attempt    runs it; an exception counts as a refusal, its text as the reason
  void must_be_refused(const std::string& name, const std::string& key_words, const std::function<Ending()>& attempt);

  /// Measures error against run time: lines of work_precision.csv, and rows for what must hold of a measurement.
  ///
  /// The rows: the slope of every method that has one; and one that all methods did the same task, their settings are
  /// at most half a decade apart, counts repeated in every run and in the replay, every run that claims an answer has
  /// an error, every method solved something, and one of them is a ruler with a slope.
  /// @param measurement  the problem and its competitors
  void work_precision(const WorkPrecision& measurement);

  /// Writes `<out>/<name>.csv`, for a figure.
  /// @param name   lower-case letters, digits, underscores
  /// @param table  what to write
  void write(const std::string& name, const particulate::report::Table& table) const;

  /// @return whether this is a quick run: shorten sizes, repeats and sweeps, drop no claim
  bool quick() const { return settings_.quick; }
  /// @return whether this is a full run
  bool full() const { return !settings_.quick; }
  /// @return the seed of the run
  std::uint64_t seed() const { return settings_.seed; }
  /// @return a seed of this case's own, from the run's seed and the case's name: other cases do not move it
  std::uint64_t case_seed() const;
  /// @return threads to hand to the library
  int threads() const { return settings_.threads; }

  /// @return the rows so far
  const std::vector<Row>& all() const { return rows_; }
  /// @return the verdicts so far
  const std::vector<Stability>& stability() const { return stability_; }
  /// @return the measured points so far
  const std::vector<WorkPrecisionPoint>& points() const { return points_; }
  /// Adds a failed row that is not a comparison: an exception, an empty case.
  /// @param quantity  what should have been
  /// @param failure   what happened instead
  void fail(const std::string& quantity, const std::string& failure);

 private:
  void add(Row row);
  void add_order(const std::string& quantity, const Convergence& convergence, bool two_sided);
  void add_verdict(Stability verdict, Row row);

  std::string case_name_;
  Settings settings_;
  std::vector<Row> rows_;
  std::vector<Stability> stability_;
  std::vector<WorkPrecisionPoint> points_;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace verification
