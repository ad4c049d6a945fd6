#include <particulate/swarm/target.hpp>

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::swarm {

void validate(const Target& law) {
  const Eigen::Vector3d& place = law.place;
  if (!place.allFinite()) {
    throw std::invalid_argument(
        fmt::format("target: place must be finite, got ({}, {}, {}) m", place.x(), place.y(), place.z()));
  }
  if (!(law.alpha >= 0.0 && std::isfinite(law.alpha))) {
    throw std::invalid_argument(fmt::format("target: alpha must be finite and not negative, got {}", law.alpha));
  }
  if (!(law.beta >= 0.0 && law.beta <= 1.0)) {
    throw std::invalid_argument(fmt::format("target: beta must lie between 0 and 1, got {}", law.beta));
  }
}

laws::CentralField field_of(const Target& law) {
  return {.per_mass = {.alpha1 = law.alpha, .alpha2 = 0.0, .beta1 = -law.beta, .beta2 = -law.beta},
          .centre = {&law.place, 1},
          .kernel = law.kernel,
          .vanishes_at_centre = true};
}

}  // namespace particulate::swarm
