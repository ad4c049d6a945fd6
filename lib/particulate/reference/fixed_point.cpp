#include <particulate/reference/fixed_point.hpp>

#include <cmath>
#include <exception>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>
#include <kinsol/kinsol.h>
#include <sundials/sundials_context.hpp>

#include <particulate/reference/detail/handles.hpp>

namespace particulate::reference {

namespace {

using detail::check;
using detail::made;

// What KINSOL hands back to its callback.
struct Callback {
  const Map& map;
  FixedPoint& result;
  std::exception_ptr thrown = nullptr;
};

void free_kinsol(void* memory) { KINFree(&memory); }

// KINSOL disregards +1 here: what has no value ends the iteration.
int evaluate(N_Vector x, N_Vector g, void* data) noexcept {
  Callback& callback = *static_cast<Callback*>(data);
  FixedPoint& result = callback.result;
  try {
    const auto size = static_cast<Eigen::Index>(N_VGetLength(x));
    const Eigen::Map<const Eigen::VectorXd> in(N_VGetArrayPointer(x), size);
    Eigen::Map<Eigen::VectorXd> out(N_VGetArrayPointer(g), size);
    if (!in.allFinite()) return -1;
    ++result.evaluations;
    if (callback.map(in, out) && out.allFinite()) return 0;
    result.reason =
        fmt::format("the map had no finite value in iteration {}; start closer to the fixed point", result.evaluations);
    return -1;
  } catch (...) {
    callback.thrown = std::current_exception();
    return -1;
  }
}

// The iteration, from x to x. Returns KINSOL's flag.
int iterate(Callback& callback, Eigen::VectorXd& x, const FixedPointSettings& settings) {
  const sundials::Context context;
#if SUNDIALS_VERSION_MAJOR >= 7
  SUNContext_ClearErrHandlers(context);
#endif
  Eigen::VectorXd ones = Eigen::VectorXd::Ones(x.size());
  const detail::Vector at(made(N_VMake_Serial(x.size(), x.data(), context), "N_VMake_Serial"));
  const detail::Vector scale(made(N_VMake_Serial(ones.size(), ones.data(), context), "N_VMake_Serial"));
  const std::unique_ptr<void, detail::Freed<free_kinsol>> memory(made(KINCreate(context), "KINCreate"));
  void* const m = memory.get();
#if SUNDIALS_VERSION_MAJOR < 7
  check(KINSetErrFile(m, nullptr), "KINSetErrFile");
#endif
  // The limit bounds the depth, and the depth is what KINInit makes room for: in this order.
  check(KINSetNumMaxIters(m, settings.max_iterations), "KINSetNumMaxIters");
  check(KINSetMAA(m, settings.anderson), "KINSetMAA");
  check(KINInit(m, evaluate, at.get()), "KINInit");
  check(KINSetReturnNewest(m, SUNTRUE), "KINSetReturnNewest");
  check(KINSetUserData(m, &callback), "KINSetUserData");
  check(KINSetFuncNormTol(m, settings.tolerance), "KINSetFuncNormTol");
  const int flag = KINSol(m, at.get(), KIN_FP, scale.get(), scale.get());
  check(KINGetNumNonlinSolvIters(m, &callback.result.iterations), "KINGetNumNonlinSolvIters");
  check(KINGetFuncNorm(m, &callback.result.change), "KINGetFuncNorm");
  return flag;
}

}  // namespace

// Comparisons are written so that a NaN fails them.
void validate(const FixedPointSettings& settings, Eigen::Index unknowns) {
  if (!(settings.tolerance > 0.0 && std::isfinite(settings.tolerance))) {
    throw std::invalid_argument(
        fmt::format("fixed point: tolerance must be positive and finite, got {}", settings.tolerance));
  }
  if (settings.anderson < 0 || settings.anderson > unknowns) {
    throw std::invalid_argument(
        fmt::format("fixed point: anderson must lie in 0 ... {}, the number of unknowns (more differences than that "
                    "depend on one another), got {}",
                    unknowns, settings.anderson));
  }
  if (settings.max_iterations < 1) {
    throw std::invalid_argument(
        fmt::format("fixed point: max_iterations must be positive, got {}", settings.max_iterations));
  }
}

FixedPoint solve_fixed_point(const Map& map, Eigen::VectorXd& x, const FixedPointSettings& settings) {
  validate(settings, x.size());
  if (!x.allFinite()) throw std::invalid_argument("fixed point: the start must be finite, got a NaN or an infinity");
  FixedPoint result;
  if (x.size() == 0) {
    result.converged = true;
    return result;
  }
  Eigen::VectorXd newest = x;
  Callback callback{.map = map, .result = result};
  const int flag = iterate(callback, newest, settings);
  if (callback.thrown) std::rethrow_exception(callback.thrown);
  if (!result.reason.empty()) return result;
  // KINSOL's norm passes over NaN, and takes such an iterate for one that does not change.
  if (!newest.allFinite()) {
    result.reason = fmt::format(
        "iteration {} led to a value that is not finite: the earlier ones do not tell where to go; take a smaller "
        "anderson, or another start",
        result.iterations);
    return result;
  }
  x = newest;
  result.converged = flag >= 0;
  if (flag == KIN_MAXITER_REACHED) {
    result.reason = fmt::format(
        "max_iterations = {} were not enough, the last changed an unknown by {}; allow more, widen tolerance = {}, or, "
        "if the changes grow, take a larger anderson",
        settings.max_iterations, result.change, settings.tolerance);
  } else if (flag < 0) {
    throw std::runtime_error(fmt::format("SUNDIALS: KINSol failed with {}", detail::owned(KINGetReturnFlagName(flag))));
  }
  return result;
}

}  // namespace particulate::reference
