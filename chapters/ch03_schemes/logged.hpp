#pragma once

#include <vector>

#include <particulate/schemes/scheme.hpp>

/// @file
/// What both halves of chapter 3's program watch a step control with.

namespace ch03 {

/// A step control that lets another one decide, and writes down every attempt, the refused ones too.
///
/// Satisfies particulate::schemes::Controller.
template <class Control>
struct Logged {
  /// One attempt.
  struct Entry {
    double t;                            ///< its start [s]
    particulate::schemes::Attempt made;  ///< as the control saw it
    bool accepted;                       ///< whether it stands
    Control after;                       ///< the control, as it left the attempt
  };
  Control control;                  ///< which decides
  std::vector<Entry> entries = {};  ///< every attempt so far
  double t = 0.0;                   ///< start of the next one [s]

  /// @return the step to try next [s]
  double dt() const { return control.dt(); }
  /// @param it  the iteration so far @return whether the sweeps have still to go on
  bool goes_on(const particulate::schemes::Iteration& it) const { return control.goes_on(it); }
  /// @param made  the attempted step @return what the control makes of it
  particulate::schemes::Decision judge(const particulate::schemes::Attempt& made) {
    particulate::schemes::Decision decision = control.judge(made);
    entries.push_back({t, made, decision.accepted, control});
    entries.back().made.fields = {};  // these are the scheme's, and change
    if (decision.accepted) t += made.dt;
    return decision;
  }
};

/// @param log  checked by what checks its control
template <class Control>
void validate(const Logged<Control>& log) {
  validate(log.control);
}

}  // namespace ch03
