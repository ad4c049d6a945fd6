// Accident: a loop without end, in one function.
// graded: --variant 1|2 --student anna -> 0
// hint: took too long
// hint: a loop does not end

#include "cell_list.hpp"

Eigen::Vector3d nearest_image(const Eigen::Vector3d&, const Box&) { return Eigen::Vector3d::Zero(); }

Cell cells_across(const Box&, double) {
  for (volatile double x = 1.0; x > 0.0;) x = x + 1.0;
  return {};
}

Cell cell_of(const Eigen::Vector3d&, const Box&, const Cell&) { return {}; }

std::vector<Pair> near_pairs(const std::vector<Cell>&, const Cell&, const Box&, const IsNear&) { return {}; }
