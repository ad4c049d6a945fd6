#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <particulate/schemes/crossing.hpp>
#include <particulate/schemes/problem.hpp>

/// @file
/// Events: zeros of functions of the solution, where a run stops or is told of them.

namespace particulate::schemes {

/// What a run does at an event.
enum class Action {
  stop,   ///< ends there, with Status::stopped
  record  ///< ends a step there, remembers the event and goes on
};

/// Functions \f$ g_k(t, r, v, y) \f$ whose zeros are events.
///
/// All are evaluated together: `functions(state, g)` writes as many numbers as there are directions. The same object
/// can be given to a Watch, and to CVODE as the judge of it, which stops at every event. What the functions throw comes
/// out of the run as it was thrown.
struct Events {
  std::function<void(const State& at, Out g)> functions = {};  ///< writes every g_k; all continuous and finite
  std::vector<Direction> directions = {};                      ///< one a function; none: no events
  std::vector<std::string> names = {};                         ///< one a function; none: they are numbered
  std::vector<Action> actions = {};                            ///< one a function; none: every event stops
};

/// An event that happened.
struct Hit {
  std::size_t event = 0;                    ///< which function, counted from 0
  Direction crossing = Direction::falling;  ///< which way it passed zero; either: it touched zero and turned back
  double t = 0.0;                           ///< when [s]
};

/// Refuses events that cannot be meant. Called once, where they enter.
///
/// @param events  functions and directions; neither means no events
/// @throws std::invalid_argument naming what must hold and what was given
void validate(const Events& events);

/// @param events  the events
/// @param hit     one that happened
/// @return "event 0 falling", with its name in place of "event 0" if it has one
std::string describe(const Events& events, const Hit& hit);

/// Settings of a Watch.
struct WatchSettings {
  double graze = 1e-12;     ///< an extreme value of a function, over its largest value so far, that touches zero; in
                            ///< [0, 1e-3] [-]
  long most_at_once = 100;  ///< so many events and jumps in a row may follow one another within the rounding of the
                            ///< time; with more the run fails, as they accumulate; >= 1 [-]
};

/// Refuses settings that cannot be meant.
///
/// @param settings  the settings
/// @throws std::invalid_argument naming the setting, what must hold and what was given
void validate(const WatchSettings& settings);

/// Finds events in the steps of a run, by the dense output of its scheme, and remembers them.
///
/// A function is sampled at Chebyshev points of the step, as many as the order of the scheme, with its slope by
/// difference; first_crossing() tells what is found. The run shortens the step to the earliest event, solves it anew,
/// and locates the event again until it stands, so that its time has the order of the scheme and not the lower one of
/// dense output.
///
/// - **Direction.** Falling and rising are told apart; a passage the other way is nothing.
/// - **Several in a step.** The earliest ends the step, the others are located anew in the next one. Events within a
///   hundred roundings of the time happen together, in the order of their functions.
/// - **At the very start.** A function that is zero where a run starts, or where its last event was, counts only
///   once it has left zero: it passes nothing by leaving. Zero is what lies within 1e-14 of the largest value that the
///   function has had, or within ten times what an event has left of it.
/// - **At the end.** An event at the end of a run, to rounding, has happened.
/// - **Grazing.** A function that comes to zero within WatchSettings::graze of its largest value so far, and turns
///   back, has one event at the turning point, of the direction in which it came; its crossing is Direction::either.
///   One that goes further has two events, however close to each other; one that does not come so near has none. To
///   tell, the step is solved anew to end at the turning point where dense output brings it within 1e-4 of the largest
///   value in the step; if nothing has happened there, the shorter step stands.
/// - **Jumps.** A function that a jump of the state takes across zero passes nothing.
/// - **Missed.** Two passages of a function that turns more than once between two samples; what happens in the
///   first 1e-5 of a step; two passages so close to each other that dense output, of order s, does not show the turn
///   between them.
///
/// A watch is a value: a copy of it is a checkpoint. It can be handed to one run after another.
class Watch {
 public:
  /// @param events    what to look for
  /// @param settings  see WatchSettings
  /// @throws std::invalid_argument for events or settings that cannot be meant
  explicit Watch(Events events, const WatchSettings& settings = {});

  /// @return every event so far, in the order of time
  const std::vector<Hit>& hits() const { return hits_; }
  /// @return what is looked for
  const Events& events() const { return events_; }
  /// @return see WatchSettings
  const WatchSettings& settings() const { return settings_; }

  /// The first event of a step. Asked again, with the same start, it answers for the step as it is now.
  ///
  /// @param path   the step
  /// @param there  scratch
  /// @param end    how far to look, a little beyond 1 at most [-]
  /// @return its place, in (0, end]; none if there is none
  /// @throws std::invalid_argument if an event function is not finite within the step
  std::optional<double> first(const StepPath& path, State& there, double end);

  /// Books the events at the end of a step, as first() found them last.
  ///
  /// @param theta  the place that first() gave, or that of a jump [-]
  /// @param t      the time there [s]
  /// @param dt     the step [s]
  /// @return whether one of them stops the run
  bool happen(double theta, double t, double dt);

  /// @return the events that happened last at one time, in words; empty if there was none
  std::string last() const;

 private:
  // Writes every g_k at a place, or a little beside it along the motion there, and returns its time.
  using Evaluate = std::function<double(double theta, double moved, Eigen::VectorXd& g)>;

  std::optional<double> first_of(const Evaluate& at, int intervals, double end);
  std::vector<std::vector<Sample>> samples_of(const Evaluate& at, int intervals, double end) const;
  ZeroRules rules_of(std::size_t k, const std::vector<Sample>& samples);

  Events events_;
  WatchSettings settings_;
  State beside_;                                // scratch
  std::vector<int> side_;                       // of zero, +1 or -1; 0: at zero, not left yet
  std::vector<double> scale_;                   // the largest |g_k| so far
  std::vector<double> left_;                    // |g_k| where its last event was
  std::vector<std::optional<Crossing>> found_;  // in the step as first() saw it last
  std::vector<double> residue_;                 // |g_k| at the end of it
  std::vector<Hit> hits_;
};

}  // namespace particulate::schemes
