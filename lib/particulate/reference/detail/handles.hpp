#pragma once

#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <fmt/format.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nonlinearsolver.h>
#include <sundials/sundials_version.h>

#include <particulate/reference/method.hpp>

/// @file
/// What SUNDIALS hands out, owned; its flags, checked. Headers in detail/ include SUNDIALS and are not installed.

namespace particulate::reference::detail {

/// Settings are validated before they come to SUNDIALS, so that what fails there is a lack of memory or a defect of
/// ours.
inline void check(int flag, const char* call) {
  if (flag < 0) throw std::runtime_error(fmt::format("SUNDIALS: {} failed with flag {}", call, flag));
}

/// A handle that SUNDIALS has just made.
template <class Handle>
Handle made(Handle handle, const char* call) {
  if (!handle) throw std::runtime_error(fmt::format("SUNDIALS: {} returned nothing", call));
  return handle;
}

/// The deleter that is a function.
template <auto free>
struct Freed {
  template <class T>
  void operator()(T* handle) const {
    free(handle);
  }
};

using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, Freed<N_VDestroy>>;
using NonlinearSolver = std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>, Freed<SUNNonlinSolFree>>;

/// A direct linear solver and the matrix that it factorizes.
struct LinearSolver {
  std::unique_ptr<std::remove_pointer_t<SUNMatrix>, Freed<SUNMatDestroy>> matrix;
  std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, Freed<SUNLinSolFree>> solver;
};

/// The solver for a full matrix of as many rows as y has entries.
LinearSolver linear_solver(const DenseJacobian& full, N_Vector y, SUNContext context);
/// The solver for a band matrix of as many rows as y has entries.
LinearSolver linear_solver(const BandedJacobian& band, N_Vector y, SUNContext context);

/// The libraries hand their flags' names out as memory of ours.
inline std::string owned(char* text) {
  const std::unique_ptr<char, Freed<std::free>> owner(text);
  return text;
}

}  // namespace particulate::reference::detail
