// What the genetic algorithm promises of itself: who is kept, who ranks where, what is counted, which bits.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/identification/search.hpp>

#include "test_functions.hpp"

namespace verification::genetic_algorithm {

using namespace particulate::identification;

constexpr GeneticAlgorithm plain{.S = 20, .K = 6};

const Case elitism{
    {.name = "algorithm_elitism",
     .claim = "the best K strings of a generation are in the next one, and its best cost never rises",
     .equation = "R 5.1",
     .reference = Reference::design},
    [](Rows& rows) {
      for (const TestFunction& f : {rosenbrock(4), rastrigin(4), ackley(8), terraces(3)}) {
        long lost = 0, risen = 0;
        Eigen::MatrixXd parents;
        double best = std::numeric_limits<double>::infinity();
        const auto watch = [&](const Population& now) {
          for (const auto parent : parents.colwise()) {
            lost += (now.strings.colwise() - parent).colwise().squaredNorm().minCoeff() == 0.0 ? 0 : 1;
          }
          risen += now.values.front().cost <= best ? 0 : 1;
          best = now.values.front().cost;
          parents = now.strings.leftCols(plain.K);
          return true;
        };
        Population population = first_population(f.box, plain, rows.case_seed());
        evolve(f.cost, f.box, plain, {.generations = 300}, population, watch);
        rows.none(fmt::format("parents lost in 300 generations, {}", f.name), lost, "parents are kept as they are");
        rows.none(fmt::format("generations whose best cost rose, {}", f.name), risen, "parents are kept as they are");
      }
    }};

// By counting for each string those that must stand before it.
std::vector<std::size_t> ranked(const std::vector<Value>& values) {
  std::vector<std::size_t> order(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    std::size_t before = 0;
    for (std::size_t other = 0; other < values.size(); ++other) {
      const bool none = std::isnan(values[k].cost), none_either = std::isnan(values[other].cost);
      const bool better = none ? !none_either : values[other].cost < values[k].cost;
      const bool equal = none ? none_either : values[other].cost == values[k].cost;
      before += better || (equal && other < k) ? 1 : 0;
    }
    order[before] = k;
  }
  return order;
}

const Case ranking{{.name = "algorithm_ranking",
                    .claim = "strings rank by cost, equal ones in their order, those without value last",
                    .equation = "R 5.1",
                    .reference = Reference::independent_method},
                   [](Rows& rows) {
                     // Terraces of cost 0 to 3, and a corner without value.
                     const Cost cost = [](const Eigen::VectorXd& x) {
                       return x.maxCoeff() > 0.9 ? Value("corner") : Value(std::floor(4.0 * x[0]));
                     };
                     const Box box = cube(2, 0.0, 1.0);
                     const GeneticAlgorithm algorithm{.S = 200, .K = 20};
                     Population population = first_population(box, algorithm, rows.case_seed());
                     const Eigen::MatrixXd drawn = population.strings;
                     std::vector<Value> values;
                     for (const auto x : drawn.colwise()) values.push_back(cost(x));
                     evolve(cost, box, algorithm, {.generations = 1}, population);
                     const std::vector<std::size_t> order = ranked(values);
                     long elsewhere = 0, without = 0;
                     for (std::size_t k = 0; k < order.size(); ++k) {
                       const auto place = static_cast<Eigen::Index>(k), from = static_cast<Eigen::Index>(order[k]);
                       elsewhere += population.strings.col(place) == drawn.col(from) ? 0 : 1;
                       without += std::isnan(values[k].cost) ? 1 : 0;
                     }
                     rows.none("of 200 strings those that rank elsewhere", elsewhere,
                               "each is behind those that are better, and those that are equal and were before it");
                     rows.equal("evaluations without value", {.expected = without,
                                                              .computed = population.without_value["corner"],
                                                              .because = "counted apart, of the same strings"});
                   }};

const Case counted{
    {.name = "algorithm_counts",
     .claim = "every evaluation is counted, by threads, in differences and of strings without value, and none is made "
              "beyond the limit",
     .equation = "R 5.1",
     .reference = Reference::design},
    [](Rows& rows) {
      const TestFunction f = rastrigin(3);
      std::atomic<long> calls = 0, failed = 0;
      const Cost cost = [&](const Eigen::VectorXd& x) {
        ++calls;
        if (x[0] < -4.0) throw std::runtime_error(fmt::format("no value {}", ++failed % 2));
        return f.cost(x);
      };
      const Residuals residuals = [&](const Eigen::VectorXd& x) {
        ++calls;
        return f.residuals(x);
      };
      for (const long limit : {7L, 20L, 21L, 500L, 3001L}) {
        calls = 0;
        GeneticAlgorithm algorithm = plain;
        algorithm.threads = 3;
        Population population = first_population(f.box, algorithm, rows.case_seed());
        evolve(cost, f.box, algorithm, {.evaluations = limit}, population);
        const auto equal = [&](const std::string& what, long count, const char* because) {
          rows.equal(fmt::format("{}, limit {}", what, limit),
                     {.expected = calls.load(), .computed = count, .because = because});
        };
        equal("evaluations of the algorithm", population.evaluations, "the cost counts its calls");
        equal("the limit itself", limit, "no goal is set, so that it ends there, within a generation too");
        calls = failed = 0;
        Search numbers;
        numbers.polishing.central = limit % 2 == 0;
        const Found found = search(cost, residuals, f.box, numbers, {.evaluations = limit}, rows.case_seed());
        equal("evaluations of a search", found.population.evaluations, "cost and residuals count their calls");
        equal("the limit of a search itself", limit, "no goal is set");
        long without = 0;
        for (const auto& [reason, count] : found.population.without_value) without += count;
        rows.equal(fmt::format("evaluations without value, limit {}", limit),
                   {.expected = failed.load(), .computed = without, .because = "the cost counts what it throws"});
      }
    }};

std::string bits(const Population& population) { return to_bytes(population, "any"); }

const Case threads{{.name = "algorithm_threads",
                    .claim = "any number of threads gives the same bits",
                    .equation = "R 5.1",
                    .reference = Reference::identity},
                   [](Rows& rows) {
                     const TestFunction f = rastrigin(4);
                     const auto by = [&](int n, double rescaling) {
                       GeneticAlgorithm algorithm{.S = 23, .K = 6, .rescaling = rescaling, .threads = n};
                       algorithm.restart = Stagnation{.generations = 10};
                       Population population = first_population(f.box, algorithm, rows.case_seed());
                       evolve(f.cost, f.box, algorithm, {.evaluations = 2000}, population);
                       Search numbers;
                       numbers.algorithm = algorithm;
                       return bits(population) +
                              bits(search(f.cost, f.residuals, f.box, numbers, {.evaluations = 2000}, 1).population);
                     };
                     long other = 0;
                     for (const double rescaling : {std::numeric_limits<double>::infinity(), 1.5}) {
                       const std::string one = by(1, rescaling);
                       for (const int n : {2, 3, 8}) other += by(n, rescaling) == one ? 0 : 1;
                     }
                     rows.none("of six runs by 2, 3 and 8 threads, those with other bits than by one", other,
                               "all that is random is drawn by one thread, and every value has its place");
                   }};

const Case continued{
    {.name = "algorithm_continued",
     .claim = "a run that goes on from the bytes of a population ends with the same bits, wherever it was stopped",
     .equation = "R 5.1",
     .reference = Reference::identity},
    [](Rows& rows) {
      const TestFunction f = rastrigin(4);
      const Cost cost = [&](const Eigen::VectorXd& x) {
        return x[0] > 4.0 ? Value("a reason\nof two lines") : f.cost(x);
      };
      GeneticAlgorithm algorithm{.S = 20, .K = 6, .rescaling = 1.5};
      algorithm.restart = Stagnation{.generations = 4, .size = 0.05};
      const std::string problem = problem_of("Rastrigin", f.box, algorithm);
      const auto run = [&](Population population, const Stops& stops) {
        evolve(cost, f.box, algorithm, stops, population);
        return to_bytes(population, problem);
      };
      const Population first = first_population(f.box, algorithm, rows.case_seed());
      const Stops last{.evaluations = 1500};
      const std::string whole = run(first, last);
      long other = 0, stops = 0;
      for (long limit = 10; limit < 1500; limit += rows.quick() ? 13 : 1) {
        const std::string by_evaluations = run(first, {.evaluations = limit});
        other += run(population_from(by_evaluations, "file", problem), last) == whole ? 0 : 1;
        ++stops;
      }
      for (long generations = 1; generations < 100; generations += 7) {
        const std::string by_generations = run(first, {.generations = generations});
        other += run(population_from(by_generations, "file", problem), last) == whole ? 0 : 1;
        ++stops;
      }
      rows.none(fmt::format("of {} runs stopped, saved, read and continued, those with other bits", stops), other,
                "strings, values, reasons, counts and the engine are all there");
      rows.at_least("restarts on the way",
                    {.limit = 1.0,
                     .computed = static_cast<double>(population_from(whole, "file", problem).restarts),
                     .because = "else none was continued through"});
    }};

}  // namespace verification::genetic_algorithm
