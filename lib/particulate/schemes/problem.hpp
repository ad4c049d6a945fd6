#pragma once

#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <particulate/schemes/state.hpp>

/// @file
/// Problems: what a scheme is asked to integrate, what a problem may offer beyond its right-hand side, and how a scheme
/// sees it.

namespace Eigen {
template <typename Scalar, int Options, typename Index>
class SparseMatrix;
}

namespace particulate::schemes {

using SparseJacobian = Eigen::SparseMatrix<double, 0, int>;  ///< of HasSparseJacobian

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

/// Motion and values that act on each other: `rates(t, r, v, y, a, dy)`, one function, so that what both share is
/// computed once. It counts as one evaluation.
///
/// Two constants of the problem say more. `ignores_velocities`: a and dy depend on t, r and y alone, so that
/// schemes leave out what only velocities need, and v is then not that of the moment. `values_by_jumps`: y changes by
/// jumps alone; every scheme carries it along, dy is then empty and must not be written. The latter serves problems of
/// the other forms as well, whose state then has a y.
template <class P>
concept CoupledProblem = requires(P& p, double t, In r, In v, In y, Out a, Out dy) {
  { p.rates(t, r, v, y, a, dy) } -> std::same_as<bool>;
};

/// Ability: a Jacobian of the rate, `jacobian(t, y, J)` with J(i, j) = df_i/dy_j; of a PositionProblem, that of the
/// accelerations with respect to the positions, `jacobian(t, r, K)`.
template <class P>
concept HasJacobian = requires(P& p, double t, In y, Eigen::MatrixXd& J) {
  p.jacobian(t, y, J);
};

/// Ability of a MotionProblem or CoupledProblem: the Jacobian of all its rates (a, dy) with respect to all of
/// (r, v, y), `jacobian(t, r, v, y, J)`; as many rows as rates, as many columns as numbers in the state. Values that
/// change by jumps alone have neither.
template <class P>
concept HasWholeJacobian = requires(P& p, double t, In r, In v, In y, Eigen::MatrixXd& J) {
  p.jacobian(t, r, v, y, J);
};

/// Ability: that of HasJacobian as a sparse matrix, `sparse_jacobian(t, y, J)`.
template <class P>
concept HasSparseJacobian = requires(P& p, double t, In y, SparseJacobian& J) {
  p.sparse_jacobian(t, y, J);
};

/// Diagonals of a banded matrix.
struct Bandwidth {
  Eigen::Index lower = 0;  ///< those below the main diagonal, >= 0 [-]
  Eigen::Index upper = 0;  ///< those above it, >= 0 [-]
};

/// Ability: `bandwidth()`, the diagonals outside which the Jacobian is zero: difference quotients then take one
/// right-hand side for each of them instead of one for each unknown. Not for a problem that has both motion and values.
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

/// Ability of a PositionProblem: an acceleration of which a part is cheap and changes fast, so that it can be asked
/// more often than the whole. `split(state, dt)` chooses the part for a step that starts at a state, until it is called
/// again, and returns whether it could; `acceleration_fast(t, r, a)` gives it.
template <class P>
concept SplitsMotion = PositionProblem<P> && requires(P& p, const State& at, double dt, double t, In r, Out a) {
  { p.split(at, dt) } -> std::same_as<bool>;
  { p.acceleration_fast(t, r, a) } -> std::same_as<bool>;
};

/// Ability: how far apart two sets of places are, or of values where a problem has nothing else. The monograph sums
/// norms over particles, which a flat vector does not know.
template <class P>
concept Measures = requires(const P& p, In x, In y) {
  { p.distance(x, y) } -> std::same_as<double>;
};

/// Ability: what a motion looks like from inside, wherever it is and however fast it moves as a whole: `spacing(r)`,
/// the distance of the two bodies that are nearest to one another, 0 where there are none; and `common_motion(v,
/// shared)`, the velocity that all of them share, as long as v. Errors are then relative to these, see ErrorScales and
/// IterationMeasure. Without the ability places and velocities count from zero.
template <class P>
concept HasScales = requires(const P& p, In r, In v, Out shared) {
  { p.spacing(r) } -> std::same_as<double>;
  p.common_motion(v, shared);
};

/// Ability: `ranges()`, the named ranges that y falls into, one after the other. Without it y is one.
template <class P>
concept HasRanges = requires(const P& p) {
  { p.ranges() } -> std::convertible_to<std::vector<Range>>;
};

/// What one of several laws did in a jump.
struct JumpShare {
  long impacts = 0;            ///< pairs that exchanged an impulse, or changes of another kind [-]
  double energy_change = 0.0;  ///< kinetic energy after minus before [J]
};

/// What a jump did to the state.
struct Jump {
  long impacts = 0;            ///< pairs that exchanged an impulse [-]
  double energy_change = 0.0;  ///< kinetic energy after minus before [J]
  double heat = 0.0;           ///< thermal energy after minus before [J]
  double released = 0.0;       ///< chemical energy of which that came, beside kinetic energy [J]
  double overlap = 0.0;        ///< deepest overlap of two bodies before it [m]
  double penetration = 0.0;    ///< largest overlap over the diameter of the smaller of the two [-]
  double travel = 0.0;         ///< largest move of a body in the step, over its radius, if bodies could pass unseen [-]
  long evaluations = 0;        ///< right-hand sides that it asked for [-]
  std::string unsettled = {};  ///< not empty: the jump could not be completed, and why
  double accumulates =
      std::numeric_limits<double>::quiet_NaN();  ///< where jumps follow one another ever faster: the
                                                 ///< time that they do not get beyond; NaN: nowhere [s]
  std::vector<JumpShare> by_law = {};            ///< of each law that jumps, in their order; empty where there is one
};

/// Ability: a state that may change at once, `jump(state, dt)`, called with the end of every accepted step of size dt.
template <class P>
concept Jumps = requires(P& p, State& at, double dt) {
  { p.jump(at, dt) } -> std::same_as<Jump>;
};

/// Bodies that overlap in a state.
struct Overlap {
  long contacts = 0;     ///< pairs that do, and bodies with walls [-]
  double deepest = 0.0;  ///< largest depth among them [m]
};

/// Ability: which bodies overlap in a state, `overlap(state)`.
template <class P>
concept HasOverlap = requires(P& p, const State& at) {
  { p.overlap(at) } -> std::same_as<Overlap>;
};

/// Ability: `why_no_value(state)`, why a right-hand side has no value there; empty where that is not known, or it has.
template <class P>
concept SaysWhy = requires(P& p, const State& at) {
  { p.why_no_value(at) } -> std::same_as<std::string>;
};

/// The step made last, as a path: the state at a fraction theta of it, by the dense output of its scheme.
struct StepPath {
  const void* scheme;                                                                        ///< holds the step
  void (*at)(const void* scheme, const State& from, double dt, double theta, State& there);  ///< its dense output
  const State& from;                                                                         ///< its start
  double dt;                                                                                 ///< its length [s]
  int intervals;              ///< to sample it in: twice its degree, for Gauss
  const State* to = nullptr;  ///< its end, which dense output meets to rounding alone; none: it must do

  /// @param theta  fraction of the step, from 0 to a little beyond 1 [-]
  /// @param there  receives the state
  void operator()(double theta, State& there) const {
    if (to && theta == 1.0) {
      there = *to;
    } else {
      at(scheme, from, dt, theta, there);
    }
  }
};

/// Ability: `first_jump(path, end)`, the first fraction in (0, end] of a step at which the state must jump, if any. The
/// end is 1, or a little more where a step that was shortened to a jump is looked at again.
template <class P>
concept LocatesJumps = Jumps<P> && requires(P& p, const StepPath& path, double end) {
  { p.first_jump(path, end) } -> std::same_as<std::optional<double>>;
};

/// A problem of several coupled fields, each of which can be advanced with the others frozen: section 7.5.1.
///
/// `fields()` says how many. `solve(k, from, dt, seen, to)` advances field k from the state `from` over dt, with every
/// other field as it stands in `seen`, and writes its own part of `to`, which may be the same object as `seen`; it
/// returns whether there is a value. `part(k)` is the Part of a state that field k owns.
template <class P>
concept StaggeredProblem = requires(P& p, std::size_t k, const State& from, double dt, State& to) {
  { p.fields() } -> std::same_as<std::size_t>;
  { p.solve(k, from, dt, from, to) } -> std::same_as<bool>;
  { p.part(k) } -> std::same_as<Part>;
};

/// Ability of a staggered problem: how far apart two values of one field are, `distance(k, x, y)`; of the field that
/// owns the motion, places.
template <class P>
concept MeasuresFields = requires(const P& p, std::size_t k, In x, In y) {
  { p.distance(k, x, y) } -> std::same_as<double>;
};

/// A time in which a solution does something by itself, whatever drives it.
struct TimeScale {
  /// How an explicit step feels it.
  enum class Kind {
    oscillates,  ///< \f$ 1/\omega \f$ of a motion: a spring
    waves,       ///< \f$ 1/\omega \f$ of values of first order: sound
    decays,      ///< \f$ 1/\lambda \f$: diffusion, drag
    drifts,      ///< the step beyond which what a step of forward Euler adds to a disturbance that is carried along
                 ///< does harm; no other scheme minds
    relaxes,     ///< \f$ 1/\lambda \f$ of one staggered field towards another, where it solves that by itself:
                 ///< staggering does not mind, to all others it decays
    loads        ///< \f$ \tau/(\Lambda - 1) \f$ of such a field with the weight Lambda > 1 against the other: sweeps
                 ///< between them contract by \f$ \Lambda\,\Delta t/(\tau + \Delta t) \f$; no other scheme minds
  };
  std::string name;              ///< for reports: "sound"
  Kind kind = Kind::oscillates;  ///< see Kind
  double seconds = 0.0;          ///< the shortest of its kind, > 0 [s]
};

/// Ability: `step_limits(state)`, the time scales of which a step may span only so many: see Limited.
template <class P>
concept HasStepLimits = requires(P& p, const State& at) {
  { p.step_limits(at) } -> std::convertible_to<std::vector<TimeScale>>;
};

/// What a problem has, as a scheme must know it to advance all of it.
struct Traits {
  bool motion = false;      ///< places and velocities
  bool velocities = false;  ///< accelerations that look at velocities
  bool values = false;      ///< values with rates
  bool carries = false;     ///< values that change by jumps alone
  bool staggered = false;   ///< fields that are advanced in turn
};

class Problem;

/// Ability of a staggered problem: `field_size(k, state)`, what the rounding of a field is measured by, where its own
/// size, its distance from zero, may become zero while that of what drives it does not.
template <class P>
concept HasFieldSizes = requires(const P& p, std::size_t k, const State& at) {
  { p.field_size(k, at) } -> std::same_as<double>;
};

/// What can be integrated: one of the four forms of a right-hand side, or staggered fields.
template <class P>
concept AnyProblem = FirstOrderProblem<P> || SecondOrderProblem<P> || CoupledProblem<P> || StaggeredProblem<P>;

/// @tparam P  a problem
/// @return what it has
template <class P>
constexpr Traits traits_of() {
  constexpr bool carries = requires { requires bool(P::values_by_jumps); };
  if constexpr (CoupledProblem<P>) {
    constexpr bool ignores = requires { requires bool(P::ignores_velocities); };
    return {.motion = true,
            .velocities = !ignores,
            .values = !carries,
            .carries = carries,
            .staggered = StaggeredProblem<P>};
  } else {
    static_assert(!(FirstOrderProblem<P> && SecondOrderProblem<P>),
                  "a problem with motion and values has one function rates(t, r, v, y, a, dy) for both");
    return {.motion = SecondOrderProblem<P>,
            .velocities = !PositionProblem<P> && MotionProblem<P>,
            .values = FirstOrderProblem<P>,
            .carries = SecondOrderProblem<P> && carries,
            .staggered = StaggeredProblem<P>};
  }
}

/// The arguments of a right-hand side; nothing is copied.
struct Where {
  double t;                             ///< time [s]
  Eigen::Map<const Eigen::VectorXd> r;  ///< places [m]
  Eigen::Map<const Eigen::VectorXd> v;  ///< velocities [m/s]
  Eigen::Map<const Eigen::VectorXd> y;  ///< values
};

/// Where a right-hand side writes its answers.
struct Answers {
  Eigen::Map<Eigen::VectorXd> a;   ///< accelerations [m/s^2]
  Eigen::Map<Eigen::VectorXd> dy;  ///< rates of the values
};

/// Stands between a problem and whoever asks it: counts, records or replays its answers. What a problem can do beyond
/// its right-hand sides and Jacobians goes past it.
class Hook {
 public:
  /// Which right-hand side is asked for.
  enum class Side { whole, slow, fast };
  virtual ~Hook() = default;
  /// @param problem  answers by itself
  /// @param side     which right-hand side
  /// @param at       where
  /// @param to       receives the answers
  /// @return whether there is a value
  virtual bool rates(const Problem& problem, Side side, const Where& at, const Answers& to) = 0;
  /// @param problem  answers by itself
  /// @param at       where
  /// @param J        receives the Jacobian
  virtual void jacobian(const Problem& problem, const Where& at, Eigen::MatrixXd& J) = 0;
  /// @param jump  one that the problem has just made
  virtual void jumped(const Jump& jump) = 0;
};

namespace detail {

// What stands behind an erased pointer.
template <class T>
T& as(void* erased) {
  return *static_cast<T*>(erased);
}
template <class T>
const T& as(const void* erased) {
  return *static_cast<const T*>(erased);
}

// What a problem can do; what it cannot is null.
struct Abilities {
  Traits traits;
  bool whole_jacobian = false;
  bool (*rates)(void*, const Where&, const Answers&) = nullptr;
  bool (*slow)(void*, const Where&, const Answers&) = nullptr;
  bool (*fast)(void*, const Where&, const Answers&) = nullptr;
  bool (*split)(void*, const State&, double) = nullptr;
  void (*jacobian)(void*, const Where&, Eigen::MatrixXd&) = nullptr;
  void (*sparse_jacobian)(void*, const Where&, SparseJacobian&) = nullptr;
  Bandwidth (*bandwidth)(const void*) = nullptr;
  double (*distance)(const void*, const In&, const In&) = nullptr;
  double (*spacing)(const void*, const In&) = nullptr;
  void (*common_motion)(const void*, const In&, Out) = nullptr;
  std::vector<Range> (*ranges)(const void*) = nullptr;
  Overlap (*overlap)(void*, const State&) = nullptr;
  std::string (*why_no_value)(void*, const State&) = nullptr;
  Jump (*jump)(void*, State&, double) = nullptr;
  std::optional<double> (*first_jump)(void*, const StepPath&, double) = nullptr;
  std::size_t (*fields)(void*) = nullptr;
  bool (*solve)(void*, std::size_t, const State&, double, const State&, State&) = nullptr;
  Part (*part)(void*, std::size_t) = nullptr;
  double (*field_distance)(const void*, std::size_t, const In&, const In&) = nullptr;
  double (*field_size)(const void*, std::size_t, const State&) = nullptr;
  std::vector<TimeScale> (*step_limits)(void*, const State&) = nullptr;
};

template <class P>
constexpr void add_right_hand_sides(Abilities& can) {
  if constexpr (CoupledProblem<P>) {
    can.rates = [](void* p, const Where& at, const Answers& to) {
      return as<P>(p).rates(at.t, at.r, at.v, at.y, Out(to.a), Out(to.dy));
    };
  } else if constexpr (PositionProblem<P>) {
    can.rates = [](void* p, const Where& at, const Answers& to) {
      return as<P>(p).acceleration(at.t, at.r, Out(to.a));
    };
  } else if constexpr (MotionProblem<P>) {
    can.rates = [](void* p, const Where& at, const Answers& to) {
      return as<P>(p).acceleration(at.t, at.r, at.v, Out(to.a));
    };
  } else if constexpr (FirstOrderProblem<P>) {
    can.rates = [](void* p, const Where& at, const Answers& to) { return as<P>(p).rate(at.t, at.y, Out(to.dy)); };
  }
  if constexpr (Splits<P>) {
    can.slow = [](void* p, const Where& at, const Answers& to) { return as<P>(p).rate_slow(at.t, at.y, Out(to.dy)); };
    can.fast = [](void* p, const Where& at, const Answers& to) { return as<P>(p).rate_fast(at.t, at.y, Out(to.dy)); };
  }
  if constexpr (SplitsMotion<P>) {
    can.split = [](void* p, const State& at, double dt) { return as<P>(p).split(at, dt); };
    can.fast = [](void* p, const Where& at, const Answers& to) {
      return as<P>(p).acceleration_fast(at.t, at.r, Out(to.a));
    };
  }
}

template <class P>
constexpr void add_jacobians(Abilities& can) {
  constexpr bool of_places = PositionProblem<P>;
  if constexpr (HasWholeJacobian<P>) {
    can.whole_jacobian = true;
    can.jacobian = [](void* p, const Where& at, Eigen::MatrixXd& J) { as<P>(p).jacobian(at.t, at.r, at.v, at.y, J); };
  } else if constexpr (HasJacobian<P> && (of_places || FirstOrderProblem<P>)) {
    can.jacobian = [](void* p, const Where& at, Eigen::MatrixXd& J) {
      as<P>(p).jacobian(at.t, of_places ? at.r : at.y, J);
    };
  }
  if constexpr (HasSparseJacobian<P> && (of_places || FirstOrderProblem<P>)) {
    can.sparse_jacobian = [](void* p, const Where& at, SparseJacobian& J) {
      as<P>(p).sparse_jacobian(at.t, of_places ? at.r : at.y, J);
    };
  }
  if constexpr (Banded<P>) {
    can.bandwidth = [](const void* p) { return as<P>(p).bandwidth(); };
  }
}

template <class P>
constexpr void add_measures(Abilities& can) {
  if constexpr (Measures<P>) {
    can.distance = [](const void* p, const In& x, const In& y) { return as<P>(p).distance(x, y); };
  }
  if constexpr (MeasuresFields<P>) {
    can.field_distance = [](const void* p, std::size_t k, const In& x, const In& y) {
      return as<P>(p).distance(k, x, y);
    };
  }
  if constexpr (HasFieldSizes<P>) {
    can.field_size = [](const void* p, std::size_t k, const State& at) { return as<P>(p).field_size(k, at); };
  }
  if constexpr (HasScales<P>) {
    can.spacing = [](const void* p, const In& r) { return as<P>(p).spacing(r); };
    can.common_motion = [](const void* p, const In& v, Out shared) { as<P>(p).common_motion(v, shared); };
  }
  if constexpr (HasRanges<P>) {
    can.ranges = [](const void* p) { return std::vector<Range>(as<P>(p).ranges()); };
  }
  if constexpr (HasStepLimits<P>) {
    can.step_limits = [](void* p, const State& at) { return std::vector<TimeScale>(as<P>(p).step_limits(at)); };
  }
}

template <class P>
constexpr void add_jumps_and_fields(Abilities& can) {
  if constexpr (HasOverlap<P>) {
    can.overlap = [](void* p, const State& at) { return as<P>(p).overlap(at); };
  }
  if constexpr (SaysWhy<P>) {
    can.why_no_value = [](void* p, const State& at) { return as<P>(p).why_no_value(at); };
  }
  if constexpr (Jumps<P>) {
    can.jump = [](void* p, State& at, double dt) { return as<P>(p).jump(at, dt); };
  }
  if constexpr (LocatesJumps<P>) {
    can.first_jump = [](void* p, const StepPath& path, double end) { return as<P>(p).first_jump(path, end); };
  }
  if constexpr (StaggeredProblem<P>) {
    can.fields = [](void* p) { return as<P>(p).fields(); };
    can.solve = [](void* p, std::size_t k, const State& from, double dt, const State& seen, State& to) {
      return as<P>(p).solve(k, from, dt, seen, to);
    };
    can.part = [](void* p, std::size_t k) { return as<P>(p).part(k); };
  }
}

template <class P>
constexpr Abilities abilities() {
  Abilities can{.traits = traits_of<P>()};
  add_right_hand_sides<P>(can);
  add_jacobians<P>(can);
  add_measures<P>(can);
  add_jumps_and_fields<P>(can);
  return can;
}

template <class P>
inline constexpr Abilities abilities_of = abilities<P>();

}  // namespace detail

/// Any problem with its type erased, as schemes see it: a pointer to it and one to the table of what it can do. Nothing
/// is owned or allocated; a scheme is compiled once, in its source, and a problem costs its user one table.
///
/// Right-hand sides and Jacobians can be counted, and go to a Hook if there is one. Asked for an ability that the
/// problem does not have, it has none to call: ask first.
class Problem {
 public:
  /// @param problem      must outlive this
  /// @param evaluations  counts the right-hand sides that are asked for, slow and fast parts apart, and solved fields;
  ///                     none: they are not counted
  template <AnyProblem P>
  requires(!std::is_same_v<std::remove_const_t<P>, Problem>) Problem(P& problem, long* evaluations = nullptr)
      : self_(const_cast<std::remove_const_t<P>*>(&problem)), can_(&detail::abilities_of<P>), count_(evaluations) {}

  /// @param evaluations  counts from now on @return the same problem, whose right-hand sides are counted
  Problem counted_by(long& evaluations) const {
    Problem same = *this;
    same.count_ = &evaluations;
    return same;
  }
  /// @param hook  must outlive what is returned @return the same problem, whose questions go to a hook
  Problem with(Hook& hook) const {
    Problem same = *this;
    same.hook_ = &hook;
    return same;
  }
  /// @return the same problem, which answers by itself and counts nothing
  Problem bare() const {
    Problem same = *this;
    same.hook_ = nullptr, same.count_ = nullptr;
    return same;
  }

  /// Which problem it is: the object's address, and its type's.
  using Identity = std::pair<const void*, const void*>;
  /// @return whose; one that was changed in place stays the same
  Identity identity() const { return {self_, can_}; }

  /// @return what it has
  const Traits& traits() const { return can_->traits; }

  /// All rates at once.
  ///
  /// @param at  where; a part that the problem does not have is empty
  /// @param to  receives the rates of what it has
  /// @return whether the problem has a value there
  bool rates(const Where& at, const Answers& to) const { return ask(Hook::Side::whole, can_->rates, at, to); }
  /// The same, into vectors of the length that they need.
  ///
  /// @param t   time [s]
  /// @param r   places [m]
  /// @param v   velocities [m/s]
  /// @param y   values
  /// @param to  receives the rates
  /// @return whether the problem has a value there
  bool rates(double t, const Eigen::VectorXd& r, const Eigen::VectorXd& v, const Eigen::VectorXd& y, Rates& to) const {
    to.a.resize(r.size());
    to.dy.resize(can_->traits.values ? y.size() : 0);
    return rates(Where{t, {r.data(), r.size()}, {v.data(), v.size()}, {y.data(), y.size()}},
                 Answers{{to.a.data(), to.a.size()}, {to.dy.data(), to.dy.size()}});
  }
  /// @param at  a state @param to receives its rates @return whether the problem has a value there
  bool rates(const State& at, Rates& to) const { return rates(at.t, at.r, at.v, at.y, to); }

  /// @return whether it has a slow and a fast part
  bool splits() const { return can_->slow; }
  /// @param at  where @param to receives the slow part @return whether it has a value there
  bool rate_slow(const Where& at, const Answers& to) const { return ask(Hook::Side::slow, can_->slow, at, to); }
  /// @param at  where @param to receives the fast part @return whether it has a value there
  bool rate_fast(const Where& at, const Answers& to) const { return ask(Hook::Side::fast, can_->fast, at, to); }

  /// @return whether its motion has a part that changes fast, and is then rate_fast()
  bool splits_motion() const { return can_->split; }
  /// @param at  the start of a step @param dt the step [s] @return whether that part could be chosen for it
  bool split(const State& at, double dt) const { return can_->split(self_, at, dt); }

  /// @return whether it gives a Jacobian
  bool has_jacobian() const { return can_->jacobian; }
  /// @return whether that is the one of HasWholeJacobian
  bool has_whole_jacobian() const { return can_->whole_jacobian; }
  /// @param at  where @param J receives the Jacobian, of the size that it has before
  void jacobian(const Where& at, Eigen::MatrixXd& J) const {
    hook_ ? hook_->jacobian(bare(), at, J) : can_->jacobian(self_, at, J);
  }
  /// @return whether it gives a sparse one
  bool has_sparse_jacobian() const { return can_->sparse_jacobian; }
  /// @param at  where @param J receives the Jacobian, of the size that it has before
  void sparse_jacobian(const Where& at, SparseJacobian& J) const { can_->sparse_jacobian(self_, at, J); }
  /// @return the diagonals outside which it is zero; none: unknown
  std::optional<Bandwidth> bandwidth() const {
    return can_->bandwidth ? std::optional(can_->bandwidth(self_)) : std::nullopt;
  }

  /// Distance in the problem's own measure, in the sum of absolute values without one.
  ///
  /// @param x  places, or values where the problem has nothing else
  /// @param y  others, as many
  /// @return distance, >= 0, in their unit
  double distance(const In& x, const In& y) const;
  /// The same of one staggered field.
  ///
  /// @param k  which field
  /// @param x  what it owns, of motion the places
  /// @param y  another value of it
  /// @return distance, >= 0, in its unit
  double distance(std::size_t k, const In& x, const In& y) const;
  /// What the rounding of one staggered field is measured by: see HasFieldSizes.
  ///
  /// @param k   which field
  /// @param at  a state
  /// @param x   what the field owns of it, of motion the places
  /// @return its distance from zero, or more
  double size(std::size_t k, const State& at, const In& x) const;
  /// @return whether it knows its scales: see HasScales
  bool has_scales() const { return can_->spacing; }
  /// @param r  places [m] @return the distance of the two nearest bodies; 0 where it is unknown [m]
  double spacing(const In& r) const { return can_->spacing ? can_->spacing(self_, r) : 0.0; }
  /// @param v       velocities [m/s]
  /// @param shared  receives what they share, as long as v; zero where it is unknown [m/s]
  void common_motion(const Eigen::VectorXd& v, Eigen::VectorXd& shared) const {
    shared.resize(v.size());
    can_->common_motion ? can_->common_motion(self_, v, shared) : void(shared.setZero());
  }
  /// @param size  of y @return the ranges that it falls into: the problem's, or one
  /// @throws std::invalid_argument if the problem's do not make up y one after the other
  std::vector<Range> ranges(Eigen::Index size) const;

  /// @return whether its state jumps
  bool jumps() const { return can_->jump; }
  /// @param at  the end of a step; receives what it becomes @param dt that step [s] @return what was done
  Jump jump(State& at, double dt) const {
    Jump jump = can_->jump(self_, at, dt);
    if (hook_) hook_->jumped(jump);
    return jump;
  }
  /// @param at  a state @return which bodies overlap there; none where it knows of none
  Overlap overlap(const State& at) const { return can_->overlap ? can_->overlap(self_, at) : Overlap{}; }
  /// @param at  a state @return why it has no value there; empty: it does not know, or has one
  std::string why_no_value(const State& at) const {
    return can_->why_no_value ? can_->why_no_value(self_, at) : std::string();
  }
  /// @return whether it finds the moment of its jumps
  bool locates_jumps() const { return can_->first_jump; }
  /// @param path  a step @param end how far to look [-] @return the place of the first jump in it, if any
  std::optional<double> first_jump(const StepPath& path, double end) const {
    return can_->first_jump(self_, path, end);
  }

  /// @return the number of staggered fields
  std::size_t fields() const { return can_->fields(self_); }
  /// Advances one field; see StaggeredProblem.
  ///
  /// @param k     which field
  /// @param from  the start of the step
  /// @param dt    the step [s]
  /// @param seen  where the other fields are taken from
  /// @param to    receives the field
  /// @return whether there is a value
  bool solve(std::size_t k, const State& from, double dt, const State& seen, State& to) const {
    if (count_) ++*count_;
    return can_->solve(self_, k, from, dt, seen, to);
  }
  /// @param k  which field @return the part of a state that it owns
  Part part(std::size_t k) const { return can_->part(self_, k); }

  /// @return whether it has time scales that limit a step
  bool has_step_limits() const { return can_->step_limits; }
  /// @param at  a state @return the time scales there
  std::vector<TimeScale> step_limits(const State& at) const { return can_->step_limits(self_, at); }

 private:
  bool ask(Hook::Side side, bool (*by_itself)(void*, const Where&, const Answers&), const Where& at,
           const Answers& to) const {
    if (count_) ++*count_;
    return hook_ ? ask_hook(side, at, to) : by_itself(self_, at, to);
  }
  bool ask_hook(Hook::Side side, const Where& at, const Answers& to) const;

  void* self_;
  const detail::Abilities* can_;
  long* count_ = nullptr;
  Hook* hook_ = nullptr;
};

/// @tparam P  a problem
/// @param problem  any
/// @return what it has, also where its type is erased
template <class P>
Traits traits(const P& problem) {
  if constexpr (std::is_same_v<P, Problem>) {
    return problem.traits();
  } else {
    return traits_of<P>();
  }
}

}  // namespace particulate::schemes
