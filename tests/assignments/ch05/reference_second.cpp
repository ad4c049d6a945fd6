// The library itself, variant 2.
// graded: --variant 2 --student anna|bob@school.edu|1234567|carla-7 -> 20

#include <particulate/identification/mating.hpp>

#include "mating.hpp"

void mate(Eigen::MatrixXd& strings, Eigen::Index K, const Uniform& uniform) {
  for (Eigen::Index child = 0; child < K; ++child) {
    const Eigen::Index first = child, second = (child + 1) % K;
    strings.col(K + child) = particulate::identification::mated(strings.col(first), strings.col(second), uniform);
  }
}
