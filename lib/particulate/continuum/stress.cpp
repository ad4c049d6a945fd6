#include <particulate/continuum/stress.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::continuum {

void validate(const Newtonian& law) {
  if (!(law.mu >= 0.0 && std::isfinite(law.mu))) {
    throw std::invalid_argument(
        fmt::format("Newtonian fluid: mu must be finite and not negative, got {} Pa s", law.mu));
  }
  // -2 mu/3 itself is rounded wherever it comes from.
  const double least = -2.0 / 3.0 * law.mu, rounding = 2.0 * std::numeric_limits<double>::epsilon() * law.mu;
  if (!(law.lambda >= least - rounding && std::isfinite(law.lambda))) {
    throw std::invalid_argument(
        fmt::format("Newtonian fluid: lambda must be finite and at least -2 mu/3 = {} Pa s, or expansion would release "
                    "energy, got {} Pa s",
                    least, law.lambda));
  }
}

}  // namespace particulate::continuum
