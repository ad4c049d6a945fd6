#include <particulate/kinematics/particles.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

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

void validate_heat(const Particles& p) {
  const Eigen::Index N = p.size(), temperatures = p.temperature.size(), capacities = p.heat_capacity.size();
  if (temperatures != capacities || (temperatures != 0 && temperatures != N)) {
    throw std::invalid_argument(
        fmt::format("particles: temperature and heat_capacity must both be empty or hold one entry a particle, got {} "
                    "and {} for {}",
                    temperatures, capacities, N));
  }
  const auto require_positive = [](const Eigen::VectorXd& x, const char* what, const char* unit) {
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      if (x[i] > 0.0 && std::isfinite(x[i])) continue;
      throw std::invalid_argument(
          fmt::format("particles: {} must be positive and finite, got {} {} for particle {}", what, x[i], unit, i));
    }
  };
  require_positive(p.temperature, "temperatures", "K");
  require_positive(p.heat_capacity, "heat capacities", "J/(kg K)");
}

}  // namespace

void validate(const Particles& particles) {
  validate_lengths(particles);
  validate_heat(particles);
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

Particles particles(const std::vector<Particle>& list) {
  const auto N = static_cast<Eigen::Index>(list.size());
  Particles all{
      .position = Vectors(N, 3), .velocity = Vectors(N, 3), .mass = Eigen::VectorXd(N), .radius = Eigen::VectorXd(N)};
  const bool all_move = std::none_of(list.begin(), list.end(), [](const Particle& one) { return one.immovable; });
  if (!all_move) all.immovable.resize(list.size());
  const bool have_heat = std::any_of(list.begin(), list.end(), [](const Particle& one) {
    return !std::isnan(one.temperature) || !std::isnan(one.heat_capacity);
  });
  all.temperature.resize(have_heat ? N : 0);
  all.heat_capacity.resize(have_heat ? N : 0);
  for (Eigen::Index i = 0; i < N; ++i) {
    const auto& [position, velocity, mass, radius, immovable, temperature, heat_capacity] =
        list[static_cast<std::size_t>(i)];
    const char* const missing = position.array().isNaN().any() ? "position"
                                : std::isnan(mass)             ? "mass"
                                : std::isnan(radius)           ? "radius"
                                                               : nullptr;
    if (missing != nullptr) {
      throw std::invalid_argument(fmt::format(
          "particles: each must be given a position, a mass and a radius, and particle {} has no {}", i, missing));
    }
    set_vector(all.position, i, position);
    set_vector(all.velocity, i, velocity);
    all.mass[i] = mass;
    all.radius[i] = radius;
    if (immovable) all.immovable[static_cast<std::size_t>(i)] = true;
    if (have_heat) all.temperature[i] = temperature, all.heat_capacity[i] = heat_capacity;
  }
  validate(all);
  return all;
}

Eigen::VectorXd inverse_masses(const Particles& particles) {
  Eigen::VectorXd inverse = particles.mass.cwiseInverse();
  for (std::size_t i = 0; i < particles.immovable.size(); ++i) {
    if (particles.immovable[i]) inverse[static_cast<Eigen::Index>(i)] = 0.0;
  }
  return inverse;
}

Particles chosen(const Particles& particles, const std::vector<Eigen::Index>& numbers) {
  for (const Eigen::Index i : numbers) {
    if (i >= 0 && i < particles.size()) continue;
    throw std::invalid_argument(
        fmt::format("particles: there is no particle {} among {}: choose others", i, particles.size()));
  }
  Particles some{.position = particles.position(numbers, Eigen::all),
                 .velocity = particles.velocity(numbers, Eigen::all),
                 .mass = particles.mass(numbers),
                 .radius = particles.radius(numbers)};
  for (const Eigen::Index i : numbers) {
    if (particles.immovable.empty()) break;
    some.immovable.push_back(particles.immovable[static_cast<std::size_t>(i)]);
  }
  if (particles.temperature.size() > 0) {
    some.temperature = particles.temperature(numbers);
    some.heat_capacity = particles.heat_capacity(numbers);
  }
  return some;
}

void require_one_length(std::initializer_list<Eigen::Index> lengths) {
  if (std::adjacent_find(lengths.begin(), lengths.end(), std::not_equal_to<>()) == lengths.end()) return;
  throw std::invalid_argument(
      fmt::format("arrays of particles must hold one entry a particle each, got {}", fmt::join(lengths, " and ")));
}

RelativeMotion relative_motion(const Particles& particles, Eigen::Index i, Eigen::Index j) {
  for (const Eigen::Index k : {i, j}) {
    if (k >= 0 && k < particles.size()) continue;
    throw std::invalid_argument(
        fmt::format("relative motion: a particle must be one of {}, counted from 0, got {}", particles.size(), k));
  }
  return {.position = vector(particles.position, i) - vector(particles.position, j),
          .velocity = vector(particles.velocity, i) - vector(particles.velocity, j)};
}

}  // namespace particulate::kinematics
