#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <particulate/schemes/iteration.hpp>
#include <particulate/schemes/problem.hpp>

namespace particulate::schemes {

/// What the staggering scheme must know of one field.
struct Field {
  std::string_view name = {};  ///< for reports; it must outlive the scheme
  double TOL = 1e-6;           ///< tolerance on the field's own w_K, at least 2.3e-16 [-]
  int p = 1;  ///< exponent of Dt in the contraction of a sweep over all fields, >= 1: 2 for the fields of a fluid with
              ///< sound. Too small a p makes PhiControl answer every step with one that is wrong the other way [-]
};

/// Which values of the other fields a field sees within a sweep.
enum class Seen {
  newest,   ///< Gauss-Seidel: those that this sweep has just computed, where it has
  previous  ///< Jacobi: those of the last sweep, all fields could be solved at once
};

/// Relaxes a staggered iteration by a factor that follows from its last two residuals.
///
/// \f[ x \leftarrow x + \omega_k f_k, \qquad f = g(x) - x, \qquad
///     \omega_k = -\omega_{k-1}\,\frac{f_{k-1} \cdot (f_k - f_{k-1})}{\|f_k - f_{k-1}\|^2} \f]
///
/// Source: Aitken's method for vectors, @cite kuettler2008, equation 44. For one unknown it is the secant method: a
/// linear map is solved in three sweeps, whether it contracts or not, unless its slope is 1.
class Aitken {
 public:
  /// Forgets earlier residuals: a new step begins.
  void forget() { omega_.reset(); }
  /// The factor for the next iterate.
  ///
  /// @param residual  the map minus the iterate, in units that make all fields comparable
  /// @return omega; 1 for the first residual [-]
  double factor(const Eigen::VectorXd& residual);

 private:
  Eigen::VectorXd last_;
  std::optional<double> omega_;
};

/// Staggering: several coupled fields solved in turn, the others frozen, and again until none of them changes.
///
/// @equation{R 7.5.1} Every field k has its own error \f$ w_K^{(k)} \f$, measured as in section 3.3, its own tolerance
/// and exponent. iterations() gives them in units of the tolerances, so that a step is accepted if and only if
/// \f$ \max_k w_K^{(k)}/TOL_k \le 1 \f$, and PhiControl with TOL = 1 chooses \f$ \min_k \Phi_K^{(k)}\,\Delta t \f$. The
/// first iterate is the state at the start of the step.
///
/// Relaxation moves the fields that carry the iteration: all but the first, which is solved anew from the others.
/// Errors are those of the map, before relaxation: a small factor cannot pass for convergence. The model behind \f$
/// \Phi_K \f$ then holds only roughly. Under Jacobi there is none: its eigenvalues come in pairs of opposite sign,
/// which no single factor can bring down.
///
/// A field owns the motion, r and v, and is measured by r, or it owns a range of y: see Part.
class Staggered {
 public:
  static constexpr int order = 1;  ///< of the global error where every field is solved by an Euler scheme [-]
  /// @param of  what a problem has @return whether it has fields
  static constexpr bool advances(const Traits& of) { return of.staggered; }

  /// How many time scales one step may span, of fields that are each solved by a step of Euler: see Limited. With the
  /// newest values one sweep is a leapfrog between the fields, over 2 of a wave; iterated to its fixed point it
  /// contracts over 1, with those of the last sweep too. One sweep of these is forward Euler. Of relaxed sweeps nothing
  /// is known.
  ///
  /// @param kind    of time scale
  /// @param sweeps  of every step; 0: until they have converged
  /// @return multiple of the time scale [-]
  double spans(TimeScale::Kind kind, int sweeps) const;
  static constexpr bool adds_limits = true;  ///< see AddsLimits

  /// @param fields      as many as the problem has, in the order in which they are solved
  /// @param seen        which values of the others a field sees
  /// @param relaxation  none: each sweep is taken as it is; only with Seen::newest
  /// @throws std::invalid_argument if there is no field, a tolerance or exponent cannot be meant, or Jacobi is relaxed
  explicit Staggered(std::vector<Field> fields, Seen seen = Seen::newest, std::optional<Aitken> relaxation = {});

  /// The state at the start, at the end's time.
  ///
  /// @param problem  the coupled fields
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       receives the first iterate
  /// @return true
  /// @throws std::invalid_argument if the problem has another number of fields
  bool predict(const Problem& problem, const State& from, double dt, State& to);

  /// One sweep over all fields.
  ///
  /// @param problem  the coupled fields
  /// @param from     state at the start
  /// @param dt       step [s]
  /// @param to       the iterate; receives the next one
  /// @return the iteration of the field with the largest error, in units of its tolerance
  Iteration sweep(const Problem& problem, const State& from, double dt, State& to);

  /// Dense output of order 1, whatever solves the fields: the straight line.
  ///
  /// @param from   state at the start of the step made last
  /// @param dt     that step [s]
  /// @param theta  in units of the step; 0 its start, 1 its end [-]
  /// @param there  receives the state
  void at(const State& from, double dt, double theta, State& there) const;

  /// @return how each field's iteration went, in units of its tolerance
  std::span<const Iteration> iterations() const { return iterations_; }

  void accept(double) {}  ///< Keeps nothing: a one-step method.
  void forget() {}        ///< Has nothing to forget.

 private:
  // Where a field stands in a state; what is measured of it comes first.
  struct Owned {
    Part part;
    Eigen::Index measured = 0;  // how many numbers
  };
  static Eigen::VectorXd read(const Owned& field, const State& state);
  static void write(const Owned& field, const Eigen::VectorXd& value, State& state);

  void begin(const Problem& problem, const State& to);
  void collect();
  double relaxation_factor();
  void record(const Problem& problem, std::size_t k, const State& from, const State& to);
  void relax(State& to);
  std::size_t first_relaxed() const { return fields_.size() > 1 ? 1 : 0; }

  std::vector<Field> fields_;
  Seen seen_;
  std::optional<Aitken> relaxation_;
  std::vector<Owned> owned_;
  std::vector<IterationMeasure> measures_;
  std::vector<Iteration> iterations_;
  std::vector<Eigen::VectorXd> starts_, olds_;
  State end_;  // of the step made last
};

}  // namespace particulate::schemes
