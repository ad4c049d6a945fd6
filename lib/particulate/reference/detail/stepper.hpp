#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>
#include <sundials/sundials_nvector.h>

#include <particulate/reference/events.hpp>
#include <particulate/schemes/state.hpp>

/// @file
/// What every stepper can do: start afresh, head for an end, take a step, and tell what it has cost.

namespace particulate::reference::detail {

/// A state as SUNDIALS keeps it.
struct Flat {
  double t = 0.0;
  Eigen::VectorXd x;  ///< (r, v, y)
};

/// What a stepper has done since it last started afresh.
struct Counts {
  long steps = 0, rejections = 0, sweeps = 0, evaluations = 0;
};

/// No unknowns: time passes. The norms of SUNDIALS would divide by the number of unknowns.
struct NothingToSolve {
  void restart(double, N_Vector) {}
  void stop_at(double) {}
  static int step(const Flat&, double t_end, N_Vector, double& t) {
    t = t_end;
    return 0;
  }
  static Counts counts() { return {}; }
  static std::vector<Hit> hits() { return {}; }
  static std::string name_of(int flag) { return fmt::format("flag {}", flag); }
};

}  // namespace particulate::reference::detail
