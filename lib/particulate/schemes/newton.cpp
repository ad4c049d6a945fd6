#include <particulate/schemes/newton.hpp>

#include <algorithm>

namespace particulate::schemes {

double difference_step(double value, double size) {
  const double step = std::sqrt(std::numeric_limits<double>::epsilon()) * std::max(std::abs(value), size);
  return std::copysign(std::exp2(std::round(std::log2(step))), value);
}

}  // namespace particulate::schemes
