// The library itself, variant 1.
// graded: --variant 1 --student anna|bob@school.edu|1234567|carla-7 -> 20

#include <algorithm>

#include <particulate/swarm/objective.hpp>

#include "objective.hpp"

namespace {

namespace kinematics = particulate::kinematics;

// The places that count at a moment, a row a member.
kinematics::Vectors places(const Flight& flight, Eigen::Index k) {
  kinematics::Vectors all(static_cast<Eigen::Index>(flight.lost.size()), 3);
  for (Eigen::Index i = 0; i < all.rows(); ++i) {
    const int lost = flight.lost[static_cast<std::size_t>(i)];
    const Eigen::Index counts = lost < 0 ? k : std::min<Eigen::Index>(k, lost);
    all.row(i) = flight.place[static_cast<std::size_t>(counts)].col(i).transpose();
  }
  return all;
}

// Of some of them, from the first on.
double mean_of(const Flight& flight, const Eigen::Vector3d& target, Eigen::Index first, Eigen::Index count) {
  const kinematics::Vectors still = kinematics::Vectors::Zero(count, 3);
  const auto some = [&](Eigen::Index k) -> kinematics::Vectors { return places(flight, k).middleRows(first, count); };
  particulate::swarm::Objective objective(target,
                                          {some(0), still, Eigen::VectorXd::Ones(count), Eigen::VectorXd::Zero(count)});
  for (Eigen::Index k = 1; k < flight.t.size(); ++k) {
    const particulate::schemes::State to{.r = some(k).reshaped(), .v = still.reshaped()};
    objective(to, to, flight.t[k] - flight.t[k - 1], 0);
  }
  return objective.mean();
}

}  // namespace

double objective(const Flight& flight, const Eigen::Vector3d& target, double penalty) {
  const auto N = static_cast<Eigen::Index>(flight.lost.size());
  const auto lost = N - std::count(flight.lost.begin(), flight.lost.end(), -1);
  return mean_of(flight, target, 0, N) + penalty * static_cast<double>(lost) / static_cast<double>(N);
}
