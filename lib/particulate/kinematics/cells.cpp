#include <particulate/kinematics/cells.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace particulate::kinematics {

namespace {

constexpr double rounding_unit = std::numeric_limits<double>::epsilon();
// The number of a cell stays finite.
constexpr double farthest_cell = 1e300;

// std::floor() is a call where the processor need not have an instruction for it.
double whole(double x) {
  if (!(std::abs(x) < 1e15)) return std::floor(x);
  const double towards_zero = static_cast<double>(static_cast<std::int64_t>(x));
  return towards_zero > x ? towards_zero - 1.0 : towards_zero;
}

// Which of so many cells that repeat themselves; whole numbers are held exactly, however large.
std::int64_t folded(double cell, std::int64_t cells) {
  const double n = static_cast<double>(cells);
  if (cell >= 0.0 && cell < n) return static_cast<std::int64_t>(cell);
  if (std::abs(cell) < 1e15) return static_cast<std::int64_t>(cell - n * whole(cell / n));
  const double rest = std::fmod(cell, n);
  return static_cast<std::int64_t>(rest < 0.0 ? rest + n : rest);
}

}  // namespace

Cells::Cells(const Space& domain, const Eigen::Vector3d& extent, double edge, Eigen::Index bodies)
    : periods_(domain.lengths), extent_(extent), edge_(edge), most_bodies_(bodies) {
  if (!(edge > 0.0 && std::isfinite(edge))) {
    throw std::invalid_argument(fmt::format("cells: their edge must be positive and finite, got {} m", edge));
  }
  if (bodies > std::numeric_limits<std::int32_t>::max()) {
    throw std::invalid_argument(fmt::format("cells: they hold up to {} bodies, asked for were {}",
                                            std::numeric_limits<std::int32_t>::max(), bodies));
  }
  bodies_.reserve(static_cast<std::size_t>(bodies));
}

int Cells::level(double size) const {
  const double edges = 2.0 * size / edge_;
  if (!(edges > 1.0)) return 0;
  if (!std::isfinite(edges)) return std::numeric_limits<double>::max_exponent;
  int exponent = 0;
  return std::frexp(edges, &exponent) == 0.5 ? exponent - 1 : exponent;
}

// With room for so many bodies.
Cells::Level Cells::empty_level(int number, std::int64_t room) const {
  const double edge = std::ldexp(edge_, number);
  const std::int64_t most_cells = 2 * room;
  Level level{.number = number, .bodies = 0, .room = room, .largest = 0.0, .axis = {}, .head = {}};
  std::array<std::int64_t, 3> whole{}, kept{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const double length = std::isfinite(periods_[axis]) ? periods_[axis] : extent_[axis] + edge;
    whole[k] = static_cast<std::int64_t>(std::max(1.0, std::min(1e15, std::floor(length / edge))));
    kept[k] = std::min(whole[k], most_cells);
  }
  const auto cells = [&] {
    return static_cast<double>(kept[0]) * static_cast<double>(kept[1]) * static_cast<double>(kept[2]);
  };
  while (cells() > static_cast<double>(most_cells)) {
    std::int64_t& longest = *std::max_element(kept.begin(), kept.end());
    longest -= (longest + 7) / 8;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double period = periods_[static_cast<Eigen::Index>(k)];
    // A period holds a multiple of the cells that are kept, so that they repeat themselves with it.
    const std::int64_t per_period = whole[k] - whole[k] % kept[k];
    level.axis[k] = {std::isfinite(period) ? static_cast<double>(per_period) / period : 1.0 / edge, kept[k]};
  }
  level.head.assign(static_cast<std::size_t>(cells()), -1);
  return level;
}

// Rounding never takes a place out of the cut: what is rounded alike keeps its order, and the rest is allowed for.
Cells::Cut Cells::cut(const Axis& axis, double place, double reach, double rounding) {
  const double margin = reach * (1.0 + 1e-12) + rounding;
  const double from = whole(std::clamp((place - margin) * axis.per_length, -farthest_cell, farthest_cell));
  const double to = whole(std::clamp((place + margin) * axis.per_length, -farthest_cell, farthest_cell));
  if (!(to - from + 1.0 < static_cast<double>(axis.cells))) return {0, axis.cells};
  return {folded(from, axis.cells), static_cast<std::int64_t>(to - from) + 1};
}

std::array<Cells::Cut, 3> Cells::cuts(const Level& level, const Eigen::Vector3d& place, double reach) const {
  std::array<Cut, 3> all{};
  if (!place.allFinite()) return all;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    // The cells of places that are periods apart are the same but for the roundings of both.
    const double far = std::abs(place[axis]) + (std::isfinite(periods_[axis]) ? farthest_[axis] + periods_[axis] : 0.0);
    all[k] = cut(level.axis[k], place[axis], reach, 8.0 * rounding_unit * far);
  }
  return all;
}

void Cells::insert(Eigen::Index index, const Eigen::Vector3d& place, double size) {
  if (!(place.allFinite() && std::isfinite(size))) return;
  const int number = level(size);
  auto here = std::find_if(levels_.begin(), levels_.end(), [&](const Level& one) { return one.number == number; });
  if (here == levels_.end()) here = levels_.insert(here, empty_level(number, 1));
  farthest_ = farthest_.cwiseMax(place.cwiseAbs());
  bodies_.push_back({.place = place, .size = size, .index = static_cast<std::int32_t>(index), .next = -1});
  if (here->bodies == here->room) {
    // Its bodies move into more cells.
    *here = empty_level(number, std::min(8 * here->room, std::max(most_bodies_, here->room + 1)));
    for (std::size_t k = 0; k + 1 < bodies_.size(); ++k) {
      if (level(bodies_[k].size) == number) put(static_cast<std::int32_t>(k), *here);
    }
  }
  put(static_cast<std::int32_t>(bodies_.size()) - 1, *here);
}

void Cells::put(std::int32_t body, Level& level) {
  Body& one = bodies_[static_cast<std::size_t>(body)];
  std::int64_t cell = 0;
  for (std::size_t k = 3; k-- > 0;) {
    cell = cell * level.axis[k].cells + cut(level.axis[k], one.place[static_cast<Eigen::Index>(k)], 0.0, 0.0).first;
  }
  one.next = std::exchange(level.head[static_cast<std::size_t>(cell)], body);
  level.largest = std::max(level.largest, one.size);
  ++level.bodies;
}

}  // namespace particulate::kinematics
