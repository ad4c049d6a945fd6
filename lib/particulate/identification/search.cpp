#include <particulate/identification/search.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

namespace particulate::identification {

namespace {

// What does not change in a search.
struct SearchTask {
  const Cost& cost;
  const Residuals& residuals;
  const Box& box;
  const Search& numbers;
  const Stops& stops;

  long left(const Population& population) const {
    return stops.evaluations.value_or(std::numeric_limits<long>::max()) - population.evaluations;
  }
};

// Strings that have been polished, with what their parameters are now, as long as they are in the population.
struct PolishedStrings {
  std::vector<Eigen::VectorXd> strings = {};
  Best best = {};                                             // of all that were polished
  double squares = std::numeric_limits<double>::quiet_NaN();  // of the best
};

// Polishes a string of which at least two evaluations are left: one of the residuals and, after them, one of the cost.
void polish_string(const SearchTask& task, Eigen::Index k, Found& found, PolishedStrings& done) {
  Population& population = found.population;
  Value& value = population.values[static_cast<std::size_t>(k)];
  Polishing polishing = task.numbers.polishing;
  polishing.most_evaluations = std::min(polishing.most_evaluations, task.left(population) - 1);
  const Polished polished = polish(task.residuals, task.box, population.strings.col(k), polishing);
  const Value after = evaluate(task.cost, polished.parameters);
  if (!after.reason.empty()) ++population.without_value[after.reason];
  const long evaluations = polished.evaluations + 1;
  population.evaluations += evaluations;
  found.for_polishing += evaluations;
  found.failed_differences += polished.failed_differences;
  found.polishes += 1;
  if (after.cost < value.cost) {
    population.strings.col(k) = polished.parameters;
    value = after;
    if (!(done.best.cost <= after.cost)) {
      done.best = {.parameters = polished.parameters, .cost = after.cost};
      done.squares = polished.after;
    }
  }
}

void polish_best(const SearchTask& task, Found& found, PolishedStrings& done) {
  Population& population = found.population;
  std::vector<Eigen::VectorXd> before;
  std::swap(before, done.strings);
  Eigen::Index polished = 0;
  for (Eigen::Index k = 0; k < population.strings.cols(); ++k) {
    const bool known = std::find(before.begin(), before.end(), population.strings.col(k)) != before.end();
    if (!known) {
      if (polished == task.numbers.polished || task.left(population) < 2) continue;
      const Value& value = population.values[static_cast<std::size_t>(k)];
      if (!value.reason.empty()) continue;
      polish_string(task, k, found, done);
      ++polished;
    }
    done.strings.emplace_back(population.strings.col(k));
    if (task.stops.goal && population.values[static_cast<std::size_t>(k)].cost <= *task.stops.goal) break;
  }
  rank(population);
  population.history.back() = population.values.front().cost;
}

// The sum of squares of the best, which polishing knows already if it gave the best.
void add_squares(const SearchTask& task, const PolishedStrings& done, Found& found) {
  const Best& best = found.ended.best;
  if (done.best.parameters.size() != 0 && best.parameters == done.best.parameters) {
    found.squares = done.squares;
  } else if (task.left(found.population) > 0) {
    const Eigen::VectorXd residuals = task.residuals(best.parameters);
    found.population.evaluations += 1;
    if (residuals.size() != 0) found.squares = residuals.squaredNorm();
  }
}

}  // namespace

Found search(const Cost& cost, const Residuals& residuals, const Box& box, const Search& numbers, const Stops& stops,
             std::uint64_t seed, const Observer& observer) {
  validate(numbers.polishing);
  validate(stops, numbers.algorithm);
  if (numbers.polished < 0) {
    throw std::invalid_argument(fmt::format(
        "search: the number of strings polished a generation must not be negative, got {}", numbers.polished));
  }
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  const SearchTask task{cost, residuals, box, numbers, stops};
  Found found;
  found.population = first_population(box, numbers.algorithm, seed);
  const Population& population = found.population;
  PolishedStrings done;
  for (;;) {
    const long generation = population.generation;
    Stops next = stops;
    next.generations = std::min(generation + 1, stops.generations.value_or(std::numeric_limits<long>::max()));
    if (stops.seconds) next.seconds = std::max(*stops.seconds - seconds(), 0.0);
    found.ended = evolve(cost, box, numbers.algorithm, next, found.population);
    // Where it makes no generation after one was polished, it has ended.
    if (found.ended.stop != Stop::generations || population.generation == generation) break;
    if (residuals) polish_best(task, found, done);
    if (observer && !observer(population)) {
      found.ended = {Stop::observer, "the observer asked for it", best_of(population)};
      break;
    }
  }
  found.ended.seconds = seconds();
  if (residuals) add_squares(task, done, found);
  return found;
}

}  // namespace particulate::identification
