#pragma once

#include <functional>
#include <string>

namespace particulate::report {

/// How far a long loop has come, and how long it will still take: one line on a terminal, nothing anywhere else.
///
/// A new line appears at most every tenth of a second; it is wiped when the object goes. Outside a terminal a call
/// costs one comparison.
class Progress {
 public:
  /// Where the line goes and what time it is; the defaults are the terminal on stderr, if there is one, and a steady
  /// clock.
  struct Surroundings {
    bool shown = false;                             ///< whether anybody looks
    std::function<void(const std::string&)> print;  ///< takes text for the terminal
    std::function<double()> now;                    ///< a steady clock [s]
  };

  /// @param label     what is going on, a few words
  /// @param total     the amount of work, > 0, in any unit (steps, seconds of simulated time, cases)
  /// @param patience  time before the first line appears; work that is over sooner needs none [s]
  /// @throws std::invalid_argument unless total > 0
  Progress(std::string label, double total, double patience = 1.0);
  /// @param label         what is going on, a few words
  /// @param total         the amount of work, > 0
  /// @param patience      time before the first line appears [s]
  /// @param surroundings  terminal and clock
  Progress(std::string label, double total, double patience, Surroundings surroundings);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Wipes the line.
  ~Progress();

  /// Tells how much is done. Less than was told before counts as no progress, more than the total as the total.
  /// @param done  amount of work done, in the unit of the total
  void at(double done) {
    if (surroundings_.shown) show(done);
  }
  /// Wipes the line, so that something else can be printed; the next at() brings it back.
  void wipe();
  /// Changes what is going on; printed with the next at().
  /// @param label  a few words
  void label(std::string label) { label_ = std::move(label); }

 private:
  void show(double done);

  std::string label_;
  double total_;
  Surroundings surroundings_;
  double started_ = 0.0, due_ = 0.0, fraction_ = 0.0;
  bool line_is_there_ = false;
};

/// Runs that share nothing, as wholes among threads, with a line of progress.
///
/// @param label    what is going on, a few words
/// @param count    how many runs, > 0
/// @param threads  that share them, at least this one
/// @param run      is called once with each number from 0 to count - 1, by several threads at once
/// @throws what a run throws, after the others have ended
void for_each_run(const std::string& label, int count, int threads, const std::function<void(int)>& run);

}  // namespace particulate::report
