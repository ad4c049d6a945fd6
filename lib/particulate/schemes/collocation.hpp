#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include <particulate/schemes/collocation_table.hpp>
#include <particulate/schemes/iteration.hpp>
#include <particulate/schemes/mixing.hpp>
#include <particulate/schemes/newton.hpp>
#include <particulate/schemes/problem.hpp>
#include <particulate/schemes/runge_kutta.hpp>
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
  double size = 1.0;                  ///< errors of values and positions count relative above it, > 0 [their unit]
  double speed = 1.0;                 ///< errors of velocities likewise, > 0 [m/s]
  Eigen::VectorXd sizes = {};         ///< one size for each value or position, instead of `size`; empty: none
};

/// Refuses settings that cannot be meant.
///
/// @param settings  the settings
/// @throws std::invalid_argument naming the setting, what must hold and what was given
void validate(const CollocationSettings& settings);

namespace detail {

/// sum += scale sum_j w_j k_j.
///
/// @param w      one weight for each column of k
/// @param scale  of all weights
/// @param k      n x s
/// @param sum    n
void add_weighted(const double* w, double scale, const Eigen::MatrixXd& k, Eigen::VectorXd& sum);

}  // namespace detail

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
/// ignore them. Radau<1> from Guess::free_flight by Picard is BackwardEuler. Source: @cite hairer1993, sections II.7
/// and II.14.
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
/// \f$ (for s = 1 the change from the last step's rates is taken). It is blind in a step in which that coefficient
/// passes zero, as it may at a turning point: there the largest step that a control allows must do. Radau on values,
/// made for stiff problems, where that power is not reached, estimates with order s by the defect of its polynomial at
/// the start of the step, \f$ \gamma h\,(I - \gamma h J)^{-1}(f(t, y) - \sum_j l_j(0) k_j) \f$: @cite hairer1996,
/// section IV.8.
///
/// A scheme is a value: its copy is a checkpoint. What it remembers holds only where the next step starts exactly at
/// the end of the last; elsewhere, and after forget(), it begins anew.
///
/// @tparam Nodes   Gauss or Radau
/// @tparam Solver  Sequential, Picard (all stages at once), Anderson, Newton<DenseStages> or Newton<SparseStages>
template <class Nodes, class Solver = Sequential>
class Collocation {
 public:
  static constexpr int order = Nodes::order;  ///< of the global error [-]

  /// @param settings  see CollocationSettings
  /// @param solver    how the stage equations are solved
  /// @throws std::invalid_argument for settings that cannot be meant
  explicit Collocation(CollocationSettings settings = {}, Solver solver = {})
      : settings_(std::move(settings)), solver_(std::move(solver)) {
    validate(settings_);
  }

  /// The guess: rates at the nodes, and the state at the end that they make.
  ///
  /// @param problem  the right-hand side; asked for the start's where there is no polynomial to extrapolate, and for
  ///                 Jacobians by Newton
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       receives the first iterate
  /// @return whether the problem had a value where it was asked
  template <class P, class State>
  bool predict(P& problem, const State& from, double dt, State& to) {
    begin<P>(from);
    if (!guess(problem, from, dt)) return false;
    if constexpr (is_newton) {
      const bool bad = retried_ || rate_ > slow;
      if (!newton_.prepare(problem, from, dt, {.A = table().A, .sizes = sizes(from), .bad = bad})) return false;
    }
    to.t = from.t + dt;
    finish(from, dt, to);
    if constexpr (!is_newton && S > 1) weigh_otherwise<P, State>(dt);
    return true;
  }

  /// One sweep over all stages.
  ///
  /// @param problem  the right-hand side
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       the iterate; receives the next one
  /// @return the iteration so far
  template <class P, class State>
  Iteration sweep(P& problem, const State& from, double dt, State& to) {
    const bool first = measure_.waits_for_first();
    if (!renew_rates(problem, from, dt)) return measure_.no_value();
    if constexpr (is_newton) {
      finish(from, dt, to);
      measure_.normalize(1.0, 0.0);
      return measure_.record(newton_change_);
    } else {
      before_ = measured(from, to);
      finish(from, dt, to);
      const double scale = needs_speed_ ? dt : 1.0;
      if (first) {
        if (zero_.size() != before_.size()) zero_.setZero(before_.size());
        measure_.normalize(distance(problem, place_of(to), place_of(from)),
                           scale * distance(problem, measured(from, from), zero_));
      }
      double change = scale * distance(problem, measured(from, to), before_);
      if constexpr (S > 1) {
        other_before_.swap(other_);
        weigh_otherwise<P, State>(dt);
        change = std::max(change, distance(problem, other_, other_before_));
      }
      return measure_.record(change);
    }
  }

  /// The error that the step just made left, relative to the sizes of the settings; see the class.
  ///
  /// @param problem  the right-hand side; Radau on values asks for one more after a refused step, and at the start
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       state at its end
  /// @return the error and its order; NaN where the last step is unknown and one stage tells nothing
  template <class P, class State>
  Truncation truncation(P& problem, const State& from, double dt, const State& to) {
    if constexpr (!is_motion<State> && Nodes::order % 2 == 1) {
      return defect_at_start(problem, from, dt, to);
    } else {
      return leading_coefficient(from, dt, to);
    }
  }

  /// Keeps the polynomial of the step just made, and what rounding added to its end.
  ///
  /// @param dt  the step [s]
  void accept(double dt) {
    accepted_ = true;
    old_dt_ = dt;
    std::swap(end_, new_end_);
    if (settings_.compensated) {
      carry_.swap(new_carry_);
      speed_carry_.swap(new_speed_carry_);
    }
    refused_at_ = std::numeric_limits<double>::quiet_NaN();
  }

  /// Drops it: the state was changed from outside.
  void forget() {
    accepted_ = has_old_ = false;
    end_.t = std::numeric_limits<double>::quiet_NaN();
    if constexpr (is_newton) newton_.forget();
  }

  /// Dense output: the polynomial of the step made last, of uniform order s.
  ///
  /// @param from   state at the start of that step
  /// @param dt     that step [s]
  /// @param theta  in units of the step; 0 its start, 1 its end [-]
  /// @param there  receives the state
  template <class State>
  void at(const State& from, double dt, double theta, State& there) const {
    const Row once = table().once(theta);
    there.t = from.t + theta * dt;
    if constexpr (is_motion<State>) {
      there.r = from.r + (theta * dt) * from.v;
      there.v = from.v;
      detail::add_weighted(table().twice(theta).data(), dt * dt, k_, there.r);
      detail::add_weighted(once.data(), dt, k_, there.v);
    } else {
      there.y = from.y;
      detail::add_weighted(once.data(), dt, k_, there.y);
    }
  }

 private:
  using Table = CollocationTable<Nodes>;
  using Row = typename Table::Row;
  static constexpr int S = Nodes::stages;
  template <class State>
  static constexpr bool is_motion = std::is_same_v<State, Motion>;
  template <class P>
  static constexpr int p_of = PositionProblem<P> ? 2 : 1;
  // Newton's sweeps that contract less keep their Jacobian no longer.
  static constexpr double slow = 1e-2;
  static constexpr bool is_newton = requires { typename Solver::Linear; };
  static const Table& table() { return Table::get(); }

  static const Eigen::VectorXd& place_of(const Motion& state) { return state.r; }
  static const Eigen::VectorXd& place_of(const Values& state) { return state.y; }

  // Where forces depend on velocities the sweeps are measured by these, as in PhiFamily.
  const Eigen::VectorXd& measured(const Motion&, const Motion& state) const { return needs_speed_ ? state.v : state.r; }
  const Eigen::VectorXd& measured(const Values&, const Values& state) const { return state.y; }

  template <class State>
  Eigen::VectorXd sizes(const State& from) const {
    const Eigen::Index n = place_of(from).size();
    if (settings_.sizes.size() == 0) return Eigen::VectorXd::Constant(n, settings_.size);
    if (settings_.sizes.size() != n) {
      throw std::invalid_argument(
          fmt::format("collocation: sizes must be one for each of {} unknowns, got {}", n, settings_.sizes.size()));
    }
    return settings_.sizes;
  }

  // --- The step ------------------------------------------------------------------------------------------------------

  template <class P, class State>
  void begin(const State& from) {
    const Eigen::Index n = place_of(from).size();
    needs_speed_ = is_motion<State> && !PositionProblem<P>;
    rate_ = measure_.iteration().rate;
    measure_.begin(is_newton ? 1 : p_of<P>);
    if constexpr (std::is_same_v<Solver, Anderson>) solver_.forget();
    retried_ = refused_at_ == from.t;
    refused_at_ = from.t;  // until accept() says otherwise
    if (accepted_) {
      old_.swap(k_);
      has_old_ = true;
      accepted_ = false;
    }
    if (!continues(from)) {
      has_old_ = false;
      carry_.setZero(n);
      speed_carry_.setZero(n);
    }
    k_.resize(n, S);
    f_.resize(n);
  }

  bool continues(const Motion& from) const {
    return goes_on_at(from.t) && from.r.size() == end_.r.size() && from.r == end_.r && from.v == end_.v;
  }
  bool continues(const Values& from) const {
    return goes_on_at(from.t) && from.y.size() == end_.r.size() && from.y == end_.r;
  }
  // The end of a run may be set to the time asked for, which differs by rounding.
  bool goes_on_at(double t) const { return std::abs(t - end_.t) <= 1e-9 * old_dt_; }

  template <class P, class State>
  bool guess(P& problem, const State& from, double dt) {
    bootstraps_ = false;
    if (settings_.guess == Guess::free_flight) {
      k_.setZero();
      return true;
    }
    if (has_old_) {
      for (int i = 0; i < S; ++i) {
        f_.setZero();
        detail::add_weighted(table().basis(1.0 + table().c[i] * dt / old_dt_).data(), 1.0, old_, f_);
        k_.col(i) = f_;
      }
    } else {
      place(from);
      if (!derive(problem, from, from.t, start_)) return false;
      k_.colwise() = start_;
      bootstraps_ = S > 1;
    }
    if constexpr (S == 1) guessed_ = k_.col(0);
    return true;
  }

  void place(const Motion& from) {
    place_ = from.r;
    speed_ = from.v;
  }
  void place(const Values& from) { place_ = from.y; }

  // State of stage i, from the rates as they stand.
  void place(const Motion& from, double dt, int i) {
    place_ = from.r + (table().c[i] * dt) * from.v;
    detail::add_weighted(table().A_bar.row(i).data(), dt * dt, k_, place_);
    if (!needs_speed_) return;
    speed_ = from.v;
    detail::add_weighted(table().A.row(i).data(), dt, k_, speed_);
  }
  void place(const Values& from, double dt, int i) {
    place_ = from.y;
    detail::add_weighted(table().A.row(i).data(), dt, k_, place_);
  }

  template <class P>
  bool derive(P& problem, const Motion&, double t, Eigen::VectorXd& rate) {
    rate.resize(place_.size());
    return acceleration_of(problem, t, place_, speed_, rate);
  }
  template <class P>
  bool derive(P& problem, const Values&, double t, Eigen::VectorXd& rate) {
    rate.resize(place_.size());
    return problem.rate(t, place_, rate);
  }

  template <class P, class State>
  bool rate_at_stage(P& problem, const State& from, double dt, int i) {
    place(from, dt, i);
    return derive(problem, from, from.t + table().c[i] * dt, f_);
  }

  template <class P, class State>
  bool renew_rates(P& problem, const State& from, double dt) {
    if constexpr (std::is_same_v<Solver, Sequential>) {
      for (int i = 0; i < S; ++i) {
        if (!rate_at_stage(problem, from, dt, i)) return false;
        k_.col(i) = f_;
        if (bootstraps_) draw_through(i);
      }
      bootstraps_ = false;
      return true;
    } else {
      image_.resize(k_.rows(), S);
      for (int i = 0; i < S; ++i) {
        if (!rate_at_stage(problem, from, dt, i)) return false;
        image_.col(i) = f_;
      }
      mix(from, dt);
      return true;
    }
  }

  // The later stages on the polynomial through the rates at the start and at the nodes up to i.
  void draw_through(int i) {
    const auto& c = table().c;
    for (int later = i + 1; later < S; ++later) {
      double at_start = 1.0;
      Row l = Row::Zero();
      for (int j = 0; j <= i; ++j) {
        at_start *= (c[later] - c[j]) / -c[j];
        l[j] = c[later] / c[j];
        for (int m = 0; m <= i; ++m) l[j] *= m == j ? 1.0 : (c[later] - c[m]) / (c[j] - c[m]);
      }
      f_ = at_start * start_;
      detail::add_weighted(l.data(), 1.0, k_, f_);
      k_.col(later) = f_;
    }
  }

  template <class State>
  void mix(const State& from, double dt) {
    if constexpr (is_newton) {
      const Eigen::MatrixXd change = newton_.solve(image_ - k_);
      k_ += change;
      newton_change_ = stage_change(change, from, dt);
    } else {
      using Flat = Eigen::Map<Eigen::VectorXd>;
      Eigen::VectorXd x = Flat(k_.data(), k_.size()), gx = Flat(image_.data(), image_.size());
      solver_.next(x, gx);
      Flat(k_.data(), k_.size()) = x;
    }
  }

  // Largest change of a stage, each number over its size.
  template <class State>
  double stage_change(const Eigen::MatrixXd& change, const State& from, double dt) const {
    const Eigen::VectorXd size = place_of(from).cwiseAbs().cwiseMax(sizes(from));
    const double power = is_motion<State> ? dt * dt : dt;
    const auto& A = is_motion<State> ? table().A_bar : table().A;
    double largest = 0.0;
    for (int i = 0; i < S; ++i) {
      Eigen::VectorXd moved = Eigen::VectorXd::Zero(size.size());
      detail::add_weighted(A.row(i).data(), power, change, moved);
      largest = std::max(largest, moved.cwiseQuotient(size).cwiseAbs().maxCoeff());
      if (!moved.allFinite()) return std::numeric_limits<double>::quiet_NaN();
    }
    return largest;
  }

  // sum = start + change, and what rounding added to it.
  void add(const Eigen::VectorXd& start, Eigen::VectorXd& sum, Eigen::VectorXd& carry) const {
    sum = start + change_;
    carry = (sum - start) - change_;
  }

  // The rates with the other one of the weights b and b_bar than the state that is measured, over the same powers of
  // the step: changes that turn, as they do where the slowest contracting ones are a pair, are never blind to both.
  template <class P, class State>
  void weigh_otherwise(double dt) {
    other_.setZero(k_.rows());
    const Row& weights = PositionProblem<P> ? table().b : table().b_bar;
    detail::add_weighted(weights.data(), is_motion<State> ? dt * dt : dt, k_, other_);
  }

  void finish(const Motion& from, double dt, Motion& to) {
    const double *const by_place = table().b_bar.data(), *const by_speed = table().b.data();
    if (settings_.compensated) {
      change_ = dt * from.v - carry_;
      detail::add_weighted(by_place, dt * dt, k_, change_);
      add(from.r, to.r, new_carry_);
      change_ = -speed_carry_;
      detail::add_weighted(by_speed, dt, k_, change_);
      add(from.v, to.v, new_speed_carry_);
    } else {
      to.r = from.r + dt * from.v;
      detail::add_weighted(by_place, dt * dt, k_, to.r);
      to.v = from.v;
      detail::add_weighted(by_speed, dt, k_, to.v);
    }
    new_end_ = to;
  }
  void finish(const Values& from, double dt, Values& to) {
    if (settings_.compensated) {
      change_ = -carry_;
      detail::add_weighted(table().b.data(), dt, k_, change_);
      add(from.y, to.y, new_carry_);
    } else {
      to.y = from.y;
      detail::add_weighted(table().b.data(), dt, k_, to.y);
    }
    new_end_.t = to.t;
    new_end_.r = to.y;
  }

  // --- Its error -----------------------------------------------------------------------------------------------------

  // Largest of |x_i|, over its size or that of the value.
  double over_sizes(const Eigen::VectorXd& x, const Values& to, double) const {
    if (settings_.sizes.size() > 0) return x.cwiseQuotient(to.y.cwiseAbs().cwiseMax(sizes(to))).cwiseAbs().maxCoeff();
    return (x.array().abs() / to.y.array().abs().max(settings_.size)).maxCoeff();
  }
  // Of accelerations, as they move velocities and, over the step, positions.
  double over_sizes(const Eigen::VectorXd& x, const Motion& to, double dt) const {
    const double speed = std::max(settings_.speed, to.v.cwiseAbs().maxCoeff());
    if (settings_.sizes.size() > 0) {
      return std::max(x.cwiseAbs().maxCoeff() / speed,
                      dt * x.cwiseQuotient(to.r.cwiseAbs().cwiseMax(sizes(to))).cwiseAbs().maxCoeff());
    }
    const double size = std::max(settings_.size, to.r.cwiseAbs().maxCoeff());
    return x.cwiseAbs().maxCoeff() * std::max(1.0 / speed, dt / size);
  }

  template <class State>
  Truncation leading_coefficient(const State& from, double dt, const State& to) {
    if (place_of(from).size() == 0) return {.error = 0.0, .order = order};
    if constexpr (S == 1) {
      if (settings_.guess == Guess::free_flight) return {};
      change_ = k_.col(0) - guessed_;
    } else {
      change_.setZero(k_.rows());
      detail::add_weighted(table().top.data(), 1.0, k_, change_);
    }
    f_ = k_.cwiseAbs().rowwise().maxCoeff();
    const double rate = over_sizes(f_, to, dt);
    if (rate == 0.0) return {.error = 0.0, .order = order};
    const double eta = over_sizes(change_, to, dt) / rate;
    return {.error = dt * rate * std::pow(eta, static_cast<double>(order) / std::max(S - 1, 1)), .order = order};
  }

  template <class P>
  Truncation defect_at_start(P& problem, const Values& from, double dt, const Values& to) {
    if (from.y.size() == 0) return {.error = 0.0, .order = S};
    if (has_old_) {
      start_ = old_.col(S - 1);
    } else if (settings_.guess == Guess::free_flight) {
      place(from);
      if (!derive(problem, from, from.t, start_)) return {.error = std::numeric_limits<double>::infinity(), .order = S};
    }
    change_.setZero(k_.rows());
    detail::add_weighted(table().basis(0.0).data(), 1.0, k_, change_);
    Eigen::VectorXd error = filtered(start_ - change_, dt);
    if (retried_ || !has_old_) {  // the stiff part of a start off the slow solution has still to be damped once
      place_ = from.y + error;
      if (derive(problem, from, from.t, f_)) error = filtered(f_ - change_, dt);
    }
    return {.error = over_sizes(error, to, dt), .order = S};
  }
  Eigen::VectorXd filtered(const Eigen::VectorXd& defect, double dt) const {
    if constexpr (is_newton) {
      return newton_.filtered(defect, dt);
    } else {
      return (dt / (2.0 * S - 1.0)) * defect;
    }
  }

  CollocationSettings settings_;
  Solver solver_;
  typename NewtonOf<Solver>::type newton_;
  IterationMeasure measure_;
  Eigen::MatrixXd k_, old_, image_;                                                // one column a stage
  Eigen::VectorXd f_, start_, guessed_;                                            // rates
  Eigen::VectorXd place_, speed_, change_, before_, other_, other_before_, zero_;  // scratch
  Eigen::VectorXd carry_, speed_carry_, new_carry_, new_speed_carry_;  // what rounding added to the start, to the end
  Motion end_{.t = std::numeric_limits<double>::quiet_NaN(), .r = {}, .v = {}};  // of the step accepted last
  Motion new_end_;                                                               // of the step made last
  double old_dt_ = 0.0, newton_change_ = 0.0, rate_ = 0.0;
  double refused_at_ = std::numeric_limits<double>::quiet_NaN();
  bool accepted_ = false, has_old_ = false, bootstraps_ = false, retried_ = false, needs_speed_ = false;
};

}  // namespace particulate::schemes
