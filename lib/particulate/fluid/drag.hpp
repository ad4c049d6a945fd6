#pragma once

#include <cmath>
#include <concepts>
#include <numbers>
#include <string>
#include <vector>

#include <particulate/kinematics/domain.hpp>
#include <particulate/laws/law.hpp>

/// @file
/// What a fluid does to a sphere: drag, and the force of the pressure around it.

namespace particulate::fluid {

/// A fluid at a place; by itself a uniform stream, the same at every place and time.
struct Stream {
  Eigen::Vector3d v = Eigen::Vector3d::Zero();  ///< velocity [m/s]
  double rho = 1.2;                             ///< density, > 0 [kg/m^3]
  double mu = 1.8e-5;                           ///< viscosity, > 0 [Pa s]
  double theta = 300.0;                         ///< temperature, > 0 [K]

  /// @return this
  const Stream& operator()(double, const Eigen::Vector3d&) const { return *this; }
};

/// What tells a Stream at a time and a place: `field(t, x)`. A Stream is one, so is any callable, and a FrozenFlow.
template <class F>
concept StreamField = requires(const F& field, double t, const Eigen::Vector3d& x) {
  { field(t, x) } -> std::convertible_to<Stream>;
};

/// @param stream  a fluid at a place
/// @return whether it is one: positive where it must be, and finite
inline bool is_value(const Stream& stream) {
  return stream.rho > 0.0 && stream.mu > 0.0 && stream.theta > 0.0 && stream.v.allFinite() &&
         std::isfinite(stream.rho + stream.mu + stream.theta);
}

/// Refuses a stream that is none.
///
/// @param stream  a fluid at a place
/// @throws std::invalid_argument naming what must hold and what was given
void validate(const Stream& stream);

/// The Reynolds number at which the drag of a sphere drops, because the flow along its surface becomes turbulent.
inline constexpr double drag_crisis = 3e5;

/// Drag coefficient of a smooth sphere.
///
/// \f[ C_D = \begin{cases} 24/Re & Re \le 1 \\ 24/Re^{0.646} & 1 < Re \le 400 \\ 0.5 & 400 < Re \le 3 \cdot 10^5
///     \\ 0.000366\,Re^{0.4275} & 3 \cdot 10^5 < Re \le 2 \cdot 10^6 \\ 0.18 & 2 \cdot 10^6 < Re \end{cases} \f]
///
/// @equation{R 8.1.1} Source: Chow 1980, as the monograph cites it. It jumps: by -0.07 % at 400, by -84 % at the
/// drag_crisis, by -0.44 % at 2e6.
/// @param Re  Reynolds number of the diameter, >= 0 [-]
/// @return C_D; infinite at 0 [-]
double drag_coefficient(double Re);

/// Drag over the velocity of the fluid past a sphere.
///
/// \f[ \xi = \tfrac12 C_D\, \rho_f\, u\, \pi b^2, \qquad Re = \frac{2 b\, \rho_f\, u}{\mu_f}, \qquad
///     \xi \to 6 \pi \mu_f b \quad (Re \le 1) \f]
///
/// @equation{R 8.1.1} Finite at rest.
/// @param fluid  around the sphere
/// @param b      radius [m]
/// @param u      speed of the fluid past it, >= 0 [m/s]
/// @return xi, with the drag xi (v_f - v) [kg/s]
double drag_rate(const Stream& fluid, double b, double u);

/// Drag of a sphere,
///
/// \f[ \Psi^{drag} = \tfrac12 C_D\, \rho_f\, \|v_f - v\|\, (v_f - v)\, \pi b^2 . \f]
///
/// @equation{R 8.1.1}
/// @param fluid  around the sphere
/// @param b      radius [m]
/// @param v      velocity of the sphere [m/s]
/// @return force on it [N]
inline Eigen::Vector3d drag(const Stream& fluid, double b, const Eigen::Vector3d& v) {
  const Eigen::Vector3d past = fluid.v - v;
  return drag_rate(fluid, b, kinematics::length(past)) * past;
}

/// The speeds at which drag balances a force, from the lowest: of a sphere that falls, its terminal speeds.
///
/// @equation{D 8.1.1} Branch by branch in closed form. Where C_D jumps down, forces in a certain range have two: a
/// sphere settles at the one on its side of the jump, which repels.
/// @param fluid  around the sphere, at rest
/// @param b      radius, > 0 [m]
/// @param force  on it, >= 0 and finite [N]
/// @return one or two speeds [m/s]
/// @throws std::invalid_argument for what is no force, no sphere or no fluid
std::vector<double> steady_speeds(const Stream& fluid, double b, double force);

namespace detail {

void require_finite_gravity(const Eigen::Vector3d& g);
inline double volume(double b) { return 4.0 / 3.0 * std::numbers::pi * b * b * b; }
std::string no_stream(Eigen::Index particle, const Eigen::Vector3d& place, const Stream& there);

template <StreamField Field>
std::string why_no_stream(const laws::At<>& at, const Field& fluid) {
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    const Stream there = fluid(at.t, at.position.row(i));
    if (!is_value(there)) return no_stream(i, at.position.row(i), there);
  }
  return {};
}

}  // namespace detail

/// Drag on each particle in a given flow, which does not feel it.
///
/// @equation{R 8.1.1} It asks for velocities: Verlet cannot take it. It has no potential.
/// @tparam Field  a Stream, a callable or a FrozenFlow
template <StreamField Field>
struct Drag {
  Field fluid;  ///< around the particles
};
/// @cond
template <class Field>
Drag(Field) -> Drag<Field>;
/// @endcond

/// What the pressure of a fluid at rest in gravity adds: the weight of the fluid that a particle displaces, upwards.
///
/// \f[ \Psi_i = -\tfrac43 \pi b_i^3\, \rho_f\, g \f]
///
/// @equation{D 8.1.1} An outer force like gravity itself: what holds that pressure is not part of the scene.
/// @tparam Field  a Stream, a callable or a FrozenFlow
template <StreamField Field>
struct Buoyancy {
  Field fluid;                         ///< around the particles
  Eigen::Vector3d g{0.0, 0.0, -9.81};  ///< acceleration of gravity [m/s^2]
};
/// @cond
template <class Field>
Buoyancy(Field) -> Buoyancy<Field>;
template <class Field>
Buoyancy(Field, Eigen::Vector3d) -> Buoyancy<Field>;
/// @endcond

/// Refuses a uniform stream that is none. What a field answers is looked at where it is asked.
///
/// @param law  the drag
/// @throws std::invalid_argument naming what must hold and what was given
inline void validate(const Drag<Stream>& law) { validate(law.fluid); }
/// Refuses a uniform stream that is none, and an acceleration that is not finite.
///
/// @param law  the buoyancy
/// @throws std::invalid_argument naming what must hold and what was given
template <StreamField Field>
void validate(const Buoyancy<Field>& law) {
  if constexpr (std::same_as<Field, Stream>) validate(law.fluid);
  detail::require_finite_gravity(law.g);
}

/// Adds the drag.
///
/// @equation{R 8.1.1}
/// @param law    a law that validate() accepts
/// @param at     the particles
/// @param force  receives the forces, added to what it holds [N]
/// @return whether the fluid has a value at each of them
template <StreamField Field, kinematics::Domain D>
bool add_force(const Drag<Field>& law, const D&, const laws::At<laws::Velocity>& at, laws::Forces force) {
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    const Stream there = law.fluid(at.t, at.position.row(i));
    if (!is_value(there)) return false;
    force.row(i) += drag(there, at.radius[i], at.velocity.row(i));
  }
  return force.allFinite();
}

/// Adds the weights of displaced fluid.
///
/// @equation{D 8.1.1}
/// @param law    a law that validate() accepts
/// @param at     the particles
/// @param force  receives the forces, added to what it holds [N]
/// @return whether the fluid has a value at each of them
template <StreamField Field, kinematics::Domain D>
bool add_force(const Buoyancy<Field>& law, const D&, const laws::At<>& at, laws::Forces force) {
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    const Stream there = law.fluid(at.t, at.position.row(i));
    if (!is_value(there)) return false;
    force.row(i) -= detail::volume(at.radius[i]) * there.rho * law.g;
  }
  return force.allFinite();
}

/// @param law  the drag
/// @param at   the particles
/// @return which of them the fluid has no value at; empty: none
template <StreamField Field, kinematics::Domain D>
std::string why_no_force(const Drag<Field>& law, const D&, const laws::At<>& at) {
  return detail::why_no_stream(at, law.fluid);
}
/// @param law  the buoyancy
/// @param at   the particles
/// @return which of them the fluid has no value at; empty: none
template <StreamField Field, kinematics::Domain D>
std::string why_no_force(const Buoyancy<Field>& law, const D&, const laws::At<>& at) {
  return detail::why_no_stream(at, law.fluid);
}

}  // namespace particulate::fluid
