#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <particulate/contact/contact.hpp>
#include <particulate/kinematics/domain.hpp>
#include <particulate/laws/gravity.hpp>
#include <particulate/reference/integrator.hpp>
#include <particulate/scenes/scene.hpp>

/// @file
/// Balls that bounce on the ground until they rest: closed form, scene, events.

namespace verification {

using BouncingScene = particulate::scenes::Scene<particulate::kinematics::Space, particulate::laws::Gravity,
                                                 particulate::contact::Contact<>>;

/// A ball dropped from a height, which keeps e of its speed at every impact.
///
/// Impact k = 0, 1, ... comes at \f$ t_k = \sqrt{2h/g}\,(1 + 2 \sum_{i=1}^k e^i) \f$ with the speed \f$ \sqrt{2gh}\,e^k
/// \f$. Infinitely many of them are over at \f$ \sqrt{2h/g}\,(1+e)/(1-e) \f$.
struct Bouncing {
  double h;         ///< of its lowest point above the ground [m]
  double e;         ///< < 1 [-]
  double g = 9.81;  ///< [m/s^2]

  double fall() const { return std::sqrt(2.0 * h / g); }
  double impact_speed(int k) const { return g * fall() * std::pow(e, k); }
  double impact_time(int k) const { return fall() * (1.0 + 2.0 * e * (1.0 - std::pow(e, k)) / (1.0 - e)); }
  double total_time() const { return fall() * (1.0 + e) / (1.0 - e); }

  /// Height of the lowest point and velocity.
  struct Moment {
    double z, v;
  };
  Moment at(double t) const {
    if (t < fall()) return {h - 0.5 * g * t * t, -g * t};
    if (t >= total_time()) return {0.0, 0.0};
    int k = 0;
    while (t >= impact_time(k + 1)) ++k;
    const double since = t - impact_time(k), up = e * impact_speed(k);
    return {up * since - 0.5 * g * since * since, up - g * since};
  }
};

constexpr double ball_radius = 0.05;

/// Balls beside one another, too far apart to meet, each dropped from its own height above the ground z = 0.
inline BouncingScene bouncing_scene(const std::vector<double>& heights, double e, double gamma = 0.01) {
  using particulate::kinematics::Vectors;
  const auto N = static_cast<Eigen::Index>(heights.size());
  particulate::kinematics::Particles balls{.position = Vectors::Zero(N, 3),
                                           .velocity = Vectors::Zero(N, 3),
                                           .mass = Eigen::VectorXd::Constant(N, 2.0),
                                           .radius = Eigen::VectorXd::Constant(N, ball_radius)};
  for (Eigen::Index i = 0; i < N; ++i) {
    balls.position(i, 0) = 4.0 * ball_radius * static_cast<double>(i);
    balls.position(i, 2) = ball_radius + heights[static_cast<std::size_t>(i)];
  }
  return {balls, particulate::kinematics::Space{{particulate::kinematics::Wall{}}}, particulate::laws::Gravity{},
          particulate::contact::Contact<>{.restitution = {e}, .gamma = gamma}};
}

/// Where and how fast balls of such a scene are.
inline particulate::schemes::State bouncing_truth(const BouncingScene& scene, const std::vector<double>& heights,
                                                  double e, double t) {
  particulate::schemes::State there = particulate::scenes::start(scene);
  const auto N = static_cast<Eigen::Index>(heights.size());
  there.t = t;
  for (Eigen::Index i = 0; i < N; ++i) {
    const Bouncing::Moment now = Bouncing{.h = heights[static_cast<std::size_t>(i)], .e = e}.at(t);
    there.r[2 * N + i] = ball_radius + now.z;
    there.v[2 * N + i] = now.v;
  }
  return there;
}

/// Events of N balls: each one's lowest point comes down to the ground.
inline particulate::reference::Events ground_events(Eigen::Index N) {
  particulate::reference::Events events;
  for (Eigen::Index i = 0; i < N; ++i) {
    events.push_back(
        {.function = [row = 2 * N + i](const particulate::schemes::State& at) { return at.r[row] - ball_radius; },
         .direction = particulate::reference::Direction::falling});
  }
  return events;
}

/// What an impact on the ground does: the law itself, e u back, without forces meanwhile.
inline auto rebound(double e) {
  return [e](particulate::schemes::State& state, const std::vector<particulate::reference::Hit>& hits) {
    const Eigen::Index N = state.v.size() / 3;
    for (const particulate::reference::Hit& hit : hits) { state.v[2 * N + static_cast<Eigen::Index>(hit.event)] *= -e; }
  };
}

}  // namespace verification
