#include <particulate/kinematics/particles.hpp>

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::kinematics {

namespace {

void validate_lengths(const Particles& p) {
  const Eigen::Index N = p.mass.size();
  if (p.position.rows() != N || p.velocity.rows() != N || p.radius.size() != N) {
    throw std::invalid_argument(
        fmt::format("particles: position, velocity, mass and radius must hold one entry a particle, got {}, {}, {} "
                    "and {}",
                    p.position.rows(), p.velocity.rows(), N, p.radius.size()));
  }
}

void validate_finite(const Vectors& x, const char* what, const char* unit) {
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    if (!x.row(i).allFinite()) {
      throw std::invalid_argument(fmt::format("particles: {} must be finite, got ({}, {}, {}) {} for particle {}", what,
                                              x(i, 0), x(i, 1), x(i, 2), unit, i));
    }
  }
}

}  // namespace

void validate(const Particles& particles) {
  validate_lengths(particles);
  const std::size_t flags = particles.immovable.size();
  if (flags != 0 && flags != static_cast<std::size_t>(particles.size())) {
    throw std::invalid_argument(fmt::format(
        "particles: immovable must be empty or hold one entry a particle, got {} for {}", flags, particles.size()));
  }
  validate_finite(particles.position, "positions", "m");
  validate_finite(particles.velocity, "velocities", "m/s");
  for (Eigen::Index i = 0; i < particles.size(); ++i) {
    const double m = particles.mass[i];
    const double b = particles.radius[i];
    if (!(m > 0.0 && std::isfinite(m))) {
      throw std::invalid_argument(
          fmt::format("particles: masses must be positive and finite, got {} kg for particle {}", m, i));
    }
    if (!(b >= 0.0 && std::isfinite(b))) {
      throw std::invalid_argument(
          fmt::format("particles: radii must be finite and not negative, got {} m for particle {}", b, i));
    }
  }
}

Eigen::VectorXd inverse_masses(const Particles& particles) {
  Eigen::VectorXd inverse = particles.mass.cwiseInverse();
  for (std::size_t i = 0; i < particles.immovable.size(); ++i) {
    if (particles.immovable[i]) inverse[static_cast<Eigen::Index>(i)] = 0.0;
  }
  return inverse;
}

RelativeMotion relative_motion(const Particles& particles, Eigen::Index i, Eigen::Index j) {
  return {.position = vector(particles.position, i) - vector(particles.position, j),
          .velocity = vector(particles.velocity, i) - vector(particles.velocity, j)};
}

}  // namespace particulate::kinematics
