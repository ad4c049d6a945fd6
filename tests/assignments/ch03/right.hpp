#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "step_control.hpp"

// What a student may well write, for either variant; decisions take the factor handed in. Submissions with one mistake
// take the rest from here.
namespace right {

inline double step_factor(const Sweeps& sweeps, int K_d) {
  if (sweeps.w_K == 0.0 || sweeps.K == 0) return std::numeric_limits<double>::infinity();
  const double wanted = std::pow(sweeps.TOL / sweeps.w_0, 1.0 / (sweeps.p * K_d));
  return wanted / std::pow(sweeps.w_K / sweeps.w_0, 1.0 / (sweeps.p * sweeps.K));
}

inline bool is_accepted(const std::vector<Sweeps>& fields) {
  return std::all_of(fields.begin(), fields.end(), [](const Sweeps& field) { return field.w_K <= field.TOL; });
}

// The smallest of all fields.
inline double phi(const std::vector<Sweeps>& fields, const Settings& settings) {
  double least = std::numeric_limits<double>::infinity();
  for (const Sweeps& field : fields) {
    least = std::min(least, std::isfinite(field.w_K) ? ::step_factor(field, settings.K_d) : 0.0);
  }
  return least;
}

// The decision to accept or not, with a factor that is still to be bounded.
inline Decision decision(double dt, bool accepted, double factor, const Settings& settings) {
  const double bounded =
      accepted ? std::clamp(factor, 1.0, settings.growth) : std::clamp(factor, settings.shrink, settings.retry);
  return {.accepted = accepted, .next = std::min(settings.limit, bounded * dt)};
}

inline Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings) {
  return decision(dt, is_accepted(fields), phi(fields, settings), settings);
}

using Two = std::array<double, 2>;

// One sweep over both stages of a Gauss step: the accelerations at the places that the last ones make.
inline Two sweep(const Acceleration& a, const State& from, double dt, const Two& last, double root = std::sqrt(3.0)) {
  const double first = from.r + (0.5 - root / 6) * dt * from.v;
  const double second = from.r + (0.5 + root / 6) * dt * from.v;
  return {a(first + dt * dt * (last[0] / 24 + (0.125 - root / 12) * last[1])),
          a(second + dt * dt * ((0.125 + root / 12) * last[0] + last[1] / 24))};
}

// Sweeps from a guess.
inline Two swept(const Acceleration& a, const State& from, double dt, int sweeps, Two stages = {},
                 double root = std::sqrt(3.0)) {
  for (int k = 0; k < sweeps; ++k) stages = sweep(a, from, dt, stages, root);
  return stages;
}

// The end of the step.
inline State gauss2_end(const State& from, double dt, const Two& a, double root = std::sqrt(3.0)) {
  return {.r = from.r + dt * from.v + dt * dt * ((0.25 + root / 12) * a[0] + (0.25 - root / 12) * a[1]),
          .v = from.v + 0.5 * dt * (a[0] + a[1])};
}

inline State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps) {
  return gauss2_end(from, dt, swept(a, from, dt, sweeps));
}

}  // namespace right
