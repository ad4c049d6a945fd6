#include <particulate/scenes/scene.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include <particulate/kinematics/cells.hpp>

namespace particulate::scenes::detail {

void add_jump(schemes::Jump one, schemes::Jump& all) {
  all.impacts += one.impacts;
  all.energy_change += one.energy_change;
  all.heat += one.heat;
  all.released += one.released;
  all.overlap = std::max(all.overlap, one.overlap);
  all.penetration = std::max(all.penetration, one.penetration);
  all.travel = std::max(all.travel, one.travel);
  all.evaluations += one.evaluations;
  all.by_law.push_back({.impacts = one.impacts, .energy_change = one.energy_change});
  all.unsettled = std::move(one.unsettled);
  all.accumulates = one.accumulates;
}

double closest(const kinematics::Space& domain, schemes::In r) {
  constexpr Eigen::Index few = 32;
  const Eigen::Index N = r.size() / 3;
  if (N <= few || !r.allFinite()) return closest<kinematics::Space>(domain, r);
  const Eigen::Map<const kinematics::Vectors> at(r.data(), N, 3);
  double nearest = std::numeric_limits<double>::infinity();
  const auto look_at = [&](const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
    const double apart = kinematics::length(separation(domain, one, other));
    if (apart > 0.0) nearest = std::min(nearest, apart);
  };
  // Some of those that follow one another in the longest direction are near enough for cells with few bodies.
  const Eigen::RowVector3d extent = at.colwise().maxCoeff() - at.colwise().minCoeff();
  Eigen::Index axis = 0;
  extent.maxCoeff(&axis);
  std::vector<Eigen::Index> order(static_cast<std::size_t>(N));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(), [&](Eigen::Index i, Eigen::Index j) { return at(i, axis) < at(j, axis); });
  for (std::size_t k = 1; k < order.size(); ++k) look_at(at.row(order[k - 1]), at.row(order[k]));
  if (!std::isfinite(nearest)) return closest<kinematics::Space>(domain, r);
  kinematics::Cells cells(domain, extent, nearest, N);
  for (const Eigen::Index i : order) {
    const Eigen::Vector3d here = at.row(i);
    const int any_level = 0;
    cells.near(here, 0.5 * nearest, any_level, [&](const auto& body) { look_at(here, body.place); });
    cells.insert(i, here, 0.5 * nearest);
  }
  return nearest;
}

std::string why_no_temperature(schemes::In y) {
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    if (y[i] >= 0.0) continue;
    return fmt::format("particle {} has a temperature of {} K, which must not be negative: take a smaller step", i,
                       y[i]);
  }
  return {};
}

void require_temperatures(const kinematics::Particles& particles) {
  if (particles.temperature.size() == particles.size()) return;
  throw std::invalid_argument(
      "scene: its laws exchange heat, so that every particle must have a temperature and a heat capacity, but they "
      "have none: give Particles::temperature and heat_capacity");
}

void require_temperatures(Eigen::Index given, Eigen::Index N) {
  if (given == N) return;
  throw std::invalid_argument(
      fmt::format("scene: the y of a state must hold a temperature a particle, {}, got {} numbers", N, given));
}

void refuse_length(Eigen::Index given, Eigen::Index N) {
  throw std::invalid_argument(
      fmt::format("scene: vectors of {} particles must hold {} numbers, got {}", N, 3 * N, given));
}

}  // namespace particulate::scenes::detail
