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

using schemes::Where;

// (r, v, y) in the place where SUNDIALS has it.
Where where(double t, N_Vector x, const Callback& callback) {
  const double* const first = N_VGetArrayPointer(x);
  const Eigen::Index n = callback.at.r.size();
  return {t, {first, n}, {first + n, n}, {first + 2 * n, callback.at.y.size()}};
}

using Side = bool (schemes::Problem::*)(const Where&, const schemes::Answers&) const;

int evaluate_by(Side side, double t, N_Vector x, N_Vector dx, Callback& callback) noexcept {
  // The fixed-point solver of SUNDIALS 6 takes -1 for a lack of convergence and asks again: it gets no further.
  if (callback.thrown) return -1;
  try {
    const Where at = where(t, x, callback);
    const Eigen::Index n = at.r.size(), m = at.y.size();
    Eigen::Map<Eigen::VectorXd> out(N_VGetArrayPointer(dx), 2 * n + m);
    const bool carried = callback.problem.traits().carries;
    if (carried) out.tail(m).setZero();
    ++callback.evaluations;
    const schemes::Answers to{{out.data() + n, n}, {out.data() + 2 * n, carried ? 0 : m}};
    if ((callback.problem.*side)(at, to)) {
      out.head(n) = at.v;
      if (out.allFinite()) return 0;
    }
    callback.no_value_at = t;
    return 1;
  } catch (...) {
    callback.thrown = std::current_exception();
    return -1;
  }
}

void check_size(const Eigen::MatrixXd& J, Eigen::Index rows, Eigen::Index columns) {
  if (J.rows() == rows && J.cols() == columns) return;
  throw std::invalid_argument(fmt::format(
      "problem: jacobian must leave its matrix {} x {}, one row a rate and one column an unknown, got {} x {}", rows,
      columns, J.rows(), J.cols()));
}

}  // namespace

bool has_jacobian(const schemes::Problem& problem) {
  return problem.has_whole_jacobian() || (problem.has_jacobian() && !problem.traits().motion);
}

int evaluate(sunrealtype t, N_Vector y, N_Vector dy, void* data) noexcept {
  Callback& callback = *static_cast<Callback*>(data);
  return evaluate_by(&schemes::Problem::rates, t, y, dy, callback);
}

int evaluate_slow(sunrealtype t, N_Vector y, N_Vector dy, void* data) noexcept {
  Callback& callback = *static_cast<Callback*>(data);
  return evaluate_by(&schemes::Problem::rate_slow, t, y, dy, callback);
}

int evaluate_fast(sunrealtype t, N_Vector y, N_Vector dy, void* data) noexcept {
  Callback& callback = *static_cast<Callback*>(data);
  return evaluate_by(&schemes::Problem::rate_fast, t, y, dy, callback);
}

int fill_jacobian(sunrealtype t, N_Vector y, N_Vector, SUNMatrix J, void* data, N_Vector, N_Vector, N_Vector) noexcept {
  Callback& callback = *static_cast<Callback*>(data);
  try {
    const Where at = where(t, y, callback);
    const Eigen::Index n = at.r.size(), all = 2 * n + at.y.size();
    const Eigen::Index m = callback.problem.traits().carries ? 0 : at.y.size();
    Eigen::MatrixXd& rates = callback.jacobian;  // of (a, dy) by what has rates; without motion that is all there is
    rates.setZero(n + m, 2 * n + m);
    callback.problem.jacobian(at, rates);
    check_size(rates, n + m, 2 * n + m);
    if (!rates.allFinite()) {
      callback.no_jacobian_at = t;
      return 1;
    }
    Eigen::Map<Eigen::MatrixXd> out(SUNDenseMatrix_Data(J), all, all);  // both are column by column
    out.setZero();
    out.block(0, n, n, n).setIdentity();  // r' = v
    out.block(n, 0, n + m, 2 * n + m) = rates;
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
    callback.at.t = t;
    schemes::unflatten(read(y), callback.at);
    for (std::size_t k = 0; k < callback.armed.size(); ++k) {
      g[k] = callback.events[k].function(callback.at);
      if (!std::isfinite(g[k])) {
        callback.no_event_at = t;
        return -1;
      }
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
