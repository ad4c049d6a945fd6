#include <particulate/continuum/deformation.hpp>

#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::continuum {

void validate_deformation(const Tensor<double>& F) {
  // The terms of the determinant, all added: what J is lost in.
  double terms = 0.0;
  for (int j = 0; j < 3; ++j) {
    const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    terms += std::abs(F(0, j)) * (std::abs(F(1, j1) * F(2, j2)) + std::abs(F(1, j2) * F(2, j1)));
  }
  const double J = jacobian(F);
  if (J > 4.0 * std::numeric_limits<double>::epsilon() * terms) return;
  throw std::invalid_argument(
      fmt::format("deformation: J = det F must be positive, and above the rounding of its terms, got {} of terms of {} "
                  "in all; give "
                  "the gradient of a motion that neither flattens matter nor turns it inside out",
                  J, terms));
}

}  // namespace particulate::continuum
