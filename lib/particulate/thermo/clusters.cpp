#include <particulate/thermo/clusters.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

#include <particulate/laws/neighbours.hpp>

namespace particulate::thermo {

namespace {

// Sets of bodies, each known by the least of its numbers.
class Sets {
 public:
  explicit Sets(Eigen::Index N) : parent_(static_cast<std::size_t>(N)) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) {
    const std::size_t a = find(i), b = find(j);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace

Eigen::Index Clusters::largest() const { return sizes.empty() ? 0 : *std::max_element(sizes.begin(), sizes.end()); }

double Clusters::linked_share() const {
  if (of.empty()) return 0.0;
  const auto alone = std::count(sizes.begin(), sizes.end(), 1);
  return 1.0 - static_cast<double>(alone) / static_cast<double>(of.size());
}

Clusters find_clusters(const kinematics::Space& domain, const kinematics::VectorsIn& position, double link) {
  if (!(link >= 0.0 && std::isfinite(link))) {
    throw std::invalid_argument(
        fmt::format("clusters: the link length must be finite and not negative, got {} m", link));
  }
  if (!position.allFinite()) {
    throw std::invalid_argument(
        "clusters: every position must be finite, got one that is not: look for the step that "
        "made it so");
  }
  const Eigen::Index N = position.rows();
  laws::Neighbours neighbours;
  const laws::Candidates near = neighbours.candidates(domain, position, Eigen::VectorXd::Constant(N, 0.5 * link));
  Clusters found{.of = std::vector<Eigen::Index>(static_cast<std::size_t>(N)), .sizes = {}};
  Sets sets(N);
  for (Eigen::Index i = 0; i < N; ++i) {
    near.behind(i, [&](Eigen::Index j) {
      if (kinematics::length(separation(domain, position.row(i), position.row(j))) > link) return;
      ++found.links;
      sets.join(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
    });
  }
  for (std::size_t i = 0; i < found.of.size(); ++i) {
    const std::size_t root = sets.find(i);
    if (root == i) found.sizes.push_back(0);
    found.of[i] = root == i ? static_cast<Eigen::Index>(found.sizes.size()) - 1 : found.of[root];
    ++found.sizes[static_cast<std::size_t>(found.of[i])];
  }
  return found;
}

}  // namespace particulate::thermo
