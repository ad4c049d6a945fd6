// The library itself, variant 1: its cells sort the bodies by the cells that are given.
// graded: --variant 1 --student anna|bob@school.edu|carla-7 -> 20

#include <algorithm>
#include <cmath>

#include <particulate/kinematics/cells.hpp>
#include <particulate/kinematics/domain.hpp>

#include "cell_list.hpp"

namespace {

namespace kinematics = particulate::kinematics;

constexpr double layers = 1.0;

kinematics::Space space(const Eigen::Vector3d& length, const Box& box) {
  kinematics::Space domain;
  for (int k = 0; k < 3; ++k) {
    if (box.periodic[static_cast<std::size_t>(k)]) domain.lengths[k] = length[k];
  }
  return domain;
}

Eigen::Vector3d places(const Cell& cell) { return {cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5}; }

}  // namespace

Eigen::Vector3d nearest_image(const Eigen::Vector3d& d, const Box& box) {
  return separation(space(box.length, box), Eigen::Vector3d::Zero(), d);
}

Cell cells_across(const Box& box, double reach) {
  const Eigen::Vector3d cells = (layers / reach * box.length).array().floor().max(1.0);
  return {static_cast<int>(cells.x()), static_cast<int>(cells.y()), static_cast<int>(cells.z())};
}

Cell cell_of(const Eigen::Vector3d& place, const Box& box, const Cell& cells) {
  const Eigen::Vector3d image = wrapped(space(box.length, box), place);
  Cell cell{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Index axis = static_cast<Eigen::Index>(k);
    cell[k] = std::clamp(static_cast<int>(std::floor(image[axis] / box.length[axis] * cells[k])), 0, cells[k] - 1);
  }
  return cell;
}

// Bodies stand in the middle of their cells, whose lengths are 1: those in neighbouring ones are sqrt(3) layers apart.
std::vector<Pair> near_pairs(const std::vector<Cell>& cell, const Cell& cells, const Box& box, const IsNear& is_near) {
  const Eigen::Vector3d length(cells[0], cells[1], cells[2]);
  const kinematics::Space domain = space(length, box);
  const double size = 0.5 * layers * std::sqrt(3.0) + 1e-9;
  kinematics::Cells list(domain, length, layers, static_cast<Eigen::Index>(cell.size()));
  std::vector<Pair> pairs;
  for (std::size_t j = 0; j < cell.size(); ++j) {
    list.near(places(cell[j]), size, 0, [&](const kinematics::Cells::Body& body) {
      const Eigen::Vector3d d = separation(domain, places(cell[j]), body.place);
      if (d.cwiseAbs().maxCoeff() < layers + 0.5 && is_near(body.index, static_cast<int>(j))) {
        pairs.push_back({body.index, static_cast<int>(j)});
      }
    });
    list.insert(static_cast<Eigen::Index>(j), places(cell[j]), size);
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const Pair& a, const Pair& b) { return a.i < b.i || (a.i == b.i && a.j < b.j); });
  return pairs;
}
