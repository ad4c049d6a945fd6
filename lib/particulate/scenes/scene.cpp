#include <particulate/scenes/scene.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

namespace particulate::scenes::detail {

void add_jump(schemes::Jump one, schemes::Jump& all) {
  all.impacts += one.impacts;
  all.energy_change += one.energy_change;
  all.overlap = std::max(all.overlap, one.overlap);
  all.travel = std::max(all.travel, one.travel);
  all.evaluations += one.evaluations;
  all.by_law.push_back({.impacts = one.impacts, .energy_change = one.energy_change});
  all.unsettled = std::move(one.unsettled);
  all.accumulates = one.accumulates;
}

// In the order of their longest direction no pair is looked at that is farther apart in it than the nearest so far.
double closest(schemes::In r) {
  const Eigen::Index N = r.size() / 3;
  if (N < 2) return 0.0;
  const Eigen::Map<const kinematics::Vectors> at(r.data(), N, 3);
  Eigen::Index axis = 0;
  (at.colwise().maxCoeff() - at.colwise().minCoeff()).maxCoeff(&axis);
  std::vector<Eigen::Index> order(static_cast<std::size_t>(N));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(), [&](Eigen::Index i, Eigen::Index j) { return at(i, axis) < at(j, axis); });
  double nearest = std::numeric_limits<double>::infinity();
  for (auto i = order.begin(); i != order.end(); ++i) {
    for (auto j = std::next(i); j != order.end() && at(*j, axis) - at(*i, axis) < nearest; ++j) {
      const double apart = (at.row(*j) - at.row(*i)).stableNorm();
      if (apart > 0.0) nearest = std::min(nearest, apart);
    }
  }
  return std::isfinite(nearest) ? nearest : 0.0;
}

void refuse_length(Eigen::Index given, Eigen::Index N) {
  throw std::invalid_argument(
      fmt::format("scene: vectors of {} particles must hold {} numbers, got {}", N, 3 * N, given));
}

}  // namespace particulate::scenes::detail
