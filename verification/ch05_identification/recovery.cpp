// Near fields found again from what they did: closed-form motions, clouds with noise, and what no history tells.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Cholesky>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/starts.hpp>
#include <particulate/identification/near_field_shape.hpp>
#include <particulate/kinematics/breathing.hpp>
#include <particulate/report/spread.hpp>

#include "fits.hpp"

namespace verification::identification_recovery {

using namespace particulate;
using namespace particulate::identification;

// Bodies that breathe from rest, by Kepler's equation, and what of their motion goes into the relative energy.
struct Closed {
  const char* name;
  kinematics::Particles start;
  kinematics::Breathing motion;
  double factor;  // energy per unit mass = factor (dr/dt)^2
};

// Two bodies: mu v^2/2 over M = m_i m_j/(2 M^2) v^2.
Closed closed_pair(double alpha1, double alpha2) {
  constexpr double m_i = 1.0, m_j = 3.0, r_0 = 2.0;
  return {.name = "pair",
          .start = pair_at_rest(m_i, m_j, r_0),
          .motion = {kinematics::breathing_pair(alpha1, alpha2, m_i, m_j), r_0},
          .factor = m_i * m_j / (2.0 * (m_i + m_j) * (m_i + m_j))};
}
Closed closed_pentagon(double alpha1, double alpha2) {
  constexpr double m = 2.0, r_0 = 1.5;
  const kinematics::Vectors corners = kinematics::regular_polygon(5);
  return {.name = "pentagon",
          .start = at_rest(corners, r_0, Eigen::VectorXd::Constant(5, m)),
          .motion = {kinematics::breathing_body(alpha1, alpha2, m, corners), r_0},
          .factor = 0.5};
}

// The cost of repeating a closed form, of (ln alpha1, ln alpha2) or all four parameters.
HistoryCost cost_of(const Closed& exact, const std::vector<double>& times) {
  Target target{.name = "relative [J/kg]", .times = times, .values = {}};
  target.values.resize(static_cast<Eigen::Index>(times.size()), 1);
  for (std::size_t k = 0; k < times.size(); ++k) {
    const double v = exact.motion.at(times[k]).v;
    target.values(static_cast<Eigen::Index>(k), 0) = exact.factor * v * v;
  }
  return HistoryCost({target}, cloud_model({exact.start}, times, 2.0, 3.0, 1e-13));
}

const Case closed_forms{
    {.name = "recovery_closed_forms",
     .claim = "the strengths of a near field are found from the history of a breathing pair or polygon",
     .equation = "D 5.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      constexpr double alpha1 = 0.5, alpha2 = 0.25;
      const Eigen::Vector2d start{std::log(0.8 * alpha1), std::log(1.25 * alpha2)};
      for (const Closed& exact : {closed_pair(alpha1, alpha2), closed_pentagon(alpha1, alpha2)}) {
        const HistoryCost cost = cost_of(exact, moments(0.4 * exact.motion.period(), 20));
        const Residuals residuals = [&](const Eigen::VectorXd& p) { return cost.residuals(p); };
        const Eigen::VectorXd found = fit(residuals, box_about(start, 1.0), start);
        const char* const because = "the run keeps some 1e-10, and both are determined";
        rows.compare(
            fmt::format("alpha1 of the {} [N m^2/kg^2]", exact.name),
            {.expected = alpha1, .computed = std::exp(found[0]), .tolerance = relative(1e-8), .because = because});
        rows.compare(
            fmt::format("alpha2 of the {} [N m^3/kg^2]", exact.name),
            {.expected = alpha2, .computed = std::exp(found[1]), .tolerance = relative(1e-8), .because = because});
        rows.at_most(fmt::format("cost of the {} where it was found [-]", exact.name),
                     {.limit = 1e-8, .computed = cost(found).cost, .because = "as the strengths"});
        rows.at_least(fmt::format("cost of the {} where the search starts [-]", exact.name),
                      {.limit = 0.1, .computed = cost(start).cost, .because = "else nothing was to be found"});
      }
    }};

// Clouds of which the relative energy is known to 1 % of each value.
struct NoisyClouds {
  explicit NoisyClouds(const Rows& rows)
      : N(rows.quick() ? 30 : 60),
        starts(5),
        seeds(rows.quick() ? 2 : 6),
        times(moments(0.5, 20)),
        cost(own_cost(cloud_model(book_clouds(N, starts, 1), times), starts, times, true_parameters())) {}

  Residuals residuals(std::uint64_t seed) const {
    return in_deviations(sampled(cost), with_noise(cost.data(), noise, seed), noise * cost.data());
  }
  Eigen::MatrixXd jacobian() const {
    return sensitivities(sampled(cost), true_parameters(), absolute_steps(4, 1e-4)).jacobian;
  }

  static constexpr double noise = 0.01;
  Eigen::Index N;
  int starts, seeds;
  std::vector<double> times;
  HistoryCost cost;
};

// (ln d_e, ln V'', beta1, beta2) of (ln alpha1, ln alpha2, beta1, beta2).
Eigen::Vector4d log_shape(const Eigen::Vector4d& p) {
  const NearFieldShape shape =
      shape_of({.alpha1 = std::exp(p[0]), .alpha2 = std::exp(p[1]), .beta1 = p[2], .beta2 = p[3]});
  return {std::log(shape.d_e), std::log(shape.stiffness), shape.beta1, shape.beta2};
}

Eigen::Vector4d log_strengths(const Eigen::Vector4d& q) {
  const kinematics::CentralForce law =
      force_of({.d_e = std::exp(q[0]), .stiffness = std::exp(q[1]), .beta1 = q[2], .beta2 = q[3]});
  return {std::log(law.alpha1), std::log(law.alpha2), law.beta1, law.beta2};
}

// What was found with several noises, a column each: off the truth.
struct Off {
  Eigen::MatrixXd parameters;  // (ln alpha1, ln alpha2, beta1, beta2)
  Eigen::MatrixXd shape;       // (ln d_e, ln V'', beta1, beta2)
};
Off found_all(const NoisyClouds& clouds, std::uint64_t first_seed) {
  const Eigen::Vector4d truth = true_parameters(), start = truth + Eigen::Vector4d(0.1, 0.05, 0.1, 0.1);
  Off off{.parameters = Eigen::MatrixXd(4, clouds.seeds), .shape = Eigen::MatrixXd(4, clouds.seeds)};
  for (int seed = 0; seed < clouds.seeds; ++seed) {
    const Residuals residuals = clouds.residuals(first_seed + static_cast<std::uint64_t>(seed));
    const Eigen::Vector4d found = fit(residuals, box_about(start, 0.9), start);
    off.parameters.col(seed) = found - truth;
    off.shape.col(seed) = log_shape(found) - log_shape(truth);
  }
  return off;
}

// Whether what was found is as far off as the covariance says, no less and no more.
void compare_with_bars(Rows& rows, const Off& off, const Uncertainty& of, const Uncertainty& shape) {
  rows.at_most("largest error over its error bar, all parameters [-]",
               {.limit = 4.0,
                .computed = std::max((off.parameters.array().colwise() / of.deviation.array()).abs().maxCoeff(),
                                     (off.shape.array().colwise() / shape.deviation.array()).abs().maxCoeff()),
                .because = "of some tens of numbers, each beyond four with a chance of 6e-5"});
  // By Wilson and Hilferty the cube root of chi-square over its mean is normal.
  const double freedom = static_cast<double>(off.shape.size()), variance = 2.0 / (9.0 * freedom);
  const double chi_square = off.shape.cwiseProduct(shape.covariance.ldlt().solve(off.shape)).sum();
  rows.compare("chi-square of all errors with their covariance, as a normal deviate [-]",
               {.expected = 0.0,
                .computed = (std::cbrt(chi_square / freedom) - 1.0 + variance) / std::sqrt(variance),
                .tolerance = absolute(4.0),
                .because = "four standard deviations, to either side"});
}

const Case noisy_cloud{
    {.name = "recovery_cloud",
     .claim = "from a cloud's relative energy with 1 % noise the equilibrium distance and the stiffness are found, the "
              "strength of attraction is not, and all lie as far off as the covariance says",
     .equation = "D 5.1",
     .reference = Reference::statistics},
    [](Rows& rows) {
      const NoisyClouds clouds(rows);
      const Off off = found_all(clouds, rows.case_seed());
      const Eigen::MatrixXd J = clouds.jacobian();
      const Eigen::VectorXd noise = NoisyClouds::noise * clouds.cost.data();
      const Uncertainty of = uncertainty(J, noise);
      const Uncertainty shape =
          uncertainty(to_other_parameters(J, derivative_of_log_shape({.alpha1 = 0.5, .alpha2 = 0.25})), noise);
      const auto worst = [](const Eigen::MatrixXd& all, Eigen::Index k) { return all.row(k).cwiseAbs().maxCoeff(); };
      rows.at_most("largest error of d_e over it [-]",
                   {.limit = 0.01, .computed = worst(off.shape, 0), .because = "what the chapter claims"});
      rows.at_most("largest error of V''(d_e) over it [-]",
                   {.limit = 0.05, .computed = worst(off.shape, 1), .because = "what the chapter claims"});
      rows.at_least("error bar of ln alpha1 [-]",
                    {.limit = 0.04, .computed = of.deviation[0], .because = "four times what a recovery would be"});
      const Eigen::Vector4d truth = true_parameters();
      const Residuals exact = in_deviations(sampled(clouds.cost), clouds.cost.data(), noise);
      const Profile held = profile(exact, box_about(truth, 0.9), truth, 0, truth[0] + Eigen::Array2d(-0.04, 0.04), fit);
      rows.at_most(
          "rise of chi-square where alpha1 is held 4 % off and the others are fitted anew [-]",
          {.limit = 1.0, .computed = held.cost.maxCoeff(), .because = "less than what noise does to one datum"});
      compare_with_bars(rows, off, of, shape);
      report::Table shown({"parameter", "error bar [-]", "largest error [-]"});
      const std::array names{"ln alpha1", "ln alpha2", "beta1", "beta2"};
      for (Eigen::Index k = 0; k < 4; ++k) {
        shown.add({names[static_cast<std::size_t>(k)], of.deviation[k], worst(off.parameters, k)});
      }
      shown.add({"ln d_e", shape.deviation[0], worst(off.shape, 0)});
      shown.add({"ln V''", shape.deviation[1], worst(off.shape, 1)});
      rows.write("recovery", shown);
    }};

const Case given_exponents{
    {.name = "recovery_given_exponents",
     .claim = "from a cloud's relative energy with 1 % noise both strengths are found where the exponents are given",
     .equation = "D 5.1",
     .reference = Reference::statistics},
    [](Rows& rows) {
      const NoisyClouds clouds(rows);
      const Eigen::Vector2d truth = true_parameters().head(2), start = truth + Eigen::Vector2d(0.2, 0.1);
      const Uncertainty of = uncertainty(clouds.jacobian().leftCols(2), NoisyClouds::noise * clouds.cost.data());
      double worst = 0.0, over_bar = 0.0;
      for (int seed = 0; seed < clouds.seeds; ++seed) {
        const Residuals residuals = clouds.residuals(rows.case_seed() + static_cast<std::uint64_t>(seed));
        const Eigen::ArrayXd off = fit(residuals, box_about(start, 0.9), start) - truth;
        worst = report::worse_of(worst, off.abs().maxCoeff());
        over_bar = report::worse_of(over_bar, (off / of.deviation.array()).abs().maxCoeff());
      }
      rows.at_most("largest error of ln alpha1 and ln alpha2 [-]",
                   {.limit = 0.01, .computed = worst, .because = "what the chapter claims"});
      rows.at_most("largest error over its error bar [-]",
                   {.limit = 4.0, .computed = over_bar, .because = "beyond four with a chance of 6e-5 each"});
    }};

// Small clouds, whose relative energy is known to a share of each value.
struct ProfiledClouds {
  explicit ProfiledClouds(int starts)
      : cost(own_cost(cloud_model(book_clouds(10, starts, 1), moments(0.5, 20)), starts, moments(0.5, 20),
                      true_parameters())) {}
  // Of (ln alpha1, ln alpha2, beta1, beta2), or of the shape.
  Residuals residuals(double share, bool of_shape) const {
    const Residuals by_strengths = in_deviations(sampled(cost), cost.data(), share * cost.data());
    if (!of_shape) return by_strengths;
    return [by_strengths](const Eigen::VectorXd& q) { return by_strengths(log_strengths(q)); };
  }
  HistoryCost cost;
};

// The ends of a parameter's 95 % interval, from the truth, over 1.96 of its error bar.
struct Ends {
  double lower, upper;
};
Ends ends_of(const Residuals& residuals, const Eigen::VectorXd& best, Eigen::Index which, const Eigen::ArrayXd& bars) {
  const Eigen::MatrixXd J = sensitivities(residuals, best, absolute_steps(4, 1e-4)).jacobian;
  const double bar = uncertainty(J, Eigen::VectorXd::Ones(J.rows())).deviation[which];
  const Eigen::VectorXd at = best[which] + bars * bar;
  const Profile found = profile(residuals, box_about(best, 0.9), best, which, at, fit);
  const double half = std::sqrt(rise_of_95_percent) * bar;
  return {.lower = (best[which] - found.lower) / half, .upper = (found.upper - best[which]) / half};
}

const Case profiles{
    {.name = "profiles",
     .claim =
         "where noise is so small that the model is linear in it profiles have the intervals of the covariance; with "
         "1 % that of the strength of attraction reaches farther up than down",
     .equation = "D 5.1",
     .reference = Reference::identity},
    [](Rows& rows) {
      const ProfiledClouds clouds(6);
      const Eigen::Vector4d strengths = true_parameters(), shape = log_shape(strengths);
      const Eigen::Array2d two{-2.5, 2.5};  // of a parabola that is enough
      const auto compare = [&](const std::string& name, const Ends& ends) {
        for (const auto& [side, end] : {std::pair{"lower", ends.lower}, std::pair{"upper", ends.upper}}) {
          rows.compare(fmt::format("{} end of the interval of {} over 1.96 error bars, noise 0.01 % [-]", side, name),
                       {.expected = 1.0,
                        .computed = end,
                        .tolerance = absolute(0.02),
                        .because = "asymmetry falls with the noise: a hundredth of that at 1 %"});
        }
      };
      compare("ln alpha1", ends_of(clouds.residuals(1e-4, false), strengths, 0, two));
      compare("ln d_e", ends_of(clouds.residuals(1e-4, true), shape, 0, two));
      const Ends skew = ends_of(clouds.residuals(1e-2, false), strengths, 0, Eigen::Array4d(-2.5, -1.5, 1.5, 3.5));
      rows.at_least("upper over lower end of the interval of ln alpha1, noise 1 % [-]",
                    {.limit = 1.2,
                     .computed = skew.upper / skew.lower,
                     .because = "what a covariance cannot say, far beyond what the rows on 0.01 % allow"});
    }};

// Two bodies that swing by a thousandth about their equilibrium distance: whatever beta1, a beta2 and strengths with
// the same d_e and V'' swing alike.
const Case unseen{
    {.name = "profile_without_end",
     .claim = "what a small swing says of the exponents is nothing: the profile is flat, the interval without ends",
     .equation = "D 5.1",
     .reference = Reference::design},
    [](Rows& rows) {
      const Eigen::Vector4d truth{0.0, 0.0, 1.0, 2.0};                // of the shape
      const double period = 2.0 * std::numbers::pi / std::sqrt(2.0);  // reduced mass 1/2, V'' = 1
      const std::vector<double> times = moments(period, 20);
      const HistoryCost cost =
          own_cost(cloud_model({pair_at_rest(1.0, 1.0, 1.001)}, times), 1, times, log_strengths(truth));
      const Eigen::VectorXd noise = Eigen::VectorXd::Constant(20, 0.01 * cost.data().maxCoeff());
      const SampledModel by_shape = [&](const Eigen::VectorXd& q) { return cost.sampled(log_strengths(q)); };
      const Residuals residuals = in_deviations(by_shape, cost.data(), noise);
      const Box box{.lower = Eigen::Vector4d(-0.1, -1.0, 0.2, 1.6), .upper = Eigen::Vector4d(0.1, 1.0, 1.5, 4.0)};
      const Profile exponent =
          profile(residuals, box, truth, 3, (Eigen::VectorXd(4) << 1.65, 1.8, 2.5, 3.9).finished(), fit);
      const auto shown = [](double end) { return std::string(std::isfinite(end) ? "an end" : "none"); };
      rows.equal("lower end of beta2",
                 {.expected = "none", .computed = shown(exponent.lower), .because = "it is flat"});
      rows.equal("upper end of beta2",
                 {.expected = "none", .computed = shown(exponent.upper), .because = "it is flat"});
      rows.at_most("highest of its profile [-]", {.limit = 0.1 * rise_of_95_percent,
                                                  .computed = exponent.cost.maxCoeff(),
                                                  .because = "flat is far below the rise of an interval"});
      const Profile stiffness = profile(residuals, box, truth, 1, Eigen::Vector4d(-0.5, -0.05, 0.05, 0.5), fit);
      rows.at_most("interval of ln V'' [-]", {.limit = 0.2,
                                              .computed = stiffness.upper - stiffness.lower,
                                              .because = "the period tells it, to a few percent"});
      const Uncertainty of = uncertainty(sensitivities(by_shape, truth, absolute_steps(4, 1e-4)).jacobian, noise);
      rows.at_least("error bar of beta2 over that of ln V'' [-]",
                    {.limit = 100.0, .computed = of.deviation[3] / of.deviation[1], .because = "as the profiles"});
    }};

}  // namespace verification::identification_recovery
