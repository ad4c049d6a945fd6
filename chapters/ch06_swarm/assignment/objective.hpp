#pragma once

#include <vector>

#include <Eigen/Core>

/// @file
/// The header to keep: write this function in objective.cpp, and change nothing here. Only your variant is to be coded,
/// which the head of the score table names: run the check once to learn it.

/// A flight as it was recorded, of N members at n + 1 moments.
struct Flight {
  Eigen::VectorXd t;                    ///< the moments, ascending, not evenly; two at least [s]
  std::vector<Eigen::Matrix3Xd> place;  ///< at each moment the members' places, a column a member [m]
  /// Of each member the number of the moment at which it was lost, counted from 0; -1: never. What is recorded of it
  /// behind that moment is where it would be if it had flown on, and does not count.
  std::vector<int> lost;
};

/// How badly a swarm flew.
/// @param flight   what was recorded of it
/// @param target   where it should be; no member starts there [m]
/// @param penalty  w, if all are lost [-]
/// @return the objective of the brief [-]
double objective(const Flight& flight, const Eigen::Vector3d& target, double penalty);
