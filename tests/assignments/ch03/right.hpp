#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "step_control.hpp"

// What a student may well write, for either variant. Submissions with one mistake take the rest from here.
namespace right {

inline double step_factor(const Sweeps& sweeps, int K_d) {
  if (sweeps.w_K == 0.0 || sweeps.K == 0) return std::numeric_limits<double>::infinity();
  const double wanted = std::pow(sweeps.TOL / sweeps.w_0, 1.0 / (sweeps.p * K_d));
  return wanted / std::pow(sweeps.w_K / sweeps.w_0, 1.0 / (sweeps.p * sweeps.K));
}

inline bool is_accepted(const std::vector<Sweeps>& fields) {
  return std::all_of(fields.begin(), fields.end(), [](const Sweeps& field) { return field.w_K <= field.TOL; });
}

inline double bounded(double factor, bool accepted, const Settings& settings) {
  return accepted ? std::clamp(factor, 1.0, settings.growth) : std::clamp(factor, settings.shrink, settings.retry);
}

// The smallest of what `factor` gives for each field.
template <class Factor>
double smallest(const std::vector<Sweeps>& fields, const Settings& settings, const Factor& factor) {
  double least = std::numeric_limits<double>::infinity();
  for (const Sweeps& field : fields) {
    least = std::min(least, std::isfinite(field.w_K) ? factor(field, settings.K_d) : 0.0);
  }
  return least;
}

// The decision with a factor of the student's own.
template <class Factor>
Decision next_step(double dt, const std::vector<Sweeps>& fields, const Settings& settings, const Factor& factor) {
  const bool accepted = is_accepted(fields);
  const double phi = smallest(fields, settings, factor);
  return {.accepted = accepted, .next = std::min(settings.limit, bounded(phi, accepted, settings) * dt)};
}

// One sweep over both stages of a Gauss step: the accelerations at the places that the last ones make.
inline std::array<double, 2> sweep(const Acceleration& a, const State& from, double dt,
                                   const std::array<double, 2>& last) {
  const double root = std::sqrt(3.0);
  const double first = from.r + (0.5 - root / 6) * dt * from.v;
  const double second = from.r + (0.5 + root / 6) * dt * from.v;
  return {a(first + dt * dt * (last[0] / 24 + (0.125 - root / 12) * last[1])),
          a(second + dt * dt * ((0.125 + root / 12) * last[0] + last[1] / 24))};
}

// Its end.
inline State gauss2_end(const State& from, double dt, const std::array<double, 2>& a) {
  const double root = std::sqrt(3.0);
  return {.r = from.r + dt * from.v + dt * dt * ((0.25 + root / 12) * a[0] + (0.25 - root / 12) * a[1]),
          .v = from.v + 0.5 * dt * (a[0] + a[1])};
}

inline State gauss2_step(const Acceleration& a, const State& from, double dt, int sweeps) {
  std::array<double, 2> stages{};
  for (int k = 0; k < sweeps; ++k) stages = sweep(a, from, dt, stages);
  return gauss2_end(from, dt, stages);
}

}  // namespace right
