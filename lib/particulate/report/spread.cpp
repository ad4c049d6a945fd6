#include <particulate/report/spread.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace particulate::report {

Spread spread_of(std::vector<double> numbers) {
  if (numbers.empty()) throw std::invalid_argument("spread: needs one number at least, got none");
  std::sort(numbers.begin(), numbers.end(),
            [](double a, double b) { return a < b || (std::isnan(b) && !std::isnan(a)); });
  return {numbers.front(), numbers[numbers.size() / 2], numbers.back()};
}

Mean mean_of(const std::vector<double>& numbers) {
  if (numbers.empty()) throw std::invalid_argument("mean: needs one number at least, got none");
  const auto n = static_cast<double>(numbers.size());
  const double mean = std::accumulate(numbers.begin(), numbers.end(), 0.0) / n;
  double square = 0.0;
  for (const double x : numbers) square += (x - mean) * (x - mean);
  return {mean, std::sqrt(square / (n * (n - 1.0)))};
}

}  // namespace particulate::report
