#pragma once

#include <optional>
#include <vector>

#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>

namespace particulate::schemes {

/// Settings of multirate collocation that do not change what it converges to.
struct MultirateSettings {
  double TOL = 1e-8;                 ///< of the inner steps: see ErrorControl, at least 2.3e-16 [-]
  std::optional<double> size = {};   ///< errors of positions count relative above it, > 0 [m]; none: see ErrorScales
  std::optional<double> speed = {};  ///< errors of velocities likewise, > 0 [m/s]
};

/// Refuses settings that cannot be meant.
///
/// @param settings  the settings
/// @throws std::invalid_argument naming the setting, what must hold and what was given
void validate(const MultirateSettings& settings);

/// Multirate collocation, whatever its nodes: all that Multirate does, compiled once.
class AnyMultirate {
 public:
  /// @param of  what a problem has @return whether it is motion alone that ignores velocities
  static constexpr bool advances(const Traits& of) { return of.motion && !of.velocities && !of.values; }

  /// Begins a run: goes on from the last one where that ended, else anew. @see AnyCollocation::begin
  ///
  /// @param problem  whose history alone is kept
  /// @param state    the start
  void begin(const Problem& problem, const State& state);

  /// The guess: the slow acceleration of the last step, run on; without one that at the start throughout, and two
  /// sweeps from there.
  ///
  /// @param problem  the right-hand side, in two parts: see SplitsMotion
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       receives the end of the motion under it
  /// @return whether the problem had a value, and the inner steps went through
  /// @throws std::invalid_argument if the problem does not split its acceleration
  bool predict(const Problem& problem, const State& from, double dt, State& to);

  /// One sweep: the slow acceleration at the nodes of the motion as it stands, and the motion under it.
  ///
  /// @param problem  the right-hand side; the whole is asked for once a node
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       the iterate; receives the next one
  /// @return the iteration so far
  Iteration sweep(const Problem& problem, const State& from, double dt, State& to);

  /// The error that the step just made left, of its slow part. @see Collocation
  ///
  /// @param problem  the right-hand side
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       state at its end
  /// @return the error and its order
  Truncation truncation(const Problem& problem, const State& from, double dt, const State& to);

  /// Keeps the slow acceleration of the step just made. @param dt  the step [s]
  void accept(double dt);

  /// Drops it: the state was changed from outside.
  void forget();

  /// Dense output, of the inner steps.
  ///
  /// @param from   state at the start of the step made last
  /// @param dt     that step [s]
  /// @param theta  in units of the step; 0 its start, 1 its end [-]
  /// @param there  receives the state
  void at(const State& from, double dt, double theta, State& there) const;

  /// @return inner steps that stand in the step made last [-]
  std::size_t inner_steps() const { return inner_steps_; }

 protected:
  /// @param table     of the nodes
  /// @param order     of the method in the slow acceleration [-]
  /// @param settings  see MultirateSettings
  /// @throws std::invalid_argument for settings that cannot be meant
  AnyMultirate(const CollocationTable& table, int order, const MultirateSettings& settings);

 private:
  using Inner = Collocation<Gauss<6>>;
  struct Piece {
    State from;
    double dt = 0.0;
    Eigen::MatrixXd rates;
  };

  bool continues(const State& from) const;
  bool guess_slow(const Problem& problem, const State& from, double dt);
  bool slow_at(const Problem& problem, double t, const Eigen::VectorXd& r, Eigen::Index node);
  bool renew_slow(const Problem& problem, const State& from, double dt);
  bool fast_at(const Problem& problem, double t, const Eigen::VectorXd& r);
  bool travel(const Problem& problem, const State& from, double dt, State& to);

  const CollocationTable* table_;
  int order_;
  MultirateSettings settings_;
  ErrorScales scales_;
  PartMeasures measures_;
  double spacing_ = 0.0;                              // of the bodies at the start of the step [m]
  double inner_step_ = 0.0, first_inner_step_ = 0.0;  // to begin with; chosen last [s]
  // One column a node: slow accelerations, places of the motion, and whole accelerations with where they were asked.
  Eigen::MatrixXd slow_, places_, whole_, asked_, old_whole_, old_places_;
  Eigen::VectorXd fast_, change_, size_, before_;
  Rates rates_;
  std::vector<Piece> pieces_;  // of the step made last, in their order; more is kept for the next
  std::size_t inner_steps_ = 0;
  State end_{.t = std::numeric_limits<double>::quiet_NaN()}, new_end_;
  double old_t_ = 0.0, old_dt_ = 0.0, t_ = 0.0;
  Problem::Identity of_{};
  bool has_old_ = false;
};

/// Collocation in two rates: a slow acceleration on the nodes of long steps, a fast one in short steps within them.
///
/// \f[ \ddot r = \underbrace{a(r) - a_f(r)}_{\approx\ \sum_j l_j(\theta)\, s_j} + a_f(r), \qquad
///     s_j = a(r(t + c_j h)) - a_f(r(t + c_j h)) \f]
///
/// @equation{D 3.4} The fast part is what the problem chooses at the start of every step (SplitsMotion): the pairs of
/// particles that come close, of which there are few. The motion under the polynomial of the slow part is an ordinary
/// problem, solved by `Gauss<6>` under ErrorControl in as many steps as it needs. A sweep takes the motion at the
/// nodes, asks for the whole acceleration there, which is what costs, and solves again. So the nodes follow the smooth
/// field of many particles, and few of them see a close encounter. Sweeps contract as those of Collocation on the slow
/// part alone, from a slow polynomial that is extrapolated from the last step: two are enough.
///
/// Its order is 2 S in the long step for motions that this resolves. What the slow acceleration does to a motion much
/// faster than the step is of order S, and the estimate of the error, that of Collocation for the slow part, does not
/// know: tighten its tolerance, or the step, until the answer stands. The inner steps keep their own tolerance. A long
/// step is not symplectic. After a jump, such as stepped contact at its end, it begins anew, with a constant slow
/// acceleration and two more sweeps: take Collocation where impacts are frequent.
///
/// @tparam S  nodes of a long step, 2 to 16
template <int S>
class Multirate : public AnyMultirate {
 public:
  static constexpr int order = 2 * S;  ///< of the global error [-]

  /// @param settings  see MultirateSettings
  /// @throws std::invalid_argument for settings that cannot be meant
  explicit Multirate(const MultirateSettings& settings = {}) : AnyMultirate(table_of<Gauss<S>>(), order, settings) {
    static_assert(S >= 2);
  }
};

}  // namespace particulate::schemes
