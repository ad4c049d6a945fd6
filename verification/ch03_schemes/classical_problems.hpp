#pragma once

#include <cmath>

#include <particulate/kinematics/domain.hpp>
#include <particulate/kinematics/particles.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/problem.hpp>

/// @file
/// Problems of the literature with published digits: the test set for initial value problems, @cite mazzia2008.

namespace verification {

/// Robertson's three reactions, of which one is 1e9 times faster than another.
///
/// y1' = -0.04 y1 + 1e4 y2 y3, y2' = 0.04 y1 - 1e4 y2 y3 - 3e7 y2^2, y3' = 3e7 y2^2; the sum of all stays 1.
struct Robertson {
  /// The three rates. @see particulate::schemes::FirstOrderProblem
  bool rate(double, particulate::schemes::In y, particulate::schemes::Out dy) const {
    const double first = 0.04 * y[0], second = 3e7 * y[1] * y[1], third = 1e4 * y[1] * y[2];
    dy[0] = third - first;
    dy[1] = first - third - second;
    dy[2] = second;
    return true;
  }
  /// Their derivatives. @see particulate::schemes::HasJacobian
  void jacobian(double, particulate::schemes::In y, Eigen::MatrixXd& J) const {
    J.resize(3, 3);
    J.row(0) << -0.04, 1e4 * y[2], 1e4 * y[1];
    J.row(2) << 0.0, 6e7 * y[1], 0.0;
    J.row(1) = -J.row(0) - J.row(2);
  }
  /// @return one of the first substance, none of the others
  static particulate::schemes::State start() { return {.t = 0.0, .y = Eigen::Vector3d{1.0, 0.0, 0.0}}; }
  /// @return the published digits
  static particulate::schemes::State published() {
    return {.t = 1e11, .y = Eigen::Vector3d{2.083340149701255e-8, 8.333360770334713e-14, 0.9999999791665050}};
  }
};

/// Van der Pol's oscillator, y1' = y2, y2' = mu (1 - y1^2) y2 - y1: slow but for two leaps a period of 0.81 mu.
struct VanDerPol {
  double mu = 1000.0;  ///< strength of the damping [-]

  /// Both rates. @see particulate::schemes::FirstOrderProblem
  bool rate(double, particulate::schemes::In y, particulate::schemes::Out dy) const {
    dy[0] = y[1];
    dy[1] = mu * (1.0 - y[0] * y[0]) * y[1] - y[0];
    return true;
  }
  /// Their derivatives. @see particulate::schemes::HasJacobian
  void jacobian(double, particulate::schemes::In y, Eigen::MatrixXd& J) const {
    J.resize(2, 2);
    J << 0.0, 1.0, -2.0 * mu * y[0] * y[1] - 1.0, mu * (1.0 - y[0] * y[0]);
  }
  /// @return the outermost place, at rest
  static particulate::schemes::State start() { return {.t = 0.0, .y = Eigen::Vector2d{2.0, 0.0}}; }
  /// @return the published digits, mu = 1000
  static particulate::schemes::State published() {
    return {.t = 2000.0, .y = Eigen::Vector2d{1.706167732170469, -8.928097010248125e-4}};
  }
};

/// The Oregonator, a model of the Belousov-Zhabotinskii reaction: three substances that pulsate over five decades.
///
/// y1' = s (y2 - y1 y2 + y1 - q y1^2), y2' = (y3 - y2 - y1 y2)/s, y3' = w (y1 - y3).
struct Oregonator {
  double s = 77.27;     ///< [-]
  double q = 8.375e-6;  ///< [-]
  double w = 0.161;     ///< [-]

  /// The three rates. @see particulate::schemes::FirstOrderProblem
  bool rate(double, particulate::schemes::In y, particulate::schemes::Out dy) const {
    dy[0] = s * (y[1] - y[0] * y[1] + y[0] - q * y[0] * y[0]);
    dy[1] = (y[2] - y[1] - y[0] * y[1]) / s;
    dy[2] = w * (y[0] - y[2]);
    return true;
  }
  /// Their derivatives. @see particulate::schemes::HasJacobian
  void jacobian(double, particulate::schemes::In y, Eigen::MatrixXd& J) const {
    J.resize(3, 3);
    J.row(0) << s * (1.0 - y[1] - 2.0 * q * y[0]), s * (1.0 - y[0]), 0.0;
    J.row(1) << -y[1] / s, -(1.0 + y[0]) / s, 1.0 / s;
    J.row(2) << w, 0.0, -w;
  }
  /// @return (1, 2, 3)
  static particulate::schemes::State start() { return {.t = 0.0, .y = Eigen::Vector3d{1.0, 2.0, 3.0}}; }
  /// @return the published digits
  static particulate::schemes::State published() {
    return {.t = 360.0, .y = Eigen::Vector3d{1.000814870318523, 1228.178521549917, 132.0554942846706}};
  }
};

/// The same rates without their Jacobian, for methods that must form it from difference quotients.
template <class P>
struct WithoutJacobian {
  P problem = {};  ///< which answers

  /// Forwards. @see particulate::schemes::FirstOrderProblem
  bool rate(double t, particulate::schemes::In y, particulate::schemes::Out dy) const { return problem.rate(t, y, dy); }
};

/// The Pleiades: seven stars of masses 1 ... 7 in a plane, which pass close by one another. Gravity with the constant 1
/// is the near field that attracts with the square of the distance and repels not at all.
inline particulate::scenes::Scene<particulate::kinematics::Space, particulate::laws::NearField> pleiades() {
  particulate::kinematics::Particles stars{.position = particulate::kinematics::Vectors::Zero(7, 3),
                                           .velocity = particulate::kinematics::Vectors::Zero(7, 3),
                                           .mass = Eigen::VectorXd::LinSpaced(7, 1.0, 7.0),
                                           .radius = Eigen::VectorXd::Zero(7)};
  stars.position.col(0) << 3.0, 3.0, -1.0, -3.0, 2.0, -2.0, 2.0;
  stars.position.col(1) << 3.0, -3.0, 2.0, 0.0, 0.0, -4.0, 4.0;
  stars.velocity.col(0) << 0.0, 0.0, 0.0, 0.0, 0.0, 1.75, -1.5;
  stars.velocity.col(1) << 0.0, 0.0, 0.0, -1.25, 1.0, 0.0, 0.0;
  return {stars, particulate::kinematics::Space{},
          particulate::laws::NearField{.alpha1 = 1.0, .alpha2 = 0.0, .beta1 = 2.0}};
}

/// Where the Pleiades have published digits [s].
inline constexpr double pleiades_end = 3.0;

}  // namespace verification
