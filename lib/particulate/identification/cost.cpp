#include <particulate/identification/cost.hpp>

#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::identification {

Value::Value(std::string why) : cost(std::numeric_limits<double>::quiet_NaN()), reason(std::move(why)) {
  if (reason.empty()) throw std::invalid_argument("a value that is none must say why: its reason is empty");
}

void validate(const Box& box) {
  if (box.lower.size() == 0 || box.lower.size() != box.upper.size()) {
    throw std::invalid_argument(
        fmt::format("a box must have as many lower as upper bounds, at least one; got {} and {}", box.lower.size(),
                    box.upper.size()));
  }
  for (Eigen::Index i = 0; i < box.lower.size(); ++i) {
    const double low = box.lower[i], high = box.upper[i];
    if (!(low < high) || !std::isfinite(high - low)) {
      throw std::invalid_argument(fmt::format(
          "bounds of parameter {} must be finite, the lower below the upper; got {:g} and {:g}", i, low, high));
    }
  }
}

Value evaluate(const Cost& cost, const Eigen::VectorXd& parameters) {
  try {
    Value value = cost(parameters);
    if (value.reason.empty() && !std::isfinite(value.cost)) {
      return Value(std::isnan(value.cost) ? "the cost is not a number" : "the cost is infinite");
    }
    return value;
  } catch (const std::exception& error) { return Value(std::string(error.what())); } catch (...) {
    return Value("the cost threw what is no std::exception");
  }
}

}  // namespace particulate::identification
