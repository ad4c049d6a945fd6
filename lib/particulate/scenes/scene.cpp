#include <particulate/scenes/scene.hpp>

#include <algorithm>
#include <stdexcept>

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

void refuse_length(Eigen::Index given, Eigen::Index N) {
  throw std::invalid_argument(
      fmt::format("scene: vectors of {} particles must hold {} numbers, got {}", N, 3 * N, given));
}

}  // namespace particulate::scenes::detail
