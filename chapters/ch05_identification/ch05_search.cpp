//! @page ch05_search Chapter 5: The genetic algorithm
//! @brief The monograph's algorithm over many seeds: how fast it begins, where it stops, and what helps.
//! @tableofcontents
//!
//! @section ch05_search_steps Its steps
//!
//! 1. Draw S strings at random in the box.
//! 2. Compute the cost of each.
//! 3. Rank them.
//! 4. Let neighbours in rank mate, the first with the second, the third with the fourth, up to the K-th: two children a
//!    pair, each component \f$ \Phi_k \Lambda^a_k + (1 - \Phi_k) \Lambda^b_k \f$ with a \f$ \Phi_k \f$ of its own.
//! 5. Keep these K parents and their K children, and draw the rest anew.
//! 6. Go on from 2, until the cost is low enough or patience is at an end.
//!
//! Parents stay, so the best cost never rises: particulate::identification::evolve asserts it in every generation.
//! Children lie between their parents. What that means for the spread of strings is verified in
//! @ref verify_ch05_mating_of_random_pairs and @ref verify_ch05_mating_of_neighbours.
//!
//! @figure{ch05_generations, Cost\, over all seeds: median of the best string (lines)\, its least and largest (shaded)\, median of the mean of the six best (dashed). Above by generation: Figure 5.2. Below by evaluations\, a point a generation.}
//!
//! @section ch05_search_program The program

#include <array>
#include <cmath>

#include <particulate/identification/search.hpp>
#include <particulate/report/progress.hpp>
#include <particulate/report/spread.hpp>

#include "ch05_identification.hpp"

namespace ch05 {
namespace {

//! Beside the plain algorithm stand two that the monograph allows for. *Rescaled*, it draws new strings near the best
//! parents only, and when it stands still for long it puts its best string aside and begins anew. *Polished*, it hands
//! the best string of each generation to the method of Levenberg and Marquardt @cite more1978, and what comes back
//! takes that string's place among the parents.

struct Variant {
  const char* name;
  Search numbers;
};

std::array<Variant, 3> variants_of(const GeneticAlgorithm& plain) {
  GeneticAlgorithm rescaled = plain;
  rescaled.rescaling = 1.5;
  rescaled.restart = Stagnation{.generations = 8, .size = 0.01};
  return {{{"plain", {.algorithm = plain, .polished = 0}},
           {"rescaled", {.algorithm = rescaled, .polished = 0}},
           {"polished", {.algorithm = rescaled, .polished = 1}}}};
}

//! A run that has come to its goal has that cost in all generations that it was spared.

constexpr double goal = 1e-9;

struct Course {
  std::vector<double> best, mean;  // by generation, from 1
  std::vector<long> evaluations;
  long without_value;
};

Course follow(const HistoryCost& cost, const Search& numbers, long generations, std::uint64_t seed) {
  Course course;
  const Found found = search(
      cost, [&](const Eigen::VectorXd& string) { return cost.residuals(string); }, box_of_search(), numbers,
      {.goal = goal, .generations = generations}, seed,
      [&](const Population& population) {
        course.best.push_back(best_of(population).cost);
        course.mean.push_back(mean_of_best(population));
        course.evaluations.push_back(population.evaluations);
        return true;
      });
  course.without_value = 0;
  for (const auto& [reason, count] : found.population.without_value) course.without_value += count;
  course.best.resize(static_cast<std::size_t>(generations), course.best.back());
  course.mean.resize(static_cast<std::size_t>(generations), course.mean.back());
  course.evaluations.resize(static_cast<std::size_t>(generations), course.evaluations.back());
  return course;
}

}  // namespace

void searches(const Parameters& p, report::Chapter& chapter, report::Checks& checks) {
  const report::Common& common = chapter.common();
  const HistoryCost cost = exact_cost(p, few_of(chapter, p, p.duration));
  const int generations = common.quick ? p.generations / 2 : p.generations, runs = common.quick ? p.runs / 6 : p.runs;
  report::Table courses({"variant", "generation", "median evaluations", "least best [-]", "median best [-]",
                         "largest best [-]", "median of the mean of six [-]"});
  report::Table ends({"variant", "runs", "at the goal", "median evaluations", "without value",
                      "median cost at the end [-]", "largest [-]", "median gain of the last half"});
  report::Progress progress("searches", 3.0 * runs);
  int done = 0;
  for (const Variant& variant : variants_of(algorithm_of(p))) {
    std::vector<Course> all;
    for (int k = 0; k < runs; ++k) {
      all.push_back(follow(cost, variant.numbers, generations, common.seed + static_cast<std::uint64_t>(k)));
      progress.at(++done);
    }
    for (std::size_t g = 0; g < all.front().best.size(); ++g) {
      const report::Spread best = report::spread_over(all, [&](const Course& c) { return c.best[g]; });
      const report::Spread mean = report::spread_over(all, [&](const Course& c) { return c.mean[g]; });
      const report::Spread spent =
          report::spread_over(all, [&](const Course& c) { return static_cast<double>(c.evaluations[g]); });
      courses.add({variant.name, g + 1, spent.median, best.least, best.median, best.largest, mean.median});
    }
    const auto last = [](const Course& c) { return c.best.back(); };
    const auto evaluations = [](const Course& c) { return static_cast<double>(c.evaluations.back()); };
    const auto none = [](const Course& c) { return static_cast<double>(c.without_value); };
    const auto gain = [](const Course& c) { return c.best[c.best.size() / 2] / c.best.back(); };
    ends.add({variant.name, runs,
              std::count_if(all.begin(), all.end(), [&](const Course& c) { return last(c) <= goal; }),
              report::spread_over(all, evaluations).median, report::spread_over(all, none).median,
              report::spread_over(all, last).median, report::spread_over(all, last).largest,
              report::spread_over(all, gain).median});
    if (variant.numbers.polished > 0) {
      checks.add("polished searches: median cost at the end", report::spread_over(all, last).median, goal);
    }
  }
  chapter.output().write("generations", courses);
  chapter.output().write("searches", ends);
}

}  // namespace ch05

//! @section ch05_search_results Where it stops
//!
//! @table{ch05_searches}
//!
//! Ten generations take the plain algorithm a good way down. Then its parents have become alike: all their children lie
//! where they lie themselves, and of new strings in the whole box hardly one is better. What it has found by then is
//! what it ends with, and that depends on the seed. Going on costs evaluations and gains nothing, which the last column
//! says.
//!
//! Rescaled, it goes on improving, slowly, along the valley. Polished, it needs one string in the right valley, and is
//! at the bottom after a generation or two, the evaluations of its differences counted. That is so because this cost is
//! smooth, has residuals, and few minima within the time chosen. On Rastrigin's function, which has thousands, neither
//! mating nor polishing finds the lowest alone in a time like that of both together
//! (@ref verify_ch05_evaluations_per_success); in Rosenbrock's single valley polished random strings win, and the same
//! table says so. What a search of four parameters has attained after so many evaluations, of a goal of 1e-6, and what
//! an evaluation takes beside a cost that takes next to nothing:
//!
//! @table{ch05_cost_by_evaluations}
//!
//! Beside optimizers of others evaluations and seconds stand on @ref speed "the page on speed". Those of pagmo saw the
//! scalar cost only: residuals tell more than that, so where something was polished the ratio is not one of algorithms.
//! A simulation takes ten thousand times as long as what the algorithm does about it, so evaluations are what counts.
//!
//! @section ch05_search_exercises Exercises
//!
//! 1. Take `--parents 2` and 10. When does each stand still, and at what cost?
//! 2. Why are strings without value so many at first, and hardly any later?
//! 3. Let all components of a child share one \f$ \Phi \f$. Where do the children of two parents lie then?
