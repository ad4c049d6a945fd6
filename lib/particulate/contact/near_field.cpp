#include <particulate/contact/near_field.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::contact {

namespace {

// Particles j are taken in runs that fit the first-level cache together with all their intermediate powers.
constexpr Eigen::Index run_length = 128;
using Run = std::array<double, run_length>;

// out = x^exponent entry by entry, by multiplication where the exponent is whole, in the order kinematics::power uses.
void powers(const Run& x, Eigen::Index n, double exponent, Run& out) {
  constexpr double largest = 64.0;
  if (exponent > largest || exponent != std::floor(exponent)) {
    for (Eigen::Index k = 0; k < n; ++k) out[k] = std::pow(x[k], exponent);
    return;
  }
  Run base;
  std::copy_n(x.begin(), n, base.begin());
  std::fill_n(out.begin(), n, 1.0);
  for (int left = static_cast<int>(exponent); left > 0; left /= 2) {
    if (left % 2 == 1) {
      for (Eigen::Index k = 0; k < n; ++k) out[k] *= base[k];
    }
    if (left > 1) {
      for (Eigen::Index k = 0; k < n; ++k) base[k] *= base[k];
    }
  }
}

struct Columns {
  const double *x, *y, *z, *charge;
  double *fx, *fy, *fz;
};

// Forces between particle i and the n particles from j on; false if a distance to one of them has no full square.
bool add_run(const NearField& law, const Columns& c, Eigen::Index i, Eigen::Index j, Eigen::Index n) {
  Run dx, dy, dz, inverse, attraction, repulsion;
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0.0;
#pragma omp simd reduction(min : nearest) reduction(max : farthest)
  for (Eigen::Index k = 0; k < n; ++k) {
    dx[k] = c.x[j + k] - c.x[i];
    dy[k] = c.y[j + k] - c.y[i];
    dz[k] = c.z[j + k] - c.z[i];
    const double square = dx[k] * dx[k] + dy[k] * dy[k] + dz[k] * dz[k];
    nearest = std::min(nearest, square);
    farthest = std::max(farthest, square);
    inverse[k] = 1.0 / std::sqrt(square);
  }
  if (!(is_full(nearest) && is_full(farthest))) return false;
  powers(inverse, n, law.beta1, attraction);
  powers(inverse, n, law.beta2, repulsion);

  const double alpha1 = law.alpha1 * c.charge[i];
  const double alpha2 = law.alpha2 * c.charge[i];
  double fx = 0.0, fy = 0.0, fz = 0.0;
#pragma omp simd reduction(+ : fx, fy, fz)
  for (Eigen::Index k = 0; k < n; ++k) {
    const double over_d = (alpha1 * attraction[k] - alpha2 * repulsion[k]) * (c.charge[j + k] * inverse[k]);
    const double x = over_d * dx[k], y = over_d * dy[k], z = over_d * dz[k];
    fx += x, fy += y, fz += z;
    c.fx[j + k] -= x, c.fy[j + k] -= y, c.fz[j + k] -= z;
  }
  c.fx[i] += fx, c.fy[i] += fy, c.fz[i] += fz;
  return true;
}

}  // namespace

void validate(const NearField& law) {
  validate(
      kinematics::CentralForce{.alpha1 = law.alpha1, .alpha2 = law.alpha2, .beta1 = law.beta1, .beta2 = law.beta2});
  if (!(law.d_ref > 0.0 && std::isfinite(law.d_ref))) {
    throw std::invalid_argument(fmt::format("near field: d_ref must be positive and finite, got {} m", law.d_ref));
  }
  if (law.scaling != Scaling::mass && law.scaling != Scaling::area && law.scaling != Scaling::pair) {
    throw std::invalid_argument(
        fmt::format("near field: scaling must be mass, area or pair, got number {}", static_cast<int>(law.scaling)));
  }
}

kinematics::CentralForce pair_law(const NearField& law, double charge_i, double charge_j) {
  return {.alpha1 = law.alpha1 * charge_i * charge_j,
          .alpha2 = law.alpha2 * charge_i * charge_j,
          .beta1 = law.beta1,
          .beta2 = law.beta2};
}

Eigen::VectorXd charges(const NearField& law, const Places& at) {
  switch (law.scaling) {
    case Scaling::mass:
      return at.mass;
    case Scaling::area:
      return (4.0 * std::numbers::pi) * at.radius.cwiseAbs2();
    case Scaling::pair:
      return Eigen::VectorXd::Ones(at.mass.size());
  }
  throw std::invalid_argument("near field: scaling must be mass, area or pair");
}

bool add_force(const NearField& law, const kinematics::Open&, const Places& at, Forces force) {
  const Eigen::Index N = at.mass.size();
  const Eigen::VectorXd other = law.scaling == Scaling::mass ? Eigen::VectorXd() : charges(law, at);
  const double* const charge = law.scaling == Scaling::mass ? at.mass.data() : other.data();  // masses are not copied
  const double* const r = at.position.data();
  double* const f = force.data();
  const Columns columns{.x = r, .y = r + N, .z = r + 2 * N, .charge = charge, .fx = f, .fy = f + N, .fz = f + 2 * N};
  for (Eigen::Index i = 0; i < N; ++i) {
    for (Eigen::Index j = i + 1; j < N; j += run_length) {
      if (!add_run(law, columns, i, j, std::min(run_length, N - j))) return false;
    }
  }
  return force.allFinite();
}

}  // namespace particulate::contact
