#pragma once

#include <functional>
#include <string>
#include <vector>

#include <particulate/identification/cost.hpp>
#include <particulate/kinematics/particles.hpp>
#include <particulate/scenes/scene.hpp>

/// @file
/// What simulations are to repeat: histories, and how far others are from them.

namespace particulate::identification {

/// A history at some times.
struct Sampled {
  std::vector<double> times;  ///< rising [s]
  Eigen::VectorXd values;     ///< one a time
};

/// What simulations are to repeat: how one quantity went in time, from each of one or several random starts.
struct Target {
  std::string name;           ///< of the quantity, with its unit
  std::vector<double> times;  ///< at least two, rising; the simulation must give the same to the last bit [s]
  Eigen::MatrixXd values;     ///< A*, a row a time, a column a start
  double weight = 1.0;        ///< of this target among several, >= 0; their sum counts as 1 [-]
};

/// Refuses a history that nothing can be learnt from: an empty one, one of zeros, and one that varies by less than
/// 1e-9 of its size, as the bulk energy of an isolated scene does.
///
/// @param target  the history
/// @throws std::invalid_argument naming the target, what must hold, what was given and what to do
void validate(const Target& target);

/// What a model makes of one set of parameters, from one start.
struct Simulated {
  std::vector<Sampled> histories = {};  ///< one a target, in their order
  std::string reason = {};              ///< why there are none, in a few words that are the same for the same reason
};

/// A simulation. Throwing, and a history that is not finite, count as no value.
using HistoryModel = std::function<Simulated(const Eigen::VectorXd& parameters, Eigen::Index start)>;

/// How far one history of one start is from its target.
struct Part {
  std::string name;  ///< "relative [J/kg], start 2"
  double share;      ///< weight over the sum of the weights and the number of starts [-]
  double distance;   ///< from the target, normalized [-]
};

/// What a cost is made of.
struct Parts {
  std::vector<Part> parts = {};  ///< one a target and start; none where the parameters have no value
  std::string reason = {};       ///< why there are none
};

/// The cost of parameters: how far the histories that they lead to are from their targets. It is a Cost.
///
/// \f[ \Pi(\Lambda) = \sum_h \frac{w_h}{\sum w} \frac1R \sum_{r=1}^R
///     \frac{\int_0^T |A_{hr}(\Lambda) - A_{hr}^*|\,dt}{\int_0^T |A_{hr}^*|\,dt} \f]
///
/// @equation{R 5.1} Over targets h and starts r; integrals by the trapezoidal rule over the times of the target. A
/// start without a value leaves the parameters without one.
class HistoryCost {
 public:
  /// @param targets  at least one; each with as many starts, weights not all zero
  /// @param model    gives a history a target, at its times
  /// @throws std::invalid_argument as validate() does, and saying what targets must hold together
  HistoryCost(std::vector<Target> targets, HistoryModel model);

  /// @param parameters  of which the cost is asked
  /// @return the sum of share times distance, or the reason of the first start that has none [-]
  /// @throws std::invalid_argument if the model gives another number of histories, or other times
  Value operator()(const Eigen::VectorXd& parameters) const;
  /// @param parameters  of which the cost is asked
  /// @return the distance of each history from its target, for the log
  /// @throws std::invalid_argument as the cost does
  Parts parts(const Eigen::VectorXd& parameters) const;
  /// Differences from the targets, so scaled that the sum of their squares is the cost with squares for absolute
  /// values.
  ///
  /// \f[ \rho_{hrk} = \sqrt{\frac{w_h}{R \sum w}\, \frac{q_k}{\int_0^T {A_{hr}^*}^2 dt}}\;
  ///     (A_{hr}(\Lambda) - A_{hr}^*)(t_k) \f]
  ///
  /// @equation{R 5.1} q_k are the weights of the trapezoidal rule.
  /// @param parameters  of which they are asked
  /// @return one a target, start and time, in the order of sampled(); empty where there is no value
  /// @throws std::invalid_argument as the cost does
  Eigen::VectorXd residuals(const Eigen::VectorXd& parameters) const;
  /// @param parameters  of which they are asked
  /// @return the histories themselves: target by target, in each start by start, in each time by time; empty where
  ///         there is no value
  /// @throws std::invalid_argument as the cost does
  Eigen::VectorXd sampled(const Eigen::VectorXd& parameters) const;
  /// @return the targets in the order of sampled()
  const Eigen::VectorXd& data() const { return data_; }

 private:
  Eigen::Index starts() const { return targets_.front().values.cols(); }
  Eigen::VectorXd sampled(const Eigen::VectorXd& parameters, std::string& reason) const;

  std::vector<Target> targets_;
  HistoryModel model_;
  std::vector<double> shares_;                 // of each target, of one start
  Eigen::VectorXd data_;                       // of all, as sampled() stacks them
  Eigen::VectorXd per_absolute_, per_square_;  // of each difference in the cost, and of its square in that of squares
};

/// How a history is simulated.
struct HistoryRun {
  double TOL = 1e-6;  ///< of the error of a step [-]
  long most_steps =
      1000;  ///< after which a run has no value: parameters that make bodies collapse would take hours [-]
};

/// The relative kinetic energy of a run at some times: per unit mass, about the centre of mass. By Gauss collocation
/// of order 16, so that a history of a cloud at the default tolerance is good to some 1e-9 and smooth in the
/// parameters, in some 50 steps.
///
/// @equation{M 2.28}
/// @param particles  the start
/// @param problem    how they move
/// @param times      rising, not before 0 [s]
/// @param run        how
/// @return one history; none if the run fails on the way, with the name of its Failure, or takes too many steps
/// @throws std::invalid_argument for times and tolerances that cannot be meant
Simulated relative_energy_history(const kinematics::Particles& particles, const schemes::Problem& problem,
                                  const std::vector<double>& times, const HistoryRun& run = {});

/// The same of a scene:
///
///     const HistoryModel model = [&](const Eigen::VectorXd& p, Eigen::Index start) {
///       return relative_energy_history(Scene(starts[start], Space{}, NearField{.alpha1 = p[0], .alpha2 = p[1]}),
///       times);
///     };
///
/// @param scene  the start and its laws
/// @param times  rising, not before 0 [s]
/// @param run    how
/// @return as above
template <kinematics::Domain D, class... Laws>
Simulated relative_energy_history(const scenes::Scene<D, Laws...>& scene, const std::vector<double>& times,
                                  const HistoryRun& run = {}) {
  return relative_energy_history(scene.particles(), schemes::Problem(scene), times, run);
}

}  // namespace particulate::identification
