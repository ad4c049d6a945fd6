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
//! provenance "mark R 6.2"). A swarm that stays where it is has \f$ \Pi = 1 \f$. If all went straight to
//! the target at the largest speed and stopped there, it would be \f$ \sum_i d_i(0)^2 / (2 v_{max} T \sum_i d_i(0)) \f$:
//! one that must go round an obstacle cannot do as well.
//!
//! @figure{ch06_generations, Cost by generation of swarms of several sizes\, over all seeds of the algorithm: median of the best string (lines)\, its least and largest (shaded)\, median of the mean of the six best (dashed). Figure 6.3.}
//!
//! @section ch06_designs_program The program

#include <algorithm>
#include <iterator>

#include <particulate/report/progress.hpp>
#include <particulate/report/spread.hpp>

#include "ch06_swarm.hpp"

namespace ch06 {

//! The algorithm is chapter 5's plain one, which sees nothing of a design but its cost.

Tuned tune(const Parameters& p, const Course& course, int members, int starts, std::uint64_t seed) {
  const report::Common& common = p.line.common();
  const identification::Box box = design_bounds();
  const identification::GeneticAlgorithm algorithm = algorithm_of(p);
  identification::Population population = first_population(box, algorithm, seed);
  Tuned tuned{.members = members, .starts = starts, .seed = seed};
  const identification::Evolution ended =
      evolve(objective(starts_of(members, common.seed, starts), course), box, algorithm,
             {.generations = common.quick ? 2 * p.generations / 5 : p.generations}, population,
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
//! quarter. Every size gets the same seeds of the algorithm. Flights take longer the more members there are, by and
//! large by their pairs.

std::vector<int> sizes_of(const Parameters& p) {
  if (p.line.common().quick) return {p.members / 16, p.members / 8, p.members / 2};
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

// From a single start.
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
      const report::Spread best = report::spread_over(designs, [&](const Tuned& tuned) { return tuned.best[g]; });
      const report::Spread mean = report::spread_over(designs, [&](const Tuned& tuned) { return tuned.mean[g]; });
      generations.add({members, g + 1, best.least, best.median, best.largest, mean.median});
    }
  }
  output.write("generations", generations);
}

//! What a design takes is counted and timed, and nothing is claimed of it.

double straight_flight(const Course& course, const kinematics::Particles& start) {
  const Eigen::ArrayXd d = (start.position.rowwise() - course.target.transpose()).rowwise().norm();
  return d.square().sum() / (2.0 * course.v_max * course.duration * d.sum());
}

void write_costs(const Parameters& p, const std::vector<Tuned>& all, report::Chapter& chapter) {
  report::Table costs({"members", "flights for a design", "flights per second", "a generation [s]", "a design [s]"});
  for (const int members : sizes_of(p)) {
    const std::vector<Tuned> designs = of_size(all, members);
    const double seconds = report::spread_over(designs, &Tuned::seconds).median;
    const auto flights = static_cast<double>(designs.front().evaluations);
    const auto generations = static_cast<double>(designs.front().best.size());
    costs.add({members, flights, flights / seconds, seconds / generations, seconds});
    if (members != sizes_of(p).back()) continue;
    chapter.summary().add({"cost of a straight flight at the largest speed",
                           straight_flight(course_of(p), starts_of(members, chapter.common().seed, 1).front())});
    chapter.summary().add({"cost of a design, median", report::spread_over(designs, &Tuned::cost).median});
    chapter.summary().add({"flights for a design", flights});
    chapter.summary().add({"flights per second", flights / seconds});
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
    std::vector<Captions> says;
    std::size_t lost = 0;
    for (const Tuned& tuned : designs) {
      const Seen seen = watch(tuned.design, course_of(p), start);
      says.push_back(seen.captions);
      lost += seen.trial.flight.lost.size();
    }
    const auto median = [&](double Captions::*number) { return report::spread_over(says, number).median; };
    sizes.add({members, report::spread_over(designs, &Tuned::cost).median, lost, median(&Captions::height),
               median(&Captions::bunched), median(&Captions::unpacked), median(&Captions::overshoot),
               median(&Captions::undershoot), median(&Captions::distance)});
  }
  output.write("sizes", sizes);
}

//! Then they fly from starts that they have not seen, and with more members, or fewer, than they were tuned on.

struct Elsewhere {
  double lost;      // of all members of all flights [-]
  double distance;  // at the end, the largest of all flights [m]
};

Elsewhere try_elsewhere(const Parameters& p, const Tuned& tuned, int members) {
  const report::Common& common = p.line.common();
  const int flights = common.quick ? p.others / 2 : p.others;
  Elsewhere tried{0.0, 0.0};
  for (const kinematics::Particles& start :
       starts_of(members, common.seed + static_cast<std::uint64_t>(p.starts), flights)) {
    const Seen seen = watch(tuned.design, course_of(p), start);
    tried.lost += static_cast<double>(seen.trial.flight.lost.size()) / (members * flights);
    tried.distance = std::max(tried.distance, seen.captions.distance);
  }
  return tried;
}

void elsewhere(const Parameters& p, const std::vector<Tuned>& all, report::Chapter& chapter) {
  report::Table table({"tuned on", "starts", "designs", "flown with", "largest share lost [-]", "median share lost [-]",
                       "median final distance [m]", "largest [m]"});
  const int large = sizes_of(p).back(), small = large / 4;
  const auto add = [&](const std::vector<Tuned>& designs, int members) {
    std::vector<Elsewhere> tried;
    for (const Tuned& tuned : designs) tried.push_back(try_elsewhere(p, tuned, members));
    const report::Spread lost = report::spread_over(tried, &Elsewhere::lost),
                         distance = report::spread_over(tried, &Elsewhere::distance);
    table.add({designs.front().members, designs.front().starts, designs.size(), members, lost.largest, lost.median,
               distance.median, distance.largest});
    return tried;
  };
  add(of_size(all, small), small);
  add(of_size(all, small), p.members);
  add(of_size(all, large), small);
  const std::vector<Elsewhere> tried = add(of_size(all, large), p.members);
  add({all.back()}, p.members);
  chapter.output().write("elsewhere", table);
  const auto failed = std::count_if(tried.begin(), tried.end(), [](const auto& one) { return !(one.lost <= 0.01); });
  claim_of_own(p, chapter, "designs that lose more than 1 % from other starts", static_cast<double>(failed),
               p.seeds / 5);
}

}  // namespace

std::vector<Tuned> designs(const Parameters& p, report::Chapter& chapter) {
  const std::vector<Tuned> all = tune_all(p);
  write_generations(p, all, chapter.output());
  write_costs(p, all, chapter);
  write_sizes(p, all, chapter.output());
  elsewhere(p, all, chapter);
  return of_size(all, sizes_of(p).back());
}

}  // namespace ch06

//! @section ch06_designs_results What comes of it
//!
//! A design is found soon. Of the first strings, drawn at random, the best is no bad one, and some generations later the
//! six best have become alike; from then on the algorithm stands almost still, as it does in @ref ch05_search
//! "chapter 5". What a straight flight would cost stands @ref ch06_results "among the results", and is not far.
//!
//! @table{ch06_sizes}
//!
//! The factor \f$ 1/N \f$ does what it is for: larger swarms agree in their cost and in what they do. Very few members
//! are cheaper and hardly unpack: a design relies on nobody being where a larger swarm has somebody. What a
//! design takes grows with the pairs:
//!
//! @table{ch06_costs}
//!
//! The numbers of the best designs are another matter. Each line is a seed of the algorithm:
//!
//! @table{ch06_strings}
//!
//! Their costs agree, their strings do not: strengths of the members' own forces differ by a multiple. The objective
//! hardly asks how members treat each other, as long as they stay together and nobody is lost. It does ask how they pass
//! the fence, and there strings agree best: a strong repulsion of the obstacles, and a steep one.
//!
//! @section ch06_designs_elsewhere Other starts, other sizes
//!
//! A design has been tuned on one start, and knows its members by their places. So the last question is what it does
//! with others:
//!
//! @table{ch06_elsewhere}
//!
//! Lost are shares of all members of all flights of a design. One that has lost nobody at home may lose some elsewhere,
//! the more the fewer members it was tuned on: those had gone where others cannot follow. The mean over several starts
//! helps, even of few members, and is what we should take if we had to rely on a design.
//!
//! @section ch06_designs_exercises Exercises
//!
//! 1. Take the penalty away: `course.loss_penalty = 0.0` in `course_of`. Does the algorithm give members up, and what
//!    for?
//! 2. Take `--seed 2` to 6, each with a start of its own. What of the captions fails first?
