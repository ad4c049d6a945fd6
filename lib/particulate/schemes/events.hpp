#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <particulate/schemes/crossing.hpp>
#include <particulate/schemes/problem.hpp>

/// @file
/// Events: zeros of functions of the solution, where a run stops, is told of them, or changes its state.

namespace particulate::schemes {

/// Whether a run goes on after an event.
enum class Action {
  stop,   ///< it ends there, with Status::stopped
  record  ///< it ends a step there, remembers the event and goes on
};

/// A zero of a function \f$ g(t, r, v, y) \f$ of the state, and what is done there.
///
/// The same events can be given to a Watch, and to CVODE as the judge of it, which stops at every one and leaves what
/// is to be done to its caller. Each function is asked by itself: what several of them need is theirs to keep. What a
/// function or a change throws comes out of the run as it was thrown.
///
/// A ball on the ground z = 0:
/// @code
/// {.function = [](const State& at) { return at.r[2]; },
///  .direction = Direction::falling,
///  .action = Action::record,
///  .change = [e](State& at) { return at.v[2] *= -e, Jump{.impacts = 1}; }}
/// @endcode
struct Event {
  std::function<double(const State& at)> function = {};  ///< g: finite, and continuous but for jumps of its own
  Direction direction = Direction::either;               ///< which passages count
  Action action = Action::stop;                          ///< whether the run goes on
  std::function<Jump(State& at)> change = {};  ///< what becomes of r, v and y, before the run stops or goes on; what it
                                               ///< returns is added to the Outcome; empty: nothing
  std::string name = {};                       ///< for reports; empty: the event is numbered
};

/// What to look for; none: no events.
using Events = std::vector<Event>;

/// An event that happened.
struct Hit {
  std::size_t event = 0;                    ///< which one, counted from 0
  Direction crossing = Direction::falling;  ///< which way it passed zero; either: it touched zero and turned back
  double t = 0.0;                           ///< when [s]
};

/// Refuses events that cannot be meant. Called once, where they enter.
///
/// @param events  each with a function
/// @throws std::invalid_argument naming what must hold and what was given
void validate(const Events& events);

/// @param events  the events
/// @param hit     one that happened
/// @return "event 0 falling", with its name in place of "event 0" if it has one
std::string describe(const Events& events, const Hit& hit);

/// Settings of a Watch.
struct WatchSettings {
  double graze = 1e-12;     ///< an extreme value of a function, over its largest value in the step, that touches zero;
                            ///< in [0, 1e-3] [-]
  long most_at_once = 100;  ///< so many events and jumps in a row may follow one another without passing time that can
                            ///< be told; with more the run fails, as they accumulate; >= 1 [-]
};

/// Refuses settings that cannot be meant.
///
/// @param settings  the settings
/// @throws std::invalid_argument naming the setting, what must hold and what was given
void validate(const WatchSettings& settings);

/// Where a run must end a step.
struct Stop {
  double theta;  ///< the place, in (0, end] [-]
  bool reached;  ///< false: a function changes its sign there, and at the end of the step it has not, or no longer
  bool sharp;    ///< false: a function touches zero, which is only as sharp in time as the root of its value
};

/// Finds events in the steps of a run, by the dense output of its scheme, and remembers them.
///
/// A function is sampled at Chebyshev points of the step, as many as the order of the scheme, with its slope by
/// difference; first_crossing() tells what is found. The run shortens the step to the earliest event, solves it anew,
/// and locates the event again until the step ends there, so that its time has the order of the scheme and not the
/// lower one of dense output.
///
/// - **Passing.** A function that has one sign at the start of a step and the other, or zero, later on in it has an
///   event, however small it is and whatever its unit; one that jumps across zero has it where it jumps; one that stays
///   at zero, where it gets there. The step ends beyond the zero, within 1e-14 of the whole step.
/// - **Direction.** A passage the other way is nothing.
/// - **Several in a step.** The earliest ends the step, the others are located anew in the next one. Those that cannot
///   be told apart happen together, in the order of their events.
/// - **At the start.** A function that is zero at the start of a step passes nothing by leaving, but does by coming
///   back. At the start of a run, and where an event has changed the state, it is zero within what sixteen roundings of
///   the state, or 1e-14 of the step, make of it; where it turns, within what those roundings make of it.
/// - **After a change** of the state at an event, by Event::change or by the caller, a function goes back to where it
///   came from, unless its slope shows that it goes on: a ball that is sent back, however slowly, meets the ground
///   again. Events that come back before they have left zero by more than rounding end the run, as they accumulate.
/// - **At the end.** An event at the end of a run, to rounding, has happened.
/// - **Grazing.** A function that comes to zero within WatchSettings::graze of its largest value in the step, or within
///   sixteen roundings of the state, and turns back has one event at the turning point, of the direction in which it
///   came; its crossing is Direction::either. One that goes further has two events; one that does not come so near has
///   none. To tell, the step is solved anew to end at the turning point where dense output brings it within 1e-4 of the
///   largest value in the step; if nothing has happened there, the shorter step stands.
/// - **Jumps.** A function that a jump of the state takes across zero passes nothing.
/// - **Missed.** Two passages of a function that turns more than once between two samples; two passages so close to
///   each other that dense output does not show the turn between them.
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

  /// Looks at the start of a step, before first().
  ///
  /// @param path  the whole step
  /// @throws std::invalid_argument if an event function is not finite there
  void start(const StepPath& path);

  /// The first event of a step, whole or shortened.
  ///
  /// @param path  the step
  /// @param end   how far to look: 1, or a little beyond [-]
  /// @param last  whether the run ends with the step: what it has reached to rounding has then happened
  /// @return where it is; none if there is none
  /// @throws std::invalid_argument if an event function is not finite within the step
  std::optional<Stop> first(const StepPath& path, double end, bool last);

  /// Books the events of a step that stands, as first() saw it last.
  ///
  /// @param to    its end
  /// @param stop  where it was to end; none: it has no event
  /// @return how many happened
  std::size_t happen(const State& to, const std::optional<Stop>& stop);

  /// Lets the events that happened last change the state.
  ///
  /// @param many  how many
  /// @param at    the state there, changed in place
  /// @return what each change did
  /// @throws std::invalid_argument if one leaves numbers that are not finite, another number of them, or another time
  std::vector<Jump> change(std::size_t many, State& at) const;

  /// @param many  how many events happened last @return whether one of them stops the run
  bool stops(std::size_t many) const;
  /// @return whether the last event had come back to zero before it left it by more than rounding
  bool stands() const { return stands_; }
  /// @return how many events and jumps in a row have passed no time so far, through all runs: the run counts them [-]
  long& at_once() { return at_once_; }
  /// @return the events that happened last at one time, in words; empty if there was none
  std::string last() const;

 private:
  // How a function starts a step.
  struct Beginning {
    int side = 0;           // of zero, +1 or -1; 0: at zero
    int from = 0;           // at zero: the side to which it goes or goes back, 0: not known
    double value = 0.0;     // there
    double rounding = 0.0;  // what rounding of the state makes of it
    double graze = 0.0;     // an extreme value so near to zero touches it
    double farthest = 0.0;  // how far it gets to that side
    bool changed = false;   // at zero, where an event has changed the state
  };
  // What the last step has left of a function that had an event, and has not left zero since.
  struct Left {
    int side = 0;          // it came from here; 0: it had none
    double band = 0.0;     // what is so near to zero is still there
    bool back = false;     // it goes back there: it has touched zero, or this was found before
    bool changed = false;  // see Beginning
  };

  double value(std::size_t k, const State& at) const;
  double slope(std::size_t k, const StepPath& path, double theta, double end);
  Beginning begin(std::size_t k, bool changed, double moves) const;
  std::vector<std::vector<Sample>> samples_of(const StepPath& path, double end);
  ZeroRules rules_of(std::size_t k, const std::vector<Sample>& samples, bool last) const;

  Events events_;
  WatchSettings settings_;
  bool fresh_ = true;  // no step has been made yet
  bool stands_ = false;
  long at_once_ = 0;
  State there_, beside_;  // scratch
  State last_;            // the state that the last event has met
  std::vector<Left> left_;
  std::vector<Beginning> begun_;                // of the step looked at
  std::vector<std::optional<Crossing>> found_;  // in it
  std::vector<Hit> hits_;
};

}  // namespace particulate::schemes
