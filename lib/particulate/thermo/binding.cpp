#include <particulate/thermo/binding.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::thermo {

void validate(const Binding& law, const kinematics::Particles& particles) {
  if (!(law.F_b >= 0.0 && std::isfinite(law.F_b))) {
    throw std::invalid_argument(fmt::format("binding: F_b must be finite and not negative, got {} N/kg^2", law.F_b));
  }
  Eigen::VectorXd largest = particles.radius;
  const Eigen::Index pair = std::min<Eigen::Index>(2, largest.size());
  std::partial_sort(largest.begin(), largest.begin() + pair, largest.end(), std::greater<>());
  const double touching = largest.head(pair).sum();
  if (law.d_b > touching && std::isfinite(law.d_b)) return;
  throw std::invalid_argument(fmt::format(
      "binding: d_b must be finite and above the sum of any two radii, of which the largest is {} m, got {} m",
      touching, law.d_b));
}

void validate(const Binding& law, const kinematics::Space& domain) {
  const double half = 0.5 * domain.lengths.minCoeff();
  if (law.d_b <= half) return;
  throw std::invalid_argument(
      fmt::format("binding: d_b must be at most half the shortest period of space, {} m, got {} m", half, law.d_b));
}

double binding_integral(double x) {
  if (x >= 1.0) return 0.0;
  // From the end, in 1 - x, where it falls to zero.
  const double y = 1.0 - std::max(x, 0.0);
  return 16.0 * y * y * y * (1.0 / 3.0 - y * (0.5 - 0.2 * y));
}

laws::Candidates candidates(const Binding& law, const kinematics::Space& domain, const laws::At<>& at) {
  return at.scratch.neighbours.candidates(domain, at.position,
                                          Eigen::VectorXd::Constant(at.mass.size(), 0.5 * law.d_b));
}

}  // namespace particulate::thermo
