// What the algorithm itself takes, beside a cost that takes nothing.

#include <algorithm>
#include <chrono>
#include <vector>

#include <fmt/format.h>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

#include <harness/case.hpp>
#include <particulate/identification/genetic_algorithm.hpp>
#include <particulate/report/table.hpp>

#include "test_functions.hpp"

namespace verification::overhead_races {

using namespace particulate::identification;

constexpr long evaluations = 50'000;

template <class Run>
double seconds_of(const Run& run) {
  const auto start = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double by_algorithm(const Cost& cost, const Box& box, double rescaling) {
  const GeneticAlgorithm algorithm{.S = 20, .K = 6, .rescaling = rescaling};
  Population population = first_population(box, algorithm, 1);
  return seconds_of([&] { evolve(cost, box, algorithm, {.evaluations = evaluations}, population); });
}

// The least that any search does: draw and evaluate.
double by_random_search(const Cost& cost, const Box& box) {
  boost::random::mt19937_64 engine(1);
  boost::random::uniform_01<double> uniform;
  double best = 1e300;
  const double taken = seconds_of([&] {
    for (long n = 0; n < evaluations; ++n) {
      Eigen::VectorXd x(box.lower.size());
      for (Eigen::Index k = 0; k < x.size(); ++k) x[k] = box.lower[k] + uniform(engine) * (box.upper[k] - box.lower[k]);
      best = std::min(best, evaluate(cost, x).cost);
    }
  });
  return best < 1e300 ? taken : missing;
}

double median(std::vector<double> x) {
  std::sort(x.begin(), x.end());
  return x[x.size() / 2];
}

const Case overhead{
    {.name = "algorithm_overhead",
     .claim = "an evaluation costs the algorithm at most ten times what drawing a random string costs",
     .equation = "R 5.1",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      particulate::report::Table table({"parameters", "method", "seconds per evaluation"});
      const Cost free = [](const Eigen::VectorXd& x) { return x[0]; };
      for (const Eigen::Index n : {4, 8}) {
        const Box box = cube(n, -1.0, 1.0);
        std::vector<double> random, plain, rescaled;
        for (int k = 0; k < 5; ++k) {
          random.push_back(by_random_search(free, box) / evaluations);
          plain.push_back(by_algorithm(free, box, std::numeric_limits<double>::infinity()) / evaluations);
          rescaled.push_back(by_algorithm(free, box, 1.5) / evaluations);
        }
        table.add({n, "random search", median(random)});
        table.add({n, "plain algorithm", median(plain)});
        table.add({n, "with rescaling", median(rescaled)});
        const double most = std::max(median(plain), median(rescaled));
        rows.at_most(fmt::format("over random search, {} parameters", n),
                     {.limit = 10.0,
                      .computed = most / median(random),
                      .because = fmt::format("median of five, alternating; {:.2g} us an evaluation", 1e6 * most)});
      }
      rows.write("algorithm_overhead", table);
    }};

}  // namespace verification::overhead_races
