#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <harness/competitors.hpp>
#include <harness/near_field_cloud.hpp>
#include <particulate/kinematics/breathing.hpp>
#include <particulate/reference/method.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/phi_control.hpp>

/// @file
/// What the chapters' measurements of error against run time share: the breathing bodies, lists of settings, and how
/// the references and the phi family begin a run.

namespace verification {

/// Unit masses at `corners`, at rest, breathing with radius R(t): places and velocities are R and R' times the corners.
/// Outputs at every tenth of a period up to 0.9: at the period itself the bodies stand still.
///
/// @param corners  of a figure about the origin, N x 3
/// @param radial   R'' = -A/R^2 + B/R^3 for the attraction 1 and alpha2
/// @param alpha2   repulsion [N m^3]
/// @param r_0      R at the start [m]
/// @return the race, its truth in closed form
Race breathing_race(const particulate::kinematics::Vectors& corners, const particulate::kinematics::RadialForce& radial,
                    double alpha2, double r_0);

/// The breathing pair, released 1 m apart. @param alpha2 repulsion: the smaller, the stiffer [N m^3] @return the race
Race breathing_pair_race(double alpha2);

/// The breathing pentagon, alpha2 = 0.5. @return the race
Race pentagon_race();

/// A race without a closed form.
struct JudgedRace {
  Race race;     ///< its truth is known at the output times only
  double floor;  ///< by how much the two references disagree, in the measure of the race [-]
};

/// What a method of SUNDIALS hands out in a race, as a reference.
///
/// @param race    problem, start and output times
/// @param method  with its tolerances
/// @return the states at the output times
/// @throws std::runtime_error if it does not get there
std::vector<schemes::State> handed_by(const Race& race, const particulate::reference::Method& method);

/// A race whose truth is ARKODE's, Fehlberg 8(7), and whose floor is its distance from CVODE's, Adams: two families at
/// their tightest.
///
/// @param scene  starts at t = 0
/// @param t_end  the last output [s]
/// @param legs   outputs at equal intervals, >= 1
/// @return the race and its floor
/// @throws std::runtime_error if a reference does not get there
JudgedRace judged_race(const NearFieldScene& scene, double t_end, int legs);

/// The error of a closed form that was evaluated in extended precision, rounded to doubles.
inline constexpr double rounding_floor = 2e-16;

/// Steps in one leg: the first, and by what factor they grow how often.
struct Steps {
  int first;      ///< >= 1
  double factor;  ///< > 1, at most half a decade
  int times;      ///< >= 0
};

/// Steps that divide a leg evenly.
///
/// @param leg       time between two outputs [s]
/// @param steps     how many in a leg
/// @param multiple  that many times more: for methods that need fewer evaluations a step, or smaller steps
/// @return step sizes, falling, no two alike [s]
std::vector<double> step_sizes(double leg, const Steps& steps, int multiple = 1);

/// What the references are asked for.
///
/// @param tightest  the last, at most the loosest [-]
/// @param loosest   the first [-]
/// @return two tolerances a decade
std::vector<double> tolerances(double tightest, double loosest = 1e-4);

/// A reference method whose setting is its relative tolerance, for competitor().
///
/// @param method          with its settings, but for its tolerances
/// @param absolute_share  absolute over relative tolerance, in the units of the problem
/// @return begin(problem, start, tolerance)
Begin by(const particulate::reference::Method& method, double absolute_share = 1.0);

/// The tolerance on the sweeps of the phi family that keeps the error of the iteration at a share of the step's own.
///
/// The last sweep leaves \f$ C/(1 - C)\,w_K \f$ of the displacement in the position, and of the velocity in that,
/// where \f$ C = (\phi\,\omega\,\Delta t)^2 \f$ is its contraction. The step itself, of order p, leaves about
/// \f$ (\omega\,\Delta t)^{p+1} \f$ of the velocity. So \f$ w_K \le \text{share}\,(\Delta t/T)^{p-1} \f$ does, with any
/// T that is not below the times \f$ 1/\omega \f$ in which the motion changes.
struct SweepTolerance {
  int order;     ///< p of the scheme: 1, or 2 at phi = 1/2 [-]
  double share;  ///< of the error of the step, > 0 [-]
  double T;      ///< the longest time in which the motion changes, > 0 [s]

  /// What to ask of a controller.
  ///
  /// @param dt  the largest step [s]
  /// @return TOL [-]
  double operator()(double dt) const { return share * std::pow(dt / T, order - 1); }
};

/// The phi family under the monograph's controller, for competitor(): the setting is Dt_lim, which bounds the error of
/// the step; the controller makes smaller steps where the sweeps contract too slowly.
///
/// @param scheme  a PhiFamily
/// @param TOL     on the sweeps, from Dt_lim
/// @return begin(problem, start, limit)
template <class Scheme>
Begin under_phi_control(Scheme scheme, SweepTolerance TOL) {
  return under(scheme,
               [TOL](double limit) { return schemes::PhiControl{.TOL = TOL(limit), .step = limit, .limit = limit}; });
}

/// The phi family at fixed steps, for competitor().
///
/// @param scheme  a PhiFamily
/// @param TOL     on the sweeps, from the step
/// @return begin(problem, start, step)
template <class Scheme>
Begin sweeping_at_fixed_step(Scheme scheme, SweepTolerance TOL) {
  return under(scheme, [TOL](double step) { return schemes::FixedStep{.step = step, .TOL = TOL(step)}; });
}

/// Fixes a slope that is to be fitted.
///
/// @param slope    nominal
/// @param who      a competitor at fixed steps
/// @param steeper  why errors may fall faster; empty: they may not
/// @return the competitor with a slope to be fitted
Competitor with_slope(double slope, Competitor who, std::string steeper = {});

/// Why RK4 may be steeper where bodies turn once, at the middle of the motion.
inline constexpr const char* symmetric_turn =
    "the motion is symmetric in time about its turn, which cancels RK4's leading error";

/// Marks settings that were chosen for the problem.
///
/// @param who  a competitor
/// @return the same, drawn apart from those with a method's defaults
Competitor tuned(Competitor who);

}  // namespace verification
