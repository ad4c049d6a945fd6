#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>

/// @file
/// A scene with heat as two fields, its motion and its temperatures, for staggering and for heat that is stiff.

namespace particulate::scenes {

/// The temperatures of a scene, with the motion frozen: a problem of first order of their own. @see
/// schemes::FirstOrderProblem
///
/// \f[ m_i c_i\, \dot\theta_i = \dot Q_i(r, v, \theta) \f]
///
/// @equation{R 7.5.1} With a sparse Jacobian where every law that heats knows its slopes, so that Newton iteration
/// takes steps that heat as stiff as a reaction or a radiation allows.
/// @tparam S  a Scene with has_heat_flow; it must outlive the field
template <class S>
struct Temperatures {
  const S& scene;     ///< whose laws heat
  schemes::State at;  ///< r and v, frozen

  /// @param t   time [s]
  /// @param y   temperatures, N numbers [K]
  /// @param dy  receives their rates [K/s]
  /// @return whether all have a finite value
  bool rate(double t, schemes::In y, schemes::Out dy) const { return scene.temperature_rates(t, at.r, at.v, y, dy); }
  /// @param t  time [s]
  /// @param y  temperatures, N numbers [K]
  /// @param J  receives the derivatives of their rates, N x N [1/s]
  void sparse_jacobian(double t, schemes::In y, schemes::SparseJacobian& J) const requires requires {
    scene.temperature_jacobian(t, at.r, at.v, y, J);
  }
  { scene.temperature_jacobian(t, at.r, at.v, y, J); }
};

/// The motion of a scene, with the temperatures frozen. @see schemes::SecondOrderProblem
///
/// @equation{R 7.5.1} Without jumps, which a StaggeredScene makes once a step.
/// @tparam S  a Scene that is_coupled; it must outlive the field
template <class S>
struct Motion {
  const S& scene;     ///< whose laws exert forces
  Eigen::VectorXd y;  ///< temperatures, frozen [K]

  /// @param t  time [s]
  /// @param r  positions, 3 N numbers [m]
  /// @param a  receives the accelerations [m/s^2]
  /// @return whether all have a finite value
  bool acceleration(double t, schemes::In r, schemes::Out a) const requires(!S::needs_velocity) {
    return scene.motion_rates(t, r, r, y, a);
  }
  /// @param t  time [s]
  /// @param r  positions, 3 N numbers [m]
  /// @param v  velocities, 3 N numbers [m/s]
  /// @param a  receives the accelerations [m/s^2]
  /// @return whether all have a finite value
  bool acceleration(double t, schemes::In r, schemes::In v, schemes::Out a) const requires S::needs_velocity {
    return scene.motion_rates(t, r, v, y, a);
  }
};

/// A scene with heat whose motion and temperatures are solved in turn, each with the other frozen as it was found last:
/// the two fields, 0 and 1, of schemes::Staggered.
///
/// @equation{R 7.5.1} Each field takes one step of a scheme of its own: a temperature then may have a stiff one. As the
/// other field stands still over that step, at its end, the whole is of order 1 whatever the two are. Jumps come once,
/// at the end of an accepted step. Where no force depends on temperature the second sweep changes nothing: staggering
/// is then trivial.
/// @tparam S             a Scene with has_heat_flow; it must outlive this
/// @tparam MotionScheme  advances the motion of S
/// @tparam HeatScheme    advances values of first order
template <class S, schemes::Scheme MotionScheme, schemes::Scheme HeatScheme>
struct StaggeredScene {
  static_assert(S::has_heat_flow,
                "a staggered scene needs a law that heats or cools: without one its temperatures have no rate");

  const S& scene;              ///< the scene
  MotionScheme motion_scheme;  ///< for field 0
  HeatScheme heat_scheme;      ///< for field 1

  /// @return 2
  std::size_t fields() const { return 2; }
  /// @param k  which field
  /// @return the motion, or all of y
  schemes::Part part(std::size_t k) const {
    return k == 0 ? schemes::Part{.motion = true} : schemes::Part{.first = 0, .size = scene.particles().size()};
  }
  /// One step of one field. @see schemes::StaggeredProblem
  ///
  /// @param k     which field
  /// @param from  state at the start of the step
  /// @param dt    step [s]
  /// @param seen  where the other field is taken from
  /// @param to    receives the field
  /// @return whether its scheme could make the step
  bool solve(std::size_t k, const schemes::State& from, double dt, const schemes::State& seen, schemes::State& to) {
    if (k == 0) {
      Motion<S> field{.scene = scene, .y = seen.y};
      schemes::State own{.t = from.t, .r = from.r, .v = from.v};
      if (!steps(field, motion_scheme, dt, own)) return false;
      to.r = own.r, to.v = own.v;
    } else {
      Temperatures<S> field{.scene = scene, .at = {.t = seen.t, .r = seen.r, .v = seen.v}};
      schemes::State own{.t = from.t, .y = from.y};
      if (!steps(field, heat_scheme, dt, own)) return false;
      to.y = own.y;
    }
    return true;
  }
  /// @param k  which field
  /// @param x  one set of its values
  /// @param y  another
  /// @return the sum over particles of the distances of their places [m]; of temperatures, of their differences [K]
  double distance(std::size_t k, schemes::In x, schemes::In y) const {
    return k == 0 ? scene.distance(x, y) : (x - y).template lpNorm<1>();
  }
  /// @param state  a state of the scene; it is changed
  /// @param dt     the step that ends there [s]
  /// @return what contacts and limits did
  schemes::Jump jump(schemes::State& state, double dt) const requires(S::jumping_laws > 0) {
    return scene.jump(state, dt);
  }
  /// @param state  a state of the scene
  /// @return why it has no value there; empty: it has
  std::string why_no_value(const schemes::State& state) const { return scene.why_no_value(state); }

 private:
  template <class Field, class Scheme>
  static bool steps(Field& field, Scheme& scheme, double dt, schemes::State& own) {
    const double end = own.t + dt;
    own.t_carry = (end - own.t) - dt;  // the step is dt to the last bit, however late it is
    const schemes::Outcome made = schemes::integrate(field, own, end, scheme, schemes::FixedStep{.step = dt});
    return made.status == schemes::Status::reached;
  }
};

/// @param scene          the scene; it must outlive both
/// @param motion_scheme  for its motion
/// @param heat_scheme    for its temperatures
/// @return both fields, to be advanced by schemes::Staggered
template <class S, class MotionScheme, class HeatScheme>
StaggeredScene<S, MotionScheme, HeatScheme> staggered(const S& scene, MotionScheme motion_scheme,
                                                      HeatScheme heat_scheme) {
  return {scene, std::move(motion_scheme), std::move(heat_scheme)};
}
/// A scene that ends with its line has no fields that outlive it.
template <class S, class MotionScheme, class HeatScheme>
void staggered(const S&&, MotionScheme, HeatScheme) = delete;

}  // namespace particulate::scenes
