#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <harness/competitors.hpp>
#include <harness/near_field_cloud.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/kinematics/breathing.hpp>
#include <particulate/reference/integrator.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/integrate.hpp>
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
inline Race<NearFieldScene> breathing_race(const particulate::kinematics::Vectors& corners,
                                           const particulate::kinematics::RadialForce& radial, double alpha2,
                                           double r_0) {
  using namespace particulate;
  const Eigen::Index N = corners.rows();
  const kinematics::Breathing exact(radial, r_0);
  const kinematics::Particles start{.position = r_0 * corners,
                                    .velocity = kinematics::Vectors::Zero(N, 3),
                                    .mass = Eigen::VectorXd::Ones(N),
                                    .radius = Eigen::VectorXd::Zero(N)};
  const NearFieldScene scene{start, kinematics::Space{},
                             laws::NearField{.alpha1 = 1.0, .alpha2 = alpha2, .beta1 = 2.0, .beta2 = 3.0}};
  Race<NearFieldScene> race{.problem = scene, .start = scenes::start(scene), .outputs = {}, .truth = {}};
  for (int tenth = 1; tenth <= 9; ++tenth) race.outputs.push_back(tenth * exact.period() / 10.0);
  // Every run is asked about the same few times, and the closed form takes longer than many a run.
  race.truth = [corners, exact, known = std::make_shared<std::map<double, schemes::State>>()](double t) {
    const auto [at, is_new] = known->try_emplace(t);
    if (is_new) {
      const kinematics::Radial now = exact.at(t);
      at->second = {.t = t, .r = (now.r * corners).reshaped(), .v = (now.v * corners).reshaped()};
    }
    return at->second;
  };
  // |dr/dt| is largest where A/r^2 = B/r^3: v^2 = A^2/B - 2 A/r_0 + B/r_0^2.
  const double fastest = std::sqrt(radial.A * radial.A / radial.B - 2.0 * radial.A / r_0 + radial.B / (r_0 * r_0));
  race.length = r_0 * corners.rowwise().norm().maxCoeff();
  race.speed = fastest * corners.rowwise().norm().maxCoeff();
  return race;
}

/// The breathing pair, released 1 m apart. @param alpha2 repulsion: the smaller, the stiffer [N m^3] @return the race
inline Race<NearFieldScene> breathing_pair_race(double alpha2) {
  const particulate::kinematics::Vectors halves{{-0.5, 0.0, 0.0}, {0.5, 0.0, 0.0}};
  return breathing_race(halves, particulate::kinematics::breathing_pair(1.0, alpha2, 1.0, 1.0), alpha2, 1.0);
}

/// The breathing pentagon, alpha2 = 0.5. @return the race
inline Race<NearFieldScene> pentagon_race() {
  const particulate::kinematics::Vectors corners = particulate::kinematics::regular_polygon(5);
  return breathing_race(corners, particulate::kinematics::breathing_body(1.0, 0.5, 1.0, corners), 0.5, 1.0);
}

/// A race without a closed form.
struct JudgedRace {
  Race<NearFieldScene> race;  ///< its truth is known at the output times only
  double floor;               ///< by how much the two references disagree, in the measure of the race [-]
};

/// A race whose truth is ARKODE's, Fehlberg 8(7), and whose floor is its distance from CVODE's, Adams: two families at
/// their tightest.
///
/// @param scene  starts at t = 0
/// @param t_end  the last output [s]
/// @param legs   outputs at equal intervals, >= 1
/// @return the race and its floor
/// @throws std::runtime_error if a reference does not get there
inline JudgedRace judged_race(const NearFieldScene& scene, double t_end, int legs) {
  using namespace particulate;
  JudgedRace judged{.race = {.problem = scene, .start = scenes::start(scene), .outputs = {}, .truth = {}}, .floor = {}};
  Race<NearFieldScene>& race = judged.race;
  for (int leg = 1; leg <= legs; ++leg) race.outputs.push_back(t_end * leg / legs);
  const auto handed_by = [&](const reference::Method& method) {
    std::vector<schemes::State> states;
    schemes::State state = race.start;
    reference::Integrator integrator(scene, race.start, method);
    for (const double t : race.outputs) {
      const schemes::Outcome out = integrator.advance(state, t);
      if (out.status != schemes::Status::reached) throw std::runtime_error("a reference failed: " + out.reason);
      states.push_back(state);
    }
    return states;
  };
  const std::vector<schemes::State> truth = handed_by(
      reference::ExplicitRungeKutta{.table = reference::Table::fehlberg_13_7_8, .relative = 1e-15, .absolute = 1e-15});
  race.length = race.start.r.lpNorm<Eigen::Infinity>();
  race.speed = 0.0;
  for (const schemes::State& at : truth) race.speed = std::max(race.speed, at.v.lpNorm<Eigen::Infinity>());
  race.truth = [truth](double t) {
    return *std::find_if(truth.begin(), truth.end(), [t](const schemes::State& at) { return at.t >= t; });
  };
  detail::Lane<NearFieldScene> other(race);
  other.handed = handed_by(reference::Adams{.relative = 1e-15, .absolute = 1e-15});
  judged.floor = other.errors().max;
  return judged;
}

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
inline std::vector<double> step_sizes(double leg, const Steps& steps, int multiple = 1) {
  std::vector<double> sizes;
  for (int k = 0; k <= steps.times; ++k) {
    sizes.push_back(leg / std::round(multiple * steps.first * std::pow(steps.factor, k)));
  }
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  return sizes;
}

/// What the references are asked for.
///
/// @param tightest  the last, at most the loosest [-]
/// @param loosest   the first [-]
/// @return two tolerances a decade
inline std::vector<double> tolerances(double tightest, double loosest = 1e-4) {
  std::vector<double> all;
  for (double exponent = std::log10(loosest); exponent >= std::log10(tightest) - 1e-9; exponent -= 0.5) {
    all.push_back(std::pow(10.0, exponent));
  }
  return all;
}

/// A reference method whose setting is its relative tolerance, for competitor().
///
/// @param settings        of the method, but for its tolerances
/// @param absolute_share  absolute over relative tolerance, in the units of the problem
/// @return begin(problem, start, tolerance)
template <class Settings>
auto by(Settings settings, double absolute_share = 1.0) {
  return [=](auto& problem, const auto& start, double tolerance) {
    Settings now = settings;
    now.relative = tolerance;
    now.absolute = absolute_share * tolerance;
    return [integrator = particulate::reference::Integrator(problem, start, now)](auto& state, double t_end) mutable {
      return integrator.advance(state, t_end);
    };
  };
}

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
auto under_phi_control(Scheme scheme, SweepTolerance TOL) {
  return [=](auto& problem, const schemes::State&, double limit) {
    return [&problem, scheme, control = schemes::PhiControl{.TOL = TOL(limit), .step = limit, .limit = limit}](
               schemes::State& state, double t_end) mutable {
      return schemes::integrate(problem, state, t_end, scheme, control);
    };
  };
}

/// The phi family at fixed steps, for competitor().
///
/// @param scheme  a PhiFamily
/// @param TOL     on the sweeps, from the step
/// @return begin(problem, start, step)
template <class Scheme>
auto sweeping_at_fixed_step(Scheme scheme, SweepTolerance TOL) {
  return [=](auto& problem, const schemes::State&, double step) {
    return [&problem, scheme, control = schemes::FixedStep{.step = step, .TOL = TOL(step)}](schemes::State& state,
                                                                                            double t_end) mutable {
      return schemes::integrate(problem, state, t_end, scheme, control);
    };
  };
}

/// Fixes a slope that is to be fitted.
///
/// @param slope    nominal
/// @param who      a competitor at fixed steps
/// @param steeper  why errors may fall faster; empty: they may not
/// @return the competitor with a slope to be fitted
inline Competitor with_slope(double slope, Competitor who, std::string steeper = {}) {
  who.slope = slope;
  who.steeper = std::move(steeper);
  return who;
}

/// Why RK4 may be steeper where bodies turn once, at the middle of the motion.
inline constexpr const char* symmetric_turn =
    "the motion is symmetric in time about its turn, which cancels RK4's leading error";

/// Marks settings that were chosen for the problem.
///
/// @param who  a competitor
/// @return the same, drawn apart from those with a method's defaults
inline Competitor tuned(Competitor who) {
  who.tuned = true;
  return who;
}

}  // namespace verification
