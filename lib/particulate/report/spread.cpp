#include <particulate/report/spread.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace particulate::report {

Spread spread_of(std::vector<double> numbers) {
  if (numbers.empty()) throw std::invalid_argument("spread: needs one number at least, got none");
  std::sort(numbers.begin(), numbers.end(),
            [](double a, double b) { return a < b || (std::isnan(b) && !std::isnan(a)); });
  return {numbers.front(), numbers[numbers.size() / 2], numbers.back()};
}

}  // namespace particulate::report
