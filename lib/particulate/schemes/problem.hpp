#pragma once

#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>

#include <Eigen/Core>

/// @file
/// Problems: what a scheme is asked to integrate, and what a problem may offer beyond its right-hand side.

namespace particulate::schemes {

using In = Eigen::Ref<const Eigen::VectorXd>;  ///< a flat, contiguous, unpadded vector that is read
using Out = Eigen::Ref<Eigen::VectorXd>;       ///< a flat, contiguous, unpadded vector that is written

/// A moment of a first-order problem \f$ y' = f(t, y) \f$.
struct Values {
  double t = 0.0;     ///< time [s]
  Eigen::VectorXd y;  ///< the unknowns, in the problem's units
};

/// A moment of a second-order problem \f$ r'' = a(t, r[, v]) \f$.
///
/// For particles, r is the N x 3 array of positions read column by column: all x, then all y, then all z.
struct Motion {
  double t = 0.0;     ///< time [s]
  Eigen::VectorXd r;  ///< positions [m]
  Eigen::VectorXd v;  ///< velocities, as long as r [m/s]
};

/// A right-hand side \f$ y' = f(t, y) \f$: `rate(t, y, dy)`.
///
/// Every right-hand side returns whether it has a value at that point. False (two particles coincide, a temperature is
/// negative) is no mistake of the caller: the step is tried again smaller, or the run ends and says why. A caller's
/// mistake throws.
template <class P>
concept FirstOrderProblem = requires(P& p, double t, In y, Out dy) {
  { p.rate(t, y, dy) } -> std::same_as<bool>;
};

/// A right-hand side \f$ r'' = a(t, r) \f$, forces that depend on positions only: `acceleration(t, r, a)`.
template <class P>
concept PositionProblem = requires(P& p, double t, In r, Out a) {
  { p.acceleration(t, r, a) } -> std::same_as<bool>;
};

/// A right-hand side \f$ r'' = a(t, r, v) \f$, forces that depend on velocities too: `acceleration(t, r, v, a)`.
template <class P>
concept MotionProblem = requires(P& p, double t, In r, In v, Out a) {
  { p.acceleration(t, r, v, a) } -> std::same_as<bool>;
};

/// Either form of \f$ r'' = a \f$.
template <class P>
concept SecondOrderProblem = PositionProblem<P> || MotionProblem<P>;

/// Ability: a Jacobian of the rate, `jacobian(t, y, J)` with J(i, j) = df_i/dy_j; of a PositionProblem, that of the
/// accelerations with respect to the positions, `jacobian(t, r, K)`.
template <class P>
concept HasJacobian = requires(P& p, double t, In y, Eigen::MatrixXd& J) {
  p.jacobian(t, y, J);
};

/// Ability: the same as a sparse matrix, `sparse_jacobian(t, y, J)`.
///
/// @tparam Sparse  Eigen::SparseMatrix<double>, which this header does not need to know
template <class P, class Sparse>
concept HasSparseJacobian = requires(P& p, double t, In y, Sparse& J) {
  p.sparse_jacobian(t, y, J);
};

/// Diagonals of a banded matrix.
struct Bandwidth {
  Eigen::Index lower = 0;  ///< those below the main diagonal, >= 0 [-]
  Eigen::Index upper = 0;  ///< those above it, >= 0 [-]
};

/// Ability: `bandwidth()`, the diagonals outside which the Jacobian is zero: difference quotients then take one
/// right-hand side for each of them instead of one for each unknown.
template <class P>
concept Banded = requires(const P& p) {
  { p.bandwidth() } -> std::same_as<Bandwidth>;
};

/// Ability: a rate in two parts, `rate_slow + rate_fast = rate`, for schemes that treat them apart.
template <class P>
concept Splits = requires(P& p, double t, In y, Out dy) {
  { p.rate_slow(t, y, dy) } -> std::same_as<bool>;
  { p.rate_fast(t, y, dy) } -> std::same_as<bool>;
};

/// Ability: how far apart two states are. The monograph sums norms over particles, which a flat vector does not know.
template <class P>
concept Measures = requires(const P& p, In x, In y) {
  { p.distance(x, y) } -> std::same_as<double>;
};

/// What a jump did to the state.
struct Jump {
  long impacts = 0;            ///< pairs that exchanged an impulse [-]
  double energy_change = 0.0;  ///< kinetic energy after minus before [J]
  double overlap = 0.0;        ///< deepest overlap of two bodies before it [m]
  long evaluations = 0;        ///< right-hand sides that it asked for [-]
  std::string unsettled;       ///< not empty: the jump could not be completed, and why
  double accumulates =
      std::numeric_limits<double>::quiet_NaN();  ///< where jumps follow one another ever faster: the
                                                 ///< time that they do not get beyond; NaN: nowhere [s]
};

/// Ability: a state that may change at once, `jump(state, dt)`, called with the end of every accepted step of size dt.
template <class P>
concept Jumps = requires(P& p, Motion& at, double dt) {
  { p.jump(at, dt) } -> std::same_as<Jump>;
};

/// A step as a path: `path(theta, there)` gives the state at a fraction theta of it, from 0 to a little beyond 1,
/// `path.dt` its length [s], and `path.intervals` in how many parts it must be sampled. @see StepPath
template <class Path, class State>
concept SampledPath = requires(const Path& path, double theta, State& there) {
  path(theta, there);
  { path.dt } -> std::convertible_to<double>;
  { path.intervals } -> std::convertible_to<int>;
};

/// Ability: `first_jump(path, end)`, the first fraction in (0, end] of a step at which the state must jump, if any; the
/// path is a SampledPath. The end is 1, or a little more where a step that was shortened to a jump is looked at again.
template <class P, class Path>
concept LocatesJumps = Jumps<P> && requires(P& p, const Path& path, double end) {
  { p.first_jump(path, end) } -> std::same_as<std::optional<double>>;
};

/// A problem of several coupled fields, each of which can be advanced with the others frozen: section 7.5.1.
///
/// `fields()` says how many. `solve(k, from, dt, seen, to)` advances field k from the state `from` over dt, with every
/// other field as it stands in `seen`, and writes its own part of `to`, which may be the same object as `seen`; it
/// returns whether there is a value. `part(k, state)` is the contiguous part of a state that field k owns.
template <class P, class State>
concept StaggeredProblem = requires(P& p, std::size_t k, const State& from, double dt, State& to) {
  { p.fields() } -> std::same_as<std::size_t>;
  { p.solve(k, from, dt, from, to) } -> std::same_as<bool>;
  { p.part(k, to) } -> std::same_as<Out>;
};

/// Ability of a staggered problem: how far apart two values of one field are, `distance(k, x, y)`.
template <class P>
concept MeasuresFields = requires(const P& p, std::size_t k, In x, In y) {
  { p.distance(k, x, y) } -> std::same_as<double>;
};

/// Distance of two states in the problem's own measure, in the sum of absolute values without one.
///
/// @param problem  the problem, asked for `distance` if it has that ability
/// @param x        one state, or one set of positions
/// @param y        another of the same length
/// @return distance, >= 0, in the units of the state
template <class P>
double distance(const P& problem, In x, In y) {
  if constexpr (Measures<P>) {
    return problem.distance(x, y);
  } else {
    return (x - y).template lpNorm<1>();
  }
}

/// Distance of two values of one field in the problem's own measure, in the sum of absolute values without one.
///
/// @param problem  the problem, asked for `distance` if it has that ability
/// @param k        which field
/// @param x        one value of it
/// @param y        another of the same length
/// @return distance, >= 0, in the units of the field
template <class P>
double distance(const P& problem, std::size_t k, In x, In y) {
  if constexpr (MeasuresFields<P>) {
    return problem.distance(k, x, y);
  } else {
    return (x - y).template lpNorm<1>();
  }
}

/// Counts right-hand sides, and passes on everything else its problem can do.
///
/// Every competitor is charged by the same counter, wherever the problem is called from.
template <class P>
struct Counted {
  P& problem;            ///< the problem that answers; it must outlive the counter
  long evaluations = 0;  ///< right-hand sides asked for so far; slow and fast parts, and fields, count apart [-]
  long jacobians = 0;    ///< Jacobians asked for so far [-]

  /// @cond every ability, forwarded under its own name
  /// Counts and forwards. @see PositionProblem
  bool acceleration(double t, In r, Out a) requires PositionProblem<P> {
    ++evaluations;
    return problem.acceleration(t, r, a);
  }
  /// Counts and forwards. @see MotionProblem
  bool acceleration(double t, In r, In v, Out a) requires MotionProblem<P> {
    ++evaluations;
    return problem.acceleration(t, r, v, a);
  }
  /// Counts and forwards. @see FirstOrderProblem
  bool rate(double t, In y, Out dy) requires FirstOrderProblem<P> {
    ++evaluations;
    return problem.rate(t, y, dy);
  }
  /// Counts and forwards. @see Splits
  bool rate_slow(double t, In y, Out dy) requires Splits<P> {
    ++evaluations;
    return problem.rate_slow(t, y, dy);
  }
  /// Counts and forwards. @see Splits
  bool rate_fast(double t, In y, Out dy) requires Splits<P> {
    ++evaluations;
    return problem.rate_fast(t, y, dy);
  }
  /// Counts and forwards. @see HasJacobian
  void jacobian(double t, In y, Eigen::MatrixXd& J) requires HasJacobian<P> {
    ++jacobians;
    problem.jacobian(t, y, J);
  }
  /// Counts and forwards. @see HasSparseJacobian
  template <class Sparse>
  void sparse_jacobian(double t, In y, Sparse& J) requires HasSparseJacobian<P, Sparse> {
    ++jacobians;
    problem.sparse_jacobian(t, y, J);
  }
  /// Forwards. @see Banded
  Bandwidth bandwidth() const requires Banded<P> { return problem.bandwidth(); }
  /// Forwards. @see StaggeredProblem
  std::size_t fields() const requires requires { problem.fields(); }
  { return problem.fields(); }
  /// Counts and forwards. @see StaggeredProblem
  template <class State>
  bool solve(std::size_t k, const State& from, double dt, const State& seen,
             State& to) requires StaggeredProblem<P, State> {
    ++evaluations;
    return problem.solve(k, from, dt, seen, to);
  }
  /// Forwards. @see StaggeredProblem
  template <class State>
  Out part(std::size_t k, State& state) const requires StaggeredProblem<P, State> {
    return problem.part(k, state);
  }
  /// Forwards. @see MeasuresFields
  double distance(std::size_t k, In x, In y) const requires MeasuresFields<P> { return problem.distance(k, x, y); }
  /// Forwards. @see Measures
  double distance(In x, In y) const requires Measures<P> { return problem.distance(x, y); }
  /// Forwards. @see Jumps
  Jump jump(Motion& at, double dt) requires Jumps<P> { return problem.jump(at, dt); }
  /// Forwards. @see LocatesJumps
  template <class Path>
  std::optional<double> first_jump(const Path& path, double end) requires LocatesJumps<P, Path> {
    return problem.first_jump(path, end);
  }
  /// @endcond
};

/// Any second-order problem as \f$ y = (r, v) \f$: for integrators that know first-order problems only.
template <SecondOrderProblem P>
struct FirstOrderForm {
  P& problem;  ///< the problem that answers; it must outlive this view

  /// \f$ (r, v)' = (v, a) \f$.
  ///
  /// @param t   time [s]
  /// @param y   positions, then velocities
  /// @param dy  velocities, then accelerations; as long as y
  /// @return whether the problem has a value there
  bool rate(double t, In y, Out dy) {
    const Eigen::Index n = y.size() / 2;
    dy.head(n) = y.tail(n);
    if constexpr (PositionProblem<P>) {
      return problem.acceleration(t, y.head(n), dy.tail(n));
    } else {
      return problem.acceleration(t, y.head(n), y.tail(n), dy.tail(n));
    }
  }
};

}  // namespace particulate::schemes
