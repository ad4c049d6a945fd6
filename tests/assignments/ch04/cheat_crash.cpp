// Accident: bodies are asked for that there are not, and cells far out of bounds.
// graded: --variant 1|2 --student anna -> 0
// hint: crashed
// hint: an index or a pointer is wrong

#include "cell_list.hpp"

namespace {

double far_away() {
  const volatile double here = 0.0;
  const volatile double* const values = &here;
  const volatile long far = 1000000000000;
  return values[far];
}

}  // namespace

Eigen::Vector3d nearest_image(const Eigen::Vector3d&, const Box&) { return Eigen::Vector3d::Constant(far_away()); }

Cell cells_across(const Box&, double) { return {static_cast<int>(far_away()), 0, 0}; }

Cell cell_of(const Eigen::Vector3d&, const Box&, const Cell&) { return {static_cast<int>(far_away()), 0, 0}; }

std::vector<Pair> near_pairs(const std::vector<Cell>& cell, const Cell&, const Box&, const IsNear& is_near) {
  const int N = static_cast<int>(cell.size());
  return {{is_near(-1, N) ? 0 : 1, 1}};
}
