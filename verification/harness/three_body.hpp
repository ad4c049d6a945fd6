#pragma once

#include <array>
#include <vector>

#include <harness/impacts_by_events.hpp>
#include <particulate/contact/contact.hpp>
#include <particulate/contact/impact.hpp>
#include <particulate/kinematics/domain.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/reference/integrator.hpp>
#include <particulate/scenes/scene.hpp>

/// @file
/// Three bodies that attract one another until they collide.

namespace verification {

using ThreeBodyScene = particulate::scenes::Scene<particulate::kinematics::Space, particulate::laws::NearField,
                                                  particulate::contact::Contact<>>;

constexpr double three_body_restitution = 0.8;

/// Three bodies of different masses that fall towards one another. They touch at 0.5 to 0.55 m, where the near field,
/// with its equilibrium at 0.5 m, attracts: two of them bounce on each other again and again.
///
/// @param closer  1 - closer is the size of the triangle, so that several starts have impacts at unrelated times
inline ThreeBodyScene three_body_scene(double closer = 0.0) {
  particulate::kinematics::Particles bodies{
      .position = particulate::kinematics::Vectors{{-0.6, -0.3, 0.02}, {0.55, -0.4, -0.03}, {0.1, 0.7, 0.01}},
      .velocity = particulate::kinematics::Vectors{{0.1, 0.35, 0.0}, {-0.2, -0.15, 0.05}, {0.2, -0.2, -0.04}},
      .mass = Eigen::Vector3d{1.0, 1.3, 0.8},
      .radius = Eigen::Vector3d{0.26, 0.29, 0.24}};
  bodies.position *= 1.0 - closer;
  return {bodies, particulate::kinematics::Space{},
          particulate::laws::NearField{.alpha1 = 1.0, .alpha2 = 0.5, .beta1 = 2.0, .beta2 = 3.0},
          particulate::contact::Contact<>{.restitution = {three_body_restitution}, .gamma = 0.01}};
}

using Pair = std::array<Eigen::Index, 2>;
constexpr std::array<Pair, 3> three_pairs{Pair{0, 1}, Pair{0, 2}, Pair{1, 2}};

inline Eigen::Vector3d row_of(const Eigen::VectorXd& flat, Eigen::Index i) {
  const Eigen::Index N = flat.size() / 3;
  return {flat[i], flat[N + i], flat[2 * N + i]};
}

inline void set_row(Eigen::VectorXd& flat, Eigen::Index i, const Eigen::Vector3d& value) {
  const Eigen::Index N = flat.size() / 3;
  flat[i] = value[0], flat[N + i] = value[1], flat[2 * N + i] = value[2];
}

/// Events of bodies: the gap between two of them closes; (0, 1), (0, 2), ..., (1, 2), as in three_pairs.
inline particulate::reference::Events gap_events(const Eigen::VectorXd& radius) {
  particulate::reference::Events events;
  for (Eigen::Index i = 0; i < radius.size(); ++i) {
    for (Eigen::Index j = i + 1; j < radius.size(); ++j) {
      events.push_back({.function =
                            [i, j, reach = radius[i] + radius[j]](const particulate::schemes::State& at) {
                              return (row_of(at.r, j) - row_of(at.r, i)).norm() - reach;
                            },
                        .direction = particulate::reference::Direction::falling});
    }
  }
  return events;
}

/// What an impact of two of three bodies does: the impact map of section 2.2 at once, without other forces meanwhile.
inline auto impact_of_pair(const Eigen::VectorXd& mass) {
  return [mass](particulate::schemes::State& state, const std::vector<particulate::reference::Hit>& hits) {
    for (const particulate::reference::Hit& hit : hits) {
      const auto& [i, j] = three_pairs[hit.event];
      const Eigen::Vector3d n = (row_of(state.r, j) - row_of(state.r, i)).normalized();
      const particulate::contact::Rebound after = particulate::contact::impact(
          {.velocity = row_of(state.v, i), .inverse_mass = 1.0 / mass[i]},
          {.velocity = row_of(state.v, j), .inverse_mass = 1.0 / mass[j]}, n, three_body_restitution,
          Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 0.0, particulate::contact::Frictionless{});
      set_row(state.v, i, after.velocity_i);
      set_row(state.v, j, after.velocity_j);
    }
  };
}

/// Moves three bodies by CVODE, stopping at every impact.
///
/// @return the counts of all legs
inline particulate::schemes::Outcome three_bodies_by_roots(ThreeBodyScene& scene, particulate::schemes::State& state,
                                                           double t_end, double relative) {
  particulate::reference::Integrator integrator(
      scene, state, particulate::reference::Adams{.relative = relative, .absolute = 0.1 * relative},
      gap_events(scene.particles().radius));
  return advance_through_impacts(integrator, state, t_end, impact_of_pair(scene.particles().mass));
}

}  // namespace verification
