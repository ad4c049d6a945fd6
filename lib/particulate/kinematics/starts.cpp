#include <particulate/kinematics/starts.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <particulate/kinematics/cells.hpp>

namespace particulate::kinematics {

namespace {

constexpr const char* axes = "xyz";

void validate_box(const Box& box) {
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double length = box.lengths[axis];
    if (length > 0.0 && std::isfinite(length) && std::isfinite(box.corner[axis])) continue;
    throw std::invalid_argument(
        fmt::format("start: a box must have a finite corner and lengths that are positive and finite, got {} m from {} "
                    "m in {}",
                    length, box.corner[axis], axes[axis]));
  }
}

void validate_addition(const Eigen::VectorXd& radius, const Addition& to) {
  validate_box(to.box);
  validate(to.domain);
  for (Eigen::Index i = 0; i < radius.size(); ++i) {
    if (radius[i] >= 0.0 && std::isfinite(radius[i])) continue;
    throw std::invalid_argument(
        fmt::format("start: radii must be finite and not negative, got {} m for sphere {}", radius[i], i));
  }
  validate_periods(to.domain, radius);
  if (to.most_attempts < 0) {
    throw std::invalid_argument(
        fmt::format("start: the most attempts must be positive, or 0 for the default, got {}", to.most_attempts));
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (to.box.lengths[axis] <= to.domain.lengths[axis]) continue;
    throw std::invalid_argument(
        fmt::format("start: the box must not be longer than the period, got {} m for a period of {} m in {}",
                    to.box.lengths[axis], to.domain.lengths[axis], axes[axis]));
  }
}

// How far from the edges a centre must stay.
Eigen::Vector3d margin(double radius, const Addition& to) {
  Eigen::Vector3d stay = Eigen::Vector3d::Zero();
  if (to.inside == Inside::centres) return stay;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (std::isinf(to.domain.lengths[axis])) stay[axis] = radius;
  }
  if ((2.0 * stay.array() <= to.box.lengths.array()).all()) return stay;
  throw std::invalid_argument(
      fmt::format("start: a sphere must fit into the box, got a radius of {} m for a shortest edge of {} m: take a "
                  "smaller one, or let centres alone lie inside",
                  radius, to.box.lengths.minCoeff()));
}

[[noreturn]] void give_up(const Eigen::VectorXd& radius, const Addition& to, Eigen::Index placed, long attempts) {
  throw std::invalid_argument(fmt::format(
      "start: spheres must find room one after the other: {} of {} did in {} attempts, which is a volume fraction of "
      "{:.4f} of {:.4f} asked for. At random they come to a standstill at {:.3f} where there are no edges, with 1000 "
      "of "
      "them near 0.35 if they lie wholly inside and near 0.47 if their centres do: take fewer or smaller ones, start "
      "from a lattice, or below that raise most_attempts",
      placed, radius.size(), attempts, volume_fraction(radius.head(placed), to.box), volume_fraction(radius, to.box),
      saturation));
}

bool is_free(const Cells& cells, const Space& domain, const Eigen::Vector3d& place, double radius) {
  bool free = true;
  cells.near(place, radius, 0, [&](const Cells::Body& other) {
    const double apart = radius + other.size;
    free = free && !(separation(domain, place, other.place).squaredNorm() < apart * apart);
  });
  return free;
}

}  // namespace

std::function<double()> uniform_from(std::uint64_t seed) {
  return [engine = std::mt19937_64(seed)]() mutable { return static_cast<double>(engine() >> 11) * 0x1p-53; };
}

double volume_fraction(const Eigen::VectorXd& radius, const Box& box) {
  return 4.0 / 3.0 * std::numbers::pi * radius.array().cube().sum() / box.lengths.prod();
}

Added random_addition(const Eigen::VectorXd& radius, const Addition& to, const std::function<double()>& uniform) {
  validate_addition(radius, to);
  const Eigen::Index N = radius.size();
  Added added{.position = Vectors(N, 3)};
  if (N == 0) return added;
  const long most = to.most_attempts > 0 ? to.most_attempts : std::max(1'000'000L, 1000L * static_cast<long>(N));
  // Points overlap nothing, but cells have edges.
  const double spacing = std::cbrt(to.box.lengths.prod() / static_cast<double>(N));
  const double smallest = radius.minCoeff();
  Cells cells(to.domain, to.box.lengths, smallest > 0.0 ? 2.0 * smallest : spacing, N);
  for (Eigen::Index i = 0; i < N; ++i) {
    const Eigen::Vector3d stay = margin(radius[i], to), room = to.box.lengths - 2.0 * stay;
    Eigen::Vector3d place;
    do {
      if (added.attempts++ == most) give_up(radius, to, i, most);
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        place[axis] = to.box.corner[axis] + stay[axis] + room[axis] * uniform();
      }
    } while (!is_free(cells, to.domain, place, radius[i]));
    cells.insert(i, place, radius[i]);
    set_vector(added.position, i, place);
  }
  return added;
}

Vectors lattice(Lattice kind, Eigen::Index N, double edge) {
  if (!(N >= 0 && edge > 0.0 && std::isfinite(edge))) {
    throw std::invalid_argument(fmt::format(
        "lattice: must have places, not fewer than none, and a positive and finite edge, got {} and {} m", N, edge));
  }
  static const std::vector<Eigen::Vector3d> middle = {{0.5, 0.5, 0.5}};
  static const std::vector<Eigen::Vector3d> faces = {
      {0.25, 0.25, 0.25}, {0.75, 0.75, 0.25}, {0.75, 0.25, 0.75}, {0.25, 0.75, 0.75}};
  const std::vector<Eigen::Vector3d>& basis = kind == Lattice::simple_cubic ? middle : faces;
  const auto places = static_cast<Eigen::Index>(basis.size());
  Eigen::Index n = 0;
  while (places * n * n * n < N) ++n;
  Vectors position(N, 3);
  for (Eigen::Index i = 0; i < N; ++i) {
    const Eigen::Index cell = i / places, row = cell / n, layer = row / n;
    const Eigen::Vector3d corner(static_cast<double>(cell % n), static_cast<double>(row % n),
                                 static_cast<double>(layer));
    set_vector(position, i, edge * (corner + basis[static_cast<std::size_t>(i % places)]));
  }
  return position;
}

namespace {

constexpr std::array<std::string_view, 9> columns = {"x", "y", "z", "vx", "vy", "vz", "m", "b", "immovable"};

// One line of a file of particles.
struct Line {
  const std::vector<std::string>& fields;
  const std::string& origin;
  std::size_t number;

  [[noreturn]] void refuse(const std::string& what) const {
    throw std::invalid_argument(fmt::format("{}:{}: {}", origin, number, what));
  }
  double at(std::size_t column) const {
    std::string_view text = fields[column];
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc{} && end == text.data() + text.size() && std::isfinite(value)) return value;
    refuse(fmt::format("{} must be a finite number, got \"{}\"", columns[column], fields[column]));
  }
};

void validate_header(const Line& header) {
  const std::size_t given = header.fields.size();
  const bool right = (given == columns.size() || given + 1 == columns.size()) &&
                     std::equal(header.fields.begin(), header.fields.end(), columns.begin());
  if (right) return;
  header.refuse(
      fmt::format("a file of particles must begin with the line \"x,y,z,vx,vy,vz,m,b\", and \",immovable\" if some do "
                  "not move, got \"{}\": write it above the numbers, in this order",
                  fmt::join(header.fields, ",")));
}

}  // namespace

Particles particles_from(const std::vector<std::vector<std::string>>& lines, const std::string& origin) {
  static const std::vector<std::string> nothing;
  const std::vector<std::string>& header = lines.empty() ? nothing : lines.front();
  validate_header({header, origin, 1});
  std::vector<Particle> list;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const Line line{lines[k], origin, k + 1};
    if (line.fields.size() != header.size()) {
      line.refuse(fmt::format("must hold {} columns, {}, got {}: write one particle a line", header.size(),
                              fmt::join(header, ","), line.fields.size()));
    }
    const double immovable = header.size() == columns.size() ? line.at(8) : 0.0;
    if (!(line.at(6) > 0.0)) line.refuse(fmt::format("m must be positive, in kg, got {}", line.at(6)));
    if (!(line.at(7) >= 0.0)) line.refuse(fmt::format("b must not be negative, in m, got {}", line.at(7)));
    if (immovable != 0.0 && immovable != 1.0) line.refuse(fmt::format("immovable must be 0 or 1, got {}", immovable));
    list.push_back({.position = {line.at(0), line.at(1), line.at(2)},
                    .velocity = {line.at(3), line.at(4), line.at(5)},
                    .mass = line.at(6),
                    .radius = line.at(7),
                    .immovable = immovable == 1.0});
  }
  return particles(list);
}

namespace {

// What overlaps deepest: two spheres, or one and a wall.
struct Deepest {
  double depth = 0.0, within_rounding = 0.0;  // beyond what rounding explains, and not
  Eigen::Index i = -1, j = -1, wall = -1;
};

Deepest deepest_overlap(const Particles& particles, const Space& domain) {
  // Of places and radii: roundings of a long run add up.
  constexpr double added_up = 1e-12;
  const Eigen::VectorXd inverse_mass = inverse_masses(particles), &radius = particles.radius;
  const Eigen::RowVector3d extent = particles.position.colwise().maxCoeff() - particles.position.colwise().minCoeff();
  const double largest = radius.maxCoeff();
  const double edge = (radius.array() > 0.0).select(2.0 * radius, 2.0 * largest).minCoeff();
  Deepest worst;
  if (!(edge > 0.0)) return worst;  // points
  Cells cells(domain, extent, edge, particles.size());
  for (Eigen::Index i = 0; i < particles.size(); ++i) {
    const Eigen::Vector3d here = particles.position.row(i);
    const auto look_at = [&](double gap, double far, Eigen::Index j, Eigen::Index wall) {
      double& deepest = -gap > added_up * far ? worst.depth : worst.within_rounding;
      if (-gap <= deepest) return;
      deepest = -gap;
      if (&deepest == &worst.depth) worst.i = i, worst.j = j, worst.wall = wall;
    };
    const int any_level = 0;
    cells.near(here, radius[i], any_level, [&](const auto& body) {
      if (!(inverse_mass[i] > 0.0 || inverse_mass[body.index] > 0.0)) return;
      const double apart = length(separation(domain, here, body.place));
      look_at(apart - radius[i] - body.size, here.norm() + body.place.norm() + radius[i] + body.size, body.index, -1);
    });
    cells.insert(i, here, radius[i]);
    for (std::size_t k = 0; k < domain.walls.size() && inverse_mass[i] > 0.0; ++k) {
      const Wall& wall = domain.walls[k];
      look_at(height_above(wall, here) - radius[i], here.norm() + wall.point.norm() + radius[i], -1,
              static_cast<Eigen::Index>(k));
    }
  }
  return worst;
}

}  // namespace

double validate_apart(const Particles& particles, const Space& domain) {
  validate(particles);
  validate(domain);
  const Deepest worst = particles.size() > 0 ? deepest_overlap(particles, domain) : Deepest{};
  if (worst.i < 0) return worst.within_rounding;
  const std::string who = worst.wall < 0 ? fmt::format("spheres {} and {}", worst.j, worst.i)
                                         : fmt::format("sphere {} and wall {}", worst.i, worst.wall);
  throw std::invalid_argument(fmt::format(
      "start: no two spheres may overlap, nor a sphere and a wall; {} overlap by {} m, deepest of all: move "
      "them apart, make them smaller, or take stepped contacts (Contact)",
      who, worst.depth));
}

namespace {

// The lowest 21 bits, with two zeros after each.
std::uint64_t spread(std::uint64_t bits) {
  bits &= 0x1fffff;
  bits = (bits | bits << 32) & 0x1f00000000ffff;
  bits = (bits | bits << 16) & 0x1f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  return (bits | bits << 2) & 0x1249249249249249;
}

}  // namespace

std::vector<Eigen::Index> order_by_cells(const VectorsIn& position, double edge) {
  if (!(edge > 0.0)) throw std::invalid_argument(fmt::format("order: cells must have a positive edge, got {} m", edge));
  if (position.rows() == 0) return {};
  constexpr double last = 0x1fffff;
  const Eigen::RowVector3d least = position.colwise().minCoeff();
  std::vector<std::pair<std::uint64_t, Eigen::Index>> places;  // along the curve, and whose
  for (Eigen::Index i = 0; i < position.rows(); ++i) {
    std::uint64_t place = 0;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      // Beyond so many cells they share the last one.
      const double cell = std::min(last, std::floor((position(i, axis) - least[axis]) / edge));
      place |= spread(static_cast<std::uint64_t>(cell)) << axis;
    }
    places.emplace_back(place, i);
  }
  std::sort(places.begin(), places.end());
  std::vector<Eigen::Index> order(places.size());
  std::transform(places.begin(), places.end(), order.begin(), [](const auto& one) { return one.second; });
  return order;
}

Particles reordered(const Particles& particles, const std::vector<Eigen::Index>& order) {
  const Eigen::Index N = particles.size();
  std::vector<Eigen::Index> sorted = order, all(static_cast<std::size_t>(N));
  std::sort(sorted.begin(), sorted.end());
  std::iota(all.begin(), all.end(), Eigen::Index{0});
  if (sorted != all) {
    throw std::invalid_argument(
        fmt::format("order: must name each of {} particles once, got {} numbers that do not", N, order.size()));
  }
  return chosen(particles, order);
}

}  // namespace particulate::kinematics
