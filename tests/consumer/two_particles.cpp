// Two particles under the near field, from rest to their closest approach: a third of where they started.

#include <cmath>
#include <cstdio>

#include <fmt/core.h>

#include <particulate/laws/near_field.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
#include <particulate/schemes/verlet.hpp>

using namespace particulate;

int main() {
  const auto pair = kinematics::particles({{.position = {-0.5, 0.0, 0.0}, .mass = 1.0, .radius = 0.0},
                                           {.position = {0.5, 0.0, 0.0}, .mass = 1.0, .radius = 0.0}});
  const laws::NearField near_field{.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 2.0, .beta2 = 3.0};
  const scenes::Scene scene(pair, kinematics::Space{}, near_field);

  const double half_a_period = 2.4183991523123 / 2.0;
  schemes::State state = scenes::start(scene);
  schemes::VelocityVerlet scheme;
  schemes::FixedStep control{.step = 1e-4};
  const schemes::Outcome outcome = schemes::integrate(scene, state, half_a_period, scheme, control);

  const double distance = (position(state, 1) - position(state, 0)).norm();
  fmt::print("distance {:.9f} m: {}\n", distance, describe(outcome));
  const bool right = outcome.status == schemes::Status::reached && std::abs(distance - 1.0 / 3.0) < 1e-7;
  return right && std::fflush(stdout) == 0 ? 0 : 1;
}
