#include <particulate/schemes/sampling.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::schemes::detail {

SampleTimes::SampleTimes(std::vector<double> times) : times_(std::move(times)) {
  double last = -std::numeric_limits<double>::infinity();
  for (const double t : times_) {
    if (!(std::isfinite(t) && t > last)) {
      throw std::invalid_argument(
          fmt::format("sampling: times must be finite and each later than the one before, got {} s after {} s: sort "
                      "them and leave out what is twice",
                      t, last));
    }
    last = t;
  }
}

bool SampleTimes::in_step(const State& from, const State& to) const {
  if (left() == 0 || times_[next_] > to.t) return false;
  if (times_[next_] < from.t) {
    throw std::invalid_argument(
        fmt::format("sampling: times must not lie before the start of the run at t = {} s, got {} s: leave out those "
                    "that are earlier, or begin the run there",
                    from.t, times_[next_]));
  }
  return true;
}

}  // namespace particulate::schemes::detail
