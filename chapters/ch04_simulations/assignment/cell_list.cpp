#include "cell_list.hpp"

// Fill the four holes. The brief is README.md; what each function must return stands in cell_list.hpp.

Eigen::Vector3d nearest_image([[maybe_unused]] const Eigen::Vector3d& d, [[maybe_unused]] const Box& box) {
  return Eigen::Vector3d::Zero();
}

Cell cells_across([[maybe_unused]] const Box& box, [[maybe_unused]] double reach) { return {}; }

Cell cell_of([[maybe_unused]] const Eigen::Vector3d& place, [[maybe_unused]] const Box& box,
             [[maybe_unused]] const Cell& cells) {
  return {};
}

std::vector<Pair> near_pairs([[maybe_unused]] const std::vector<Cell>& cell, [[maybe_unused]] const Cell& cells,
                             [[maybe_unused]] const Box& box, [[maybe_unused]] const IsNear& is_near) {
  return {};
}
