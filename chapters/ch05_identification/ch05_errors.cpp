//! @page ch05_errors Chapter 5: What was found, and how surely
//! @brief A near field from noisy histories, its error bars, what nothing tells of, and a test on a new start.
//! @tableofcontents
//!
//! @section ch05_errors_question A good fit is not yet knowledge
//!
//! A search ends with one string of low cost. Are there others, far from it, of a cost that is as low? Then the fit
//! foretells, and its parameters mean nothing. The monograph does not ask; it is the question of everyone who wants to
//! use the numbers.
//!
//! @figure{ch05_profiles, By how much the sum of squares rises\, in standard deviations squared\, if one number is held off its best value and all others are fitted anew. Line: 95 per cent.}
//!
//! @section ch05_errors_theory Error bars
//!
//! Let each value \f$ A^*_k \f$ be measured with the standard deviation \f$ \sigma_k \f$, and let \f$ J_{kj} \f$ be how
//! the simulated one moves with parameter \f$ j \f$. From the singular values \f$ s_i \f$ and directions \f$ v_i \f$ of
//! \f$ J_{kj}/\sigma_k \f$
//!
//! \f[ \mathrm{cov} = \sum_i \frac{v_i v_i^T}{s_i^2} : \f]
//!
//! along \f$ v_i \f$ the parameters are known to within \f$ 1/s_i \f$. That holds where the model is linear within the
//! noise. A *profile* @cite raue2009 does without: it holds one parameter, fits all others anew, and looks how much
//! worse the best fit becomes.
//!
//! A near field can be described otherwise, by the distance \f$ d_e \f$ at which it balances and how stiff it is there,
//! \f$ V''(d_e) \f$ (particulate::identification::NearFieldShape):
//!
//! \f[ d_e = \left(\frac{\alpha_2}{\alpha_1}\right)^{1/(\beta_2 - \beta_1)}, \qquad
//!     V''(d_e) = \alpha_1 (\beta_2 - \beta_1)\, d_e^{-\beta_1 - 1} . \f]
//!
//! @section ch05_errors_program The program

#include <algorithm>
#include <array>
#include <cmath>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>

#include <particulate/identification/identifiability.hpp>
#include <particulate/identification/near_field_shape.hpp>
#include <particulate/identification/search.hpp>

#include "ch05_identification.hpp"

namespace ch05 {
namespace {

//! What was measured has noise, a share of each value. The search knows no more than that share.

struct Measured {
  Clouds clouds;
  HistoryModel model;
  HistoryCost cost;
  Eigen::VectorXd deviation;  // of each datum [J/kg]
};

Measured measure(const Parameters& p, const report::Common& common) {
  const Clouds clouds{.particles = common.quick ? p.particles / 3 : p.particles,
                      .starts = p.starts,
                      .duration = p.duration,
                      .seed = common.seed};
  const HistoryModel model = model_of(clouds);
  Eigen::MatrixXd values = histories_of(model, clouds.starts, truth_of(p));
  boost::random::mt19937_64 engine(common.seed);
  boost::random::normal_distribution<double> normal;
  for (double& value : values.reshaped()) value *= 1.0 + p.noise * normal(engine);
  const HistoryCost cost({{.name = "relative energy [J/kg]", .times = moments(clouds.duration), .values = values}},
                         model);
  return {clouds, model, cost, p.noise * cost.data().cwiseAbs()};
}

SampledModel sampled(const Measured& measured) {
  return [cost = measured.cost](const Eigen::VectorXd& string) { return cost.sampled(string); };
}

Residuals deviations(const Measured& measured) {
  return in_deviations(sampled(measured), measured.cost.data(), measured.deviation);
}

Eigen::VectorXd fit(const Residuals& residuals, const Box& box, const Eigen::VectorXd& start) {
  return polish(residuals, box, start).parameters;
}

//! The search ends when the cost is no larger than the noise. Then we polish once more, each difference in units of its
//! standard deviation. The sum of their squares is a chi-square, if the model is right and the minimum found: of as
//! many degrees of freedom as there are data, less four.

struct Identified {
  Eigen::VectorXd first, searched, string;  // the best of the first strings, of the search, and polished
  Found found;
};

Identified find(const Parameters& p, const Measured& measured, std::uint64_t seed) {
  Identified result;
  GeneticAlgorithm algorithm = algorithm_of(p);
  algorithm.rescaling = 1.5;
  algorithm.restart = Stagnation{.generations = 8, .size = 0.01};
  result.found = search(
      measured.cost, [&](const Eigen::VectorXd& string) { return measured.cost.residuals(string); }, box_of_search(),
      {.algorithm = algorithm, .polished = 1}, {.goal = p.noise, .evaluations = 5000}, seed);
  Population first = first_population(box_of_search(), algorithm, seed);
  result.first = evolve(measured.cost, box_of_search(), algorithm, {.evaluations = algorithm.S}, first).best.parameters;
  result.searched = result.found.ended.best.parameters;
  result.string = fit(deviations(measured), box_of_search(), result.searched);
  return result;
}

//! Both descriptions of a string, the second by logarithms too:

using Names = std::array<const char*, 4>;
constexpr Names of_strengths{"alpha1", "alpha2", "beta1", "beta2"}, of_shape{"d_e", "V''(d_e)", "beta1", "beta2"};

Eigen::Vector4d shape_of_string(const Eigen::VectorXd& string) {
  const NearFieldShape shape = shape_of(law_of(string));
  return {std::log(shape.d_e), std::log(shape.stiffness), shape.beta1, shape.beta2};
}

Eigen::Vector4d string_of_shape(const Eigen::VectorXd& shape) {
  const kinematics::CentralForce law =
      force_of({.d_e = std::exp(shape[0]), .stiffness = std::exp(shape[1]), .beta1 = shape[2], .beta2 = shape[3]});
  return {std::log(law.alpha1), std::log(law.alpha2), law.beta1, law.beta2};
}

//! An error bar of a logarithm is one relative to the number itself.

void add_numbers(report::Table& numbers, const Names& names, Eigen::Index first, const Eigen::Vector4d& truth,
                 const Eigen::Vector4d& found, const Uncertainty& of) {
  for (Eigen::Index k = first; k < first + 2; ++k) {
    const bool logarithm = k < 2;
    const double value = logarithm ? std::exp(found[k]) : found[k], bar = of.deviation[k];
    numbers.add({names[static_cast<std::size_t>(k)], logarithm ? std::exp(truth[k]) : truth[k], value,
                 logarithm ? value * bar : bar, logarithm ? bar : bar / value, (found[k] - truth[k]) / bar});
  }
}

report::Table directions_of(const Names& names, const Uncertainty& of) {
  report::Table directions({"singular value", "error along it", names[0], names[1], names[2], names[3]});
  for (Eigen::Index i = 0; i < 4; ++i) {
    const Eigen::VectorXd v = of.directions.col(i);
    directions.add({of.singular_values[i], 1.0 / of.singular_values[i], v[0], v[1], v[2], v[3]});
  }
  return directions;
}

//! A profile reaches three error bars to either side.

Profile profile_of(const Residuals& residuals, const Eigen::VectorXd& best, double bar) {
  const Eigen::VectorXd reach = Eigen::Vector4d(1.5, 1.5, 1.5, 1.5).cwiseMax(4.0 * bar);
  Box box{.lower = best - reach, .upper = best + reach, .allows = box_of_search().allows};
  box.lower[2] = std::max(box.lower[2], 0.0);
  const Eigen::VectorXd at = best[0] + bar * Eigen::Array<double, 8, 1>{-3.0, -2.0, -1.2, -0.5, 0.5, 1.2, 2.0, 3.0};
  return profile(residuals, box, best, 0, at, fit);
}

void add_profile(report::Table& profiles, report::Table& intervals, const char* name, const Profile& found, double best,
                 double least) {
  for (Eigen::Index k = 0; k < found.at.size(); ++k) {
    profiles.add({name, std::exp(found.at[k] - best), found.cost[k] - least});
  }
  profiles.add({name, 1.0, 0.0});
  intervals.add({name, std::exp(best), std::exp(found.lower), std::exp(found.upper), found.evaluations});
}

//! The last test is the one that counts: a start that was not measured. Its history is computed with the true near
//! field and with the one that was found.

double foretell(const Parameters& p, const Measured& measured, const Identified& found, const report::Output& output) {
  Clouds next = measured.clouds;
  next.seed += static_cast<std::uint64_t>(next.starts);
  next.starts = 1;
  const HistoryModel model = model_of(next);
  const Eigen::VectorXd truth = histories_of(model, 1, truth_of(p)), by = histories_of(model, 1, found.string),
                        first = histories_of(model, 1, found.first);
  report::Table history({"time [s]", "true [J/kg]", "found [J/kg]", "best of the first strings [J/kg]"});
  const std::vector<double> times = moments(next.duration);
  for (std::size_t k = 0; k < times.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    history.add({times[k], truth[row], by[row], first[row]});
  }
  output.write("history", history);
  return exact_cost(p, next)(found.string).cost;
}

//! Each of the tables is a question to the same fit.

void write_costs(const Parameters& p, const Measured& measured, const Identified& found, const report::Output& output) {
  const Residuals residuals = deviations(measured);
  report::Table costs({"string", "cost [-]", "sum of squares [-]", "chi-square [-]", "data less parameters"});
  const auto add = [&](const char* name, const Eigen::VectorXd& string) {
    costs.add({name, measured.cost(string).cost, measured.cost.residuals(string).squaredNorm(),
               residuals(string).squaredNorm(), measured.deviation.size() - 4});
  };
  add("best of the first strings", found.first);
  add("of the search", found.searched);
  add("polished", found.string);
  add("true", truth_of(p));
  output.write("costs", costs);
}

struct Bars {
  Uncertainty strengths, shape;
};

Bars write_numbers(const Parameters& p, const Measured& measured, const Eigen::VectorXd& found,
                   const report::Output& output) {
  const Eigen::MatrixXd J =
      sensitivities(sampled(measured), found, {.step = 1e-4, .size = Eigen::Vector4d::Ones()}).jacobian;
  const Eigen::MatrixXd by_shape = to_other_parameters(J, derivative_of_log_shape(law_of(found)));
  const Bars bars{uncertainty(J, measured.deviation), uncertainty(by_shape, measured.deviation)};
  report::Table numbers({"parameter", "true", "found", "error bar", "error bar over found", "off over error bar"});
  add_numbers(numbers, of_strengths, 0, truth_of(p), found, bars.strengths);
  add_numbers(numbers, of_strengths, 2, truth_of(p), found, bars.strengths);
  add_numbers(numbers, of_shape, 0, shape_of_string(truth_of(p)), shape_of_string(found), bars.shape);
  output.write("numbers", numbers);
  output.write("directions", directions_of(of_strengths, bars.strengths));
  output.write("directions_of_shape", directions_of(of_shape, bars.shape));
  return bars;
}

void write_profiles(const Residuals& residuals, const Eigen::VectorXd& found, const Bars& bars,
                    const report::Output& output) {
  const Residuals by_shape = [&](const Eigen::VectorXd& shape) { return residuals(string_of_shape(shape)); };
  const Eigen::Vector4d shape = shape_of_string(found);
  const double least = residuals(found).squaredNorm();
  report::Table profiles({"parameter", "held at, over the best [-]", "rise of chi-square"});
  report::Table intervals({"parameter", "best", "lower end", "upper end", "evaluations"});
  add_profile(profiles, intervals, "alpha1", profile_of(residuals, found, bars.strengths.deviation[0]), found[0],
              least);
  add_profile(profiles, intervals, "d_e", profile_of(by_shape, shape, bars.shape.deviation[0]), shape[0], least);
  output.write("profiles", profiles);
  output.write("intervals", intervals);
}

}  // namespace

void identify(const Parameters& p, report::Chapter& chapter, report::Checks& checks) {
  const Measured measured = measure(p, chapter.common());
  const Identified found = find(p, measured, chapter.common().seed);
  const Residuals residuals = deviations(measured);
  write_costs(p, measured, found, chapter.output());
  const Bars bars = write_numbers(p, measured, found.string, chapter.output());
  write_profiles(residuals, found.string, bars, chapter.output());
  const double foretold = foretell(p, measured, found, chapter.output());

  const double freedom = static_cast<double>(measured.deviation.size() - 4);
  checks.add("chi-square of the fit over its mean, less one", residuals(found.string).squaredNorm() / freedom - 1.0,
             4.0 * std::sqrt(2.0 / freedom));
  const Eigen::Vector4d off = shape_of_string(found.string) - shape_of_string(truth_of(p));
  checks.add("d_e, off the truth, in error bars", off[0] / bars.shape.deviation[0], 4.0);
  checks.add("V''(d_e), off the truth, in error bars", off[1] / bars.shape.deviation[1], 4.0);
  checks.add("cost on a start that the fit has not seen, over the noise", foretold / p.noise, 1.0);
  chapter.summary().add({"evaluations of the search", static_cast<double>(found.found.population.evaluations)});
  chapter.summary().add({"error bar of alpha1 over it", bars.strengths.deviation[0]});
  chapter.summary().add({"error bar of d_e over it", bars.shape.deviation[0]});
  chapter.summary().add({"cost on the unseen start", foretold});
}

}  // namespace ch05

//! @section ch05_errors_costs How good the fit is
//!
//! @table{ch05_costs}
//!
//! Two measures stand side by side, because two methods made them small: the algorithm the cost, with its absolute
//! values, polishing a sum of squares. The true string has neither the lowest cost nor the lowest sum of squares: the
//! fit adapts to the noise as well, by four parameters' worth, which is what the last two columns compare.
//!
//! @section ch05_errors_numbers How sure each number is
//!
//! @table{ch05_numbers}
//!
//! The same data, the same fit; but the strength of attraction is hardly known, while the distance of balance is known
//! far better than any single value was measured. That is no contradiction. Singular values and directions of both
//! descriptions, strengths first:
//!
//! @table{ch05_directions}
//!
//! @table{ch05_directions_of_shape}
//!
//! Along the last line all four parameters of the first description move together, and the histories hardly do. It is a
//! valley again, in four dimensions: along it balance and stiffness remain. In the second description the two that are
//! seen have lines of their own, and the last is little but the difference of the exponents. So a fit can say *where*
//! the near field balances and *how firmly*, and must not be asked for \f$ \alpha_1 \f$. If the exponents are known
//! beforehand, both strengths are found to within a per cent (@ref verify_ch05_recovery_given_exponents).
//!
//! @table{ch05_intervals}
//!
//! Profiles confirm the error bars without their linearity: the intervals of 95 per cent. That of \f$ \alpha_1 \f$
//! reaches farther up than down, which no covariance can say. How error bars compare with the scatter of fits to other
//! noise is verified in @ref verify_ch05_recovery_cloud, and that a profile without an end is reported as such in
//! @ref verify_ch05_profile_without_end.
//!
//! @section ch05_errors_foretells Does it foretell?
//!
//! The figure at @ref ch05_identification "the top of the chapter" shows a start that the fit has not seen. Though
//! \f$ \alpha_1 \f$ is not the true one, the history is: what the data do not tell of the parameters, they do not need
//! either, as long as one asks for the same kind of motion. Closer encounters, with contacts or for a longer time,
//! would see more of the near field, and there the fit promises nothing.
//!
//! @section ch05_errors_exercises Exercises
//!
//! 1. By which factor do the error bars fall if the noise is halved? If there are four times as many starts?
//! 2. Show that \f$ \alpha_1 = V''(d_e)\, d_e^{\beta_1+1}/(\beta_2 - \beta_1) \f$. Which of the three makes it unsure?
//! 3. Which start would tell more of the exponents: a denser cloud or a dilute one?
