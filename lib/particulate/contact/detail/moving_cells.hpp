#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <particulate/kinematics/domain.hpp>
#include <particulate/kinematics/particles.hpp>

namespace particulate::contact::detail {

// Spheres sorted into cells that they leave one after the other as they fly.
//
// A sphere is somewhere in its cell, an interval of each axis that all spheres share, whatever their sizes: so it is
// known for how long it stays there. It is listed by the level of its size, whose cells are 2^level times as long, so
// that who looks for large spheres far away looks into few cells. Periods are whole numbers of cells of every level;
// where space does not repeat itself the lists do, and spheres far from one another may share one.
class MovingCells {
 public:
  // Of nobody yet; edge is about that of a cell, extent that of the places where space does not repeat itself [m].
  MovingCells(const kinematics::Space& domain, const Eigen::Vector3d& extent, double edge,
              const Eigen::VectorXd& radius);

  // Adds the next sphere, at a place of the first period.
  void add(const Eigen::Vector3d& place, double radius);
  // The numbers of all spheres, list by list.
  std::vector<std::int32_t> in_order() const;
  // Gives sphere order[k] the number k.
  void renumber(const std::vector<std::int32_t>& order);

  // Where the cell of a sphere ends.
  double end(std::int32_t i, Eigen::Index axis, bool upwards) const {
    const auto k = static_cast<std::size_t>(axis);
    return static_cast<double>(at(i).cell[k] + (upwards ? 1 : 0)) * axes_[k].edge;
  }
  const void* where(std::int32_t i) const { return &at(i); }
  // Has a sphere step into the next cell: returns the periods by which its place is to be moved.
  double cross(std::int32_t i, Eigen::Index axis, bool upwards);

  // Visits every sphere j that i may touch while both stay in their cells, and others, as visit(j, image): with whole
  // periods by which j is to be moved. Once for each image that may be touched; i itself is among them.
  template <class F>
  void near(std::int32_t i, F&& visit) const {
    for (const Level& level : levels_) visit_cut(level, cut(level, i), visit);
  }
  // The same of those alone that it may touch since it has crossed into its cell. Levels shift to whole cells towards
  // minus infinity.
  template <class F>
  void news(std::int32_t i, Eigen::Index axis, bool upwards, F&& visit) const {
    for (const Level& level : levels_) {
      Cut all = cut(level, i);
      const auto k = static_cast<std::size_t>(axis);
      const std::int64_t reach = reach_of(level, i, k), now_reached = at(i).cell[k] + (upwards ? reach : -reach);
      all[k] = {now_reached >> level.number, now_reached >> level.number};
      visit_cut(level, all, visit);
    }
  }

 private:
  struct Axis {
    double edge, per_length;  // of a cell [m], its inverse [1/m]
    bool repeats;             // whether space does
    std::int64_t cells;       // in a period, if it does
  };
  struct Level {
    int number;
    double largest;                     // radius of its spheres [m]
    std::array<std::int64_t, 3> lists;  // along each axis; powers of two where space does not repeat itself
    std::vector<std::int32_t> head;     // of each list; negative: none
  };
  struct Resident {
    std::array<std::int64_t, 3> cell;
    std::size_t level;
  };
  struct Interval {
    std::int64_t first, last;
  };
  using Cut = std::array<Interval, 3>;
  // Along one axis: the list of a cell, and in which period it lies.
  struct Place {
    std::int64_t list;
    double period;
  };

  const Resident& at(std::int32_t i) const { return residents_[static_cast<std::size_t>(i)]; }
  // In cells of level zero, rounded up: the same of all of two levels, so that of two who come within reach one crosses
  // into it, and sees the other there.
  std::int64_t reach_of(const Level& level, std::int32_t i, std::size_t k) const {
    const double reach = (levels_[at(i).level].largest + level.largest) * axes_[k].per_length;
    return static_cast<std::int64_t>(reach * (1.0 + 1e-9)) + 1;
  }
  Cut cut(const Level& level, std::int32_t i) const {
    Cut all;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t reach = reach_of(level, i, k), here = at(i).cell[k];
      all[k] = {(here - reach) >> level.number, (here + reach) >> level.number};
    }
    return all;
  }
  Place place(const Level& level, std::size_t k, std::int64_t cell) const {
    const std::int64_t lists = level.lists[k];
    if (!axes_[k].repeats) return {cell & (lists - 1), 0.0};
    Place found{cell, 0.0};
    for (; found.list < 0; found.list += lists) found.period -= 1.0;
    for (; found.list >= lists; found.list -= lists) found.period += 1.0;
    return found;
  }
  void step(const Level& level, std::size_t k, Place& one) const {
    if (++one.list < level.lists[k]) return;
    one.list = 0;
    if (axes_[k].repeats) one.period += 1.0;
  }
  template <class F>
  void visit_cut(const Level& level, const Cut& all, F&& visit) const {
    std::array<std::int64_t, 3> count{};
    std::array<Place, 3> first{};
    for (std::size_t k = 0; k < 3; ++k) {
      count[k] = all[k].last - all[k].first + 1;
      if (!axes_[k].repeats) count[k] = std::min(count[k], level.lists[k]);
      first[k] = place(level, k, all[k].first);
    }
    // Copies: what visit() writes might be members.
    const std::int32_t *const head = level.head.data(), *const next = next_.data();
    const std::int64_t row_lists = level.lists[0];
    const double turn = axes_[0].repeats ? 1.0 : 0.0;
    Place z = first[2];
    for (std::int64_t c = count[2]; c > 0; --c, step(level, 2, z)) {
      Place y = first[1];
      for (std::int64_t b = count[1]; b > 0; --b, step(level, 1, y)) {
        const std::int32_t* const row = head + (z.list * level.lists[1] + y.list) * row_lists;
        Place x = first[0];
        for (std::int64_t a = count[0]; a > 0; --a) {
          for (std::int32_t j = row[x.list]; j >= 0; j = next[j]) {
            visit(j, Eigen::Vector3d(x.period, y.period, z.period));
          }
          if (++x.list < row_lists) continue;
          x.list = 0;
          x.period += turn;
        }
      }
    }
  }
  std::int32_t& list_of(std::int32_t i);
  void link(std::int32_t i);

  std::array<Axis, 3> axes_{};
  std::vector<Level> levels_;
  std::vector<Resident> residents_;
  std::vector<std::int32_t> next_;  // of each sphere in its list; negative: none
};

// The edge of cells of which there are up to four a body, that are not smaller than most bodies, and whose
// numbers are exact; extent receives that of the places, without a tenth of them that may have flown far away [m].
double cell_edge(const kinematics::Space& domain, const kinematics::VectorsIn& position, const Eigen::VectorXd& radius,
                 Eigen::Vector3d& extent);

}  // namespace particulate::contact::detail
