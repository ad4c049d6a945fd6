// The library itself, variant 1.
// graded: --variant 1 --student anna|bob@school.edu|1234567|carla-7 -> 20

#include <particulate/identification/mating.hpp>

#include "mating.hpp"

void mate(Eigen::MatrixXd& strings, Eigen::Index K, const Uniform& uniform) {
  for (Eigen::Index child = 0; child < K; ++child) {
    const Eigen::Index first = child - child % 2, second = first + 1;
    strings.col(K + child) = particulate::identification::mated(strings.col(first), strings.col(second), uniform);
  }
}
