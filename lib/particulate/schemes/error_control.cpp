#include <particulate/schemes/error_control.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include <particulate/schemes/iteration.hpp>

namespace particulate::schemes {

namespace {

void require(bool holds, const char* what_must_hold, double given) {
  if (!holds) throw std::invalid_argument(fmt::format("error control: {}, got {}", what_must_hold, given));
}

bool positive(double x) { return x > 0.0 && std::isfinite(x); }

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
  if (!swept || made.truncation.error > TOL) return refuse(made);
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
  Decision decision =
      swept ? Decision{.impossible =
                           fmt::format("the step of {:.6g} s leaves an error estimated at {:.3g}, above TOL = {:.3g}",
                                       made.dt, made.truncation.error, TOL),
                       .failure = Failure::inaccurate,
                       .workable = next}
            : unmet(made, sweep_TOL, allowed);
  refused = true;
  if (decision.failure == Failure::rounding) return decision;
  if (next < smallest) {
    decision.impossible +=
        fmt::format("; the next to try is {:.4g} s, below the smallest allowed {:.4g} s", next, smallest);
    return decision;
  }
  step = next;
  decision.refusal = std::exchange(decision.impossible, {});
  return decision;
}

void validate(const ErrorControl& control) {
  validate_tolerance("error control", control.TOL);
  validate_tolerance("error control, sweeps", control.sweep_TOL);
  require(control.K_d >= 1, "K_d must be at least 1", control.K_d);
  require(control.allowed >= control.K_d, "allowed must be at least K_d", control.allowed);
  require(positive(control.limit), "limit must be positive and finite, in s", control.limit);
  require(positive(control.step) && control.step <= control.limit, "step must be positive and at most limit, in s",
          control.step);
  require(control.smallest >= 0.0 && control.smallest <= control.step, "smallest must be in [0, step], in s",
          control.smallest);
  require(control.safety > 0.0 && control.safety <= 1.0, "safety must be in (0, 1]", control.safety);
  require(control.growth > 1.0 && std::isfinite(control.growth), "growth must be finite and above 1", control.growth);
  require(control.worth >= 1.0 && std::isfinite(control.worth), "worth must be finite and at least 1", control.worth);
  require(control.retry > 0.0 && control.retry < 1.0, "retry must be in (0, 1)", control.retry);
  require(control.shrink > 0.0 && control.shrink < control.retry, "shrink must be in (0, retry)", control.shrink);
}

}  // namespace particulate::schemes
