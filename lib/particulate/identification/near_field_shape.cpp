#include <particulate/identification/near_field_shape.hpp>

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::identification {

namespace {

void require_stable(double beta1, double beta2) {
  if (!(beta1 >= 0.0 && beta2 > beta1 && std::isfinite(beta2))) {
    throw std::invalid_argument(fmt::format(
        "shape of a near field: exponents must be finite and not negative, beta2 above beta1 for a stable equilibrium, "
        "got beta1 = {}, beta2 = {}",
        beta1, beta2));
  }
}

void require_positive(const char* name, double value) {
  if (!(value > 0.0 && std::isfinite(value))) {
    throw std::invalid_argument(
        fmt::format("shape of a near field: {} must be positive and finite, got {}", name, value));
  }
}

}  // namespace

NearFieldShape shape_of(const kinematics::CentralForce& law) {
  const double d_e = kinematics::equilibrium_distance(law);
  require_stable(law.beta1, law.beta2);
  return {.d_e = d_e, .stiffness = kinematics::normal_stiffness(law, d_e), .beta1 = law.beta1, .beta2 = law.beta2};
}

kinematics::CentralForce force_of(const NearFieldShape& shape) {
  require_stable(shape.beta1, shape.beta2);
  require_positive("d_e", shape.d_e);
  require_positive("the stiffness V''(d_e)", shape.stiffness);
  const double rise = shape.beta2 - shape.beta1;
  const double alpha1 = shape.stiffness * kinematics::power(shape.d_e, shape.beta1 + 1.0) / rise;
  return {.alpha1 = alpha1,
          .alpha2 = alpha1 * kinematics::power(shape.d_e, rise),
          .beta1 = shape.beta1,
          .beta2 = shape.beta2};
}

Eigen::Matrix4d derivative_of_log_shape(const kinematics::CentralForce& law) {
  const NearFieldShape shape = shape_of(law);
  const double rise = law.beta2 - law.beta1, log_d = std::log(shape.d_e);
  Eigen::Matrix4d derivative = Eigen::Matrix4d::Identity();
  derivative.row(0) = Eigen::RowVector4d(-1.0, 1.0, log_d, -log_d) / rise;
  derivative.row(1) = Eigen::RowVector4d(1.0, 0.0, -log_d - 1.0 / rise, 1.0 / rise) -
                      (law.beta1 + 1.0) * Eigen::RowVector4d(derivative.row(0));
  return derivative;
}

}  // namespace particulate::identification
