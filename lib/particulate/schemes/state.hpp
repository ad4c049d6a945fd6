#pragma once

#include <string_view>
#include <utility>

#include <Eigen/Core>

/// @file
/// The one state that every problem, scheme, event and law sees.

namespace particulate::schemes {

using In = Eigen::Ref<const Eigen::VectorXd>;  ///< a flat, contiguous, unpadded vector that is read
using Out = Eigen::Ref<Eigen::VectorXd>;       ///< a flat, contiguous, unpadded vector that is written

using VectorsOf = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3>>;   ///< N vectors of a state, a row each
using MutableVectorsOf = Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, 3>>;  ///< the same, to be written

/// A moment of a problem: places and velocities of second order, and values of first order that ride along.
///
/// \f[ r' = v, \qquad v' = a(t, r[, v][, y]), \qquad y' = f(t[, r][, v], y) \f]
///
/// What a problem does not have is empty and costs nothing. For particles, r is the N x 3 array of positions read
/// column by column: all x, then all y, then all z; positions(), position() and their like know it.
struct State {
  double t = 0.0;          ///< time [s]
  Eigen::VectorXd r = {};  ///< places [m]
  Eigen::VectorXd v = {};  ///< their velocities, as long as r [m/s]
  Eigen::VectorXd y = {};  ///< values of first order, in the problem's units
  double t_carry = 0.0;    ///< what rounding took from t: the time is t + t_carry; zero where a user writes a state [s]
};

/// The positions of the particles of a state, N x 3, where they stand in it: a view, no copy.
///
/// @param state  of particles; it must outlive the view
/// @return its r, a row a particle [m]
/// @throws std::invalid_argument if r does not hold three numbers a particle
VectorsOf positions(const State& state);
/// @copydoc positions(const State&)
MutableVectorsOf positions(State& state);
/// A state that ends with its line has no view that outlives it.
VectorsOf positions(const State&& state) = delete;

/// The velocities of the particles of a state, N x 3, where they stand in it: a view, no copy.
///
/// @param state  of particles; it must outlive the view
/// @return its v, a row a particle [m/s]
/// @throws std::invalid_argument if v does not hold three numbers a particle
VectorsOf velocities(const State& state);
/// @copydoc velocities(const State&)
MutableVectorsOf velocities(State& state);
/// A state that ends with its line has no view that outlives it.
VectorsOf velocities(const State&& state) = delete;

/// The position of one particle, as it is now. It cannot be assigned to: set_position() writes.
///
/// @param state  of particles
/// @param i      particle, 0 <= i < N
/// @return r_i [m]
/// @throws std::invalid_argument for a particle that is not there
const Eigen::Vector3d position(const State& state, Eigen::Index i);
/// The velocity of one particle, as it is now. It cannot be assigned to: set_velocity() writes.
///
/// @param state  of particles
/// @param i      particle, 0 <= i < N
/// @return v_i [m/s]
/// @throws std::invalid_argument for a particle that is not there
const Eigen::Vector3d velocity(const State& state, Eigen::Index i);

/// Puts one particle elsewhere.
///
/// @param state  of particles
/// @param i      particle, 0 <= i < N
/// @param value  its new position [m]
/// @throws std::invalid_argument for a particle that is not there
void set_position(State& state, Eigen::Index i, const Eigen::Vector3d& value);
/// Gives one particle another velocity.
///
/// @param state  of particles
/// @param i      particle, 0 <= i < N
/// @param value  its new velocity [m/s]
/// @throws std::invalid_argument for a particle that is not there
void set_velocity(State& state, Eigen::Index i, const Eigen::Vector3d& value);

/// Exchanges two states without copying a number of them.
///
/// @param a  one
/// @param b  the other
inline void swap(State& a, State& b) noexcept {
  std::swap(a.t, b.t);
  std::swap(a.t_carry, b.t_carry);
  a.r.swap(b.r);
  a.v.swap(b.v);
  a.y.swap(b.y);
}

/// A state as one vector.
///
/// @param state  a state
/// @return (r, v, y)
Eigen::VectorXd flat(const State& state);

/// Writes one vector back into a state.
///
/// @param x      (r, v, y), as long as those of the state together
/// @param state  receives it; its time stays
void unflatten(In x, State& state);

/// Whether a computed state can be handed on: no NaN, no infinity.
///
/// @param state  a state
/// @return true if every number in it is finite
bool is_finite(const State& state);

/// Moves the time of a step, and carries on what rounding takes from it, so that a sum of many steps is right to one
/// rounding.
///
/// @param from  the start of the step
/// @param dt    the step [s]
/// @param to    receives the time of its end
inline void advance_time(const State& from, double dt, State& to) {
  const double step = dt + from.t_carry;
  to.t = from.t + step;
  to.t_carry = step - (to.t - from.t);
}

/// Rates of change of a state, beyond r' = v.
struct Rates {
  Eigen::VectorXd a = {};   ///< accelerations, as long as r [m/s^2]
  Eigen::VectorXd dy = {};  ///< rates of the values, as long as y; empty where they change by jumps alone
};

/// A named range of y, of one kind and unit: its changes are measured apart from all others.
struct Range {
  std::string_view name = "values";  ///< for reports; it must outlive the run
  Eigen::Index first = 0;            ///< where it begins in y
  Eigen::Index size = 0;             ///< how many values
  double TOL = 1.0;                  ///< tolerance of its sweeps over that of the control, > 0 [-]
};

/// The part of a state that one of several staggered fields owns.
struct Part {
  bool motion = false;     ///< r and v, measured by r; else a range of y
  Eigen::Index first = 0;  ///< where its range begins
  Eigen::Index size = 0;   ///< how long it is
};

}  // namespace particulate::schemes
