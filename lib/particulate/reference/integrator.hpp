#pragma once

#include <array>
#include <memory>
#include <vector>

#include <particulate/reference/events.hpp>
#include <particulate/reference/method.hpp>
#include <particulate/schemes/problem.hpp>
#include <particulate/schemes/scheme.hpp>

namespace particulate::reference {

/// A method of SUNDIALS at work on a problem of ours: the independent judge of every scheme.
///
/// The problem is the very object that the schemes get. SUNDIALS keeps (r, v, y) in one vector, where right-hand sides
/// read and write in place; it is copied at the ends of a leg. What the problem throws comes out of advance() as it was
/// thrown. Where it has no value, or none that is finite, the step is tried again smaller; so it is where a Jacobian is
/// not finite.
///
/// What a problem changes at once at the end of a step, such as the impacts of a scene, is left out: SUNDIALS advances
/// the motion between jumps, and a ball falls through the floor unless events stop it there and the caller makes the
/// jump.
///
/// Accuracy has a floor of about 1e-11 (Adams), 1e-12 (explicit Runge-Kutta) or 2e-9 (BDF) relative, measured over ten
/// orbits of a Kepler problem; what must hold below that needs a closed form. One integrator is for one thread; several
/// may run at once.
class Integrator {
 public:
  /// Sets a method up on a problem.
  ///
  /// @param problem  the right-hand side; it must outlive the integrator
  /// @param start    where the first advance is expected to start; it fixes the number of unknowns
  /// @param method   the method and its settings
  /// @param events   where to stop on the way; only with Adams or Bdf, and at least one unknown
  /// @throws std::invalid_argument if the start is not finite, its lengths differ, a setting or the events cannot be
  /// meant, a band is as wide as the problem, or ImplicitExplicit is to solve what is no first-order problem in two
  /// parts (schemes::Splits)
  Integrator(const schemes::Problem& problem, const schemes::State& start, const Method& method,
             const Events& events = {});

  Integrator(Integrator&&) noexcept;  ///< What was moved from can only be destroyed or assigned to.
  /// Takes over what another integrator holds. @return this integrator
  Integrator& operator=(Integrator&&) noexcept;
  ~Integrator();  ///< Returns what SUNDIALS holds.

  /// Advances a state to t_end, which a step meets without interpolation, or to the first event before it.
  ///
  /// Given the state that the last advance left, the method goes on with its history and step. Given any other, and
  /// after a failure, it starts afresh from there, so that a caller may change the state in between. A leg's end cuts a
  /// step short, which Adams pays with small steps after it: two legs agree with one to the tolerances, not to the
  /// bits.
  ///
  /// At an event the state is interpolated; it stands on the far side of the zero, by no more than rounding. The next
  /// advance starts afresh from whatever the caller made of it. An event that has just stopped an advance does not stop
  /// the next one where it starts; nor does one that is exactly zero there.
  ///
  /// The outcome counts this advance alone. Evaluations are right-hand sides: those of difference quotients too, and
  /// of ImplicitExplicit each part apart. Rejections are failed error tests, steps whose nonlinear iteration did not
  /// converge, and steps on which the problem had no value. Sweeps are the nonlinear iterations, functional or
  /// Newton's; contraction is not measured and stays 0.
  ///
  /// @param state  where to start; on return the state at Outcome::t. If the problem throws it stays as it was.
  /// @param t_end  the end time, not before the state's [s]
  /// @return reached; stopped at an event, see hits(); or failed with the reason: SUNDIALS' own name for it, what it
  ///         means, what to do
  /// @throws std::invalid_argument for a state that is not finite or has changed its length, and for a bad end
  /// @throws whatever the problem or the events throw
  schemes::Outcome advance(schemes::State& state, double t_end);

  /// @return the events at which the last advance stopped, in the order of their functions; none if it did not stop
  const std::vector<Hit>& hits() const;

  /// @return right-hand sides by SUNDIALS' own count since the method last started afresh: a check on the outcomes' [-]
  long evaluations_by_sundials() const;

 private:
  struct Machinery;

  std::unique_ptr<Machinery> machinery_;
};

/// The version of SUNDIALS that runs: for the same tolerance another one may choose other steps.
///
/// @return major and minor [-]
std::array<int, 2> sundials_version();

/// Advances a state to t_end in one leg.
///
/// @param problem  the right-hand side
/// @param state    the start; on return the state at Outcome::t. If the problem throws it stays as it was.
/// @param t_end    the end time, not before the start [s]
/// @param method   the method and its settings
/// @return as Integrator::advance()
/// @throws std::invalid_argument for a start, an end or a setting that cannot be meant
/// @throws whatever the problem throws
schemes::Outcome integrate(const schemes::Problem& problem, schemes::State& state, double t_end, const Method& method);

}  // namespace particulate::reference
