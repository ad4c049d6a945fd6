#pragma once

#include <span>

/// @file
/// A program whose scenes are to be counted by instruction_count.hpp. It is a program of its own because it counts what
/// it asks of malloc, and because valgrind runs it.

namespace verification {

/// What a scene says of one run.
struct CountedRun {
  long particles = 0;  ///< in the scene
  long impacts = 0;    ///< in the run
  double sum = 0.0;    ///< of all that was computed, so that the compiler leaves nothing out
};

/// Something that can be run for any number of steps, alike each time.
struct CountedScene {
  const char* name;               ///< without blanks, no two alike
  CountedRun (*run)(long steps);  ///< sets up and takes that many steps
};

/// The whole of main(): `<program> <steps>...` runs every scene with each number of steps, and marks for callgrind
/// where a run begins and ends; without arguments it lists the scenes.
///
/// All runs are children of one process, in which every scene has taken one step: valgrind starts and translates once,
/// and each run begins alike.
/// Prints a line a run: its name, particles, steps, impacts, and the allocations and bytes that it asked for.
/// @param argc    of main
/// @param argv    of main
/// @param scenes  what to run
/// @return the exit status: 1 if a scene failed, 2 if the arguments were refused
int counted_program(int argc, const char* const* argv, std::span<const CountedScene> scenes);

}  // namespace verification
