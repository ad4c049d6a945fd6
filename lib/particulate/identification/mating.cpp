#include <particulate/identification/mating.hpp>

#include <algorithm>

namespace particulate::identification {

Eigen::VectorXd mated(const Eigen::VectorXd& a, const Eigen::VectorXd& b, const std::function<double()>& uniform) {
  Eigen::VectorXd child(a.size());
  for (Eigen::Index k = 0; k < child.size(); ++k) {
    const double phi = uniform();
    child[k] = std::clamp(phi * a[k] + (1.0 - phi) * b[k], std::min(a[k], b[k]), std::max(a[k], b[k]));
  }
  return child;
}

}  // namespace particulate::identification
