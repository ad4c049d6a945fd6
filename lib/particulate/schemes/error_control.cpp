#include <particulate/schemes/error_control.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <particulate/schemes/iteration.hpp>
#include <particulate/schemes/step_settings.hpp>

namespace particulate::schemes {

namespace {

std::string too_large(double dt, double error, double TOL) {
  if (std::isnan(error)) return fmt::format("of the step of {:.6g} s the scheme estimates no error", dt);
  return fmt::format("the step of {:.6g} s leaves an error estimated at {:.3g}, above TOL = {:.3g}", dt, error, TOL);
}

}  // namespace

bool ErrorControl::goes_on(const Iteration& it) const {
  const bool hopeless = it.K >= 2 && it.rate >= 1.0;
  return !settled(it) && !hopeless && it.K < allowed;
}

bool ErrorControl::settled(const Iteration& it) const { return it.K < 0 || it.w_K <= sweep_TOL || at_rounding(it); }

// By how much the step may grow, or must shrink, after both errors.
double ErrorControl::wish(const Attempt& made) const {
  const Truncation& seen = made.truncation;
  double factor = std::numeric_limits<double>::infinity();
  if (seen.error > 0.0) {
    const double power = 1.0 / (seen.order + 1.0);
    factor = safety * std::pow(TOL / seen.error, power);
    if (last_error > 0.0) factor *= std::min(1.0, made.dt / last_step * std::pow(last_error / seen.error, power));
  }
  const double by_sweeps = phi_K(made.iteration, sweep_TOL, K_d);
  return std::isnan(by_sweeps) ? factor : std::min(factor, by_sweeps);
}

Decision ErrorControl::judge(const Attempt& made) {
  const bool swept = made.iteration.evaluated && settled(made.iteration);
  if (!swept || !(made.truncation.error <= TOL)) return refuse(made);
  const double bounded = std::min(wish(made), refused ? 1.0 : growth);
  const double factor = bounded >= 1.0 && bounded < worth ? 1.0 : std::max(bounded, shrink);
  last_error = made.truncation.error;
  last_step = made.dt;
  if (made.dt >= step) step = std::min(limit, factor * made.dt);
  refused = false;
  return {.accepted = true};
}

Decision ErrorControl::refuse(const Attempt& made) {
  const bool swept = made.iteration.evaluated && settled(made.iteration);
  const double by_errors = wish(made);
  const double factor = made.iteration.evaluated && std::isfinite(by_errors) ? by_errors : 0.5 * (shrink + retry);
  const double next = std::clamp(factor, shrink, retry) * made.dt;
  Decision decision = swept ? Decision{.impossible = too_large(made.dt, made.truncation.error, TOL),
                                       .failure = Failure::inaccurate,
                                       .workable = next}
                            : unmet(made, sweep_TOL, allowed);
  refused = true;
  decision = detail::retried(std::move(decision), next, smallest);
  if (decision.impossible.empty()) step = next;
  return decision;
}

void validate(const ErrorControl& control) {
  constexpr const char* whose = "error control";
  validate_tolerance(whose, control.TOL);
  validate_tolerance("error control, sweeps", control.sweep_TOL);
  detail::require(whose, control.K_d >= 1, "K_d must be at least 1", control.K_d);
  detail::require(whose, control.allowed >= control.K_d, "allowed must be at least K_d", control.allowed);
  detail::require(whose, control.safety > 0.0 && control.safety <= 1.0, "safety must be in (0, 1]", control.safety);
  detail::require(whose, control.worth >= 1.0 && std::isfinite(control.worth), "worth must be finite and at least 1",
                  control.worth);
  detail::validate(whose, {.step = control.step,
                           .limit = control.limit,
                           .smallest = control.smallest,
                           .growth = control.growth,
                           .retry = control.retry,
                           .shrink = control.shrink});
}

}  // namespace particulate::schemes
