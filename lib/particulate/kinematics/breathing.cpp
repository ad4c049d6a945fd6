#include <particulate/kinematics/breathing.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace particulate::kinematics {

namespace {

constexpr long double pi = std::numbers::pi_v<long double>;

// xi - eps sin xi = mean for 0 <= mean <= pi. The left side is convex there, so Newton from xi = pi falls
// monotonically.
long double eccentric_anomaly(long double mean, long double eps) {
  long double xi = pi;
  for (int k = 0; k < 200; ++k) {
    const long double step = (xi - eps * std::sin(xi) - mean) / (1.0L - eps * std::cos(xi));
    if (!(step > 0.0L)) break;
    xi -= step;
  }
  return std::max(xi, 0.0L);
}

struct Sums {
  double inverse = 0.0, inverse_square = 0.0;
  Eigen::Vector3d across = Eigen::Vector3d::Zero();
};

// What one corner sees of the others: sums of 1/s and 1/s^2, and the part of the pull that is not radial.
Sums seen_from(const Vectors& corners, Eigen::Index i) {
  Sums sums;
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
  const Eigen::Vector3d here = vector(corners, i);
  for (Eigen::Index k = 0; k < corners.rows(); ++k) {
    if (k == i) continue;
    const Eigen::Vector3d chord = vector(corners, k) - here;
    const double s = chord.norm();
    sums.inverse += 1.0 / s;
    sums.inverse_square += 1.0 / (s * s);
    pull += chord / (s * s * s) + chord / (s * s * s * s);
  }
  sums.across = pull - pull.dot(here) * here;
  return sums;
}

void require_positive(const char* name, double value) {
  if (!(value > 0.0 && std::isfinite(value))) {
    throw std::invalid_argument(fmt::format("breathing: {} must be positive and finite, got {}", name, value));
  }
}

}  // namespace

RadialForce breathing_pair(double alpha1, double alpha2, double m_i, double m_j, double l_z) {
  return {.A = alpha1 * (m_i + m_j), .B = alpha2 * (m_i + m_j) + l_z * l_z};
}

RadialForce breathing_body(double alpha1, double alpha2, double m, const Vectors& corners) {
  if (corners.rows() < 2) {
    throw std::invalid_argument(fmt::format("breathing: a body needs at least two corners, got {}", corners.rows()));
  }
  const Sums first = seen_from(corners, 0);
  constexpr double rounding = 1e-12;
  for (Eigen::Index i = 0; i < corners.rows(); ++i) {
    const Sums sums = seen_from(corners, i);
    const bool unit = std::abs(corners.row(i).norm() - 1.0) <= rounding;
    const bool alike = std::abs(sums.inverse - first.inverse) <= rounding * first.inverse &&
                       std::abs(sums.inverse_square - first.inverse_square) <= rounding * first.inverse_square;
    const bool radial = sums.across.norm() <= rounding * (first.inverse_square + first.inverse);
    if (!(unit && alike && radial)) {
      throw std::invalid_argument(fmt::format(
          "breathing: every corner must lie on the unit sphere, see the others alike and be pulled along its radius; "
          "corner {} at ({}, {}, {}) does not",
          i, corners(i, 0), corners(i, 1), corners(i, 2)));
    }
  }
  return {.A = 0.5 * alpha1 * m * first.inverse, .B = 0.5 * alpha2 * m * first.inverse_square};
}

Vectors regular_polygon(int N) {
  if (N < 2) throw std::invalid_argument(fmt::format("regular polygon: N must be at least 2, got {}", N));
  Vectors corners(N, 3);
  for (int k = 0; k < N; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / N;
    corners.row(k) << std::cos(angle), std::sin(angle), 0.0;
  }
  return corners;
}

Vectors regular_solid(int faces) {
  const double g = std::numbers::phi;
  const double h = 1.0 / g;
  Vectors corners;
  switch (faces) {
    case 4:
      corners.resize(4, 3);
      corners << 1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1;
      break;
    case 6:
      corners.resize(8, 3);
      corners << 1, 1, 1, 1, 1, -1, 1, -1, 1, 1, -1, -1, -1, 1, 1, -1, 1, -1, -1, -1, 1, -1, -1, -1;
      break;
    case 8:
      corners.resize(6, 3);
      corners << 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1;
      break;
    case 12:
      corners.resize(20, 3);
      corners << 1, 1, 1, 1, 1, -1, 1, -1, 1, 1, -1, -1, -1, 1, 1, -1, 1, -1, -1, -1, 1, -1, -1, -1,  //
          0, h, g, 0, h, -g, 0, -h, g, 0, -h, -g, h, g, 0, h, -g, 0, -h, g, 0, -h, -g, 0,             //
          g, 0, h, g, 0, -h, -g, 0, h, -g, 0, -h;
      break;
    case 20:
      corners.resize(12, 3);
      corners << 0, 1, g, 0, 1, -g, 0, -1, g, 0, -1, -g, 1, g, 0, 1, -g, 0, -1, g, 0, -1, -g, 0,  //
          g, 0, 1, g, 0, -1, -g, 0, 1, -g, 0, -1;
      break;
    default:
      throw std::invalid_argument(fmt::format("regular solid: it has 4, 6, 8, 12 or 20 faces, got {}", faces));
  }
  return corners.rowwise().normalized();
}

Breathing::Breathing(const RadialForce& force, double r_0) {
  require_positive("A", force.A);
  require_positive("B", force.B);
  require_positive("r_0", r_0);
  const long double A = force.A, B = force.B, start = r_0;
  const long double twice_depth = 2.0L * A / start - B / (start * start);  // 2|E|
  if (!(twice_depth > 0.0L)) {
    throw std::invalid_argument(
        fmt::format("breathing: a bounded motion from rest starts beyond B/(2A) = {} m, got r_0 = {} m",
                    force.B / (2.0 * force.A), r_0));
  }
  const long double a = A / twice_depth;
  near_ = B / (twice_depth * start);
  far_ = start;
  starts_near_ = near_ > far_;
  if (starts_near_) std::swap(near_, far_);
  period_ = 2.0L * pi * std::sqrt(a * a * a / A);
}

Radial Breathing::at(double t) const {
  if (!std::isfinite(t)) {
    throw std::invalid_argument(fmt::format("breathing: the time must be finite, got {} s", t));
  }
  // Time since the inner turning point, folded onto the half period in which r grows.
  long double phase = std::fmod(static_cast<long double>(t) / period_ + (starts_near_ ? 0.0L : 0.5L), 1.0L);
  if (phase < 0.0L) phase += 1.0L;
  const bool falls = phase > 0.5L;
  const long double mean = 2.0L * pi * (falls ? 1.0L - phase : phase);

  const long double a = 0.5L * (near_ + far_);
  const long double a_eps = 0.5L * (far_ - near_);
  const long double xi = eccentric_anomaly(mean, a_eps / a);
  const long double half = std::sin(0.5L * xi);
  const long double r = near_ + 2.0L * a_eps * half * half;
  const long double v = a_eps * std::sin(xi) * (2.0L * pi / period_) * (a / r);
  return {.r = static_cast<double>(r), .v = static_cast<double>(falls ? -v : v)};
}

}  // namespace particulate::kinematics
