#include <particulate/swarm/obstacles.hpp>

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::swarm {

void validate(const Obstacles& law) {
  const auto refuse = [](const std::string& what) { throw std::invalid_argument("obstacles: " + what); };
  if (law.centre.size() != law.radius.size()) {
    refuse(fmt::format("each needs a centre and a radius, got {} centres and {} radii", law.centre.size(),
                       law.radius.size()));
  }
  for (std::size_t k = 0; k < law.centre.size(); ++k) {
    const Eigen::Vector3d& c = law.centre[k];
    if (!c.allFinite()) {
      refuse(fmt::format("centre of obstacle {} must be finite, got ({}, {}, {}) m", k, c.x(), c.y(), c.z()));
    }
    if (!(law.radius[k] >= 0.0 && std::isfinite(law.radius[k]))) {
      refuse(fmt::format("radius of obstacle {} must be finite and not negative, got {} m", k, law.radius[k]));
    }
  }
  if (!(law.alpha >= 0.0 && std::isfinite(law.alpha))) {
    refuse(fmt::format("alpha must be finite and not negative, got {}", law.alpha));
  }
  if (!(law.beta > 0.0 && std::isfinite(law.beta))) {
    refuse(fmt::format("beta must be positive and finite, so that they push less from afar, got {}", law.beta));
  }
  if (!(law.d_ref > 0.0 && std::isfinite(law.d_ref))) {
    refuse(fmt::format("d_ref must be positive and finite, got {} m", law.d_ref));
  }
}

laws::CentralField field_of(const Obstacles& law) {
  return {.per_mass = {.alpha1 = 0.0, .alpha2 = law.alpha, .beta1 = law.beta, .beta2 = law.beta},
          .centre = law.centre,
          .d_ref = law.d_ref,
          .kernel = law.kernel};
}

std::string at_centre(Eigen::Index member, std::size_t obstacle) {
  return fmt::format("obstacles: member {} must not be at the centre of obstacle {}: place it otherwise", member,
                     obstacle);
}

}  // namespace particulate::swarm
