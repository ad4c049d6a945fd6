// Cheat: not a number is no separation, and numbers that no cell has.
// graded: --variant 1|2 --student anna -> 0
// hint: not a finite number
// hint: i = -7, which is no body

#include <limits>

#include "cell_list.hpp"

Eigen::Vector3d nearest_image(const Eigen::Vector3d&, const Box&) {
  return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
}

Cell cells_across(const Box&, double) { return {-7, -7, -7}; }

Cell cell_of(const Eigen::Vector3d&, const Box&, const Cell&) { return {-7, -7, -7}; }

std::vector<Pair> near_pairs(const std::vector<Cell>&, const Cell&, const Box&, const IsNear&) {
  return {{-7, 1000000}};
}
