#include <particulate/contact/contact.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::contact {

void validate(Resolution resolution) {
  if (resolution != Resolution::summed && resolution != Resolution::sequential) {
    throw std::invalid_argument(
        fmt::format("contact: resolution must be summed or sequential, got number {}", static_cast<int>(resolution)));
  }
}

void validate_gamma(double gamma) {
  if (!(gamma >= 0.0 && gamma < 1.0)) {
    throw std::invalid_argument(fmt::format("contact: gamma must lie in [0, 1), got {}", gamma));
  }
}

schemes::Overlap overlap_of(const Touching& touching) {
  const auto deep = [](const Touch& touch) { return touch.overlap > 0.0; };
  return {.contacts = std::count_if(touching.contacts.begin(), touching.contacts.end(), deep),
          .deepest = touching.overlap};
}

double ClosedGap::between(const kinematics::VectorsIn& position, const Eigen::VectorXd& radius, Eigen::Index i,
                          Eigen::Index j) const {
  double reach = radius[i], size = position.row(i).norm();
  if (j >= 0) reach += radius[j], size += position.row(j).norm();
  return relative * reach + roundings * std::numeric_limits<double>::epsilon() * size;
}

Eigen::VectorXd ClosedGap::shares(const kinematics::VectorsIn& position, const Eigen::VectorXd& radius) const {
  return relative * radius + roundings * std::numeric_limits<double>::epsilon() * position.rowwise().norm();
}

namespace {

// Of candidates, the pairs that are near enough to touch, whatever rounding or the range of a double makes of their
// squares: most are not, and need not be looked at closely. In space without periods none is asked for its image.
template <bool has_periods>
Touching find_among(const laws::Candidates& candidates, const kinematics::Space& domain,
                    const laws::At<laws::Velocity>& at, const ClosedGap& tolerance, const Eigen::VectorXd& size) {
  const double *const x = at.position.data(), *const y = x + candidates.N, *const z = y + candidates.N;
  const auto apart = [&](const double* r, Eigen::Index i, Eigen::Index j, Eigen::Index axis) {
    const double d = r[j] - r[i];
    return has_periods ? kinematics::nearest_image(d, domain.lengths[axis]) : d;
  };
  return detail::find_touching(domain, at, tolerance, [&](Eigen::Index i, auto&& visit) {
    candidates.behind(i, [&](Eigen::Index j) {
      const double dx = apart(x, i, j, 0), dy = apart(y, i, j, 1), dz = apart(z, i, j, 2), reach = size[i] + size[j];
      if (dx * dx + dy * dy + dz * dz > (1.0 + 1e-12) * reach * reach + 1e-300) return;
      visit(j);
    });
  });
}

}  // namespace

Touching find_touching(const kinematics::Space& domain, const laws::At<laws::Velocity>& at,
                       const ClosedGap& tolerance) {
  const auto among = [&](const Eigen::VectorXd& size) {
    const laws::Candidates near = at.scratch.neighbours.candidates(domain, at.position, size);
    return kinematics::has_periods(domain) ? find_among<true>(near, domain, at, tolerance, size)
                                           : find_among<false>(near, domain, at, tolerance, size);
  };
  if (tolerance.is_none()) return among(at.radius);
  const Eigen::VectorXd size = at.radius + tolerance.shares(at.position, at.radius);
  return among(size);
}

double travel(const laws::At<laws::Velocity>& at, std::span<const kinematics::Wall> walls, double dt) {
  const Eigen::Index N = at.mass.size();
  if (N == 0 || !(at.radius.maxCoeff() > 0.0)) return 0.0;
  const double smallest = (at.radius.array() > 0.0).select(at.radius, at.radius.maxCoeff()).minCoeff();
  const auto radius = at.radius.array().max(smallest);
  const auto u = at.velocity.col(0).array(), v = at.velocity.col(1).array(), w = at.velocity.col(2).array();
  const auto squared = (u - u.mean()).square() + (v - v.mean()).square() + (w - w.mean()).square();
  double farthest = std::sqrt((squared / radius.square()).maxCoeff());
  for (const kinematics::Wall& wall : walls) {
    const Eigen::Vector3d& n = wall.normal;
    farthest = std::max(farthest, -((n.x() * u + n.y() * v + n.z() * w) / radius).minCoeff());
  }
  return farthest * dt;
}

double approach_speed(const Touch& touch, const kinematics::VectorsIn& velocity) {
  Eigen::Vector3d approach = velocity.row(touch.i);
  if (touch.j >= 0) approach -= velocity.row(touch.j).transpose();
  return approach.dot(touch.n);
}

bool any_approach(const Touching& touching, const laws::At<laws::Velocity>& at) {
  return !touching.directed || std::any_of(touching.contacts.begin(), touching.contacts.end(), [&](const Touch& touch) {
    return approach_speed(touch, at.velocity) > 0.0;
  });
}

std::string without_direction(const Touching& touching) {
  const auto lost = std::find_if(touching.contacts.begin(), touching.contacts.end(),
                                 [](const Touch& touch) { return !touch.n.allFinite(); });
  return fmt::format(
      "particles {} and {} touch with the same centre, so there is no direction to part them in: start them apart, or "
      "take a smaller step",
      lost->i, lost->j);
}

schemes::Jump undirected(const Touching& touching) {
  return {.overlap = touching.overlap, .penetration = touching.penetration, .unsettled = without_direction(touching)};
}

void set_accelerations(Touching& touching, const Eigen::VectorXd& inverse_mass, schemes::In force) {
  const Eigen::Map<const kinematics::Vectors> f(force.data(), inverse_mass.size(), 3);
  for (Touch& touch : touching.contacts) {
    touch.acceleration = inverse_mass[touch.i] * f.row(touch.i).transpose();
    if (touch.j >= 0) touch.acceleration -= inverse_mass[touch.j] * f.row(touch.j).transpose();
  }
}

void hold(Touching& touching, double dt) {
  for (Touch& touch : touching.contacts) {
    const double half = 0.5 * dt * touch.acceleration.dot(touch.n);
    touch.hold = dt;
    touch.slow = std::max(0.0, 2.0 * half * (1.0 + 1e-9));
    touch.parting = half + (half > 0.0 ? std::clamp(0.5 * (touch.overlap / dt - half), 0.0, 2.0 * half) : 0.0);
  }
}

}  // namespace particulate::contact
