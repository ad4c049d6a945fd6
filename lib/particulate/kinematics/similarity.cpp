#include <particulate/kinematics/similarity.hpp>

#include <cmath>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

namespace particulate::kinematics {

namespace {

void require_positive(std::string_view name, double value, std::string_view unit) {
  if (!(value > 0.0 && std::isfinite(value))) {
    throw std::invalid_argument(fmt::format("scales: {} must be positive and finite, got {} {}", name, value, unit));
  }
}

}  // namespace

void validate(const Scales& scales) {
  require_positive("length", scales.length, "m");
  require_positive("time", scales.time, "s");
  require_positive("mass", scales.mass, "kg");
}

SimilarityGroups similarity_groups(const Dimensional& scene, const Scales& scales) {
  validate(scales);
  const double L = scales.length;
  const double tau = scales.time;
  const double inertia = scene.mass * tau * tau;
  return {.attraction = scene.law.alpha1 * inertia * power(L, -scene.law.beta1 - 1.0),
          .repulsion = scene.law.alpha2 * inertia * power(L, -scene.law.beta2 - 1.0),
          .speed = scene.speed * tau / L,
          .radius = scene.radius / L,
          .step = scene.step / tau};
}

CentralForce scaled(const CentralForce& law, const Scales& scales) {
  validate(scales);
  const double inertia = scales.mass * scales.time * scales.time;
  return {.alpha1 = law.alpha1 * power(scales.length, law.beta1 + 1.0) / inertia,
          .alpha2 = law.alpha2 * power(scales.length, law.beta2 + 1.0) / inertia,
          .beta1 = law.beta1,
          .beta2 = law.beta2};
}

Particles scaled(const Particles& particles, const Scales& scales) {
  validate(scales);
  return {.position = scales.length * particles.position,
          .velocity = (scales.length / scales.time) * particles.velocity,
          .mass = scales.mass * particles.mass,
          .radius = scales.length * particles.radius,
          .immovable = particles.immovable};
}

}  // namespace particulate::kinematics
