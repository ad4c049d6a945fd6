#pragma once

#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <particulate/schemes/outcome.hpp>
#include <particulate/schemes/state.hpp>

/// @file
/// What a run that is cut short needs to go on, as the bytes of a file.
///
///     const auto save = [&](const State& at, const auto& control, const Outcome& so_far) {
///       report::write_whole(path, to_bytes({.scene = parameters, .state = at, .step = control.step, .outcome = so_far,
///                                           .more = {{"history", history.memory()}}}));
///     };
///     integrate_in_legs(scene, state, t_end, scheme, control, period, save, history);
///
/// and in the run that goes on, which makes its scene, scheme, control and history as that one did,
///
///     const Checkpoint from = checkpoint_from(report::read_whole(path), path, parameters, scene.particles().size());
///     state = from.state;
///     control.step = from.step;
///     history.remember(from.more.at("history"));
///     integrate_in_legs(scene, state, t_end, scheme, control, period, save, history, from.outcome);
///
/// It ends with the same bits as if it had not been cut.

namespace particulate::scenes {

/// A run at the end of one of its legs: see schemes::integrate_in_legs().
struct Checkpoint {
  std::string scene = {};         ///< what the run is made of: a text that a run must share to go on, such as its
                                  ///< parameters, without those that may change: the end time, the folder
  schemes::State state = {};      ///< with its time
  double step = 0.0;              ///< that the control would make next [s]
  std::string engine = {};        ///< the random engine, if there is one: text_of()
  schemes::Outcome outcome = {};  ///< what the run has done so far; that it was cut short is no part of it
  std::map<std::string, std::vector<double>> more = {};  ///< whatever else is to be there in the end, such as
                                                         ///< History::memory(); names without blanks
};

/// A checkpoint as a file: a line with format, version and byte order, then records, each a line with name, type and
/// count and its raw bytes, last a line with a 64-bit checksum (FNV-1a) of all before it.
///
/// @param checkpoint  what to keep
/// @return the bytes, to be written whole: report::write_whole()
/// @throws std::invalid_argument for a name with a blank, or none
std::string to_bytes(const Checkpoint& checkpoint);

/// Reads what to_bytes() gave, and refuses everything else.
///
/// @param bytes   of a file
/// @param origin  its name, for messages
/// @param scene   what this run is made of
/// @param N       how many particles it has [-]
/// @return the checkpoint
/// @throws std::runtime_error for a file of another kind, version or byte order, cut short, or altered
/// @throws std::invalid_argument if it is of another scene, naming the first line that differs
Checkpoint checkpoint_from(std::string_view bytes, const std::string& origin, std::string_view scene, Eigen::Index N);

/// @param engine  of random numbers
/// @return where it is, as its operator << writes it
template <class Engine>
std::string text_of(const Engine& engine) {
  std::ostringstream text;
  text << engine;
  return text.str();
}

namespace detail {
[[noreturn]] void refuse_engine();
}  // namespace detail

/// Sets a random engine to where another was.
///
/// @param text    from text_of() of an engine of this type
/// @param engine  receives it
/// @throws std::invalid_argument if its operator >> does not read the text
template <class Engine>
void set_engine(const std::string& text, Engine& engine) {
  // Engines of Boost want to skip a blank after their last number, and fail where the text has ended.
  std::istringstream stream(text + ' ');
  if (!(stream >> engine)) detail::refuse_engine();
}

}  // namespace particulate::scenes
