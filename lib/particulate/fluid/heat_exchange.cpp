#include <particulate/fluid/heat_exchange.hpp>

#include <stdexcept>

#include <fmt/format.h>

namespace particulate::fluid {

void validate(const HeatExchange& heat) {
  validate(cooling(heat, 0.0));
  if (heat.a_v >= 0.0 && heat.a_v <= 1.0) return;
  throw std::invalid_argument(fmt::format("heat exchange: a_v must lie between 0 and 1, got {}", heat.a_v));
}

}  // namespace particulate::fluid
