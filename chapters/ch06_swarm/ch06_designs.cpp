//! @page ch06_designs Chapter 6: How a swarm is designed
//! @brief The objective, the genetic algorithm over five seeds and several sizes, and designs on other starts and sizes.
//! @tableofcontents
//!
//! @section ch06_designs_question Eight numbers
//!
//! A design is a string of eight numbers, \f$ \Lambda = (\alpha_1, \alpha_2, \beta_1, \beta_2, \alpha_o, \beta_o,
//! \alpha_t, \beta_t) \f$. What one asks of it is to be at the target soon, with everybody:
//!
//! \f[ \Pi(\Lambda) = \frac1T \int_0^T \frac{\sum_i d_i(t)}{\sum_i d_i(0)}\,dt + w\, \frac{N_{lost}}{N} . \f]
//!
//! This is particulate::swarm::Objective with a penalty for the lost, our *reconstruction* of section 6.2 (@ref
//! provenance "mark R 6.2"). A swarm that stays where it is has \f$ \Pi = 1 \f$. One that went straight to the target at
//! the largest speed and stopped there would have \f$ d(0)/(2 v_{max} T) \f$, which no design can beat, and no swarm
//! that must go round an obstacle can reach.
//!
//! @figure{ch06_generations, Cost by generation of swarms of several sizes\, over all seeds of the algorithm: median of the best string (lines)\, its least and largest (shaded)\, median of the mean of the six best (dashed). Figure 6.3.}
//!
//! @section ch06_designs_program The program

#include <algorithm>

#include <fmt/format.h>

#include <particulate/report/progress.hpp>

#include "ch06_swarm.hpp"

namespace ch06 {

//! The algorithm is chapter 5's plain one, which sees nothing of a design but its cost.

Tuned tune(const Parameters& p, const Course& course, int members, int starts, std::uint64_t seed) {
  const report::Common& common = p.line.common();
  Course flown = course;
  if (common.quick) flown.step *= 2.0;
  const identification::Box box = design_bounds();
  const identification::GeneticAlgorithm algorithm = algorithm_of(p);
  identification::Population population = first_population(box, algorithm, seed);
  Tuned tuned{.members = members, .starts = starts, .seed = seed};
  const identification::Evolution ended =
      evolve(objective(starts_of(members, common.seed, starts), flown), box, algorithm,
             {.generations = common.quick ? 2 * p.generations / 3 : p.generations}, population,
             [&](const identification::Population& now) {
               tuned.best.push_back(best_of(now).cost);
               tuned.mean.push_back(mean_of_best(now));
               return true;
             });
  tuned.design = design_of(ended.best.parameters);
  tuned.cost = ended.best.cost;
  tuned.evaluations = population.evaluations;
  tuned.seconds = ended.seconds;
  return tuned;
}

namespace {

//! Sizes are the whole swarm and its half, quarter, eighth and sixteenth; a quick run leaves out the whole and the
//! smallest. Every size gets the same seeds of the algorithm. Flights take longer the more members there are, by and
//! large by their pairs.

std::vector<int> sizes_of(const Parameters& p) {
  if (p.line.common().quick) return {p.members / 8, p.members / 4, p.members / 2};
  return {p.members / 16, p.members / 8, p.members / 4, p.members / 2, p.members};
}

double work(const Tuned& tuned) { return tuned.starts * (tuned.members * tuned.members + 1500.0); }

std::vector<Tuned> tune_all(const Parameters& p) {
  const std::uint64_t seed = p.line.common().seed;
  std::vector<Tuned> all;
  const std::vector<int> sizes = sizes_of(p);
  for (const int members : sizes) {
    for (int k = 0; k < p.seeds; ++k) {
      all.push_back({.members = members, .starts = 1, .seed = seed + static_cast<std::uint64_t>(k)});
    }
  }
  all.push_back({.members = p.line.common().quick ? sizes[1] : sizes.back(), .starts = p.starts, .seed = seed});
  double whole = 0.0, done = 0.0;
  for (const Tuned& tuned : all) whole += work(tuned);
  report::Progress progress("designs", whole);
  for (Tuned& tuned : all) {
    tuned = tune(p, course_of(p), tuned.members, tuned.starts, tuned.seed);
    progress.at(done += work(tuned));
  }
  return all;
}

//! Those of one size, from a single start:

std::vector<Tuned> of_size(const std::vector<Tuned>& all, int members) {
  std::vector<Tuned> some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some),
               [&](const Tuned& tuned) { return tuned.members == members && tuned.starts == 1; });
  return some;
}

void write_generations(const Parameters& p, const std::vector<Tuned>& all, const report::Output& output) {
  report::Table generations({"members", "generation", "least best [-]", "median best [-]", "largest best [-]",
                             "median of the mean of six [-]"});
  for (const int members : sizes_of(p)) {
    const std::vector<Tuned> designs = of_size(all, members);
    for (std::size_t g = 0; g < designs.front().best.size(); ++g) {
      const Spread best = spread_over(designs, [&](const Tuned& tuned) { return tuned.best[g]; });
      const Spread mean = spread_over(designs, [&](const Tuned& tuned) { return tuned.mean[g]; });
      generations.add({members, g + 1, best.least, best.median, best.largest, mean.median});
    }
  }
  output.write("generations", generations);
}

//! What a design costs is counted and timed, and nothing is claimed of it.

void write_costs(const Parameters& p, const std::vector<Tuned>& all, report::Chapter& chapter) {
  report::Table costs({"members", "flights for a design", "flights per second", "a generation [s]", "a design [s]"});
  for (const int members : sizes_of(p)) {
    double flights = 0.0, seconds = 0.0, generations = 0.0, designs = 0.0;
    for (const Tuned& tuned : of_size(all, members)) {
      flights += static_cast<double>(tuned.evaluations);
      seconds += tuned.seconds;
      generations += static_cast<double>(tuned.best.size());
      ++designs;
    }
    costs.add({members, flights / designs, flights / seconds, seconds / generations, seconds / designs});
    if (members != sizes_of(p).back()) continue;
    chapter.summary().add({fmt::format("flights for a design of {} members", members), flights / designs});
    chapter.summary().add({"such flights per second", flights / seconds});
    chapter.summary().add({"seconds for a generation", seconds / generations});
  }
  chapter.output().write("costs", costs);
}

//! What designs of one size do with their own number of members, in medians:

void write_sizes(const Parameters& p, const std::vector<Tuned>& all, const report::Output& output) {
  report::Table sizes({"members", "cost [-]", "lost, of all designs", "height at the fence [m]", "least gyration [m]",
                       "largest after [m]", "overshoot [m]", "undershoot [m]", "final distance [m]"});
  for (const int members : sizes_of(p)) {
    const std::vector<Tuned> designs = of_size(all, members);
    const kinematics::Particles start = starts_of(members, p.line.common().seed, 1).front();
    std::vector<Seen> seen;
    std::size_t lost = 0;
    for (const Tuned& tuned : designs) {
      seen.push_back(watch(tuned.design, course_of(p), start));
      lost += seen.back().trial.flight.lost.size();
    }
    const auto median = [&](double Captions::*number) {
      return spread_over(seen, [&](const Seen& one) { return one.captions.*number; }).median;
    };
    sizes.add({members, spread_over(designs, [](const Tuned& tuned) { return tuned.cost; }).median, lost,
               median(&Captions::height), median(&Captions::bunched), median(&Captions::unpacked),
               median(&Captions::overshoot), median(&Captions::undershoot), median(&Captions::distance)});
  }
  output.write("sizes", sizes);
}

//! Then they fly from starts that they have not seen, and with more members, or fewer, than they were tuned on.

struct Elsewhere {
  double lost;      // of all members of all flights [-]
  double distance;  // at the end, the largest of all flights [m]
};

Elsewhere try_elsewhere(const Parameters& p, const Tuned& tuned, int members) {
  const std::uint64_t first = p.line.common().seed + static_cast<std::uint64_t>(p.starts);
  Elsewhere tried{0.0, 0.0};
  for (const kinematics::Particles& start : starts_of(members, first, p.others)) {
    const Seen seen = watch(tuned.design, course_of(p), start);
    tried.lost += static_cast<double>(seen.trial.flight.lost.size()) / (members * p.others);
    tried.distance = std::max(tried.distance, seen.captions.distance);
  }
  return tried;
}

void elsewhere(const Parameters& p, const std::vector<Tuned>& all, const report::Output& output,
               report::Checks& checks) {
  report::Table table({"tuned on", "starts", "designs", "flown with", "largest share lost [-]", "median share lost [-]",
                       "median final distance [m]", "largest [m]"});
  const int large = sizes_of(p).back(), small = large / 4;
  const auto add = [&](const std::vector<Tuned>& designs, int members) {
    std::vector<Elsewhere> tried;
    for (const Tuned& tuned : designs) tried.push_back(try_elsewhere(p, tuned, members));
    const Spread lost = spread_over(tried, [](const Elsewhere& one) { return one.lost; });
    const Spread distance = spread_over(tried, [](const Elsewhere& one) { return one.distance; });
    table.add({designs.front().members, designs.front().starts, designs.size(), members, lost.largest, lost.median,
               distance.median, distance.largest});
    return tried;
  };
  add(of_size(all, small), small);
  add(of_size(all, small), p.members);
  add(of_size(all, large), small);
  const std::vector<Elsewhere> tried = add(of_size(all, large), p.members);
  add({all.back()}, p.members);
  output.write("elsewhere", table);
  const auto failed = std::count_if(tried.begin(), tried.end(), [](const auto& one) { return !(one.lost <= 0.01); });
  checks.add("designs that lose more than 1 % from other starts", static_cast<double>(failed), p.seeds / 5);
}

}  // namespace

std::vector<Tuned> designs(const Parameters& p, report::Chapter& chapter, report::Checks& checks) {
  const std::vector<Tuned> all = tune_all(p);
  write_generations(p, all, chapter.output());
  write_costs(p, all, chapter);
  write_sizes(p, all, chapter.output());
  elsewhere(p, all, chapter.output(), checks);
  return of_size(all, sizes_of(p).back());
}

}  // namespace ch06
