#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <particulate/kinematics/domain.hpp>

namespace particulate::kinematics {

/// Bodies sorted into cubic cells by their places, so that those near a place are found without looking at all.
///
/// Two bodies are near each other where their distance is at most the sum of their sizes. Cells of level l have edges
/// \f$ h_0 2^l \f$, and a body lies in a cell of the lowest level whose edge is at least twice its size: a large body
/// among small ones does not make their cells large. A level has few cells for each of its bodies: where it would have
/// more, it repeats itself, so that what is far away may share a cell, and one body far from all others costs nothing.
///
/// A place is found at a cost that depends on what is near it alone, as long as sizes are not much larger than
/// spacings. Memory: some 48 to 72 bytes a body.
class Cells {
 public:
  /// A body as it was inserted.
  struct Body {
    Eigen::Vector3d place;  ///< [m]
    double size;            ///< [m]
    std::int32_t index;     ///< its number
    std::int32_t next;      ///< of those in its cell, counted in the order of insertion; negative: none
  };

  /// No body yet.
  ///
  /// @param domain  in whose periods places repeat themselves
  /// @param extent  of the places to come, in each direction; of no import but for the number of cells [m]
  /// @param edge    of the smallest cells, > 0 [m]
  /// @param bodies  about how many there will be, up to 2^31 - 1 [-]
  /// @throws std::invalid_argument for an edge that is not positive and finite, or too many bodies
  Cells(const Space& domain, const Eigen::Vector3d& extent, double edge, Eigen::Index bodies);

  /// @param size  of a body, >= 0 [m]
  /// @return the level of its cell
  int level(double size) const;

  /// Adds a body. One whose place or size is not finite is near nothing.
  ///
  /// @param index  its number
  /// @param place  its place, in any period [m]
  /// @param size   its size, >= 0 [m]
  void insert(Eigen::Index index, const Eigen::Vector3d& place, double size);

  /// Visits every inserted body that may be near a place, once, and some others: the distance is for the visitor to
  /// test.
  ///
  /// @param place        a place, in any period; one that is not finite is near nothing [m]
  /// @param size         what lies there, >= 0 [m]
  /// @param least_level  bodies of lower levels are left out
  /// @param visit        is called with each Body
  template <class F>
  void near(const Eigen::Vector3d& place, double size, int least_level, F&& visit) const {
    for (const Level& level : levels_) {
      if (level.number < least_level) continue;
      const std::array<Cut, 3> cut = cuts(level, place, size + level.largest);
      std::int64_t z = cut[2].first;
      for (std::int64_t c = 0; c < cut[2].count; ++c, z = after(z, level.axis[2])) {
        std::int64_t y = cut[1].first;
        for (std::int64_t b = 0; b < cut[1].count; ++b, y = after(y, level.axis[1])) {
          const std::size_t row = static_cast<std::size_t>((z * level.axis[1].cells + y) * level.axis[0].cells);
          std::int64_t x = cut[0].first;
          for (std::int64_t a = 0; a < cut[0].count; ++a, x = after(x, level.axis[0])) {
            for (std::int32_t k = level.head[row + static_cast<std::size_t>(x)]; k >= 0;) {
              const Body& body = bodies_[static_cast<std::size_t>(k)];
              visit(body);
              k = body.next;
            }
          }
        }
      }
    }
  }

 private:
  // One direction of a level: where the cells have numbers 0, 1, ... without end, they are kept as number modulo cells.
  struct Axis {
    double per_length;   // cells a length [1/m]
    std::int64_t cells;  // that are kept, a divisor of those in a period [-]
  };
  struct Level {
    int number;
    std::int64_t bodies, room;  // room for how many, before there must be more cells [-]
    double largest;             // size of its bodies [m]
    std::array<Axis, 3> axis;
    std::vector<std::int32_t> head;  // of each cell, the body inserted last
  };
  // Neighbouring cells in one direction.
  struct Cut {
    std::int64_t first, count;
  };

  Level empty_level(int number, std::int64_t room) const;
  void put(std::int32_t body, Level& level);
  static Cut cut(const Axis& axis, double place, double reach, double rounding);
  std::array<Cut, 3> cuts(const Level& level, const Eigen::Vector3d& place, double reach) const;
  static std::int64_t after(std::int64_t cell, const Axis& axis) { return cell + 1 < axis.cells ? cell + 1 : 0; }

  Eigen::Vector3d periods_, extent_;
  double edge_;
  std::int64_t most_bodies_;
  Eigen::Vector3d farthest_ = Eigen::Vector3d::Zero();  // of inserted places from the origin, in each direction [m]
  std::vector<Level> levels_;
  std::vector<Body> bodies_;
};

}  // namespace particulate::kinematics
