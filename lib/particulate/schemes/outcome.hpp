#pragma once

#include <iosfwd>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <particulate/schemes/problem.hpp>

/// @file
/// How a run ends, and what it did.

namespace particulate::schemes {

/// Why a run could not go on.
enum class Failure {
  none,               ///< it could
  no_value,           ///< the problem has no finite value at the step's iterates
  diverging,          ///< the sweeps drive the iterates apart
  slow,               ///< the sweeps contract, but do not meet the tolerance in as many as are allowed
  rounding,           ///< the tolerance asks for less than the rounding of the state
  time_stands_still,  ///< the step is too small to change the time
  inaccurate,         ///< the error of the step stays above the tolerance
  unsettled_jump,     ///< a jump of the state could not be completed
  not_located,        ///< a jump or an event is in a step, but no shorter step ends there
  accumulating,       ///< jumps or events follow one another ever faster, and never get beyond a time
  beyond_limit        ///< a fixed step spans more of a time scale of the problem than the scheme can
};

/// How a run ended.
enum class Status {
  reached,  ///< the end time was reached
  stopped,  ///< the observer asked to stop, or an event did
  failed    ///< it could not go on; the reason says why
};

/// @param status  how a run ended
/// @return its name, as it is written above
std::string_view name(Status status);
/// @param failure  why a run could not go on
/// @return its name, as it is written above, with blanks: "time stands still"
std::string_view name(Failure failure);

/// What a run did. The state that it leaves belongs to time t, whatever the status.
struct [[nodiscard]] Outcome {
  Status status = Status::reached;  ///< how it ended
  std::string reason = {};          ///< why it stopped or failed: what was seen, what would have worked
  Failure failure = Failure::none;  ///< why it failed, for a program
  double workable_step = std::numeric_limits<double>::quiet_NaN();  ///< after a failure: the step that would have met
                                                                    ///< the tolerance; NaN: unknown [s]
  double t = 0.0;                                                   ///< the time of the state that was left [s]
  long steps = 0;                                                   ///< accepted steps [-]
  long rejections = 0;                                              ///< steps that were refused and tried again [-]
  long sweeps = 0;                ///< sweeps of the iteration, in refused steps too [-]
  long evaluations = 0;           ///< right-hand sides [-]
  long impacts = 0;               ///< impulses exchanged by jumps [-]
  double contraction = 0.0;       ///< largest Iteration::rate seen above rounding [-]
  double overlap = 0.0;           ///< deepest overlap of two bodies at the end of any step [m]
  double overlap_at_start = 0.0;  ///< deepest overlap of two bodies in the state that the run was given [m]
  long contacts_at_start = 0;     ///< pairs that overlap there, and bodies with walls [-]
  double penetration = 0.0;       ///< largest Jump::penetration: above 0.1 bodies are where spheres cannot be [-]
  double travel = 0.0;  ///< largest Jump::travel of a step: where it is above 1, stepped contact may miss impacts [-]
  double energy_change = 0.0;                                      ///< of the kinetic energy by jumps [J]
  double heat = 0.0;                                               ///< thermal energy that jumps added [J]
  double released = 0.0;                                           ///< chemical energy that jumps released [J]
  double accumulation = std::numeric_limits<double>::quiet_NaN();  ///< after Failure::accumulating: the time that jumps
                                                                   ///< or events do not get beyond [s]
  std::vector<JumpShare> jumps_by_law = {};  ///< of each law that jumps, in their order; empty where there is one
  std::string ruled = {};                    ///< the time scale of the problem that cut a step last; empty: none did
};

/// Adds what the next leg of a run did: counts and energies add up, of contraction, overlap and travel the largest
/// stays. How the run ended is what the last leg says.
///
/// @param run  so far; an Outcome{} before the first leg
/// @param leg  the next one, which starts where the run was
/// @return the run
Outcome& operator+=(Outcome& run, const Outcome& leg);

/// An outcome in words: how and when the run ended, why, and what it did, as far as it is not zero.
///
/// @param outcome  of a run
/// @return lines of at most 100 columns where no word is longer, without a line break at the end
std::string describe(const Outcome& outcome);
/// Prints describe().
///
/// @param out      where to
/// @param outcome  of a run
/// @return the stream
std::ostream& operator<<(std::ostream& out, const Outcome& outcome);

}  // namespace particulate::schemes
