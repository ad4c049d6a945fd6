#include <particulate/schemes/phi_control.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <particulate/schemes/iteration.hpp>

namespace particulate::schemes {

namespace {

void require(bool holds, const char* what_must_hold, double given) {
  if (!holds) throw std::invalid_argument(fmt::format("Phi_K control: {}, got {}", what_must_hold, given));
}

bool positive(double x) { return x > 0.0 && std::isfinite(x); }

}  // namespace

Decision PhiControl::judge(const Attempt& made) {
  const Iteration& it = made.iteration;
  const bool met = it.evaluated && it.w_K <= TOL;
  const double next = std::min(limit, within_bounds(factor(made), met) * made.dt);
  if (met) {
    if (made.dt >= step) step = next;
    return {.accepted = true};
  }
  Decision refused = unmet(made, TOL, K_d);
  if (refused.failure == Failure::rounding) return refused;
  if (next < smallest) {
    refused.impossible +=
        fmt::format("; the next to try is {:.4g} s, below the smallest allowed {:.4g} s", next, smallest);
    return refused;
  }
  step = next;
  refused.refusal = std::move(refused.impossible);
  refused.impossible.clear();
  return refused;
}

// The wish of the most demanding field; NaN if nothing was measured.
double PhiControl::factor(const Attempt& made) {
  if (made.fields.empty()) return phi_K(made.iteration, TOL, K_d);
  double wish = std::numeric_limits<double>::quiet_NaN();
  controlling = made.iteration.field;
  for (const Iteration& field : made.fields) {
    const double its = phi_K(field, TOL, K_d);
    if (std::isnan(its) || its >= wish) continue;
    wish = its;
    if (std::isfinite(its)) controlling = field.field;
  }
  return wish;
}

double PhiControl::within_bounds(double wish, bool met) const {
  if (met) return std::isnan(wish) ? growth : std::clamp(wish, 1.0, growth);
  return std::isnan(wish) ? 0.5 * (shrink + retry) : std::clamp(wish, shrink, retry);
}

void validate(const PhiControl& control) {
  validate_tolerance("Phi_K control", control.TOL);
  require(control.K_d >= 1, "K_d must be at least 1", control.K_d);
  require(positive(control.limit), "limit must be positive and finite, in s", control.limit);
  require(positive(control.step) && control.step <= control.limit, "step must be positive and at most limit, in s",
          control.step);
  require(control.smallest >= 0.0 && control.smallest <= control.step, "smallest must be in [0, step], in s",
          control.smallest);
  require(control.growth > 1.0 && std::isfinite(control.growth), "growth must be finite and above 1", control.growth);
  require(control.retry > 0.0 && control.retry < 1.0, "retry must be in (0, 1)", control.retry);
  require(control.shrink > 0.0 && control.shrink < control.retry, "shrink must be in (0, retry)", control.shrink);
}

}  // namespace particulate::schemes
