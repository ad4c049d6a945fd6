#pragma once

#include <string>

#include <particulate/identification/cost.hpp>

/// @file
/// What data say of parameters: how the data move with them, how sure that makes them, and along which direction not.

namespace particulate::identification {

/// What is measured, as a model has it of parameters: as many numbers for all of them, none where there is no value.
using SampledModel = std::function<Eigen::VectorXd(const Eigen::VectorXd& parameters)>;

/// Steps of central differences.
struct Differences {
  /// Share of a parameter's size by which it is moved to either side, > 0 [-]. Their own error falls with its square;
  /// what the model's values are in error by, over the step, comes on top.
  double step = 1e-4;
  Eigen::VectorXd size = {};  ///< of each parameter, > 0; empty: what it is, where it is not 0
};

/// How what is measured moves with the parameters.
struct Sensitivities {
  Eigen::MatrixXd jacobian = {};  ///< a row a datum, a column a parameter; empty if a value was missing
  long evaluations = 0;           ///< of the model, those without a value included [-]
  long failures = 0;              ///< of them, without a value [-]
  std::string reason = {};        ///< which parameter could not be moved; empty if all could
};

/// Sensitivities by central differences.
///
/// \f[ J_{kj} = \frac{y_k(p + h_j e_j) - y_k(p - h_j e_j)}{2 h_j} \f]
///
/// @equation{D 5.1}
/// @param model  the model, asked twice a parameter
/// @param at     p, where
/// @param by     steps h_j: step times size
/// @return the sensitivities, or what failed
/// @throws std::invalid_argument for steps that cannot be meant, and a parameter that is 0 without a size
Sensitivities sensitivities(const SampledModel& model, const Eigen::VectorXd& at, const Differences& by = {});

/// The same data's sensitivities to other parameters, by the chain rule.
///
/// \f[ \frac{\partial y}{\partial q} = \frac{\partial y}{\partial p} \left(\frac{\partial q}{\partial p}\right)^{-1}
/// \f]
///
/// @equation{D 5.1}
/// @param jacobian    to p
/// @param derivative  dq/dp, square
/// @return to q
/// @throws std::invalid_argument if sizes do not fit or q does not determine p
Eigen::MatrixXd to_other_parameters(const Eigen::MatrixXd& jacobian, const Eigen::MatrixXd& derivative);

/// How sure data with noise make parameters, as far as the model is linear within the noise.
struct Uncertainty {
  Eigen::VectorXd singular_values =
      {};  ///< of the Jacobian over the noise, falling; 1/s is the error along a direction
  Eigen::MatrixXd directions =
      {};                 ///< in the parameters, of length 1, a column a singular value; the last is the weakest
  Eigen::Index rank = 0;  ///< directions that the data see at all [-]
  Eigen::MatrixXd covariance = {};   ///< of the parameters; infinite along directions that the data do not see
  Eigen::VectorXd deviation = {};    ///< standard deviation of each parameter; infinite likewise
  Eigen::MatrixXd correlation = {};  ///< of each two; of two that are infinite its limit, of one of them 0
};

/// Uncertainty of parameters, from the singular values of what moves the data, over their noise.
///
/// \f[ \frac{J_{kj}}{\sigma_k} = \sum_i u_{ki}\, s_i\, v_{ji}, \qquad
///     \mathrm{cov} = \sum_i \frac{v_i v_i^T}{s_i^2} \f]
///
/// @equation{D 5.1} The covariance of least squares over independent normal noise. Singular values depend on the units
/// of the parameters: take logarithms of what is positive.
/// @param jacobian  a row a datum, a column a parameter
/// @param noise     standard deviation of each datum, > 0
/// @param unseen    singular values up to this share of the largest count as zero, at least the error of the Jacobian's
///                  entries [-]
/// @return the uncertainty, without a NaN whatever the rank
/// @throws std::invalid_argument for noise or a Jacobian that cannot be meant
Uncertainty uncertainty(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& noise, double unseen = 1e-12);

/// What the data say against a model, in standard deviations: residuals of which the sum of squares is a chi-square.
///
/// @equation{D 5.1}
/// @param model  the model
/// @param data   what was measured
/// @param noise  standard deviation of each datum, > 0
/// @return (model - data)/noise
/// @throws std::invalid_argument if lengths differ or noise is not positive
Residuals in_deviations(SampledModel model, Eigen::VectorXd data, Eigen::VectorXd noise);

/// A least-squares fit: from residuals, bounds and a start to the parameters that it found.
using Refit = std::function<Eigen::VectorXd(const Residuals& residuals, const Box& box, const Eigen::VectorXd& start)>;

/// A sum of squares rises by this much at the ends of an interval of 95 %: chi-square with one degree of freedom.
inline constexpr double rise_of_95_percent = 3.841458820694124;

/// What of a parameter the data allow, whatever the others.
struct Profile {
  Eigen::VectorXd at;          ///< values at which it was held
  Eigen::VectorXd cost;        ///< sum of squares after the others were fitted anew; infinite where there is none
  Eigen::MatrixXd parameters;  ///< all of them there, a column a value
  double lower;                ///< where the cost has risen by `rise`; -infinity: nowhere, it is flat on that side
  double upper;                ///< likewise; +infinity: nowhere
  long evaluations;            ///< of the residuals [-]
};

/// Profile of the sum of squares over one parameter.
///
/// \f[ \chi^2_j(x) = \min_{p:\, p_j = x} \chi^2(p), \qquad
///     \text{interval: } \chi^2_j(x) \le \min \chi^2 + \text{rise} \f]
///
/// @equation{D 5.1} Unlike the covariance it does not take the model as linear. From the best outwards each fit starts
/// where its neighbour ended. Between two values the root of the rise is interpolated, which a parabola has straight.
/// @param residuals  such as in_deviations()
/// @param box        of all parameters
/// @param best       a minimum of the sum of squares
/// @param which      number of the parameter
/// @param at         values at which it is held, rising, on both sides of the best
/// @param refit      fits the others
/// @param rise       > 0; of residuals that are not in standard deviations, what the caller means
/// @return the profile
/// @throws std::invalid_argument for a parameter that is not there, values that do not rise or lie outside the box, and
///         a best that has no residuals
Profile profile(const Residuals& residuals, const Box& box, const Eigen::VectorXd& best, Eigen::Index which,
                const Eigen::VectorXd& at, const Refit& refit, double rise = rise_of_95_percent);

}  // namespace particulate::identification
