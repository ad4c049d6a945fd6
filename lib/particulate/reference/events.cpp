#include <particulate/reference/events.hpp>

#include <stdexcept>

#include <fmt/format.h>

namespace particulate::reference {

void validate(const Events& events) {
  const std::size_t n = events.directions.size();
  if ((n > 0) != static_cast<bool>(events.functions)) {
    throw std::invalid_argument(
        fmt::format("events: functions and a direction for each of them must be given together, got {} and {} "
                    "directions; leave both out for no events",
                    events.functions ? "functions" : "no functions", n));
  }
  for (std::size_t k = 0; k < n; ++k) {
    const auto number = static_cast<int>(events.directions[k]);
    if (number < -1 || number > 1) {
      throw std::invalid_argument(
          fmt::format("events: direction {} must be falling, either or rising, got number {}", k, number));
    }
  }
}

}  // namespace particulate::reference
