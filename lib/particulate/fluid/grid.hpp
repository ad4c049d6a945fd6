#pragma once

#include <array>

#include <Eigen/Core>

/// @file
/// Where a fluid is: a box in cells of one size, and what happens at its faces.

namespace particulate::fluid {

template <int Dim>
using Vector = Eigen::Matrix<double, Dim, 1>;  ///< as many numbers as directions

/// A box in equal cells; values stand for the middles of cells.
///
/// @tparam Dim  1, 2 or 3
template <int Dim>
struct Grid {
  std::array<Eigen::Index, Dim> cells = {};   ///< in each direction, >= 4 [-]
  Vector<Dim> lengths = Vector<Dim>::Ones();  ///< of the box's edges, > 0 [m]
  Vector<Dim> corner = Vector<Dim>::Zero();   ///< its least place [m]

  /// @return number of cells
  Eigen::Index size() const {
    Eigen::Index n = 1;
    for (const Eigen::Index along : cells) n *= along;
    return n;
  }
  /// @param axis  direction
  /// @return edge of a cell along it [m]
  double h(int axis) const { return lengths[axis] / static_cast<double>(cells[static_cast<std::size_t>(axis)]); }
  /// @param cell  its numbers along each direction; below 0 and beyond the last they lie outside of the box
  /// @return its middle [m]
  Vector<Dim> centre(const std::array<Eigen::Index, Dim>& cell) const {
    Vector<Dim> x;
    for (int a = 0; a < Dim; ++a)
      x[a] = corner[a] + (static_cast<double>(cell[static_cast<std::size_t>(a)]) + 0.5) * h(a);
    return x;
  }
  /// @param cell  its numbers along each direction
  /// @return its number, x fastest
  Eigen::Index index(const std::array<Eigen::Index, Dim>& cell) const {
    Eigen::Index n = 0;
    for (int a = Dim - 1; a >= 0; --a) n = n * cells[static_cast<std::size_t>(a)] + cell[static_cast<std::size_t>(a)];
    return n;
  }
};

/// Refuses a grid that is none.
///
/// @param grid  the grid
/// @throws std::invalid_argument naming the direction, what must hold and what was given
template <int Dim>
void validate(const Grid<Dim>& grid);

}  // namespace particulate::fluid
