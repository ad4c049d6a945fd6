#include <particulate/reference/detail/callback.hpp>

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <sunmatrix/sunmatrix_dense.h>

namespace particulate::reference::detail {

namespace {

Eigen::Map<const Eigen::VectorXd> read(N_Vector y) {
  return {N_VGetArrayPointer(y), static_cast<Eigen::Index>(N_VGetLength(y))};
}

int evaluate_by(const Rate& rate, double t, N_Vector y, N_Vector dy, Callback& callback) noexcept {
  // The fixed-point solver of SUNDIALS 6 takes -1 for a lack of convergence and asks again: it gets no further.
  if (callback.thrown) return -1;
  try {
    const Eigen::Map<const Eigen::VectorXd> in = read(y);
    Eigen::Map<Eigen::VectorXd> out(N_VGetArrayPointer(dy), in.size());
    ++callback.evaluations;
    if (rate(t, in, out) && out.allFinite()) return 0;
    callback.no_value_at = t;
    return 1;
  } catch (...) {
    callback.thrown = std::current_exception();
    return -1;
  }
}

void check_size(const Eigen::MatrixXd& J, Eigen::Index n) {
  if (J.rows() == n && J.cols() == n) return;
  throw std::invalid_argument(
      fmt::format("problem: jacobian must leave its matrix {} x {}, one row and one column an unknown, got {} x {}", n,
                  n, J.rows(), J.cols()));
}

}  // namespace

int evaluate(sunrealtype t, N_Vector y, N_Vector dy, void* data) noexcept {
  Callback& callback = *static_cast<Callback*>(data);
  return evaluate_by(callback.problem.whole, t, y, dy, callback);
}

int evaluate_slow(sunrealtype t, N_Vector y, N_Vector dy, void* data) noexcept {
  Callback& callback = *static_cast<Callback*>(data);
  return evaluate_by(callback.problem.slow, t, y, dy, callback);
}

int evaluate_fast(sunrealtype t, N_Vector y, N_Vector dy, void* data) noexcept {
  Callback& callback = *static_cast<Callback*>(data);
  return evaluate_by(callback.problem.fast, t, y, dy, callback);
}

int fill_jacobian(sunrealtype t, N_Vector y, N_Vector, SUNMatrix J, void* data, N_Vector, N_Vector, N_Vector) noexcept {
  Callback& callback = *static_cast<Callback*>(data);
  try {
    const Eigen::Map<const Eigen::VectorXd> in = read(y);
    const Eigen::Index n = in.size();
    callback.jacobian.setZero(n, n);
    callback.problem.jacobian(t, in, callback.jacobian);
    check_size(callback.jacobian, n);
    if (!callback.jacobian.allFinite()) {
      callback.no_jacobian_at = t;
      return 1;
    }
    Eigen::Map<Eigen::MatrixXd>(SUNDenseMatrix_Data(J), n, n) = callback.jacobian;  // both are column by column
    return 0;
  } catch (...) {
    callback.thrown = std::current_exception();
    return -1;
  }
}

// The state at an event is beyond it by rounding, and may pass it again on its way back. So a function that has stopped
// an advance is handed over as an exact zero, which CVODE disregards at a start, until it has once been farther away.
int find_events(sunrealtype t, N_Vector y, sunrealtype* g, void* data) noexcept {
  Callback& callback = *static_cast<Callback*>(data);
  if (callback.thrown) return -1;
  try {
    Eigen::Map<Eigen::VectorXd> out(g, static_cast<Eigen::Index>(callback.events.directions.size()));
    callback.events.functions(t, read(y), out);
    if (!out.allFinite()) {
      callback.no_event_at = t;
      return -1;
    }
    for (std::size_t k = 0; k < callback.armed.size(); ++k) {
      if (callback.armed[k]) continue;
      callback.armed[k] = std::abs(g[k]) > callback.residue[static_cast<Eigen::Index>(k)];
      if (!callback.armed[k]) g[k] = 0.0;
    }
    return 0;
  } catch (...) {
    callback.thrown = std::current_exception();
    return -1;
  }
}

}  // namespace particulate::reference::detail
