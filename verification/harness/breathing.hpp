#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include <harness/motions.hpp>
#include <harness/rows.hpp>
#include <harness/starts.hpp>
#include <particulate/kinematics/breathing.hpp>

/// @file
/// Bodies that move to and fro along fixed directions, compared with their closed form.

namespace verification {

/// Largest distances between computed and exact motion, over everything compared.
struct BreathingErrors {
  double position = 0.0;  ///< over the farthest place of the body [-]
  double velocity = 0.0;  ///< over the largest speed of the body [-]
};

/// A closed form with what it is scaled by.
struct ExactBreathing {
  particulate::kinematics::RadialForce force;  ///< A and B
  double r_0;                                  ///< start at rest [m]
  particulate::kinematics::Breathing motion{force, r_0};

  /// Largest |dr/dt|, where A/r^2 = B/r^3: v^2 = A^2/B - (2A/r_0 - B/r_0^2).
  double largest_speed() const {
    const double A = force.A, B = force.B;
    return std::sqrt(A * A / B - (2.0 * A / r_0 - B / (r_0 * r_0)));
  }
  /// Acceleration at the inner turning point, the largest of all.
  double largest_acceleration() const {
    const double r = motion.nearest();
    return force.B / (r * r * r) - force.A / (r * r);
  }
  /// Frequency at the inner turning point, the highest of all: omega^2 = 3B/r^4 - 2A/r^3.
  double highest_frequency() const {
    const double r = motion.nearest();
    return std::sqrt(3.0 * force.B / (r * r * r * r) - 2.0 * force.A / (r * r * r));
  }
  /// How much larger than the energy its two parts are at the inner turning point: 1/alpha2 of unit masses.
  double depth() const { return force.A * r_0 / force.B; }
};

/// What a shift in time by a share of the period makes of a motion.
inline BreathingErrors errors_of_shift(const ExactBreathing& exact, double share) {
  const double dt = share * exact.motion.period();
  return {.position = dt * exact.largest_speed() / exact.motion.farthest(),
          .velocity = dt * exact.largest_acceleration() / exact.largest_speed()};
}

/// A bound with its reason.
struct Allowed {
  BreathingErrors errors;  ///< of positions and velocities
  std::string because;     ///< why they are so large
};

/// What three periods of a fixed-step scheme may lose: three passages of two radians each at the highest frequency,
/// with the error per radian of an oscillator, (omega h)^4/120 for RK4 and (omega h)^2/24 for velocity Verlet. RK4 also
/// leaves each passage with another energy, by about (omega h)^5/120 of its parts, and so with another period.
inline Allowed allowed_to_steps(const ExactBreathing& exact, int order, double h) {
  const double phase = exact.highest_frequency() * h;
  const double radians = 6.0 * (order == 4 ? std::pow(phase, 4) / 120.0 : phase * phase / 24.0);
  const double energy = order == 4 ? 3.0 * std::pow(phase, 5) / 120.0 : 0.0;
  const double share = radians + exact.depth() * energy + 1e-12;
  return {.errors = errors_of_shift(exact, share),
          .because = fmt::format("three passages of r_min, two radians each at omega h = {:.2g}, the energy RK4 loses "
                                 "there, and 1e-12 of rounding: a "
                                 "shift in time by {:.1g} of a period",
                                 phase, share)};
}

/// What three periods of a reference method may lose: its energy is a difference of parts `depth` times larger.
inline Allowed allowed_to_tolerance(const ExactBreathing& exact, double global) {
  const double share = global * exact.depth();
  return {
      .errors = errors_of_shift(exact, share),
      .because = fmt::format("a global error of {:g} in energies that are {:.2g} times the total at r_min: a shift in "
                             "time by {:.1g} of a period",
                             global, exact.depth(), share)};
}

/// Global errors of the reference methods with their tolerances here: some hundred times the tolerance, more for Adams.
inline constexpr double global_of_adams = 1e-11, global_of_runge_kutta = 2e-12;

/// Writes the two rows of a run.
inline void compare_errors(Rows& rows, const std::string& which, const BreathingErrors& worst, const Allowed& allowed) {
  rows.at_most("positions" + which,
               {.limit = allowed.errors.position, .computed = worst.position, .because = allowed.because});
  rows.at_most("velocities" + which,
               {.limit = allowed.errors.velocity, .computed = worst.velocity, .because = allowed.because});
}

/// Adds one moment to the errors: body i is at r(t) times row i of the shape.
inline void compare_with(const ExactBreathing& exact, const particulate::kinematics::Vectors& shape,
                         const particulate::schemes::State& computed, BreathingErrors& worst) {
  const particulate::kinematics::Radial at = exact.motion.at(computed.t);
  const auto r = rows_of(computed.r);
  const auto v = rows_of(computed.v);
  const double farthest = exact.motion.farthest(), fastest = exact.largest_speed();
  for (Eigen::Index i = 0; i < shape.rows(); ++i) {
    const double size = shape.row(i).norm();
    worst.position = std::max(worst.position, (r.row(i) - at.r * shape.row(i)).norm() / (size * farthest));
    worst.velocity = std::max(worst.velocity, (v.row(i) - at.v * shape.row(i)).norm() / (size * fastest));
  }
}

/// Errors at every tenth of a period; `move(state, t_end)` integrates.
template <class Move>
BreathingErrors errors_at_tenths(const ExactBreathing& exact, const particulate::kinematics::Vectors& shape,
                                 particulate::schemes::State state, int tenths, const Move& move) {
  BreathingErrors worst;
  for (int k = 1; k <= tenths; ++k) {
    move(state, exact.motion.period() * k / 10.0);
    compare_with(exact, shape, state, worst);
  }
  return worst;
}

}  // namespace verification
