#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <particulate/kinematics/starts.hpp>

namespace particulate::scattering {

/// A ball and a box about the same centre, each of which contains a body.
struct Bound {
  Eigen::Vector3d centre;        ///< [m]
  double radius;                 ///< of the ball [m]
  Eigen::Vector3d half_extents;  ///< of the box: how far the body reaches in each direction [m]
};

/// Cubic cells of a box, about one for each body, and the bodies that each may contain: a ray then meets few of them.
///
/// Bodies are sorted by their bounds, which count as larger by a millionth of a cell, so that rounding of a walk
/// along a ray loses none. A cell names its bodies in ascending order, whoever built it.
class Grid {
 public:
  /// @param box      which contains all bodies
  /// @param bounds   of the bodies, in their order
  /// @param threads  that build it, >= 1; the same grid for any number
  /// @throws std::invalid_argument for a box that is none
  Grid(const kinematics::Box& box, std::span<const Bound> bounds, int threads = 1);

  /// Walks along a ray, cell by cell: visit(bodies, end) gets the numbers of the bodies of each cell and the distance
  /// after which the ray leaves that cell, and returns whether to go on.
  ///
  /// @param from       a place [m]
  /// @param direction  a unit vector
  /// @param visit      is called with every cell on the way through the box, in order
  template <class Visit>
  void walk(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, Visit&& visit) const {
    Walk at;
    if (!begin(from, direction, at)) return;
    for (;;) {
      // The nearest end, without a branch, whose way could not be guessed.
      const auto is_y = static_cast<std::size_t>(at.next[1] < at.next[2]);
      const auto not_x =
          static_cast<std::size_t>(at.next[0] >= at.next[1]) | static_cast<std::size_t>(at.next[0] >= at.next[2]);
      const std::size_t axis = not_x * (2 - is_y);
      const std::uint32_t first = first_[static_cast<std::size_t>(at.cell)];
      const std::uint32_t last = first_[static_cast<std::size_t>(at.cell) + 1];
      if (!visit(std::span(body_).subspan(first, last - first), at.next[axis])) return;
      if (--at.left[axis] < 0) return;
      at.cell += at.stride[axis];
      at.next[axis] += at.step[axis];
    }
  }

  /// Calls visit(i, j), i < j, for the bodies that one cell names, once for each such cell: bodies that overlap are
  /// among them.
  ///
  /// @param visit  is called with two numbers
  template <class Visit>
  void each_pair(Visit&& visit) const {
    for (std::size_t cell = 0; cell + 1 < first_.size(); ++cell) {
      for (std::uint32_t a = first_[cell]; a < first_[cell + 1]; ++a) {
        for (std::uint32_t b = a + 1; b < first_[cell + 1]; ++b) visit(body_[a], body_[b]);
      }
    }
  }

  /// @param place  in the box [m]
  /// @return numbers of the bodies that may contain it; empty outside of the box
  std::span<const std::int32_t> near(const Eigen::Vector3d& place) const;

  /// @return cells in each direction
  const std::array<std::int64_t, 3>& cells() const { return cells_; }

 private:
  // A walk: the cell, and in each direction the distance to its end, from one end to the next, and the cells that are
  // left.
  struct Walk {
    std::int64_t cell;
    std::array<double, 3> next, step;
    std::array<std::int64_t, 3> left, stride;
  };
  bool contains(const Eigen::Vector3d& place) const;
  double entry(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const;
  bool begin(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, Walk& at) const;
  std::int64_t index(double place, int axis) const;
  template <class Visit>
  void each_cell(const Bound& bound, Visit&& visit) const;

  Eigen::Vector3d corner_, edge_, per_edge_, far_;
  std::array<std::int64_t, 3> cells_{};
  std::vector<std::uint32_t> first_;
  std::vector<std::int32_t> body_;
};

}  // namespace particulate::scattering
