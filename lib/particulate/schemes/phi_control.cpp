#include <particulate/schemes/phi_control.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <particulate/schemes/iteration.hpp>
#include <particulate/schemes/step_settings.hpp>

namespace particulate::schemes {

bool PhiControl::goes_on(const Iteration& it) const { return !met(it, TOL) && it.K < K_d; }

Decision PhiControl::judge(const Attempt& made) {
  const Iteration& it = made.iteration;
  const bool settled = it.evaluated && met(it, TOL);
  const double next = std::min(limit, within_bounds(factor(made), settled) * made.dt);
  if (settled) {
    if (made.dt >= step) step = next;
    return {.accepted = true};
  }
  Decision decision = detail::retried(unmet(made, TOL, K_d), next, smallest);
  if (decision.impossible.empty()) step = next;
  return decision;
}

// The wish of the most demanding field; NaN if nothing was measured.
double PhiControl::factor(const Attempt& made) {
  if (made.fields.empty()) return phi_K(made.iteration, TOL, K_d - spare);
  double wish = std::numeric_limits<double>::quiet_NaN();
  controlling = made.iteration.field;
  for (const Iteration& field : made.fields) {
    const double its = phi_K(field, TOL, K_d - spare);
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
  constexpr const char* whose = "Phi_K control";
  validate_tolerance(whose, control.TOL);
  detail::require(whose, control.K_d >= 1, "K_d must be at least 1", control.K_d);
  detail::require(whose, control.spare >= 0 && control.spare < control.K_d, "spare must lie between 0 and K_d - 1",
                  control.spare);
  detail::require(whose, control.limit > 0.0 && std::isfinite(control.limit), "limit must be positive and finite, in s",
                  control.limit);
  detail::validate(whose, {.step = control.step,
                           .limit = control.limit,
                           .smallest = control.smallest,
                           .growth = control.growth,
                           .retry = control.retry,
                           .shrink = control.shrink});
}

}  // namespace particulate::schemes
