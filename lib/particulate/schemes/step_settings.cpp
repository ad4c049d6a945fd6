#include <particulate/schemes/step_settings.hpp>

#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace particulate::schemes::detail {

namespace {

bool positive(double x) { return x > 0.0 && std::isfinite(x); }

}  // namespace

void require(std::string_view whose, bool holds, std::string_view what, double given) {
  if (!holds) throw std::invalid_argument(fmt::format("{}: {}, got {}", whose, what, given));
}

void validate(std::string_view whose, const StepSettings& of) {
  require(whose, of.limit > 0.0, "limit must be positive, in s", of.limit);
  require(whose, of.step == 0.0 || (positive(of.step) && of.step <= of.limit),
          "step must be positive and at most limit, or left out, in s", of.step);
  const double most = of.step > 0.0 ? of.step : of.limit;
  require(whose, of.smallest >= 0.0 && of.smallest <= most, "smallest must be in [0, step], in s", of.smallest);
  require(whose, of.growth > 1.0 && std::isfinite(of.growth), "growth must be finite and above 1", of.growth);
  require(whose, of.retry > 0.0 && of.retry < 1.0, "retry must be in (0, 1)", of.retry);
  require(whose, of.shrink > 0.0 && of.shrink < of.retry, "shrink must be in (0, retry)", of.shrink);
}

void validate_step(std::string_view whose, double step) {
  if (!positive(step)) {
    throw std::invalid_argument(fmt::format("{}: step must be positive and finite, got {} s", whose, step));
  }
}

Decision retried(Decision unmet, double next, double smallest) {
  if (unmet.failure == Failure::rounding) return unmet;
  if (next < smallest) {
    unmet.impossible +=
        fmt::format("; the next to try is {:.4g} s, below the smallest allowed {:.4g} s", next, smallest);
    return unmet;
  }
  unmet.refusal = std::exchange(unmet.impossible, {});
  return unmet;
}

}  // namespace particulate::schemes::detail
