#include <particulate/scattering/placement.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <particulate/kinematics/cells.hpp>

namespace particulate::scattering {

namespace {

// sum a_i^2 u_i u_i^T.
Eigen::Matrix3d inverse_form(const Spheroid& body) {
  const double a = body.equatorial, c = body.polar;
  return a * a * Eigen::Matrix3d::Identity() + (c - a) * (c + a) * body.axis * body.axis.transpose();
}

// M^-1 R of a symmetric positive definite matrix, by its cofactors.
Eigen::Vector3d solved(const Eigen::Matrix3d& M, const Eigen::Vector3d& R) {
  Eigen::Matrix3d cofactors;
  for (Eigen::Index k = 0; k < 3; ++k) cofactors.col(k) = M.col((k + 1) % 3).cross(M.col((k + 2) % 3));
  return cofactors.transpose() * R / M.col(0).dot(cofactors.col(0));
}

// A place for a centre, such that what reaches so far lies in the box; along a period anywhere.
Eigen::Vector3d random_place(const kinematics::Addition& to, const Eigen::Vector3d& half_extents,
                             const std::function<double()>& uniform) {
  Eigen::Vector3d place;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const bool whole = to.inside == kinematics::Inside::spheres && !std::isfinite(to.domain.lengths[axis]);
    const double reach = whole ? half_extents[axis] : 0.0;
    place[axis] = to.box.corner[axis] + reach + uniform() * (to.box.lengths[axis] - 2.0 * reach);
  }
  return place;
}

void require_room(const Spheroid& like, const kinematics::Addition& to) {
  const double needed = 2.0 * bounding_radius(like);
  if (to.box.lengths.allFinite() && to.box.lengths.minCoeff() > needed && to.box.corner.allFinite()) return;
  throw std::invalid_argument(fmt::format(
      "placement: the box must be finite and longer than a body, {} m, in every direction; got {} x {} x {} m", needed,
      to.box.lengths[0], to.box.lengths[1], to.box.lengths[2]));
}

}  // namespace

bool are_apart(const Spheroid& one, const Spheroid& other, const Eigen::Vector3d& separation) {
  const double size = separation.norm(), outer = bounding_radius(one) + bounding_radius(other);
  if (size >= outer) return true;
  // In units of the larger radius, so that squares stay within a double.
  const double unit = std::max(bounding_radius(one), bounding_radius(other));
  const Eigen::Vector3d R = separation / unit;
  const Eigen::Matrix3d A = inverse_form(one) / (unit * unit), B = inverse_form(other) / (unit * unit);
  double low = 0.0, high = 1.0;
  for (int k = 0; k < 100; ++k) {
    const double l = 0.5 * (low + high), half = 0.5 * (high - low);
    const Eigen::Vector3d x = solved((1.0 - l) * A + l * B, R);
    const double value = l * (1.0 - l) * R.dot(x);
    if (value >= 1.0) return true;
    const double slope = (1.0 - 2.0 * l) * R.dot(x) - l * (1.0 - l) * x.dot((B - A) * x);
    if (value + std::abs(slope) * half < 1.0) return false;
    (slope > 0.0 ? low : high) = l;
  }
  return true;  // within a rounding of touching
}

bool are_apart(const Spheroid& one, const Spheroid& other) {
  // Rounding of bodies that touch moves them apart by no more.
  return are_apart(one, other, (1.0 + 1e-12) * (other.centre - one.centre));
}

Eigen::Vector3d random_direction(const std::function<double()>& uniform) {
  const double z = 2.0 * uniform() - 1.0, phi = 2.0 * std::numbers::pi * uniform();
  const double across = std::sqrt((1.0 - z) * (1.0 + z));
  return Eigen::Vector3d(across * std::cos(phi), across * std::sin(phi), z).normalized();
}

Placed<Sphere> place_spheres(Eigen::Index n, double radius, const kinematics::Addition& to,
                             const std::function<double()>& uniform) {
  const kinematics::Added added = random_addition(Eigen::VectorXd::Constant(n, radius), to, uniform);
  Placed<Sphere> placed{.bodies = {}, .attempts = added.attempts};
  for (Eigen::Index i = 0; i < n; ++i) placed.bodies.push_back({added.position.row(i), radius});
  return placed;
}

Placed<Spheroid> place_spheroids(Eigen::Index n, const Spheroid& like, const kinematics::Addition& to,
                                 const std::function<double()>& uniform) {
  Spheroid body = like;
  body.centre.setZero();
  body.axis.setUnit(2);
  validate(body);
  validate(to.domain);
  require_room(body, to);
  if (n < 0) throw std::invalid_argument(fmt::format("placement: a number of bodies must not be negative, got {}", n));
  const double reach = bounding_radius(body);
  const long most = to.most_attempts > 0 ? to.most_attempts : std::max(1000000L, 1000L * static_cast<long>(n));
  kinematics::Cells cells(to.domain, to.box.lengths, 2.0 * reach, std::max<Eigen::Index>(n, 1));
  Placed<Spheroid> placed;
  while (static_cast<Eigen::Index>(placed.bodies.size()) < n) {
    if (++placed.attempts > most) {
      const double fraction = static_cast<double>(placed.bodies.size()) * volume(body) / to.box.lengths.prod();
      throw std::invalid_argument(fmt::format(
          "placement: {} of {} bodies found a place in {} attempts, a fraction of {:.4f} of the box: take fewer or "
          "smaller ones, a larger box, or more attempts; random addition comes to a standstill, near 0.38 for spheres "
          "and 0.28 for oblates of 4:1",
          placed.bodies.size(), n, most, fraction));
    }
    body.axis = random_direction(uniform);
    body.centre = random_place(to, half_extents(body), uniform);
    bool free = true;
    cells.near(body.centre, reach, cells.level(reach), [&](const kinematics::Cells::Body& near) {
      const Spheroid& other = placed.bodies[static_cast<std::size_t>(near.index)];
      free = free && are_apart(body, other, separation(to.domain, body.centre, other.centre));
    });
    if (!free) continue;
    cells.insert(static_cast<Eigen::Index>(placed.bodies.size()), body.centre, reach);
    placed.bodies.push_back(body);
  }
  return placed;
}

Placed<RedCell> place_red_cells(Eigen::Index n, const RedCell& like, const kinematics::Addition& to,
                                const std::function<double()>& uniform) {
  const Placed<Spheroid> bounds = place_spheroids(n, bounding_spheroid(like), to, uniform);
  Placed<RedCell> placed{.bodies = {}, .attempts = bounds.attempts};
  for (const Spheroid& bound : bounds.bodies) placed.bodies.push_back({bound.centre, bound.axis, like.radius});
  return placed;
}

}  // namespace particulate::scattering
