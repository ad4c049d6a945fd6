#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <set>
#include <tuple>
#include <vector>

#include "cell_list.hpp"

// What a student may well write, for the variant of so many layers of neighbours. Submissions with one mistake take the
// rest from here.
namespace right {

inline Eigen::Vector3d nearest_image(const Eigen::Vector3d& d, const Box& box) {
  Eigen::Vector3d image = d;
  for (int k = 0; k < 3; ++k) {
    if (box.periodic[static_cast<std::size_t>(k)]) image[k] -= box.length[k] * std::round(d[k] / box.length[k]);
  }
  return image;
}

template <int layers>
Cell cells_across(const Box& box, double reach) {
  Cell cells{};
  for (std::size_t k = 0; k < 3; ++k) {
    cells[k] = std::max(1, static_cast<int>(layers * box.length[static_cast<Eigen::Index>(k)] / reach));
  }
  return cells;
}

inline int wrapped(int cell, int cells) { return (cell % cells + cells) % cells; }

inline Cell cell_of(const Eigen::Vector3d& place, const Box& box, const Cell& cells) {
  Cell cell{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Index axis = static_cast<Eigen::Index>(k);
    const int number = static_cast<int>(std::floor(place[axis] / box.length[axis] * cells[k]));
    cell[k] = box.periodic[k] ? wrapped(number, cells[k]) : std::clamp(number, 0, cells[k] - 1);
  }
  return cell;
}

inline std::size_t number(const Cell& cell, const Cell& cells) {
  return static_cast<std::size_t>((cell[2] * cells[1] + cell[1]) * cells[0] + cell[0]);
}

// The numbers of cells within so many layers in one direction, each once.
inline std::vector<int> around(int cell, int cells, bool periodic, int layers) {
  std::set<int> all;
  for (int c = cell - layers; c <= cell + layers; ++c) {
    if (periodic) all.insert(wrapped(c, cells));
    if (!periodic && c >= 0 && c < cells) all.insert(c);
  }
  return {all.begin(), all.end()};
}

// Who lies in each cell.
inline std::vector<std::vector<int>> lists(const std::vector<Cell>& cell, const Cell& cells) {
  std::vector<std::vector<int>> bodies(number(cells, cells) + 1);
  for (std::size_t i = 0; i < cell.size(); ++i) bodies[number(cell[i], cells)].push_back(static_cast<int>(i));
  return bodies;
}

inline void sort(std::vector<Pair>& pairs) {
  std::sort(pairs.begin(), pairs.end(),
            [](const Pair& a, const Pair& b) { return std::tie(a.i, a.j) < std::tie(b.i, b.j); });
}

// Visits the neighbours in one direction.
using Around = std::vector<int> (*)(int cell, int cells, bool periodic, int layers);

// Pairs of all bodies with those in neighbouring cells for which `takes` says so: unsorted.
template <class Takes>
std::vector<Pair> pairs_where(const std::vector<Cell>& cell, const Cell& cells, const Box& box, int layers,
                              const Takes& takes, Around next = around) {
  const std::vector<std::vector<int>> bodies = lists(cell, cells);
  std::vector<Pair> pairs;
  for (int i = 0; i < static_cast<int>(cell.size()); ++i) {
    const Cell& own = cell[static_cast<std::size_t>(i)];
    const std::vector<int> xs = next(own[0], cells[0], box.periodic[0], layers);
    const std::vector<int> ys = next(own[1], cells[1], box.periodic[1], layers);
    const std::vector<int> zs = next(own[2], cells[2], box.periodic[2], layers);
    for (const int z : zs) {
      for (const int y : ys) {
        for (const int x : xs) {
          for (const int j : bodies[number({x, y, z}, cells)]) {
            if (takes(i, j)) pairs.push_back({i, j});
          }
        }
      }
    }
  }
  return pairs;
}

template <int layers>
std::vector<Pair> near_pairs(const std::vector<Cell>& cell, const Cell& cells, const Box& box, const IsNear& is_near) {
  std::vector<Pair> pairs = pairs_where(cell, cells, box, layers, [&](int i, int j) { return i < j && is_near(i, j); });
  sort(pairs);
  return pairs;
}

}  // namespace right
