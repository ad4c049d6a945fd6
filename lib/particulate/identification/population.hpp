#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include <particulate/identification/cost.hpp>

namespace particulate::identification {

/// All that a run needs to go on.
struct Population {
  Eigen::MatrixXd strings = {};      ///< one a column; in order of rank once all have been evaluated
  std::vector<Value> values = {};    ///< of the first strings; as many as strings once a generation is complete
  long generation = 0;               ///< generations completed
  long evaluations = 0;              ///< calls of the cost
  long restarts = 0;                 ///< how often all strings were drawn anew
  std::vector<double> history = {};  ///< best cost of each generation since the last restart; NaN: none had a value
  std::map<std::string, long> without_value = {};  ///< evaluations that gave none, by reason
  Eigen::VectorXd aside = {};                      ///< the best string before the last restart; empty: there was none
  double aside_cost = std::numeric_limits<double>::quiet_NaN();  ///< its cost
  std::mt19937_64 engine = {};  ///< draws every random number; the same on every platform
};

/// A set of parameters with its cost.
struct Best {
  Eigen::VectorXd parameters = {};                         ///< empty: none has a value
  double cost = std::numeric_limits<double>::quiet_NaN();  ///< NaN: none has a value
};

/// @param population  of which some strings have been evaluated
/// @return the best of them and of what restarts put aside
Best best_of(const Population& population);

/// @param population  of which some strings have been evaluated
/// @param n           how many of the best, >= 1
/// @return mean of their costs, of fewer where fewer have a value; NaN where none has
double mean_of_best(const Population& population, std::size_t n = 6);

/// Puts strings in order of rank: equal costs keep their order, a string without value ranks behind all that have one.
///
/// @equation{R 5.1} Step 3 of the genetic algorithm.
/// @param population  of which every string has been evaluated
void rank(Population& population);

/// A population as a file, to be written whole: report::write_whole().
///
/// @param population  what to keep
/// @param problem     what it is of: problem_of()
/// @return the bytes of a scenes::Checkpoint
std::string to_bytes(const Population& population, std::string_view problem);

/// Reads what to_bytes() gave, and refuses everything else.
///
/// @param bytes    of a file
/// @param origin   its name, for messages
/// @param problem  of this run
/// @return the population
/// @throws std::runtime_error for a file of another kind, cut short or altered
/// @throws std::invalid_argument if it is of another problem, naming the first line that differs
Population population_from(std::string_view bytes, const std::string& origin, std::string_view problem);

}  // namespace particulate::identification
