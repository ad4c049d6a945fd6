#pragma once

#include <cmath>
#include <vector>

namespace tests {

/// Order that errors show under refinement: the slope of ln error over ln step, by least squares.
///
/// @param error_of  gives the error of a run with so many steps
/// @param steps     numbers of steps, at least four
template <class F>
double observed_order(const F& error_of, const std::vector<int>& steps) {
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (const int n : steps) {
    const double x = -std::log(n), y = std::log(error_of(n));
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double N = static_cast<double>(steps.size());
  return (N * sxy - sx * sy) / (N * sxx - sx * sx);
}

}  // namespace tests
