// Right, without the library: one layer of neighbours.
// graded: --variant 1 --student anna|bob@school.edu|1234567 -> 20

#include "right.hpp"

Eigen::Vector3d nearest_image(const Eigen::Vector3d& d, const Box& box) { return right::nearest_image(d, box); }

Cell cells_across(const Box& box, double reach) { return right::cells_across<1>(box, reach); }

Cell cell_of(const Eigen::Vector3d& place, const Box& box, const Cell& cells) {
  return right::cell_of(place, box, cells);
}

std::vector<Pair> near_pairs(const std::vector<Cell>& cell, const Cell& cells, const Box& box, const IsNear& is_near) {
  return right::near_pairs<1>(cell, cells, box, is_near);
}
