//! @page ch09_inverse Chapter 9: Which cloud was it?
//! @brief From what a beam leaves and how warm it makes a cloud back to the cloud: a valley, a basin, and a search.
//! @tableofcontents
//!
//! @section ch09_inverse_question Back from the answer
//!
//! Somebody has sent a beam through a cloud, has measured what came out, and how warm it became. Which cloud was it?
//! Section 9.7 of the monograph looks for the parameters of a cloud with wanted properties; they need not have been
//! measured. Here two parameters are free,
//!
//! \f[ \Lambda = (\hat n, L), \qquad 1.5 \le \hat n \le 50, \quad 0.25 \le L \le 0.4 , \f]
//!
//! and three numbers are wanted: \f$ I_x/\|I(0)\| \f$, the sum over rays that go forward, and the mean temperature
//! after a @ref ch09_heat "pulse". The cost is their weighted relative misfit
//! (particulate::identification::Misfit),
//!
//! \f[ \Pi(\Lambda) = \sum_k \frac{w_k}{\sum w}\, \frac{|A_k(\Lambda) - A_k^*|}{|A_k^*|} , \f]
//!
//! with equal weights. *Which* of these numbers are asked for decides whether there is an answer.
//!
//! @figure{ch09_map, The cost over both parameters\, with two targets (left) and with three (right). Line: the lowest cost at each L\, below a tenth. Dots: where searches ended. Cross: the cloud that was seen.}
//!
//! @section ch09_inverse_program The program

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/tools/minima.hpp>

#include <particulate/identification/genetic_algorithm.hpp>
#include <particulate/identification/misfit.hpp>
#include <particulate/identification/polishing.hpp>
#include <particulate/report/progress.hpp>

#include "ch09_scattering.hpp"

namespace ch09 {
namespace {

using namespace identification;

const Eigen::Vector2d truth(10.0, 0.325);  // n^ and L of the cloud that was seen
const Box box_of_search{.lower = Eigen::Vector2d(1.5, 0.25), .upper = Eigen::Vector2d(50.0, 0.4)};

//! A string has a cost only once clouds have been drawn, and another draw gives another cost. So every string of a
//! search meets the *same random numbers*: the same seeds, and a beam of the same rays, stratified as these tell most.
//! Of two strings that are close to one another most spheres are then at the same places, and their costs differ
//! because the strings do.

struct Lit {
  Cloud<Sphere> cloud;
  Rays rays;
};

std::vector<Lit> lit_clouds(const Parameters& p, double L, int first, int count) {
  Beam stratified = beam;
  stratified.points = Beam::Points::stratified;
  const auto side = static_cast<Eigen::Index>(std::sqrt(static_cast<double>(p.rays)));
  std::vector<Lit> all;
  for (int k = first; k < first + count; ++k) {
    const std::uint64_t of_spheres = seed_of(p, k), of_rays = of_spheres + 1000000;
    all.push_back({spheres(L, uniform_from(of_spheres)), rays_of(stratified, side * side, uniform_from(of_rays))});
  }
  return all;
}

//! The mean temperature needs no temperatures: only what a cloud absorbs, and the heat capacity of its spheres.

Eigen::VectorXd answers(const Parameters& p, double n_hat, double L, const std::vector<Lit>& clouds) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Lit& one : clouds) {
    const Ledger of = trace(one.cloud, Fresnel{n_hat}, one.rays).ledger;
    mean += Eigen::Vector3d(of.x, of.absorbed, of.forward) / (of.incident * static_cast<double>(clouds.size()));
  }
  const double capacity =
      p.rho_c * p.edge * 4.0 / 3.0 * std::numbers::pi * L * L * L;  // over the cube's face [J/(m^2 K)]
  mean[1] = theta_0 + mean[1] * area(beam) * p.fluence / capacity;
  return mean;
}

//! What is wanted are the numbers of a twin, a cloud of \f$ \hat n = 10 \f$ and \f$ L = 0.325 \f$. Each search has its own twin, made with
//! seeds that it does not use itself: what it cannot find again is lost in the differences between clouds.

struct Question {
  const Parameters& p;
  int number;   // of the search
  int targets;  // how many of the numbers are wanted

  int clouds() const { return p.line.common().quick ? p.fitted / 3 : p.fitted; }
  int first_of_twin() const { return 1000 * (number + 1); }
  std::vector<Lit> lit(double L) const { return lit_clouds(p, L, first_of_twin() + 500, clouds()); }
  Eigen::VectorXd answers_to(const Eigen::VectorXd& string) const {
    return answers(p, string[0], string[1], lit(string[1])).head(targets);
  }
};

std::vector<Wanted> numbers_of_twin(const Question& ask) {
  const Parameters& p = ask.p;
  const Eigen::VectorXd seen =
      answers(p, truth[0], truth[1], lit_clouds(p, truth[1], ask.first_of_twin(), realizations_of(p)));
  std::vector<Wanted> wanted{{.name = "I_x/I(0)", .value = seen[0]},
                             {.name = "mean temperature [K]", .value = seen[1]},
                             {.name = "forward sum", .value = seen[2]}};
  wanted.resize(static_cast<std::size_t>(ask.targets));
  return wanted;
}

//! @section ch09_inverse_search Searches
//!
//! The @ref ch05_search "genetic algorithm of chapter 5" begins, and polishing ends it, in steps that are large beside
//! what one sphere more or less does to the cost.

struct Ended {
  std::vector<double> best = {};  // cost by generation; first that of the middle of the box
  Eigen::VectorXd found = {}, polished = {};
  double cost = 0.0, polished_cost = 0.0, cost_of_truth = 0.0;
  long evaluations = 0, for_polishing = 0;
  std::vector<Reached> reached = {};
};

Ended search_for(const std::vector<Wanted>& wanted, const Question& ask) {
  const report::Common& common = ask.p.line.common();
  const Misfit cost(wanted, [&](const Eigen::VectorXd& string) { return ask.answers_to(string); });
  const GeneticAlgorithm algorithm{.threads = common.threads};
  Ended end{.best = {cost(0.5 * (box_of_search.lower + box_of_search.upper)).cost}};
  Population population = first_population(box_of_search, algorithm, seed_of(ask.p, ask.number));
  const Stops stops{.generations = common.quick ? 4 : 8};
  const Evolution evolution = evolve(cost, box_of_search, algorithm, stops, population, [&](const Population& now) {
    end.best.push_back(best_of(now).cost);
    return true;
  });
  const Polished polished = polish([&](const Eigen::VectorXd& string) { return cost.residuals(string); }, box_of_search,
                                   evolution.best.parameters, {.step = 0.03, .central = true, .tolerance = 1e-3});
  end.found = evolution.best.parameters, end.polished = polished.parameters;
  end.cost = evolution.best.cost, end.polished_cost = cost(polished.parameters).cost;
  end.cost_of_truth = cost(truth).cost;
  end.evaluations = population.evaluations, end.for_polishing = polished.evaluations;
  end.reached = cost.reached(end.polished);
  return end;
}

//! Error bars are what the searches differ by.

std::string with_scatter(const std::vector<double>& x) {
  const report::Mean mean = report::mean_of(x);
  return fmt::format("{:.4g} ± {:.2g}", mean.value, mean.standard_error * std::sqrt(static_cast<double>(x.size())));
}

template <class Number>
std::vector<double> over(const std::vector<Ended>& all, const Number& number) {
  std::vector<double> numbers(all.size());
  std::transform(all.begin(), all.end(), numbers.begin(), number);
  return numbers;
}

void add_recovered(const std::vector<Ended>& all, int targets, report::Table& table) {
  const auto mean = [&](const auto& number) { return report::mean_of(over(all, number)).value; };
  const double of_truth = mean([](const Ended& one) { return one.cost_of_truth; });
  const auto add = [&](const char* by, const auto& string, const auto& cost, const auto& evaluations) {
    table.add({targets, by, with_scatter(over(all, [&](const Ended& one) { return string(one)[0]; })),
               with_scatter(over(all, [&](const Ended& one) { return string(one)[1]; })), mean(cost), of_truth,
               mean(evaluations)});
  };
  add(
      "the genetic algorithm", [](const Ended& one) { return one.found; }, [](const Ended& one) { return one.cost; },
      [](const Ended& one) { return static_cast<double>(one.evaluations); });
  add(
      "and polishing", [](const Ended& one) { return one.polished; },
      [](const Ended& one) { return one.polished_cost; },
      [](const Ended& one) { return static_cast<double>(one.evaluations + one.for_polishing); });
}

//! Whether the mean of the searches is the truth is judged by their scatter: by Student's t, as they are few.

void claim_unbiased(const std::vector<Ended>& all, report::Checks& checks) {
  const boost::math::students_t distribution(static_cast<double>(all.size() - 1));
  const double allowed = boost::math::quantile(complement(distribution, 5e-5));
  for (const Eigen::Index i : {0, 1}) {
    const report::Mean off =
        report::mean_of(over(all, [&](const Ended& one) { return std::log(one.polished[i] / truth[i]); }));
    checks.add(fmt::format("three targets: {} found over the true one, in standard errors of ten thousand to one",
                           i == 0 ? "n^" : "L"),
               off.value / off.standard_error / allowed, 1.0);
  }
}

void search_all(const Parameters& p, report::Chapter& chapter) {
  const int searches = p.line.common().quick ? 2 * p.searches / 5 : p.searches;
  report::Table ends({"targets", "search", "n^", "L", "n^ polished", "L polished", "cost", "cost polished"});
  report::Table courses({"targets", "search", "generation", "best cost"});
  report::Table recovered({"targets", "found by", "n^", "L", "mean cost", "of the true cloud", "evaluations"});
  report::Progress progress("searches", 2.0 * searches);
  for (const int targets : {2, 3}) {
    std::vector<Ended> all;
    for (int k = 0; k < searches; ++k) {
      const Question ask{p, k, targets};
      all.push_back(search_for(numbers_of_twin(ask), ask));
      const Ended& end = all.back();
      ends.add({targets, k, end.found[0], end.found[1], end.polished[0], end.polished[1], end.cost, end.polished_cost});
      for (std::size_t g = 0; g < end.best.size(); ++g) courses.add({targets, k, g, end.best[g]});
      progress.at((targets - 2) * searches + k + 1);
    }
    add_recovered(all, targets, recovered);
    if (targets == 3) claim_unbiased(all, chapter.claims("checks"));
  }
  report::Table twin({"n^", "L"});
  twin.add({truth[0], truth[1]});
  chapter.output().write("twin", twin);
  chapter.output().write("searches", ends);
  chapter.output().write("courses", courses);
  chapter.output().write("recovered", recovered);
}

//! @section ch09_inverse_map The map
//!
//! On the map all points of a row have the same L, and so the same clouds. The lowest cost of a row is found by
//! minimization along \f$ \hat n \f$ between the neighbours of its lowest point. These places form a line; how far it
//! stays below five per cent, in widths of the box, says how different clouds can be that are equally good answers.

constexpr double good = 0.05;

struct Row {
  double L;
  std::vector<Lit> clouds;
  std::vector<double> n_hat = {};
  std::vector<Eigen::VectorXd> found = {};
};

std::vector<Row> rows_of_map(const Question& ask) {
  const int points = ask.p.line.common().quick ? 12 : 24;
  const Eigen::Vector2d low = box_of_search.lower, high = box_of_search.upper;
  std::vector<Row> rows;
  for (int i = 0; i < points; ++i) {
    const double L = low[1] + (high[1] - low[1]) * i / (points - 1);
    rows.push_back({L, ask.lit(L)});
    for (int j = 0; j < points; ++j) {
      rows.back().n_hat.push_back(low[0] * std::pow(high[0] / low[0], static_cast<double>(j) / (points - 1)));
      rows.back().found.push_back(answers(ask.p, rows.back().n_hat.back(), L, rows.back().clouds));
    }
  }
  return rows;
}

//! Between the points of a line lies what is left of it below five per cent.

struct Place {
  Eigen::Vector2d string;
  double cost;
};

std::vector<Place> line_of(const Question& ask, const std::vector<Row>& rows, const Misfit& misfit,
                           report::Table& map) {
  std::vector<Place> line;
  for (const Row& row : rows) {
    std::vector<double> costs;
    for (std::size_t j = 0; j < row.found.size(); ++j) {
      costs.push_back(misfit.of(row.found[j].head(ask.targets)).cost);
      map.add({ask.targets, row.n_hat[j], row.L, costs.back()});
    }
    const auto best = static_cast<std::size_t>(std::min_element(costs.begin(), costs.end()) - costs.begin());
    const double low = row.n_hat[best > 0 ? best - 1 : 0], high = row.n_hat[std::min(best + 1, costs.size() - 1)];
    const auto cost = [&](double n) { return misfit.of(answers(ask.p, n, row.L, row.clouds).head(ask.targets)).cost; };
    constexpr int bits = 10;
    const auto [n_hat, lowest] = boost::math::tools::brent_find_minima(cost, low, high, bits);
    line.push_back({{n_hat, row.L}, lowest});
  }
  return line;
}

double length_of(const std::vector<Place>& line) {
  double length = 0.0;
  for (std::size_t k = 1; k < line.size(); ++k) {
    const Eigen::Vector2d step = line[k].string - line[k - 1].string;
    length += step.cwiseQuotient(box_of_search.upper - box_of_search.lower).norm();
  }
  return length;
}

void draw_map(const Parameters& p, report::Chapter& chapter) {
  report::Table map({"targets", "n^", "L", "cost"}), lines({"targets", "n^", "L", "cost"});
  report::Table valleys({"targets", "lowest cost", "good from n^", "and L", "to n^", "and to L", "length"});
  const std::vector<Row> rows = rows_of_map({p, 0, 3});
  std::vector<double> lengths;
  for (const int targets : {2, 3}) {
    const Question ask{p, 0, targets};
    std::vector<Place> line = line_of(ask, rows, Misfit(numbers_of_twin(ask), {}), map);
    for (const Place& place : line) lines.add({targets, place.string[0], place.string[1], place.cost});
    const auto lower = [](const Place& a, const Place& b) { return a.cost < b.cost; };
    const Place lowest = *std::min_element(line.begin(), line.end(), lower);
    line.erase(std::remove_if(line.begin(), line.end(), [](const Place& place) { return place.cost > good; }),
               line.end());
    const Eigen::Vector2d first = line.empty() ? lowest.string : line.front().string;
    const Eigen::Vector2d last = line.empty() ? lowest.string : line.back().string;
    lengths.push_back(length_of(line));
    valleys.add({targets, lowest.cost, first[0], first[1], last[0], last[1], lengths.back()});
  }
  chapter.output().write("map", map);
  chapter.output().write("lines", lines);
  chapter.output().write("valleys", valleys);
  chapter.claims("checks").add("the valley of two targets against twice that of three; lacks [widths of the box]",
                               std::max(2.0 * lengths[1] - lengths[0], 0.0), 0.0);
}

//! @section ch09_inverse_beyond What no cloud does
//!
//! Wishes need not come from a cloud. We ask for the light of the twin from a cloud that is as hot as four times the
//! twin's temperature. There is none; the search must say so, and what came nearest.

void beyond_reach(const Parameters& p, report::Chapter& chapter) {
  const Question ask{p, 0, 3};
  std::vector<Wanted> wanted = numbers_of_twin(ask);
  wanted[1].value *= 4.0;
  const std::vector<Reached> nearest = search_for(wanted, ask).reached;
  report::Table table({"number", "wanted", "came nearest", "misfit [-]"});
  for (const Reached& one : nearest) table.add({one.name, one.wanted, one.found, one.misfit});
  chapter.output().write("beyond", table);
  chapter.claims("checks").add("of an impossible cloud: reached all the same, where 1 is yes",
                               unreached(nearest, good).empty() ? 1.0 : 0.0, 0.0);
}

}  // namespace

void inverse(const Parameters& p, report::Chapter& chapter) {
  draw_map(p, chapter);
  search_all(p, chapter);
  beyond_reach(p, chapter);
}

}  // namespace ch09

//! @section ch09_inverse_results A valley and a basin
//!
//! @table{ch09_valleys}
//!
//! With two targets, \f$ I_x \f$ and the mean temperature, the answer is a *valley*. More reflection per hit and fewer
//! hits weigh each other up: a thin cloud of good reflectors turns back as much of the beam as a dense one of poorer
//! ones, and becomes about as warm. Five per cent is what such a measurement may well be off by, and then nothing tells
//! one end from the other. The third target does: how much comes *through* falls with L by a factor, whatever the
//! spheres are made of. What was a valley is a basin.
//!
//! @figure{ch09_generations, Best cost by generation\, all searches\, with two targets (dashed) and with three. The first point is the cost of the middle of the box: Figure 9.13.}
//!
//! @table{ch09_recovered}
//!
//! Error bars are standard deviations of one search. With three targets all searches end where they should. With two each ends somewhere
//! else, at costs as low: the algorithm has not failed, the question has. Look at the costs of the true cloud. Seen
//! through other clouds of the same kind the truth costs more than what is found, so that a search that goes on only
//! fits what is accidental in its clouds. More evaluations do not help then; more clouds do.
//!
//! The genetic algorithm takes most evaluations to come near, and polishing few to come there. Neither knows that an
//! evaluation is a mean over clouds: the cost jumps where a sphere of one of them finds no place any more. Polishing
//! therefore differentiates over three per cent of the box.
//!
//! @table{ch09_beyond}
//!
//! What cannot be had is shared out among the numbers by their weights: absolute misfits give up one of them and keep
//! the others. Without the last column it would look like an answer.
//!
//! @section ch09_inverse_discussion Discussion
//!
//! Section 9.9 in our words. A beam is cheap to compute, as each ray goes its own way and hits little. What is
//! expensive are the clouds: an answer is a mean, and its error falls with the root of their number. And what one asks
//! for matters more than how one searches for it. A map of the cost, where two parameters make one possible, shows
//! within seconds what a hundred searches only suggest.
//!
//! @section ch09_inverse_exercises Exercises
//!
//! 1. Which two of the three targets suffice? Draw the maps.
//! 2. Ask for the temperature of the hottest sphere instead of the mean one. Is the cost still a cost?
//! 3. Give each string its own random numbers. What does the algorithm find now, and what does polishing do?
//! 4. How many clouds must a search average over until \f$ \hat n \f$ is known to one per cent?
