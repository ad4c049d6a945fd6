#pragma once

#include <particulate/kinematics/breathing.hpp>

/// @file
/// Closed forms evaluated in fifty decimal digits, compiled once for the cases of this chapter.

namespace verification {

/// Where a pair balances, \f$ d_e = (\alpha_2/\alpha_1)^{1/(\beta_2 - \beta_1)} \f$.
double equilibrium_in_fifty_digits(double alpha1, double alpha2, double beta1, double beta2);

/// A power of the distance between two distances, \f$ (d^{1-\beta} - d_{ref}^{1-\beta})/(1-\beta) \f$, for an exponent
/// near 1: a division by 1e-12 costs twelve of the digits.
double potential_in_fifty_digits(double d, double d_ref, double beta);

/// The pair with \f$ \alpha_1 = 1 \f$, exponents (2, 3) and unit masses that is released at rest at 1 m: distance and
/// its rate at a time, by Kepler's equation, halved into place.
particulate::kinematics::Radial breathing_in_fifty_digits(double alpha2, double t);

}  // namespace verification
