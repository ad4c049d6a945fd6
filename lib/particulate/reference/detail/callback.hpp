#pragma once

#include <exception>
#include <optional>
#include <vector>

#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nvector.h>
#include <Eigen/Core>

#include <particulate/reference/events.hpp>
#include <particulate/schemes/problem.hpp>

/// @file
/// What SUNDIALS calls, in C, and how a problem answers.

namespace particulate::reference::detail {

/// What SUNDIALS hands back to its callbacks. It sees only C: exceptions wait here until the call has returned.
struct Callback {
  schemes::Problem problem;
  schemes::State at;  ///< scratch of the events, and the lengths of r, v and y
  Events events = {};
  long evaluations = 0;
  std::exception_ptr thrown = nullptr;
  std::optional<double> no_value_at = {};     ///< where the step being tried was last told so
  std::optional<double> no_jacobian_at = {};  ///< where the Jacobian was not finite
  std::optional<double> no_event_at = {};     ///< where an event function was not finite
  Eigen::VectorXd residue = {};  ///< how far from zero each function may still stand on an event that has stopped
  std::vector<bool> armed = {};  ///< whether it has been farther away since the method last started afresh
  Eigen::MatrixXd jacobian = {};
};

/// Each returns 0, +1 for "no value here, try a smaller step", or -1 for "give up".
int evaluate(sunrealtype t, N_Vector y, N_Vector dy, void* data) noexcept;
int evaluate_slow(sunrealtype t, N_Vector y, N_Vector dy, void* data) noexcept;
int evaluate_fast(sunrealtype t, N_Vector y, N_Vector dy, void* data) noexcept;

/// Whether a problem gives the Jacobian of all that SUNDIALS advances.
bool has_jacobian(const schemes::Problem& problem);

/// Fills a dense matrix of SUNDIALS. Returns as evaluate() does.
int fill_jacobian(sunrealtype t, N_Vector y, N_Vector, SUNMatrix J, void* data, N_Vector, N_Vector, N_Vector) noexcept;

/// Returns 0, or -1 for "give up".
int find_events(sunrealtype t, N_Vector y, sunrealtype* g, void* data) noexcept;

}  // namespace particulate::reference::detail
