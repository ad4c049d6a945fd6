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

namespace kinematics = particulate::kinematics;
namespace scenes = particulate::scenes;
namespace schemes = particulate::schemes;
namespace swarm = particulate::swarm;

/// Section 6.3's start: unit masses at rest, evenly distributed in the cube of half side 1 about (0, 0, -1).
inline kinematics::Particles swarm_at_rest(Eigen::Index N, std::uint64_t seed) {
  Uniform uniform(seed);
  kinematics::Particles cloud{.position = kinematics::Vectors(N, 3),
                              .velocity = kinematics::Vectors::Zero(N, 3),
                              .mass = Eigen::VectorXd::Ones(N),
                              .radius = Eigen::VectorXd::Zero(N)};
  for (double& x : cloud.position.reshaped<Eigen::RowMajor>()) x = 2.0 * uniform() - 1.0;
  cloud.position.col(2).array() -= 1.0;
  return cloud;
}

/// Unit masses at rest at given places.
inline kinematics::Particles members(const std::vector<Eigen::Vector3d>& places) {
  std::vector<kinematics::Particle> list;
  for (const Eigen::Vector3d& place : places) list.push_back({.position = place, .mass = 1.0, .radius = 0.0});
  return kinematics::particles(list);
}

/// A design by hand that passes the fence with all its members: for claims about how flights are computed, which hold
/// of any design.
inline constexpr swarm::Design passing{.alpha1 = 0.5,
                                       .alpha2 = 0.3,
                                       .beta1 = 0.5,
                                       .beta2 = 1.0,
                                       .alpha_o = 3.0,
                                       .beta_o = 3.0,
                                       .alpha_t = 2.0,
                                       .beta_t = 0.3};

/// What a design makes of a course.
inline swarm::Obstacles obstacles_of(const swarm::Course& course, const swarm::Design& design) {
  return {.centre = course.obstacles, .radius = course.radii, .alpha = design.alpha_o, .beta = design.beta_o};
}
inline swarm::Target target_of(const swarm::Course& course, const swarm::Design& design) {
  return {.place = course.target, .alpha = design.alpha_t, .beta = design.beta_t};
}

/// The members' scene, whose flights have losses only where somebody looks for them.
template <class... Damping>
auto scene_of(const kinematics::Particles& start, const swarm::Design& design, const swarm::Course& course,
              const Damping&... damping) {
  return scenes::Scene(start, kinematics::Space{}, members_law(design, start.mass.sum()), obstacles_of(course, design),
                       target_of(course, design), damping...);
}

/// The numbers that a right-hand side is given, as vectors: a row a member.
inline schemes::VectorsOf vectors_in(const schemes::In& x) { return {x.data(), x.size() / 3, 3}; }

/// What a speed limit tends to as steps shrink: of a member at the limit that is pulled on, the pull along its velocity
/// is taken away. It is no jump, so that SUNDIALS can fly it.
template <class Scene>
struct Gliding {
  Scene scene;
  double v_max;  ///< [m/s]

  static constexpr bool needs_velocity = true;
  static constexpr int jumping_laws = 0;
  bool acceleration(double t, schemes::In r, schemes::In v, schemes::Out a) const {
    if (!scene.acceleration(t, r, v, a)) return false;
    const schemes::VectorsOf velocity = vectors_in(v);
    schemes::MutableVectorsOf pull(a.data(), velocity.rows(), 3);
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
  std::function<double(schemes::In r, schemes::In v)> rate;  ///< of the value

  static constexpr bool ignores_velocities = !Scene::needs_velocity;
  bool rates(double t, schemes::In r, schemes::In v, schemes::In, schemes::Out a, schemes::Out dy) const {
    dy[0] = rate(r, v);
    if constexpr (Scene::needs_velocity) {
      return scene.acceleration(t, r, v, a);
    } else {
      return scene.acceleration(t, r, a);
    }
  }
  schemes::Jump jump(schemes::State& at, double dt) const requires(Scene::jumping_laws > 0) {
    return scene.jump(at, dt);
  }
};
template <class Scene>
Riding(Scene, std::function<double(schemes::In, schemes::In)>) -> Riding<Scene>;

/// Where it starts, with the value 0.
template <class Scene>
schemes::State start_of(const Riding<Scene>& riding) {
  schemes::State state = scenes::start(riding.scene);
  state.y = Eigen::VectorXd::Zero(1);
  return state;
}

}  // namespace verification
