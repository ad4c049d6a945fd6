#include <particulate/schemes/collocation.hpp>

namespace particulate::schemes {

void validate(const CollocationSettings& settings) {
  const auto require = [](const char* what, double given) {
    if (!(given > 0.0 && std::isfinite(given))) {
      throw std::invalid_argument(fmt::format("collocation: {} must be positive and finite, got {}", what, given));
    }
  };
  require("size", settings.size);
  require("speed", settings.speed);
  for (const double size : settings.sizes) require("sizes", size);
}

}  // namespace particulate::schemes
