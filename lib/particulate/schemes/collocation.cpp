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

// Four columns at a time, so that the sum is loaded and stored a quarter as often.
void detail::add_weighted(const double* w, double scale, const Eigen::MatrixXd& k, Eigen::VectorXd& sum) {
  const Eigen::Index s = k.cols();
  Eigen::Index j = 0;
  for (; j + 4 <= s; j += 4) {
    sum += (scale * w[j]) * k.col(j) + (scale * w[j + 1]) * k.col(j + 1) + (scale * w[j + 2]) * k.col(j + 2) +
           (scale * w[j + 3]) * k.col(j + 3);
  }
  for (; j < s; ++j) sum += (scale * w[j]) * k.col(j);
}

}  // namespace particulate::schemes
