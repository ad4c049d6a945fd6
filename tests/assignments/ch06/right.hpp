#pragma once

#include <algorithm>

#include "objective.hpp"

// What a student may well write, for both variants, in parts: submissions with one mistake replace one of them.
namespace right {

using Eigen::Index;

// Distances, a row a member and a column a moment: of the lost where they were lost.
inline Eigen::MatrixXd distances(const Flight& flight, const Eigen::Vector3d& target) {
  Eigen::MatrixXd d(static_cast<Index>(flight.lost.size()), flight.t.size());
  for (Index i = 0; i < d.rows(); ++i) {
    const Index lost = flight.lost[static_cast<std::size_t>(i)];
    for (Index k = 0; k < d.cols(); ++k) {
      const Index counts = lost < 0 ? k : std::min(k, lost);
      d(i, k) = (flight.place[static_cast<std::size_t>(counts)].col(i) - target).norm();
    }
  }
  return d;
}

inline Eigen::VectorXd over_mean(const Eigen::MatrixXd& d) { return d.colwise().sum().transpose() / d.col(0).sum(); }

inline Eigen::VectorXd over_own(const Eigen::MatrixXd& d) {
  return (d.array().colwise() / d.col(0).array()).colwise().mean().transpose();
}

inline double time_mean(const Eigen::VectorXd& t, const Eigen::VectorXd& y) {
  double sum = 0.0;
  for (Index k = 1; k < t.size(); ++k) sum += 0.5 * (t[k] - t[k - 1]) * (y[k] + y[k - 1]);
  return sum / (t[t.size() - 1] - t[0]);
}

inline double lost_share(const Flight& flight) {
  return static_cast<double>(std::count_if(flight.lost.begin(), flight.lost.end(), [](int k) { return k >= 0; })) /
         static_cast<double>(flight.lost.size());
}

// All of it, with one of the parts in another form.
template <auto over = over_mean, auto distances_of = distances, auto mean = time_mean>
double objective(const Flight& flight, const Eigen::Vector3d& target, double penalty) {
  return mean(flight.t, over(distances_of(flight, target))) + penalty * lost_share(flight);
}

}  // namespace right
