#include <harness/claims.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace verification {

Tolerance relative(double tolerance) { return {.relative = tolerance, .absolute = 0.0}; }
Tolerance absolute(double tolerance) { return {.relative = 0.0, .absolute = tolerance}; }
Tolerance mixed(double relative, double absolute) { return {.relative = relative, .absolute = absolute}; }

Ending Ending::solved(Answer answer) { return Ending(std::move(answer)); }
Ending Ending::refused(std::string reason) { return Ending(std::move(reason)); }

double mixed_error(std::span<const double> computed, std::span<const double> expected, double scale) {
  if (computed.size() != expected.size() || computed.empty() || !(scale > 0.0)) {
    throw std::invalid_argument(
        fmt::format("mixed_error: there must be as many computed as expected values, at least one, and a positive "
                    "scale, got {}, {} and {}",
                    computed.size(), expected.size(), scale));
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < computed.size(); ++i) {
    const double error = std::abs(computed[i] - expected[i]) / std::max(std::abs(expected[i]), scale);
    if (!(error <= largest)) largest = error;
    if (std::isnan(error)) break;
  }
  return largest;
}

double fitted_order(std::span<const double> steps, std::span<const double> errors) {
  const auto positive = [](std::span<const double> values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return value > 0.0 && std::isfinite(value); });
  };
  if (steps.size() != errors.size() || steps.size() < 2 || !positive(steps) || !positive(errors)) {
    throw std::invalid_argument(
        fmt::format("fitted_order: there must be at least two steps and as many errors, all positive and finite, got "
                    "{} steps and {} errors",
                    steps.size(), errors.size()));
  }
  const double count = static_cast<double>(steps.size());
  double mean_step = 0.0, mean_error = 0.0, product = 0.0, square = 0.0;
  for (const double step : steps) mean_step += std::log2(step) / count;
  for (const double error : errors) mean_error += std::log2(error) / count;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double from_mean = std::log2(steps[i]) - mean_step;
    product += from_mean * (std::log2(errors[i]) - mean_error);
    square += from_mean * from_mean;
  }
  return product / square;
}

}  // namespace verification
