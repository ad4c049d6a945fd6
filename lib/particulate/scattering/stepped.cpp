#include <particulate/scattering/stepped.hpp>

#include <stdexcept>

#include <fmt/format.h>

namespace particulate::scattering {

void validate(const SteppedSettings& settings) {
  if (settings.xi > 0.0 && settings.xi <= 0.5) return;
  throw std::invalid_argument(
      fmt::format("stepped tracing: xi must lie in (0, 0.5], got {}: longer steps pass through bodies, none never end",
                  settings.xi));
}

}  // namespace particulate::scattering
