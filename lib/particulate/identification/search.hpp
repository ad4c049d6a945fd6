#pragma once

#include <cstdint>
#include <limits>

#include <particulate/identification/genetic_algorithm.hpp>
#include <particulate/identification/polishing.hpp>

namespace particulate::identification {

/// The numbers of a search that polishes as it goes. The defaults need few evaluations on functions of many minima.
struct Search {
  /// What finds strings to polish: it rescales, and restarts after a short time without progress.
  GeneticAlgorithm algorithm = {
      .S = 40, .K = 10, .rescaling = 1.5, .restart = Stagnation{.generations = 5, .size = 0.01}};
  /// Coarse, since most of what it polishes will be surpassed: polish() the best at the end where more is wanted.
  Polishing polishing = {.tolerance = 0.1};
  Eigen::Index polished = 10;  ///< how many strings are polished a generation, >= 0
};

/// What a search found.
struct Found {
  Evolution ended;                                            ///< how it ended, with the best parameters and their cost
  double squares = std::numeric_limits<double>::quiet_NaN();  ///< sum of their squared residuals; NaN: not evaluated
  Population population = {};   ///< the last one; it counts evaluations of the cost and of the residuals alike
  long polishes = 0;            ///< strings that were polished
  long for_polishing = 0;       ///< evaluations that they took, one of the cost each included
  long failed_differences = 0;  ///< differences that had no residuals
};

/// The genetic algorithm, with the best of each generation polished: those strings, in order of rank, that have not
/// been. Polished parameters take the place of theirs if they cost less, and so they mate.
///
/// @equation{R 5.1} A child of two minima lies in the box that they span; where they agree in a parameter it has that
/// too. So polished strings find a minimum among many that neither polishing nor mating finds alone. Polishing lowers
/// the sum of squares, the algorithm the cost, and both are reported. One thread polishes, string after string.
/// @param cost       what is to be small
/// @param residuals  whose sum of squares is small where the cost is; none: nothing is polished
/// @param box        where
/// @param numbers    of the search
/// @param stops      what ends it
/// @param seed       of all that is random
/// @param observer   sees each generation, polished
/// @return what was found
/// @throws std::invalid_argument as evolve() and polish() do
Found search(const Cost& cost, const Residuals& residuals, const Box& box, const Search& numbers, const Stops& stops,
             std::uint64_t seed, const Observer& observer = {});

}  // namespace particulate::identification
