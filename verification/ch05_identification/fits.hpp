#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include <particulate/identification/history_cost.hpp>
#include <particulate/identification/identifiability.hpp>

/// @file
/// Clouds whose near field is to be found from their relative energy, and the fits that find it.

namespace verification {

/// Parameters (ln alpha1, ln alpha2, beta1, beta2) of the near field that is to be found: (0.5, 0.25, 1, 2).
inline Eigen::Vector4d true_parameters() { return {std::log(0.5), std::log(0.25), 1.0, 2.0}; }

/// Moments T k/n, k = 1 ... n.
std::vector<double> moments(double T, int n);

/// Chapter 4's starts with seeds first, first + 1, ...
std::vector<particulate::kinematics::Particles> book_clouds(Eigen::Index N, int starts, std::uint64_t first);

/// The relative energy of clouds without contact, of (ln alpha1, ln alpha2, beta1, beta2); of the first two alone the
/// exponents are (beta1, beta2).
particulate::identification::HistoryModel cloud_model(std::vector<particulate::kinematics::Particles> starts,
                                                      std::vector<double> times, double beta1 = 1.0, double beta2 = 2.0,
                                                      double TOL = 1e-6);

/// A model's own history as what it is compared with.
particulate::identification::HistoryCost own_cost(const particulate::identification::HistoryModel& model, int starts,
                                                  const std::vector<double>& times, const Eigen::VectorXd& parameters);

/// What a cost's model gives, for sensitivities and residuals.
particulate::identification::SampledModel sampled(const particulate::identification::HistoryCost& cost);

/// Values with normal noise of a share of each.
Eigen::VectorXd with_noise(const Eigen::VectorXd& values, double share, std::uint64_t seed);

/// Steps of sensitivities to logarithms and exponents.
inline particulate::identification::Differences absolute_steps(Eigen::Index parameters, double step) {
  return {.step = step, .size = Eigen::VectorXd::Ones(parameters)};
}

/// Least squares by polish(), with its defaults.
Eigen::VectorXd fit(const particulate::identification::Residuals& residuals,
                    const particulate::identification::Box& box, const Eigen::VectorXd& start);

/// A box about parameters.
inline particulate::identification::Box box_about(const Eigen::VectorXd& middle, double half) {
  return {.lower = middle.array() - half, .upper = middle.array() + half};
}

}  // namespace verification
