#include <particulate/contact/detail/moving_cells.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <utility>

namespace particulate::contact::detail {

namespace {

// The lowest level whose cells are not shorter than a diameter.
int level_of(double radius, double edge) {
  const double edges = 2.0 * radius / edge;
  return edges > 1.0 ? static_cast<int>(std::ceil(std::log2(edges) - 1e-9)) : 0;
}

// The value below which a share of some numbers lies.
double quantile(std::vector<double>& of, double share) {
  const auto at = of.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(of.size() - 1));
  std::nth_element(of.begin(), at, of.end());
  return *at;
}

}  // namespace

double cell_edge(const kinematics::Space& domain, const kinematics::VectorsIn& position, const Eigen::VectorXd& radius,
                 Eigen::Vector3d& extent) {
  constexpr Eigen::Index enough = 1000;
  constexpr double cells_a_body = 4.0, finer = 0.9, exact = 1e-12, spare = 1.0 + 1e-6;
  const Eigen::Index N = radius.size(), stride = 1 + (N - 1) / enough;
  std::vector<double> sample;
  const auto middle = [&](const auto& column, double from, double to) {
    sample.clear();
    for (Eigen::Index i = 0; i < N; i += stride) sample.push_back(column[i]);
    const double low = quantile(sample, from);
    return quantile(sample, to) - low;
  };
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const bool repeats = std::isfinite(domain.lengths[axis]);
    extent[axis] =
        repeats ? domain.lengths[axis] : middle(position.col(axis), N < 20 ? 0.0 : 0.05, N < 20 ? 1.0 : 0.95);
  }
  double edge = extent.maxCoeff();
  const auto cells = [&](double h) { return (extent / h).cwiseMax(1.0).prod(); };
  while (edge > 0.0 && cells(finer * edge) <= cells_a_body * static_cast<double>(N)) edge *= finer;
  double farthest = 0.0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(domain.lengths[axis])) {
      farthest = std::max(farthest, position.col(axis).cwiseAbs().maxCoeff());
    }
  }
  sample.assign(radius.begin(), radius.end());
  edge = std::max({edge, 2.0 * quantile(sample, 0.9) * spare, exact * farthest});
  return edge > 0.0 ? edge : 1.0;
}

MovingCells::MovingCells(const kinematics::Space& domain, const Eigen::Vector3d& extent, double edge,
                         const Eigen::VectorXd& radius) {
  std::map<int, double> largest;  // of each level
  for (const double b : radius) largest[level_of(b, edge)] = std::max(largest[level_of(b, edge)], b);
  const int top = largest.rbegin()->first;
  for (std::size_t k = 0; k < 3; ++k) {
    const double length = domain.lengths[static_cast<Eigen::Index>(k)];
    const bool repeats = std::isfinite(length);
    std::int64_t cells = 0;
    if (repeats) {
      cells = static_cast<std::int64_t>(std::max(1.0, std::floor(length / std::ldexp(edge, top)))) << top;
    }
    const double own = repeats ? length / static_cast<double>(cells) : edge;
    axes_[k] = {.edge = own, .per_length = 1.0 / own, .repeats = repeats, .cells = cells};
  }
  for (const auto& [number, b] : largest) {
    Level level{.number = number, .largest = b, .lists = {}, .head = {}};
    for (std::size_t k = 0; k < 3; ++k) {
      const double wide = extent[static_cast<Eigen::Index>(k)] / std::ldexp(edge, number);
      level.lists[k] = axes_[k].repeats
                           ? axes_[k].cells >> number
                           : static_cast<std::int64_t>(std::bit_ceil(static_cast<std::uint64_t>(wide) + 1));
    }
    level.head.assign(static_cast<std::size_t>(level.lists[0] * level.lists[1] * level.lists[2]), -1);
    levels_.push_back(std::move(level));
  }
}

void MovingCells::add(const Eigen::Vector3d& place, double radius) {
  std::size_t level = 0;
  while (radius > levels_[level].largest) ++level;
  Resident one{.cell = {}, .level = level};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto cell = static_cast<std::int64_t>(std::floor(place[static_cast<Eigen::Index>(k)] * axes_[k].per_length));
    one.cell[k] = axes_[k].repeats ? std::clamp(cell, std::int64_t{0}, axes_[k].cells - 1) : cell;
  }
  residents_.push_back(one);
  next_.push_back(-1);
  link(static_cast<std::int32_t>(residents_.size()) - 1);
}

std::vector<std::int32_t> MovingCells::in_order() const {
  std::vector<std::int32_t> order;
  for (const Level& level : levels_) {
    for (std::int32_t i : level.head) {
      for (; i >= 0; i = next_[static_cast<std::size_t>(i)]) order.push_back(i);
    }
  }
  return order;
}

void MovingCells::renumber(const std::vector<std::int32_t>& order) {
  const std::vector<Resident> old = residents_;
  for (Level& level : levels_) std::fill(level.head.begin(), level.head.end(), -1);
  for (std::size_t k = order.size(); k-- > 0;) {
    residents_[k] = old[static_cast<std::size_t>(order[k])];
    link(static_cast<std::int32_t>(k));
  }
}

std::int32_t& MovingCells::list_of(std::int32_t i) {
  const Resident& one = at(i);
  Level& level = levels_[one.level];
  std::int64_t list = 0;
  for (std::size_t k = 3; k-- > 0;) {
    list = list * level.lists[k] + place(level, k, one.cell[k] >> level.number).list;
  }
  return level.head[static_cast<std::size_t>(list)];
}

void MovingCells::link(std::int32_t i) { next_[static_cast<std::size_t>(i)] = std::exchange(list_of(i), i); }

double MovingCells::cross(std::int32_t i, Eigen::Index axis, bool upwards) {
  const auto k = static_cast<std::size_t>(axis);
  std::int64_t& cell = residents_[static_cast<std::size_t>(i)].cell[k];
  std::int64_t next = cell + (upwards ? 1 : -1);
  double periods = 0.0;
  if (axes_[k].repeats && (next < 0 || next >= axes_[k].cells)) {
    periods = upwards ? -1.0 : 1.0;
    next = upwards ? 0 : axes_[k].cells - 1;
  }
  const int number = levels_[at(i).level].number;
  if ((next >> number) == (cell >> number)) {
    cell = next;
    return periods;
  }
  std::int32_t* link_to = &list_of(i);
  while (*link_to != i) link_to = &next_[static_cast<std::size_t>(*link_to)];
  *link_to = next_[static_cast<std::size_t>(i)];
  cell = next;
  link(i);
  return periods;
}

}  // namespace particulate::contact::detail
