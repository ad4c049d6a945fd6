#include <particulate/report/range.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace particulate::report {

// Comparisons are written so that a NaN fails them.
bool Range::holds(double value) const {
  if (std::isinf(value)) return infinite && value > 0.0;
  const bool above = above_lowest ? value > lowest : value >= lowest;
  const bool below = below_highest ? value < highest : value <= highest;
  return above && below;
}

bool Range::holds(const std::string& value) const {
  return choices.empty() || std::find(choices.begin(), choices.end(), value) != choices.end();
}

Range Range::or_infinite() const {
  Range wider = *this;
  wider.infinite = true;
  return wider;
}

std::string Range::text() const {
  if (!choices.empty()) return fmt::format("be one of {}", fmt::join(choices, ", "));
  const bool has_lowest = std::isfinite(lowest), has_highest = std::isfinite(highest);
  const std::string end = infinite ? " or inf" : "";
  if (has_lowest && has_highest) {
    return fmt::format("lie in {}{}, {}{}{}", above_lowest ? "(" : "[", lowest, highest, below_highest ? ")" : "]",
                       end);
  }
  if (has_lowest && above_lowest) return fmt::format("be greater than {}{}", lowest, end);
  if (has_lowest) return fmt::format("be at least {}{}", lowest, end);
  if (has_highest) return fmt::format("be {} {}{}", below_highest ? "less than" : "at most", highest, end);
  return "be a finite number" + end;
}

Range any() { return {}; }
Range at_least(double lowest) { return {.lowest = lowest}; }
Range more_than(double bound) { return {.lowest = bound, .above_lowest = true}; }
Range at_most(double highest) { return {.highest = highest}; }

Range between(double lowest, double highest) {
  if (!(lowest <= highest)) {
    throw std::invalid_argument(
        fmt::format("between: the lower end must not be above the upper one, got {} and {}", lowest, highest));
  }
  return {.lowest = lowest, .highest = highest};
}

Range one_of(std::vector<std::string> choices) {
  if (choices.empty()) throw std::invalid_argument("one_of: there must be at least one choice, got none");
  return {.choices = std::move(choices)};
}

}  // namespace particulate::report
