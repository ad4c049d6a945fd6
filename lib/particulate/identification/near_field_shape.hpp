#pragma once

#include <Eigen/Core>

#include <particulate/kinematics/central_force.hpp>

namespace particulate::identification {

/// A central force by what is seen of it: where it balances, and how stiff it is there.
///
/// @equation{D 5.1} Histories determine d_e and V''(d_e) well, and both strengths badly, which move with the exponents.
struct NearFieldShape {
  double d_e = 1.0;        ///< equilibrium distance, > 0 [m]
  double stiffness = 1.0;  ///< V''(d_e), > 0, in the units of the strengths [N/m for one pair]
  double beta1 = 1.0;      ///< exponent of attraction, >= 0 [-]
  double beta2 = 2.0;      ///< exponent of repulsion, > beta1 [-]
};

/// The shape of a force.
///
/// @equation{D 5.1} By equilibrium_distance() and normal_stiffness() there.
/// @param law  with a stable equilibrium; strengths per unit mass squared give a stiffness per unit mass squared
/// @return its shape
/// @throws std::invalid_argument as equilibrium_distance(), and if beta2 <= beta1
NearFieldShape shape_of(const kinematics::CentralForce& law);

/// The force of a shape.
///
/// \f[ \alpha_1 = \frac{V''(d_e)\, d_e^{\beta_1 + 1}}{\beta_2 - \beta_1}, \qquad
///     \alpha_2 = \alpha_1\, d_e^{\beta_2 - \beta_1} \f]
///
/// @equation{D 5.1} From \f$ C(d_e) = 0 \f$ and \f$ V''(d_e) = \alpha_1 d_e^{-\beta_1-1} (\beta_2 - \beta_1) \f$.
/// @param shape  the shape
/// @return its force
/// @throws std::invalid_argument naming what of the shape cannot be meant
kinematics::CentralForce force_of(const NearFieldShape& shape);

/// How (ln d_e, ln V'', beta1, beta2) change with (ln alpha1, ln alpha2, beta1, beta2).
///
/// \f[ d \ln d_e = \frac{d\ln\alpha_2 - d\ln\alpha_1 - \ln d_e\,(d\beta_2 - d\beta_1)}{\beta_2 - \beta_1}, \qquad
///     d \ln V'' = d\ln\alpha_1 - (\beta_1 + 1)\, d\ln d_e - \ln d_e\, d\beta_1
///     + \frac{d\beta_2 - d\beta_1}{\beta_2 - \beta_1} \f]
///
/// @equation{D 5.1}
/// @param law  with a stable equilibrium
/// @return the derivative, a row an entry of the first
/// @throws std::invalid_argument as shape_of()
Eigen::Matrix4d derivative_of_log_shape(const kinematics::CentralForce& law);

}  // namespace particulate::identification
