#pragma once

#include <limits>
#include <optional>
#include <span>
#include <utility>

#include <particulate/schemes/collocation_table.hpp>
#include <particulate/schemes/iteration.hpp>
#include <particulate/schemes/mixing.hpp>
#include <particulate/schemes/newton.hpp>
#include <particulate/schemes/problem.hpp>
#include <particulate/schemes/scales.hpp>
#include <particulate/schemes/stage_solver.hpp>

namespace particulate::schemes {

/// What the first sweep of a step starts from.
enum class Guess {
  extrapolated,  ///< the polynomial of the last step, run on; without one, the rates at the start throughout
  free_flight    ///< no rates at all, the guess of the monograph: no right-hand side is asked for the guess
};

/// Settings of a collocation method that do not change what it converges to.
struct CollocationSettings {
  Guess guess = Guess::extrapolated;  ///< see Guess
  bool compensated = true;            ///< whether what rounding takes from the state is kept and added again
  std::optional<double> size = {};    ///< errors of values and positions count relative above it, > 0 [their unit];
                                      ///< none: see ErrorScales
  std::optional<double> speed = {};   ///< errors of velocities likewise, > 0 [m/s]
  Eigen::VectorXd sizes = {};         ///< one size for each number in (r, y), instead of `size`; empty: none
};

/// Refuses settings that cannot be meant.
///
/// @param settings  the settings
/// @throws std::invalid_argument naming the setting, what must hold and what was given
void validate(const CollocationSettings& settings);

/// How the stage equations are solved, known when a scheme is made.
struct StageSolver {
  /// The choice.
  enum class How { in_turn, at_once, mixed, newton };
  How how = How::in_turn;  ///< see the types that it is made of
  Anderson mixing{};       ///< for How::mixed
  NewtonSteps newton{};    ///< for How::newton

  /// @cond one of each kind of solver
  StageSolver(const Sequential&) : how(How::in_turn) {}
  StageSolver(const Picard&) : how(How::at_once) {}
  StageSolver(const Anderson& anderson) : how(How::mixed), mixing(anderson) {}
  StageSolver(const Newton<DenseStages>&) : how(How::newton) {}
  StageSolver(const Newton<SparseStages>&) : how(How::newton), newton(true) {}
  /// @endcond
};

/// Dense output of a step in Nystrom form: the polynomials that have these rates at the nodes.
///
/// @param table  of the nodes
/// @param rates  of a state (r, y), first those of r, one column a node
/// @param from   state at the start of the step
/// @param dt     the step [s]
/// @param theta  in units of the step; 0 its start, 1 its end [-]
/// @param there  receives the state
void collocation_at(const CollocationTable& table, const Eigen::MatrixXd& rates, const State& from, double dt,
                    double theta, State& there);

/// What a step of order p leaves of rates k that a polynomial through s nodes follows: \f$ h |k|\,\eta^{p/(s-1)} \f$,
/// see Collocation.
///
/// @param table   of the nodes
/// @param order   p [-]
/// @param dt      h, the step [s]
/// @param change  the polynomial's leading coefficient, of the size of the state, >= 0 [1/s]
/// @param rate    |k|, likewise [1/s]
/// @return the error, of the size of the state [-]
double unresolved(const CollocationTable& table, int order, double dt, double change, double rate);

/// Collocation, whatever its nodes and its solver: all that Collocation does, compiled once.
class AnyCollocation {
 public:
  /// @param of  what a problem has @return whether it has motion or values
  static constexpr bool advances(const Traits& of) { return of.motion || of.values; }

  /// Begins a run: goes on from the last one where that ended, else anew.
  ///
  /// The problem is asked once more where it was asked last: if it answers otherwise, it was changed, and the run
  /// begins anew.
  ///
  /// @param problem  whose history alone is kept
  /// @param state    the start
  void begin(const Problem& problem, const State& state);

  /// The guess: rates at the nodes, and the state at the end that they make.
  ///
  /// @param problem  the right-hand side; asked for the start's where there is no polynomial to extrapolate, and for
  ///                 Jacobians by Newton
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       receives the first iterate
  /// @return whether the problem had a value where it was asked
  bool predict(const Problem& problem, const State& from, double dt, State& to);

  /// One sweep over all stages.
  ///
  /// @param problem  the right-hand side
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       the iterate; receives the next one
  /// @return the iteration so far, of the worst part of the state
  Iteration sweep(const Problem& problem, const State& from, double dt, State& to);

  /// @return how the iteration of each part of the state went; empty where there is one part alone
  std::span<const Iteration> iterations() const { return measures_.iterations(); }

  /// The error that the step just made left, in its ErrorScales; see Collocation.
  ///
  /// @param problem  the right-hand side; Radau on values asks for one more after a refused step, and at the start
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       state at its end
  /// @return the error and its order
  Truncation truncation(const Problem& problem, const State& from, double dt, const State& to);

  /// Keeps the polynomial of the step just made, and what rounding added to its end.
  ///
  /// @param dt  the step [s]
  void accept(double dt);

  /// Drops it: the state was changed from outside.
  void forget();

  /// Dense output: the polynomial of the step made last, of uniform order s.
  ///
  /// @param from   state at the start of that step
  /// @param dt     that step [s]
  /// @param theta  in units of the step; 0 its start, 1 its end [-]
  /// @param there  receives the state
  void at(const State& from, double dt, double theta, State& there) const {
    collocation_at(*table_, k_, from, dt, theta, there);
  }

  /// @return the rates of the step made last: see collocation_at()
  const Eigen::MatrixXd& rates() const { return k_; }

 protected:
  /// @param table     of the nodes
  /// @param order     of the method [-]
  /// @param settings  see CollocationSettings
  /// @param solver    how the stage equations are solved
  /// @throws std::invalid_argument for settings that cannot be meant
  AnyCollocation(const CollocationTable& table, int order, CollocationSettings settings, StageSolver solver);

 private:
  // What rounding added to each part of a state.
  struct Carry {
    Eigen::VectorXd r, v, y;
    void clear(const State& of);
  };

  bool is_newton() const { return solver_.how == StageSolver::How::newton; }
  Eigen::Index S() const { return table_->stages(); }
  bool prepare_newton(const Problem& problem, const State& from, double dt, const State& to);
  void begin_step(const Problem& problem, const State& from);
  bool continues(const State& from) const;
  bool answers_as_before(const Problem& problem);
  bool guess(const Problem& problem, const State& from, double dt);
  bool rates_at_start(const Problem& problem, const State& from);
  bool rates_at_stage(const Problem& problem, const State& from, double dt, Eigen::Index i);
  bool rates_here(const Problem& problem, double t);
  void add(const double* weights, double scale, Eigen::VectorXd& places, Eigen::VectorXd& values) const;
  bool renew_rates(const Problem& problem, const State& from, double dt);
  void draw_through(Eigen::Index i);
  void mix();
  double stage_change(const Eigen::MatrixXd& change, double dt) const;
  void finish(const State& from, double dt, State& to);
  void weigh_otherwise(double dt);
  void measure(const Problem& problem, const State& from, double dt, const State& to);
  void measure_motion(const Problem& problem, const State& from, double dt, const State& to);
  Truncation leading_coefficient(double dt);
  Truncation defect_at_start(const Problem& problem, const State& from, double dt);
  Eigen::VectorXd filtered(const Eigen::VectorXd& defect, double dt) const;

  const CollocationTable* table_;
  Eigen::MatrixXd A_;  // of the table, as Newton takes it
  int order_;
  CollocationSettings settings_;
  StageSolver solver_;
  PartMeasures measures_;
  ErrorScales scales_;
  Eigen::VectorXd range_TOL_;        // of each value, for Newton
  Eigen::Index n_ = 0, m_ = 0;       // places, and values with rates: the rows of what follows
  Eigen::MatrixXd k_, old_, image_;  // rates (a, dy), one column a stage
  Eigen::VectorXd f_, start_, guessed_;
  State stage_;
  Rates rates_;
  Eigen::VectorXd change_, before_, before_y_, other_r_, other_y_, other_before_r_, other_before_y_;  // scratch
  Carry carry_, new_carry_;                                   // of the start, and of the end
  State end_{.t = std::numeric_limits<double>::quiet_NaN()};  // of the step accepted last
  State new_end_;                                             // of the step made last
  double old_dt_ = 0.0, rate_ = 0.0;
  Problem::Identity of_{};  // whose history this is
  double refused_at_ = std::numeric_limits<double>::quiet_NaN();
  bool accepted_ = false, has_old_ = false, bootstraps_ = false, retried_ = false, needs_speed_ = false;
};

/// Collocation: the polynomial whose rates are right at s nodes of the step. The family to which the monograph's scheme
/// belongs as its member of one stage.
///
/// \f[ k_i = f\Big(t + c_i h,\ y + h \sum_j A_{ij} k_j\Big), \qquad y^{L+1} = y^L + h \sum_j b_j k_j \f]
///
/// @equation{D 3.4} For motions in Nystrom form,
///
/// \f[ a_i = a\Big(t + c_i h,\ r + c_i h\,v + h^2 \sum_j \bar A_{ij} a_j\,[,\ v + h \sum_j A_{ij} a_j]\Big), \qquad
///     r^{L+1} = r^L + h\,v^L + h^2 \sum_j \bar b_j a_j, \quad v^{L+1} = v^L + h \sum_j b_j a_j \f]
///
/// with \f$ \bar A = A A \f$: the same method on \f$ y = (r, v) \f$, without the velocities of the stages where forces
/// ignore them. Values that ride along with a motion take part in the same stages. Radau<1> from Guess::free_flight by
/// Picard is BackwardEuler. Source: @cite hairer1993, sections II.7 and II.14.
///
/// The stage equations are solved by sweeps, of which each asks for s right-hand sides. A sweep's change is that of the
/// state at the end of the step, in the problem's measure over the displacement of the first sweep (see
/// IterationMeasure), or with b and \f$ \bar b \f$ exchanged if that is larger; with Newton it is the largest change of
/// a stage, each number over its size. From the polynomial of the last step sweeps start so near their fixed point that
/// two or three are enough.
///
/// The error of the step is estimated without a further right-hand side. The leading coefficient of the polynomial
/// through the rates, over their size, \f$ \eta \approx (h/\rho)^{s-1} \f$, tells how far a solution of radius of
/// convergence \f$ \rho \f$ is resolved, and the step of order p leaves \f$ h |k|\,(h/\rho)^p = h|k|\,\eta^{p/(s-1)}
/// \f$ (for s = 1 the change from the last step's rates is taken, at first from those at the start). It is blind in a
/// step in which that coefficient passes zero, as it may at a turning point: there the largest step that a control
/// allows must do. Radau on values, made for stiff problems, where that power is not reached, estimates with order s by
/// the defect of its polynomial at the start of the step, \f$ \gamma h\,(I - \gamma h J)^{-1}(f(t, y) - \sum_j l_j(0)
/// k_j) \f$: @cite hairer1996, section IV.8.
///
/// A scheme is a value: its copy is a checkpoint. What it remembers holds only where the next step starts exactly at
/// the end of the last, with the same problem; elsewhere, and after forget(), it begins anew.
///
/// @tparam Nodes   Gauss or Radau
/// @tparam Solver  Sequential, Picard (all stages at once), Anderson, Newton<DenseStages> or Newton<SparseStages>
template <class Nodes, class Solver = Sequential>
class Collocation : public AnyCollocation {
 public:
  static constexpr int order = Nodes::order;  ///< of the global error [-]

  /// @param settings  see CollocationSettings
  /// @param solver    how the stage equations are solved
  /// @throws std::invalid_argument for settings that cannot be meant
  explicit Collocation(CollocationSettings settings = {}, Solver solver = Solver())
      : AnyCollocation(table_of<Nodes>(), order, std::move(settings), solver) {}
};

}  // namespace particulate::schemes
