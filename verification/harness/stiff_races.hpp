#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <harness/front.hpp>
#include <harness/races.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>

/// @file
/// Radau collocation against CVODE BDF, where temperatures are stiff. In a header, so that what is timed is compiled
/// like the cases that time it.

namespace verification {

/// Radau IIA collocation of so many stages with Newton's method and sparse matrices.
///
/// @param race   problem, start, outputs and truth
/// @param quick  whether tolerances end at 1e-9 instead of 1e-11
/// @return the competitor, with settings chosen for stiff decay
template <int stages>
Competitor radau(const Race& race, bool quick) {
  const auto control = [t_end = race.outputs.back()](double TOL) {
    return schemes::ErrorControl{
        .TOL = TOL, .sweep_TOL = std::max(0.01 * TOL, 2.3e-16), .K_d = 3, .limit = t_end, .growth = 8.0, .worth = 1.2};
  };
  const schemes::Collocation<schemes::Radau<stages>, schemes::Newton<schemes::SparseStages>> scheme;
  return tuned(
      competitor(fmt::format("Radau {}", stages), race, tolerances(quick ? 1e-9 : 1e-11, 1.0), under(scheme, control)));
}

/// Who solves stiff races: CVODE BDF, and Radau of three and of five stages.
///
/// @param race   problem, start, outputs and truth
/// @param quick  whether fewer tolerances are tried
/// @param bdf    how Newton's method of BDF gets its Jacobian, but for its tolerances
/// @return the competitors
inline std::vector<Competitor> stiff_ones(const Race& race, bool quick, const particulate::reference::Bdf& bdf = {}) {
  return {competitor("CVODE BDF", race, tolerances(1e-14, quick ? 1e-7 : 1e-3), by(bdf)), radau<3>(race, quick),
          radau<5>(race, quick)};
}

/// Rows: either Radau comes to 1e-8 with no more evaluations than CVODE BDF, those for Jacobians counted in.
///
/// @param rows     where the points are, and where rows go
/// @param problem  its name
inline void compare_at_1e_8(Rows& rows, const std::string& problem) {
  const auto evaluations = [](const WorkPrecisionPoint& point) {
    return static_cast<double>(point.counts.evaluations);
  };
  const auto cost = [&](const std::string& method) {
    const auto found = front(rows.points(), problem, {method, {method}}, 1e-8, evaluations);
    return found ? found->cost : missing;
  };
  const double bdf = cost("CVODE BDF");
  for (const std::string by : {"Radau 3", "Radau 5"}) {
    rows.at_most(fmt::format("{}, evaluations of {} to 1e-8, those for Jacobians included", problem, by),
                 {.limit = bdf, .computed = cost(by), .because = "no more than CVODE BDF takes"});
  }
}

}  // namespace verification
