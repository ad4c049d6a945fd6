#pragma once

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

/// @file
/// Submissions that differ from the right one in a function or two: many in one program.

/// One of them.
/// @tparam Functions  pointers to all that is handed in, the right ones unless said otherwise
template <class Functions>
struct Mistake {
  std::string name;     ///< of the test, but for "mistake_" before it
  Functions handed_in;  ///< with the mistake

  /// @param mistake  its name; without more, the right functions are the mistake: another problem is asked
  Mistake(const char* mistake) : name(mistake) {}

  /// @param mistake   its name
  /// @param function  which of the functions is replaced
  /// @param by        what by
  /// @param more      a function and its replacement, as often as needed
  template <class Function, class... More>
  Mistake(const char* mistake, Function Functions::*function, std::type_identity_t<Function> by, More... more)
      : Mistake(mistake, more...) {
    handed_in.*function = by;
  }
};

/// The functions with the mistake that the environment's MISTAKE names.
/// @param mistakes  all there are
/// @return pointers to the functions
/// @throws std::invalid_argument if there is no such mistake
template <class Functions>
Functions made(const std::vector<Mistake<Functions>>& mistakes) {
  const char* const name = std::getenv("MISTAKE");
  for (const Mistake<Functions>& mistake : mistakes) {
    if (name && mistake.name == name) return mistake.handed_in;
  }
  throw std::invalid_argument("MISTAKE must be the name of a mistake");
}
