#pragma once

#include <map>
#include <span>
#include <string>

#include <harness/rows.hpp>
#include <particulate/report/table.hpp>

namespace verification {

/// What a step costs, from two runs of different length: starting and setting up are in both and cancel.
struct StepCost {
  double instructions = 0.0;  ///< per particle and step, counted by valgrind's tool callgrind
  double allocations = 0.0;   ///< per step
  double bytes = 0.0;         ///< asked for, per particle and step
  double impacts = 0.0;       ///< per step
};

/// Costs of the scenes of one program.
struct StepCosts {
  std::map<std::string, StepCost> scenes;  ///< by name

  /// @param scene  by its name
  /// @return its costs
  /// @throws std::invalid_argument if the program has no such scene
  const StepCost& of(const std::string& scene) const;
};

/// The lengths of the two runs.
struct RunLengths {
  long few = 50;    ///< steps of the shorter run, >= 1
  long many = 100;  ///< steps of the longer run, > few
};

/// Counts all scenes of a program (counted_program.hpp) in one run of valgrind, which hides AVX-512 from it.
///
/// @param program  path of the program
/// @param lengths  of the two runs of each scene
/// @return the costs of a step
/// @throws std::runtime_error if valgrind is missing, or a scene failed, or was not counted: with what they said
StepCosts step_costs(const std::string& program, const RunLengths& lengths);

/// A feature of a scene, as three scenes of a counted program have it; everything else in them is alike.
struct CountedFeature {
  const char* name;                  ///< for the table and the rows
  const char *absent, *idle, *used;  ///< the scenes: without it, with it but for nothing, and at work
  double most_idle;                  ///< instructions that it may cost idle, per particle and step
  const char* because;               ///< why so many
};

/// Rows and a table of what features cost: idle at most so much more than absent, used more than absent.
///
/// @param rows      receives two rows a feature
/// @param costs     of the program
/// @param features  what to look at
/// @param each      what a step is counted per: "particle", "member"
/// @param step      what the program calls a step
/// @return the table, three lines a feature: absent, idle, used
particulate::report::Table judge_features(Rows& rows, const StepCosts& costs, std::span<const CountedFeature> features,
                                          const char* each, const char* step = "step");

}  // namespace verification
