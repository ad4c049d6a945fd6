#include <particulate/schemes/legs.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::schemes {

namespace {

// Beyond so many periods from zero their multiples are lost in rounding.
constexpr double most_periods = 1e15;

// A multiple so many roundings before the end of a run would end a leg for nothing.
constexpr double time_roundings = 8.0;

}  // namespace

double next_multiple(double period, double t) {
  if (!(period > 0.0 && std::isfinite(period))) {
    throw std::invalid_argument(fmt::format("period: must be positive and finite, got {} s", period));
  }
  if (!(std::abs(t) / period < most_periods)) {
    throw std::invalid_argument(fmt::format(
        "period: must not be lost in the rounding of the time, got {} s at t = {} s: choose a longer one", period, t));
  }
  double k = std::floor(t / period);
  while (k * period <= t) k += 1.0;
  return k * period;
}

std::vector<double> multiples(double period, double first, double last) {
  std::vector<double> times;
  if (!std::isfinite(last)) {
    throw std::invalid_argument(fmt::format("period: its multiples must end at a finite time, got {} s", last));
  }
  for (double t = next_multiple(period, std::nextafter(first, -std::numeric_limits<double>::infinity())); t <= last;
       t = next_multiple(period, t)) {
    times.push_back(t);
  }
  return times;
}

namespace detail {

double end_of_leg(double period, double t, double t_end) {
  const double next = next_multiple(period, t);
  const double slack = time_roundings * std::numeric_limits<double>::epsilon() * std::max(std::abs(t), std::abs(t_end));
  return next == t_end || next < t_end - slack ? next : t_end;
}

}  // namespace detail

}  // namespace particulate::schemes
