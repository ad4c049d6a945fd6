#include <particulate/identification/genetic_algorithm.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>

#include <particulate/identification/mating.hpp>

namespace particulate::identification {

namespace {

void require_of_algorithm(bool holds, const char* what, auto given, const char* advice) {
  if (!holds) throw std::invalid_argument(fmt::format("genetic algorithm: {}, got {}: {}", what, given, advice));
}

void validate_window(const std::optional<Stagnation>& window) {
  if (!window) return;
  require_of_algorithm(window->generations >= 1, "stagnation must be seen over at least one generation",
                       window->generations, "take ten or more");
  require_of_algorithm(window->size >= 0.0, "the share by which a cost must fall must not be negative", window->size,
                       "take 0 where any progress counts");
}

// In [0, 1), from the upper 53 bits: what the distributions of the standard library give is not the same everywhere.
double uniform_from(std::mt19937_64& engine) { return static_cast<double>(engine() >> 11) * 0x1p-53; }

bool is_allowed(const Box& box, const Eigen::VectorXd& string) { return !box.allows || box.allows(string); }

Eigen::VectorXd random_string(const Box& box, long most_tries, std::mt19937_64& engine) {
  Eigen::VectorXd string(box.lower.size());
  for (long n = 0; n < most_tries; ++n) {
    for (Eigen::Index k = 0; k < string.size(); ++k) {
      string[k] = std::min(box.lower[k] + uniform_from(engine) * (box.upper[k] - box.lower[k]), box.upper[k]);
    }
    if (is_allowed(box, string)) return string;
  }
  throw std::invalid_argument(fmt::format(
      "genetic algorithm: the box must hold parameters that are allowed, and of {} strings drawn in it none was: make "
      "the box narrower where they lie, or raise most_tries",
      most_tries));
}

// A child that is allowed; where none of many is, as between two islands, a random string.
Eigen::VectorXd allowed_child(const Box& box, long most_tries, Population& population, Eigen::Index first) {
  const auto uniform = [&] { return uniform_from(population.engine); };
  for (long n = 0; n < most_tries; ++n) {
    Eigen::VectorXd child = mated(population.strings.col(first), population.strings.col(first + 1), uniform);
    if (is_allowed(box, child)) return child;
  }
  return random_string(box, most_tries, population.engine);
}

// Where new random strings are drawn: see GeneticAlgorithm::rescaling.
Box box_about_best(const Box& box, const GeneticAlgorithm& algorithm, const Population& population) {
  if (std::isinf(algorithm.rescaling)) return box;
  const Eigen::VectorXd best = population.strings.col(0);
  const Eigen::VectorXd reach =
      algorithm.rescaling * (population.strings.leftCols(algorithm.K).colwise() - best).cwiseAbs().rowwise().maxCoeff();
  return {.lower = box.lower.cwiseMax(best - reach), .upper = box.upper.cwiseMin(best + reach), .allows = box.allows};
}

bool stagnated(const std::vector<double>& history, const Stagnation& over) {
  const auto window = static_cast<std::size_t>(over.generations);
  if (history.size() <= window) return false;
  const double past = history[history.size() - 1 - window], now = history.back();
  if (std::isnan(past)) return std::isnan(now);
  return !(past - now > over.size * std::abs(past));
}

void start_anew(const Box& box, const GeneticAlgorithm& algorithm, Population& population) {
  const Best best = best_of(population);
  population.aside = best.parameters;
  population.aside_cost = best.cost;
  population.restarts += 1;
  population.history.clear();
  population.values.clear();
  for (auto string : population.strings.colwise()) {
    string = random_string(box, algorithm.most_tries, population.engine);
  }
}

// The next generation, of which the parents alone have values.
void renew(const Box& box, const GeneticAlgorithm& algorithm, Population& population) {
  const Eigen::Index S = algorithm.S, K = algorithm.K;
  const Box around = box_about_best(box, algorithm, population);
  for (Eigen::Index k = 0; k < K; ++k) {
    population.strings.col(K + k) = allowed_child(box, algorithm.most_tries, population, k - k % 2);
  }
  for (Eigen::Index k = 2 * K; k < S; ++k) {
    population.strings.col(k) = random_string(around, algorithm.most_tries, population.engine);
  }
  population.values.resize(static_cast<std::size_t>(K), Value(0.0));
}

// Evaluates the strings without values, in their order, as many as the limit leaves.
void evaluate_new(const Cost& cost, long most, int threads, Population& population) {
  const std::size_t done = population.values.size(), all = static_cast<std::size_t>(population.strings.cols());
  const std::size_t left = static_cast<std::size_t>(std::max(most - population.evaluations, 0L));
  const std::size_t end = std::min(all, done + left);
  population.values.resize(end, Value(0.0));
  std::atomic<std::size_t> next = done;
  const auto work = [&] {
    for (std::size_t k = next++; k < end; k = next++) {
      population.values[k] = evaluate(cost, population.strings.col(static_cast<Eigen::Index>(k)));
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t n = 1; n < std::min(static_cast<std::size_t>(threads), end - done); ++n) others.emplace_back(work);
    work();
  }
  population.evaluations += static_cast<long>(end - done);
  for (std::size_t k = done; k < end; ++k) {
    if (!population.values[k].reason.empty()) ++population.without_value[population.values[k].reason];
  }
}

[[noreturn]] void refuse_without_values(const Population& population) {
  const auto most = std::max_element(population.without_value.begin(), population.without_value.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  throw std::invalid_argument(fmt::format(
      "genetic algorithm: some string of the first population must have a value, and none of {} tried had one; the "
      "most frequent reason, {} times: {}. Make the box narrower where there are values, or take more strings",
      population.evaluations, most == population.without_value.end() ? 0 : most->second,
      most == population.without_value.end() ? "none was evaluated" : most->first));
}

void complete_generation(Population& population) {
  rank(population);
  const double now = population.values.front().cost;
  if (!population.history.empty() && !std::isnan(population.history.back()) && !(now <= population.history.back())) {
    throw std::logic_error(fmt::format("genetic algorithm: the best cost must not rise, and rose from {} to {}",
                                       population.history.back(), now));
  }
  population.history.push_back(now);
  population.generation += 1;
}

bool is_complete(const Population& population) {
  return population.values.size() == static_cast<std::size_t>(population.strings.cols());
}

struct Stopped {
  Stop stop;
  std::string reason;
};

std::optional<Stopped> stop_of(const Stops& stops, const Population& population, const Best& best, double seconds) {
  if (stops.goal && best.cost <= *stops.goal) {
    return Stopped{Stop::goal, fmt::format("the best cost, {:g}, is at most the goal, {:g}", best.cost, *stops.goal)};
  }
  if (stops.evaluations && population.evaluations >= *stops.evaluations) {
    return Stopped{Stop::evaluations, fmt::format("the limit of {} evaluations is reached", *stops.evaluations)};
  }
  if (stops.generations && population.generation >= *stops.generations) {
    return Stopped{Stop::generations, fmt::format("the limit of {} generations is reached", *stops.generations)};
  }
  if (stops.stagnation && stagnated(population.history, *stops.stagnation)) {
    return Stopped{Stop::stagnation,
                   fmt::format("within {} generations the best cost fell by no more than {:g} of itself",
                               stops.stagnation->generations, stops.stagnation->size)};
  }
  if (stops.seconds && seconds >= *stops.seconds) {
    return Stopped{Stop::seconds, fmt::format("the limit of {:g} seconds is reached", *stops.seconds)};
  }
  return {};
}

void require_fitting(const Population& population, const Box& box, const GeneticAlgorithm& algorithm) {
  if (population.strings.rows() != box.lower.size() || population.strings.cols() != algorithm.S) {
    throw std::invalid_argument(
        fmt::format("genetic algorithm: the population must have {} strings of {} parameters, got {} of {}: make it by "
                    "first_population() of the same box and numbers",
                    algorithm.S, box.lower.size(), population.strings.cols(), population.strings.rows()));
  }
}

}  // namespace

void validate(const GeneticAlgorithm& algorithm) {
  require_of_algorithm(algorithm.K >= 2 && algorithm.K % 2 == 0, "the number K of parents must be even and at least 2",
                       algorithm.K, "they mate in pairs");
  if (algorithm.S < 2 * algorithm.K) {
    throw std::invalid_argument(
        fmt::format("genetic algorithm: the S strings must hold K parents and their K children, got S = {} and K = {}: "
                    "raise S or lower K",
                    algorithm.S, algorithm.K));
  }
  require_of_algorithm(algorithm.rescaling > 0.0, "rescaling must be positive", algorithm.rescaling,
                       "leave it infinite for strings from the whole box");
  require_of_algorithm(algorithm.most_tries >= 1, "at least one string must be drawn, most_tries", algorithm.most_tries,
                       "take a thousand");
  require_of_algorithm(algorithm.threads >= 1, "there must be at least one thread", algorithm.threads, "take 1");
  validate_window(algorithm.restart);
}

void validate(const Stops& stops, const GeneticAlgorithm& algorithm) {
  if (!stops.goal && !stops.stagnation && !stops.generations && !stops.evaluations && !stops.seconds) {
    throw std::invalid_argument(
        "genetic algorithm: something must end it, and no stop was given: give a goal, or a limit of generations, "
        "evaluations or seconds");
  }
  require_of_algorithm(!stops.goal || !std::isnan(*stops.goal), "the goal must be a number", stops.goal.value_or(0.0),
                       "leave it out where there is none");
  for (const std::optional<long>& limit : {stops.generations, stops.evaluations}) {
    require_of_algorithm(limit.value_or(0) >= 0, "limits of generations and evaluations must not be negative",
                         limit.value_or(0), "leave out what has no limit");
  }
  require_of_algorithm(stops.seconds.value_or(0.0) >= 0.0, "the limit of seconds must not be negative",
                       stops.seconds.value_or(0.0), "leave it out where there is none");
  validate_window(stops.stagnation);
  require_of_algorithm(!(stops.stagnation && algorithm.restart),
                       "a run that starts anew on stagnation must not end on it", "both",
                       "choose one, and a limit of evaluations");
}

Population first_population(const Box& box, const GeneticAlgorithm& algorithm, std::uint64_t seed) {
  validate(box);
  validate(algorithm);
  Population population{.strings = Eigen::MatrixXd(box.lower.size(), algorithm.S)};
  population.engine.seed(seed);
  for (auto string : population.strings.colwise()) {
    string = random_string(box, algorithm.most_tries, population.engine);
  }
  return population;
}

Evolution evolve(const Cost& cost, const Box& box, const GeneticAlgorithm& algorithm, const Stops& stops,
                 Population& population, const Observer& observer) {
  validate(box);
  validate(algorithm);
  validate(stops, algorithm);
  require_fitting(population, box, algorithm);
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  const long most = stops.evaluations.value_or(std::numeric_limits<long>::max());
  for (;;) {
    const bool new_generation = !is_complete(population);
    if (new_generation) evaluate_new(cost, most, algorithm.threads, population);
    const bool complete = is_complete(population);
    if (new_generation && complete) complete_generation(population);
    const Best best = best_of(population);
    if (best.parameters.size() == 0) refuse_without_values(population);
    if (new_generation && complete && observer && !observer(population)) {
      return {Stop::observer, "the observer asked for it", best, seconds()};
    }
    const std::optional<Stopped> stopped = stop_of(stops, population, best, seconds());
    if (stopped) return {stopped->stop, stopped->reason, best, seconds()};
    if (algorithm.restart && stagnated(population.history, *algorithm.restart)) {
      start_anew(box, algorithm, population);
    } else {
      renew(box, algorithm, population);
    }
  }
}

std::string problem_of(std::string_view name, const Box& box, const GeneticAlgorithm& algorithm) {
  std::string text =
      fmt::format("cost {}\nS {}\nK {}\nrescaling {:a}\n", name, algorithm.S, algorithm.K, algorithm.rescaling);
  if (algorithm.restart) {
    text += fmt::format("restart after {} generations, size {:a}\n", algorithm.restart->generations,
                        algorithm.restart->size);
  }
  for (Eigen::Index k = 0; k < box.lower.size(); ++k) {
    text += fmt::format("parameter {} from {:a} to {:a}\n", k, box.lower[k], box.upper[k]);
  }
  return text;
}

}  // namespace particulate::identification
