#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include <particulate/identification/cost.hpp>
#include <particulate/identification/population.hpp>

/// @file
/// The monograph's genetic algorithm: a set of parameters is a string, and strings that rank next to each other mate.
///
///     const GeneticAlgorithm algorithm{.S = 20, .K = 6};
///     Population population = first_population(box, algorithm, seed);
///     const Evolution ended = evolve(cost, box, algorithm, {.goal = 1e-3, .generations = 200}, population);
///
/// Continued with later stops, from memory or from to_bytes(), a population has the same bits as one never stopped.

namespace particulate::identification {

/// No progress: within so many generations the best cost did not fall by more than a share of itself.
struct Stagnation {
  long generations = 20;  ///< >= 1
  double size = 0.0;      ///< share of the best cost at the start of the window, >= 0 [-]
};

/// The numbers of the algorithm. By default it is the monograph's: no rescaling, no restart.
struct GeneticAlgorithm {
  Eigen::Index S = 20;  ///< strings, >= 2 K
  Eigen::Index K = 6;   ///< parents kept from generation to generation, and their children; even, >= 2
  /// New random strings are drawn no farther from the best one than this many times the parent that is farthest from
  /// it, parameter by parameter, and within the box; > 0, infinite: in the whole box [-]
  double rescaling = std::numeric_limits<double>::infinity();
  /// When all strings are drawn anew, with the best one put aside; none: never.
  std::optional<Stagnation> restart = {};
  long most_tries = 1000;  ///< draws of a string until one is allowed, >= 1
  /// Threads that share the evaluations of a generation, >= 1. They change no bit of the result, and pay where a cost
  /// takes longer than starting them, some 0.1 ms a generation.
  int threads = 1;
};

/// What ends a run, at the end of a generation; at least one. What stands here may change when a run goes on.
struct Stops {
  std::optional<double> goal = {};            ///< a cost that is good enough
  std::optional<Stagnation> stagnation = {};  ///< not together with GeneticAlgorithm::restart
  std::optional<long> generations = {};       ///< since the first, >= 0
  std::optional<long> evaluations = {};       ///< since the first, >= 0: not one more, even within a generation
  std::optional<double> seconds = {};         ///< of this run, >= 0 [s]
};

/// What ended a run.
enum class Stop { goal, stagnation, generations, evaluations, seconds, observer };

/// How a run ended.
struct Evolution {
  Stop stop = {};           ///< why
  std::string reason = {};  ///< the same in a sentence
  Best best = {};           ///< of all that have been evaluated, before restarts as well
  double seconds = 0.0;     ///< of this run [s]
};

/// Sees the population at the end of each generation, in order of rank: best_of(), mean_of_best(), its counts.
/// @return whether to go on
using Observer = std::function<bool(const Population& population)>;

/// Refuses numbers of which no algorithm can be made.
///
/// @param algorithm  the numbers
/// @throws std::invalid_argument naming the number, what must hold and what was given
void validate(const GeneticAlgorithm& algorithm);

/// Refuses stops that cannot be meant, or none at all.
///
/// @param stops      of a run
/// @param algorithm  of the same
/// @throws std::invalid_argument naming the stop, what must hold and what was given
void validate(const Stops& stops, const GeneticAlgorithm& algorithm);

/// A child of two strings.
///
/// \f[ \Lambda^c_k = \Phi_k \Lambda^a_k + (1 - \Phi_k) \Lambda^b_k, \qquad 0 \le \Phi_k \le 1 \f]
///
/// @equation{R 5.1} \f$ \Phi_k \f$ is drawn anew for every component and child, so a child lies anywhere in the box
/// that its parents span, and never outside, roundings included.
/// @param a        a parent
/// @param b        the other, of its size
/// @param uniform  draws a number in [0, 1), one a component
/// @return the child
Eigen::VectorXd mated(const Eigen::VectorXd& a, const Eigen::VectorXd& b, const std::function<double()>& uniform);

/// Random strings, not yet evaluated.
///
/// @equation{R 5.1} Step 1 of the algorithm.
/// @param box        where they lie
/// @param algorithm  how many they are
/// @param seed       of the population's engine
/// @return the population
/// @throws std::invalid_argument as validate() does, and if none of GeneticAlgorithm::most_tries draws was allowed
Population first_population(const Box& box, const GeneticAlgorithm& algorithm, std::uint64_t seed);

/// Runs the algorithm from where a population is.
///
/// @equation{R 5.1} Its steps: evaluate the strings that are new, rank all, mate neighbours in rank (1 and 2, 3 and 4,
/// to K), two children a pair; keep the K parents and their K children, draw the others anew; again, until a stop.
/// Equal costs keep their order, a string without value ranks behind all that have one.
/// @param cost        what is to be small
/// @param box         where
/// @param algorithm   its numbers, those of the population
/// @param stops       what ends this run
/// @param population  from first_population() or an earlier run; receives the last generation
/// @param observer    sees each generation
/// @return how it ended
/// @throws std::invalid_argument for what cannot be meant, and if no string of the first population has a value
/// @throws std::logic_error if the best cost rose from one generation to the next, which keeping the parents excludes
Evolution evolve(const Cost& cost, const Box& box, const GeneticAlgorithm& algorithm, const Stops& stops,
                 Population& population, const Observer& observer = {});

/// What a population is of, for to_bytes(): a run of another cannot go on with it.
///
/// @param name       of the cost and whatever belongs to it, such as what its box allows
/// @param box        its bounds
/// @param algorithm  its numbers, but for the threads
/// @return a text with a line for each
std::string problem_of(std::string_view name, const Box& box, const GeneticAlgorithm& algorithm);

}  // namespace particulate::identification
