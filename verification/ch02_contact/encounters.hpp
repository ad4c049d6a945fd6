#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <particulate/contact/contact.hpp>
#include <particulate/kinematics/domain.hpp>
#include <particulate/scenes/scene.hpp>

/// @file
/// Random impacts, and the monograph's formulas for them in extended precision, in terms of masses and forces where the
/// library computes with inverse masses and impulses.

namespace verification {

using Wide = long double;                      ///< 64 binary digits: its rounding is 2000 times below the library's
using WideVector = Eigen::Matrix<Wide, 3, 1>;  ///< of those
inline constexpr double eps = std::numeric_limits<double>::epsilon();  ///< spacing of doubles at 1

/// Keeps the larger of two deviations; a NaN, once seen, stays, so that it fails whatever it is compared with.
inline void keep_worst(double& worst, Wide deviation) {
  if (std::isnan(worst) || deviation <= worst) return;
  worst = static_cast<double>(deviation);
}

/// Two bodies that touch, what acts on them, and the laws of their impact.
struct Encounter {
  particulate::contact::Body i = {}, j = {};                 ///< the bodies
  Eigen::Vector3d n = Eigen::Vector3d::UnitX();              ///< unit vector from i to j
  double e = 1.0;                                            ///< restitution
  particulate::contact::Friction friction = {};              ///< Coulomb's coefficients
  Eigen::Vector3d acceleration_i = Eigen::Vector3d::Zero();  ///< of i by other forces [m/s^2]
  Eigen::Vector3d acceleration_j = Eigen::Vector3d::Zero();  ///< of j likewise [m/s^2]
  double duration = 1e-3;                                    ///< gamma Dt, > 0 [s]
};

/// What random encounters are drawn from.
struct Drawn {
  double decades = 2.0;          ///< masses are 10^x, x uniform in [-decades, decades]
  double bulk = 1.0;             ///< largest speed that both share, in closing speeds
  double mu = 0.0;               ///< mu_s is uniform in [0, mu], mu_d in [0, mu_s]
  double acceleration = 0.0;     ///< largest component of the accelerations [m/s^2]
  bool only_approaching = true;  ///< else a third of the pairs part
};

/// Draws encounters: closing speeds of 1e-3 to 1e3 m/s, from any direction, head-on to grazing; every fourth at 76
/// degrees from the normal and every fourth at 89.9; e is 0 and 1 in one of eight each, else uniform between.
class Encounters {
 public:
  Encounters(const Drawn& of, std::uint64_t seed) : of_(of), engine_(seed) {}

  Encounter next() {
    Encounter at;
    const WideVector n = direction().cast<Wide>().normalized();
    at.n = n.cast<double>();
    const double angle = incidence();
    const Eigen::Vector3d across = at.n.cross(direction()).normalized();
    const double speed = std::pow(10.0, 3.0 * uniform());
    const double sign = !of_.only_approaching && uniform() < -1.0 / 3.0 ? -1.0 : 1.0;
    at.j = {.velocity = of_.bulk * speed * direction(), .inverse_mass = std::pow(10.0, of_.decades * uniform())};
    at.i = {.velocity = at.j.velocity + speed * (sign * std::cos(angle) * at.n + std::sin(angle) * across),
            .inverse_mass = std::pow(10.0, of_.decades * uniform())};
    at.e = std::clamp(0.5 + 2.0 / 3.0 * uniform(), 0.0, 1.0);
    const double mu_s = of_.mu * positive();
    at.friction = {.mu_s = mu_s, .mu_d = mu_s * positive()};
    at.acceleration_i = of_.acceleration * direction();
    at.acceleration_j = of_.acceleration * direction();
    return at;
  }

  /// Uniform in [-1, 1).
  double uniform() { return uniform_(engine_); }
  /// Uniform in [0, 1).
  double positive() { return 0.5 + 0.5 * uniform(); }
  /// A unit vector, uniform over the sphere.
  Eigen::Vector3d direction() {
    Eigen::Vector3d v;
    do { v = {uniform(), uniform(), uniform()}; } while (!(v.squaredNorm() <= 1.0 && v.squaredNorm() > 1e-4));
    return v.normalized();
  }

 private:
  double incidence() {
    constexpr double degree = std::numbers::pi / 180.0;
    const long kind = count_++ % 4;
    return degree * (kind == 0 ? 76.0 : kind == 1 ? 89.9 : 90.0 * positive());
  }

  Drawn of_;
  boost::random::mt19937_64 engine_;
  boost::random::uniform_real_distribution<double> uniform_{-1.0, 1.0};
  long count_ = 0;
};

/// One impact by the monograph's formulas.
struct WideImpact {
  bool acts = false;                         ///< u > 0 and u + Delta_1 > 0
  Wide u = 0, delta1 = 0, delta2 = 0;        ///< approach speed, changes of it over both phases [m/s]
  WideVector velocity_i, velocity_j;         ///< after [m/s]
  Wide mean_normal_force = 0;                ///< on i along n, <= 0 [N]
  WideVector friction = WideVector::Zero();  ///< mean force on i [N]
  bool sticks = false;                       ///< whether friction holds
};

/// The impact map in extended precision, for two bodies that can move.
inline WideImpact monograph_impact(const Encounter& at) {
  const Wide m_i = 1 / static_cast<Wide>(at.i.inverse_mass), m_j = 1 / static_cast<Wide>(at.j.inverse_mass);
  const Wide e = at.e, dt = at.duration, dt1 = dt / (1 + e), dt2 = e * dt1;
  const WideVector n = at.n.cast<Wide>(), v_i = at.i.velocity.cast<Wide>(), v_j = at.j.velocity.cast<Wide>();
  const WideVector force_i = m_i * at.acceleration_i.cast<Wide>(), force_j = m_j * at.acceleration_j.cast<Wide>();
  const Wide v_in = v_i.dot(n), v_jn = v_j.dot(n), E_in = force_i.dot(n) * dt, E_jn = force_j.dot(n) * dt;

  WideImpact out;
  out.u = v_in - v_jn;
  out.delta1 = (force_i.dot(n) / m_i - force_j.dot(n) / m_j) * dt1;
  out.delta2 = (force_i.dot(n) / m_i - force_j.dot(n) / m_j) * dt2;
  out.velocity_i = v_i + dt / m_i * force_i;
  out.velocity_j = v_j + dt / m_j * force_j;
  out.acts = out.u > 0 && out.u + out.delta1 > 0;
  if (!out.acts) return out;

  const Wide parting = e * (out.u + out.delta1) - out.delta2;
  const Wide v_in_after = (m_i * v_in + m_j * v_jn + E_in + E_jn - m_j * parting) / (m_i + m_j);
  // (2.17) on the lighter body, which loses no digits.
  out.mean_normal_force =
      m_i <= m_j ? (m_i * (v_in_after - v_in) - E_in) / dt : -(m_j * (v_in_after + parting - v_jn) - E_jn) / dt;
  const WideVector slip = (v_i - v_j) + dt * (force_i / m_i - force_j / m_j);
  const WideVector no_slip = (slip - slip.dot(n) * n) / ((1 / m_i + 1 / m_j) * dt);
  const Wide normal = std::abs(out.mean_normal_force);
  out.sticks = no_slip.norm() <= at.friction.mu_s * normal;
  if (out.sticks) {
    out.friction = -no_slip;
  } else {
    out.friction = -at.friction.mu_d * normal / no_slip.norm() * no_slip;
  }
  const WideVector tangential_i = out.velocity_i - out.velocity_i.dot(n) * n;
  const WideVector tangential_j = out.velocity_j - out.velocity_j.dot(n) * n;
  out.velocity_i = v_in_after * n + tangential_i + dt / m_i * out.friction;
  out.velocity_j = (v_in_after + parting) * n + tangential_j - dt / m_j * out.friction;
  return out;
}

/// The library's answer to an encounter.
inline particulate::contact::Rebound library_impact(const Encounter& at) {
  return impact(at.i, at.j, at.n, at.e, at.acceleration_i, at.acceleration_j, at.duration, at.friction);
}

/// Largest speed before and after: what rounding is measured against.
inline double largest_speed(const Encounter& at, const Eigen::Vector3d& after_i, const Eigen::Vector3d& after_j) {
  return std::max({at.i.velocity.norm(), at.j.velocity.norm(), after_i.norm(), after_j.norm()});
}

/// Kinetic energy of two bodies that can move, evaluated in extended precision.
inline Wide pair_energy(const Encounter& at, const WideVector& v_i, const WideVector& v_j) {
  return v_i.squaredNorm() / (2 * static_cast<Wide>(at.i.inverse_mass)) +
         v_j.squaredNorm() / (2 * static_cast<Wide>(at.j.inverse_mass));
}

/// The bodies of an encounter as spheres of diameter 1 that overlap slightly, i at the origin, so that their
/// separation holds no rounding. Immovable is what has no inverse mass.
inline particulate::kinematics::Particles touching_pair(const Encounter& at) {
  particulate::kinematics::Particles pair{.position = particulate::kinematics::Vectors::Zero(2, 3),
                                          .velocity = particulate::kinematics::Vectors(2, 3),
                                          .mass = Eigen::Vector2d::Ones(),
                                          .radius = Eigen::Vector2d::Constant(0.5 + 1e-9),
                                          .immovable = {at.i.inverse_mass == 0.0, at.j.inverse_mass == 0.0}};
  pair.position.row(1) = at.n;
  pair.velocity << at.i.velocity.transpose(), at.j.velocity.transpose();
  if (at.i.inverse_mass > 0.0) pair.mass[0] = 1.0 / at.i.inverse_mass;
  if (at.j.inverse_mass > 0.0) pair.mass[1] = 1.0 / at.j.inverse_mass;
  return pair;
}

/// Velocities that a scene's jump leaves, and what it says of itself.
struct Jumped {
  particulate::schemes::Jump jump;     ///< its report
  particulate::kinematics::Vectors v;  ///< velocities after [m/s]
};

/// Lets the contacts of a scene act on its start.
///
/// @throws std::runtime_error if the jump could not be completed
template <class Scene>
Jumped jump_of(const Scene& scene, double dt) {
  particulate::schemes::State state = particulate::scenes::start(scene);
  const particulate::schemes::Jump jump = scene.jump(state, dt);
  if (!jump.unsettled.empty()) throw std::runtime_error("a jump was not completed: " + jump.unsettled);
  return {.jump = jump, .v = velocities(state)};
}

/// A scene of particles in unbounded space that meet, and feel nothing else.
template <class R, class F>
auto contact_scene(const particulate::kinematics::Particles& particles,
                   const particulate::contact::Contact<R, F>& law) {
  return particulate::scenes::Scene<particulate::kinematics::Space, particulate::contact::Contact<R, F>>{
      particles, particulate::kinematics::Space{}, law};
}

/// The contact law of restitution e and friction.
inline particulate::contact::Contact<particulate::contact::ConstantRestitution, particulate::contact::Friction> rough(
    double e, const particulate::contact::Friction& friction,
    particulate::contact::Resolution resolution = particulate::contact::Resolution::sequential) {
  return {.restitution = {e}, .friction = friction, .gamma = 0.01, .resolution = resolution};
}

/// The contact law of restitution e without friction.
inline particulate::contact::Contact<> smooth(
    double e, particulate::contact::Resolution resolution = particulate::contact::Resolution::sequential) {
  return {.restitution = {e}, .friction = {}, .gamma = 0.01, .resolution = resolution};
}

/// Velocities of both bodies.
using Velocities = std::array<Eigen::Vector3d, 2>;

/// @return those after an impact by itself
inline Velocities by_impact(const Encounter& at) {
  const particulate::contact::Rebound after = library_impact(at);
  return {after.velocity_i, after.velocity_j};
}

/// @return those after a jump of a scene in which the pair touches
template <class L>
Velocities by_scene(const Encounter& at, const L& law) {
  const Jumped after = jump_of(contact_scene(touching_pair(at), law), 1e-3);
  return {after.v.row(0).transpose(), after.v.row(1).transpose()};
}

/// How impacts of one moment are resolved, by name.
inline constexpr std::pair<particulate::contact::Resolution, const char*> resolutions[] = {
    {particulate::contact::Resolution::summed, "summed"}, {particulate::contact::Resolution::sequential, "sequential"}};

}  // namespace verification
