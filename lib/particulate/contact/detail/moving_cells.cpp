#include <particulate/contact/detail/moving_cells.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
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
  const int top = level_of(radius.maxCoeff(), edge);
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
  std::vector<std::int32_t> level_at(static_cast<std::size_t>(top) + 1, -1);
  for (const double b : radius) {
    const int number = level_of(b, edge);
    std::int32_t& here = level_at[static_cast<std::size_t>(number)];
    if (here < 0) {
      here = static_cast<std::int32_t>(levels_.size());
      levels_.push_back({.number = number, .largest = 0.0, .lists = {}, .head = {}});
    }
    Level& level = levels_[static_cast<std::size_t>(here)];
    level.largest = std::max(level.largest, b);
    residents_.push_back({.cell = {}, .level = here, .next = -1, .before = -1, .radius = b});
  }
  for (Level& level : levels_) {
    std::size_t lists = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const double wide = extent[static_cast<Eigen::Index>(k)] / std::ldexp(edge, level.number);
      level.lists[k] = axes_[k].repeats
                           ? axes_[k].cells >> level.number
                           : static_cast<std::int64_t>(std::bit_ceil(static_cast<std::uint64_t>(wide) + 1));
      lists *= static_cast<std::size_t>(level.lists[k]);
    }
    level.head.assign(lists, -1);
  }
}

std::int32_t& MovingCells::list_of(std::int32_t i) {
  const Resident& one = residents_[static_cast<std::size_t>(i)];
  Level& level = levels_[static_cast<std::size_t>(one.level)];
  std::int64_t list = 0;
  for (std::size_t k = 3; k-- > 0;) {
    list = list * level.lists[k] + place(level, k, one.cell[k] >> level.number).list;
  }
  return level.head[static_cast<std::size_t>(list)];
}

void MovingCells::link(std::int32_t i) {
  Resident& one = residents_[static_cast<std::size_t>(i)];
  one.next = std::exchange(list_of(i), i);
  one.before = -1;
  if (one.next >= 0) residents_[static_cast<std::size_t>(one.next)].before = i;
}

void MovingCells::unlink(std::int32_t i) {
  const Resident& one = at(i);
  (one.before >= 0 ? residents_[static_cast<std::size_t>(one.before)].next : list_of(i)) = one.next;
  if (one.next >= 0) residents_[static_cast<std::size_t>(one.next)].before = one.before;
}

void MovingCells::insert(std::int32_t i, const Eigen::Vector3d& place) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto cell = static_cast<std::int64_t>(std::floor(place[static_cast<Eigen::Index>(k)] * axes_[k].per_length));
    residents_[static_cast<std::size_t>(i)].cell[k] =
        axes_[k].repeats ? std::clamp(cell, std::int64_t{0}, axes_[k].cells - 1) : cell;
  }
  link(i);
}

double MovingCells::cross(std::int32_t i, Eigen::Index axis, bool upwards) {
  const auto k = static_cast<std::size_t>(axis);
  std::int64_t& cell = residents_[static_cast<std::size_t>(i)].cell[k];
  std::int64_t next = cell + (upwards ? 1 : -1);
  double periods = 0.0;
  if (axes_[k].repeats && (next < 0 || next >= axes_[k].cells)) {
    periods = upwards ? -1.0 : 1.0;
    next = upwards ? 0 : axes_[k].cells - 1;
  }
  const int number = levels_[static_cast<std::size_t>(at(i).level)].number;
  const bool moves = (next >> number) != (cell >> number);
  if (moves) unlink(i);
  cell = next;
  if (moves) link(i);
  return periods;
}

}  // namespace particulate::contact::detail
