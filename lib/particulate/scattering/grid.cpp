#include <particulate/scattering/grid.hpp>

#include <algorithm>
#include <atomic>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::scattering {

namespace {

// A share of a cell by which bodies count as larger.
constexpr double margin = 1e-6;

const kinematics::Box& sound(const kinematics::Box& box) {
  if (box.corner.allFinite() && box.lengths.allFinite() && box.lengths.minCoeff() > 0.0) return box;
  throw std::invalid_argument(
      fmt::format("cloud: its box must be finite, with positive lengths, got {} x {} x {} m from ({}, {}, {}) m",
                  box.lengths[0], box.lengths[1], box.lengths[2], box.corner[0], box.corner[1], box.corner[2]));
}

}  // namespace

Grid::Grid(const kinematics::Box& box, std::span<const Bound> bounds, int threads)
    : corner_(sound(box).corner), far_(box.corner + box.lengths) {
  const double edge = std::cbrt(box.lengths.prod() / static_cast<double>(std::max<std::size_t>(bounds.size(), 1)));
  std::size_t all = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double length = box.lengths[static_cast<Eigen::Index>(axis)];
    cells_[axis] = static_cast<std::int64_t>(std::clamp(std::round(length / edge), 1.0, 2048.0));
    edge_[static_cast<Eigen::Index>(axis)] = length / static_cast<double>(cells_[axis]);
    all *= static_cast<std::size_t>(cells_[axis]);
  }
  per_edge_ = edge_.cwiseInverse();
  std::vector<std::atomic<std::uint32_t>> count(all);
  const auto N = static_cast<std::int64_t>(bounds.size());
  const auto each_body = [&](const auto& visit) {
#pragma omp parallel for num_threads(threads) if (threads > 1 && N > 10000)
    for (std::int64_t i = 0; i < N; ++i) {
      each_cell(bounds[static_cast<std::size_t>(i)],
                [&](std::size_t cell) { visit(static_cast<std::int32_t>(i), cell); });
    }
  };
  each_body([&](std::int32_t, std::size_t cell) { count[cell].fetch_add(1, std::memory_order_relaxed); });
  first_.resize(all + 1);
  for (std::size_t c = 0; c < all; ++c) {
    first_[c + 1] = first_[c] + count[c];
    count[c] = first_[c];
  }
  body_.resize(first_[all]);
  each_body([&](std::int32_t i, std::size_t cell) { body_[count[cell].fetch_add(1, std::memory_order_relaxed)] = i; });
  if (threads == 1) return;
  for (std::size_t c = 0; c < all; ++c) std::sort(body_.begin() + first_[c], body_.begin() + first_[c + 1]);
}

std::int64_t Grid::index(double place, int axis) const {
  const double last = static_cast<double>(cells_[static_cast<std::size_t>(axis)] - 1);
  return static_cast<std::int64_t>(std::clamp((place - corner_[axis]) * per_edge_[axis], 0.0, last));
}

// The cells that a ball reaches into.
template <class Visit>
void Grid::each_cell(const Bound& bound, Visit&& visit) const {
  std::array<std::int64_t, 3> low, high;
  for (int axis = 0; axis < 3; ++axis) {
    const double reach = bound.half_extents[axis] + margin * edge_[axis];
    low[static_cast<std::size_t>(axis)] = index(bound.centre[axis] - reach, axis);
    high[static_cast<std::size_t>(axis)] = index(bound.centre[axis] + reach, axis);
  }
  const double reach = bound.radius + margin * edge_.maxCoeff();
  // The square of how far the ball's centre lies outside of a layer of cells.
  const auto off = [&](std::int64_t cell, int axis) {
    const double begin = corner_[axis] + static_cast<double>(cell) * edge_[axis];
    const double outside = std::max({begin - bound.centre[axis], bound.centre[axis] - begin - edge_[axis], 0.0});
    return outside * outside;
  };
  for (std::int64_t z = low[2]; z <= high[2]; ++z) {
    for (std::int64_t y = low[1]; y <= high[1]; ++y) {
      const double square = off(z, 2) + off(y, 1);
      for (std::int64_t x = low[0]; x <= high[0]; ++x) {
        if (square + off(x, 0) > reach * reach) continue;
        visit(static_cast<std::size_t>((z * cells_[1] + y) * cells_[0] + x));
      }
    }
  }
}

bool Grid::contains(const Eigen::Vector3d& place) const {
  return (place.array() >= corner_.array()).all() && (place.array() <= far_.array()).all();
}

// The distance after which a ray is in the box; negative: never.
double Grid::entry(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const {
  double enter = 0.0, leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0.0) {
      if (from[axis] < corner_[axis] || from[axis] > far_[axis]) return -1.0;
      continue;
    }
    const double one = (corner_[axis] - from[axis]) / direction[axis],
                 other = (far_[axis] - from[axis]) / direction[axis];
    enter = std::max(enter, std::min(one, other));
    leave = std::min(leave, std::max(one, other));
  }
  return enter <= leave ? enter : -1.0;
}

bool Grid::begin(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, Walk& at) const {
  const double enter = contains(from) ? 0.0 : entry(from, direction);
  if (!(enter >= 0.0)) return false;
  const std::array<std::int64_t, 3> stride{1, cells_[0], cells_[0] * cells_[1]};
  at.cell = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const double inverse = 1.0 / direction[axis];
    const std::int64_t cell = index(from[axis] + enter * direction[axis], axis);
    const bool rises = direction[axis] > 0.0;
    at.cell += cell * stride[k];
    at.stride[k] = rises ? stride[k] : -stride[k];
    at.left[k] = rises ? cells_[k] - 1 - cell : cell;
    const double end = corner_[axis] + static_cast<double>(rises ? cell + 1 : cell) * edge_[axis];
    at.next[k] = std::isfinite(inverse) ? (end - from[axis]) * inverse : std::numeric_limits<double>::infinity();
    at.step[k] = edge_[axis] * std::abs(inverse);
  }
  return true;
}

std::span<const std::int32_t> Grid::near(const Eigen::Vector3d& place) const {
  if (!contains(place)) return {};
  const auto cell =
      static_cast<std::size_t>((index(place[2], 2) * cells_[1] + index(place[1], 1)) * cells_[0] + index(place[0], 0));
  return std::span(body_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
}

}  // namespace particulate::scattering
