#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <harness/uniform.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/swarm/design.hpp>

/// @file
/// The swarms of this chapter's cases: where they start, a design that flies, and flights whose objective is a value of
/// the problem.

namespace verification {

/// Section 6.3's start: unit masses at rest, evenly distributed in the cube of half side 1 about (0, 0, -1).
inline particulate::kinematics::Particles swarm_at_rest(Eigen::Index N, std::uint64_t seed) {
  Uniform uniform(seed);
  particulate::kinematics::Particles swarm{.position = particulate::kinematics::Vectors(N, 3),
                                           .velocity = particulate::kinematics::Vectors::Zero(N, 3),
                                           .mass = Eigen::VectorXd::Ones(N),
                                           .radius = Eigen::VectorXd::Zero(N)};
  for (double& x : swarm.position.reshaped<Eigen::RowMajor>()) x = 2.0 * uniform() - 1.0;
  swarm.position.col(2).array() -= 1.0;
  return swarm;
}

/// Unit masses at rest at given places.
inline particulate::kinematics::Particles members(const std::vector<Eigen::Vector3d>& places) {
  std::vector<particulate::kinematics::Particle> list;
  for (const Eigen::Vector3d& place : places) list.push_back({.position = place, .mass = 1.0, .radius = 0.0});
  return particulate::kinematics::particles(list);
}

/// A design by hand that passes the fence with all its members: for claims about how flights are computed, which hold
/// of any design.
inline constexpr particulate::swarm::Design passing{.alpha1 = 0.5,
                                                    .alpha2 = 0.3,
                                                    .beta1 = 0.5,
                                                    .beta2 = 1.0,
                                                    .alpha_o = 3.0,
                                                    .beta_o = 3.0,
                                                    .alpha_t = 2.0,
                                                    .beta_t = 0.3};

/// What a design makes of a course.
inline particulate::swarm::Obstacles obstacles_of(const particulate::swarm::Course& course,
                                                  const particulate::swarm::Design& design) {
  return {.centre = course.obstacles, .radius = course.radii, .alpha = design.alpha_o, .beta = design.beta_o};
}
inline particulate::swarm::Target target_of(const particulate::swarm::Course& course,
                                            const particulate::swarm::Design& design) {
  return {.place = course.target, .alpha = design.alpha_t, .beta = design.beta_t};
}

/// The members' scene, whose flights have losses only where somebody looks for them.
template <class... Damping>
auto scene_of(const particulate::kinematics::Particles& start, const particulate::swarm::Design& design,
              const particulate::swarm::Course& course, const Damping&... damping) {
  return particulate::scenes::Scene(start, particulate::kinematics::Space{}, members_law(design, start.mass.sum()),
                                    obstacles_of(course, design), target_of(course, design), damping...);
}

/// The numbers that a right-hand side is given, as vectors: a row a member.
inline particulate::schemes::VectorsOf vectors_in(const particulate::schemes::In& x) {
  return {x.data(), x.size() / 3, 3};
}

/// What a speed limit tends to as steps shrink: of a member at the limit that is pulled on, the pull along its velocity
/// is taken away. It is no jump, so that SUNDIALS can fly it.
template <class Scene>
struct Gliding {
  Scene scene;
  double v_max;  ///< [m/s]

  static constexpr bool needs_velocity = true;
  static constexpr int jumping_laws = 0;
  bool acceleration(double t, particulate::schemes::In r, particulate::schemes::In v,
                    particulate::schemes::Out a) const {
    if (!scene.acceleration(t, r, v, a)) return false;
    const particulate::schemes::VectorsOf velocity = vectors_in(v);
    particulate::schemes::MutableVectorsOf pull(a.data(), velocity.rows(), 3);
    for (Eigen::Index i = 0; i < pull.rows(); ++i) {
      const double speed = velocity.row(i).norm(), along = pull.row(i).dot(velocity.row(i));
      if (speed >= v_max * (1.0 - 1e-12) && along > 0.0) pull.row(i) -= along / (speed * speed) * velocity.row(i);
    }
    return true;
  }
};
template <class Scene>
Gliding(Scene, double) -> Gliding<Scene>;

/// A scene with a value that rides along: its integral is found by whatever integrates the motion.
template <class Scene>
struct Riding {
  Scene scene;
  std::function<double(particulate::schemes::In r, particulate::schemes::In v)> rate;  ///< of the value

  static constexpr bool ignores_velocities = !Scene::needs_velocity;
  bool rates(double t, particulate::schemes::In r, particulate::schemes::In v, particulate::schemes::In,
             particulate::schemes::Out a, particulate::schemes::Out dy) const {
    dy[0] = rate(r, v);
    if constexpr (Scene::needs_velocity) {
      return scene.acceleration(t, r, v, a);
    } else {
      return scene.acceleration(t, r, a);
    }
  }
  particulate::schemes::Jump jump(particulate::schemes::State& at, double dt) const requires(Scene::jumping_laws > 0) {
    return scene.jump(at, dt);
  }
};
template <class Scene>
Riding(Scene, std::function<double(particulate::schemes::In, particulate::schemes::In)>) -> Riding<Scene>;

/// Where it starts, with the value 0.
template <class Scene>
particulate::schemes::State start_of(const Riding<Scene>& riding) {
  particulate::schemes::State state = particulate::scenes::start(riding.scene);
  state.y = Eigen::VectorXd::Zero(1);
  return state;
}

}  // namespace verification
