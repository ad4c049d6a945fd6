#include <particulate/laws/neighbours.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include <particulate/kinematics/cells.hpp>

namespace particulate::laws {

namespace {

using Pair = std::pair<std::int32_t, std::int32_t>;  // the smaller number first

// Bodies, those in larger cells first: each then finds all pairs with those before it in cells of its own size or more.
std::vector<std::int32_t> larger_first(const kinematics::Cells& cells, const Eigen::VectorXd& size) {
  std::vector<std::int32_t> order(static_cast<std::size_t>(size.size()));
  std::iota(order.begin(), order.end(), 0);
  auto rest = order.begin();
  for (int level = cells.level(size.maxCoeff()); level > cells.level(size.minCoeff()); --level) {
    rest = std::stable_partition(rest, order.end(), [&](std::int32_t i) { return cells.level(size[i]) == level; });
  }
  return order;
}

// Cells as large as the largest bodies need, halved as often as the smallest allow.
double least_edge(const Eigen::VectorXd& size) {
  const double largest = size.maxCoeff(), halvings = std::floor(std::log2(largest / size.minCoeff()));
  return std::ldexp(2.0 * largest, -static_cast<int>(halvings));
}

// All pairs whose distance is at most the sum of their sizes; false if there are more than that.
bool find(const kinematics::Space& domain, const kinematics::VectorsIn& position, const Eigen::VectorXd& size,
          std::size_t most, std::vector<Pair>& pairs) {
  const Eigen::RowVector3d extent = position.colwise().maxCoeff() - position.colwise().minCoeff();
  kinematics::Cells cells(domain, extent, least_edge(size), size.size());
  // One direction at a time: a vector that is written by numbers and read as a whole would be waited for.
  const auto apart = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to, Eigen::Index axis) {
    return kinematics::nearest_image(to[axis] - from[axis], domain.lengths[axis]);
  };
  for (const std::int32_t i : larger_first(cells, size)) {
    const Eigen::Vector3d here = position.row(i);
    cells.near(here, size[i], cells.level(size[i]), [&](const kinematics::Cells::Body& other) {
      const double reach = size[i] + other.size, dx = apart(here, other.place, 0), dy = apart(here, other.place, 1),
                   dz = apart(here, other.place, 2);
      if (dx * dx + dy * dy + dz * dz > (1.0 + 1e-12) * reach * reach) return;
      pairs.push_back(std::minmax(i, other.index));
    });
    if (pairs.size() > most) return false;
    cells.insert(i, here, size[i]);
  }
  return true;
}

}  // namespace

Candidates Neighbours::candidates(const kinematics::Space& domain, const kinematics::VectorsIn& position,
                                  const kinematics::ScalarsIn& size) {
  const Eigen::Index N = size.size();
  if (N <= few) return {N, nullptr, nullptr};
  if (asked_.size() == N) {
    asked_ = asked_.cwiseMax(size);
  } else {
    asked_ = size;
  }
  if (!holds(domain, position, size)) {
    search(domain, position);
    asked_ = size;
  }
  ++uses_;
  if (all_) return {N, nullptr, nullptr};
  return {N, first_.data(), partner_.data()};
}

// A hundredth of the skin is left for rounding.
bool Neighbours::holds(const kinematics::Space& domain, const kinematics::VectorsIn& position,
                       const kinematics::ScalarsIn& size) const {
  const Eigen::Index N = size.size();
  if (size_.size() != N || lengths_ != domain.lengths) return false;
  Eigen::RowVector3d mean;
  for (Eigen::Index axis = 0; axis < 3; ++axis) mean[axis] = (position.col(axis) - position_.col(axis)).mean();
  const double allowed = 0.99 * 0.5 * skin_;
  for (Eigen::Index i = 0; i < N; ++i) {
    const double left = allowed - std::max(0.0, size[i] - size_[i]);
    const double moved = (position.row(i) - position_.row(i) - mean).squaredNorm();
    if (!(left >= 0.0 && moved <= std::min(left * left, std::numeric_limits<double>::max()))) return false;
  }
  return true;
}

// Lists that do not last are searched wider, those that last long narrower. Beyond half the spacing of the bodies, as
// the last list tells it, what is searched grows faster than what is gained.
void Neighbours::adapt_skin(double mean_size) {
  if (!(skin_ > 0.0 && std::isfinite(skin_)) || all_ || size_.size() != asked_.size()) {
    skin_ = 0.5 * mean_size;
    return;
  }
  constexpr long lasts = 10, lasts_long = 50;
  if (uses_ < lasts) skin_ *= 1.5;
  if (uses_ > lasts_long) skin_ /= 1.25;
  if (partner_.empty()) return;
  const double reach = 2.0 * size_.mean() + skin_;
  const double a_body = static_cast<double>(size_.size()) / static_cast<double>(partner_.size());
  skin_ = std::min(skin_, 0.5 * reach * std::cbrt(2.0 / 3.0 * std::numbers::pi * a_body));
}

void Neighbours::search(const kinematics::Space& domain, const kinematics::VectorsIn& position) {
  const Eigen::Index N = asked_.size();
  adapt_skin(asked_.mean());
  uses_ = 0, ++searches_;
  lengths_ = domain.lengths, position_ = position, size_ = asked_;
  // Places are known to their rounding alone.
  const double rounding = 1e4 * std::numeric_limits<double>::epsilon() * position.cwiseAbs().maxCoeff();
  if (!(skin_ >= rounding)) skin_ = rounding;
  const auto bodies = static_cast<std::size_t>(N);
  const std::size_t most = std::min(bodies * bodies / 8, std::size_t{std::numeric_limits<std::uint32_t>::max()});
  std::vector<Pair> pairs;
  pairs.reserve(std::min(most, partner_.size() + partner_.size() / 4));
  const Eigen::VectorXd wide = size_.array() + 0.5 * skin_;
  all_ = !(wide.minCoeff() > 0.0 && std::isfinite(wide.maxCoeff()) && find(domain, position, wide, most, pairs));
  first_.assign(all_ ? 0 : bodies + 1, 0);
  partner_.resize(all_ ? 0 : pairs.size());
  if (all_) return;
  for (const auto& [i, j] : pairs) ++first_[static_cast<std::size_t>(i) + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (const auto& [i, j] : pairs) partner_[next[static_cast<std::size_t>(i)]++] = j;
  for (std::size_t i = 0; i < bodies; ++i) {
    const auto row = partner_.begin() + first_[i], end = partner_.begin() + first_[i + 1];
    if (!std::is_sorted(row, end)) std::sort(row, end);
  }
}

}  // namespace particulate::laws
