#pragma once

#include <array>
#include <functional>
#include <vector>

#include <Eigen/Core>

/// @file
/// The header to keep: write these functions in cell_list.cpp, and change nothing here. Only your variant is to be
/// coded, which the head of the score table names: run the check once to learn it.

/// Where the bodies are: from 0 up to, without, a length in each direction, in some of which everything repeats itself.
struct Box {
  Eigen::Vector3d length = Eigen::Vector3d::Ones();  ///< in each direction, > 0 [m]
  std::array<bool, 3> periodic = {};                 ///< whether places a length apart are the same, in each direction
};

/// In each direction the number of a cell, from 0, or how many cells there are.
using Cell = std::array<int, 3>;

/// Two bodies within reach of one another.
struct Pair {
  int i = 0;  ///< one body, counted from 0
  int j = 0;  ///< the other, j > i
};

/// Whether the distance of two bodies is at most the reach. It knows their places; each call is counted.
using IsNear = std::function<bool(int i, int j)>;

/// The shortest of a separation and those of its images, direction by direction.
/// @param d    from one place to another; may be many lengths long [m]
/// @param box  the box
/// @return d, less whole lengths in periodic directions, so that there no component is longer than half a length [m]
Eigen::Vector3d nearest_image(const Eigen::Vector3d& d, const Box& box);

/// How many cells fit: all of the same length, which must not be too short.
/// @param box    the box
/// @param reach  of a pair, > 0; may be longer than the box [m]
/// @return in each direction the largest number of cells that your variant allows, but at least 1
Cell cells_across(const Box& box, double reach);

/// The cell of a place. Cell number c reaches from c up to, without, c + 1 lengths of a cell.
/// @param place  a place; it may have left the box, by many lengths [m]
/// @param box    the box
/// @param cells  how many in each direction, >= 1
/// @return in periodic directions the cell of its image in the box; in others the first or the last one where the place
///         lies before or behind all
Cell cell_of(const Eigen::Vector3d& place, const Box& box, const Cell& cells);

/// All pairs within reach.
/// @param cell     of each body
/// @param cells    how many in each direction, as many as your cells_across() must give
/// @param box      the box
/// @param is_near  tells whether two bodies are within reach; ask it no more than is needed
/// @return each pair once, i < j, ascending by i, and by j for the same i
std::vector<Pair> near_pairs(const std::vector<Cell>& cell, const Cell& cells, const Box& box, const IsNear& is_near);
