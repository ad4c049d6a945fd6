#pragma once

#include <particulate/continuum/deformation.hpp>

/// @file
/// Stress: what it exerts on a plane, what it is in a Newtonian fluid, and what its work becomes.

namespace particulate::continuum {

/// Force per area on a plane, from what the planes of the axes bear: Cauchy's tetrahedron.
///
/// \f[ t = \sigma\, n \f]
///
/// @equation{D A.4} The first index of sigma is the direction of the force, the second that of the plane.
/// @param sigma  stress [Pa]
/// @param n      outward unit normal [-]
/// @return t, exerted by what lies outside [Pa]
template <class S>
Vector<S> traction(const Tensor<S>& sigma, const Vector<S>& n) {
  return sigma * n;
}

/// What a fluid's stress is made of, beyond its pressure: isotropic, linear in the rate of deformation, and without
/// memory. At lambda = -2 mu/3 the pressure is minus the mean normal stress (Stokes).
struct Newtonian {
  double mu = 1.0;             ///< viscosity, >= 0 [Pa s]
  double lambda = -2.0 / 3.0;  ///< second viscosity, >= -2 mu/3 [Pa s]
};

/// Refuses viscosities with which a flow would gain energy. Called once, where a law enters.
///
/// @param law  the constants
/// @throws std::invalid_argument naming the constant, what must hold and what was given
void validate(const Newtonian& law);

/// The part of the stress that comes with a rate of deformation.
///
/// \f[ \tau = \lambda \operatorname{tr}(D)\, I + 2 \mu D \f]
///
/// @equation{D A.8}
/// @param law  constants that validate() accepts
/// @param D    rate of deformation [1/s]
/// @return tau, symmetric as D is [Pa]
template <class S>
Tensor<S> viscous_stress(const Newtonian& law, const Tensor<S>& D) {
  return law.lambda * D.trace() * Tensor<S>::Identity() + 2.0 * law.mu * D;
}

/// The stress of a Newtonian fluid.
///
/// \f[ \sigma = -P I + \lambda \operatorname{tr}(D)\, I + 2 \mu D \f]
///
/// @equation{D A.8}
/// @param law  constants that validate() accepts
/// @param P    pressure [Pa]
/// @param D    rate of deformation [1/s]
/// @return sigma [Pa]
template <class S>
Tensor<S> stress(const Newtonian& law, S P, const Tensor<S>& D) {
  return viscous_stress(law, D) - P * Tensor<S>::Identity();
}

/// Power of a stress in a flow, per volume.
///
/// \f[ \sigma : \nabla v = \sigma_{ij} \frac{\partial v_i}{\partial x_j} \f]
///
/// @equation{D A.7} Of a symmetric stress the spin takes none.
/// @param sigma  stress [Pa]
/// @param L      gradient of velocity [1/s]
/// @return power [W/m^3]
template <class S>
S stress_power(const Tensor<S>& sigma, const Tensor<S>& L) {
  return sigma.cwiseProduct(L).sum();
}

/// What viscosity turns into heat, per volume: the power of the viscous stress as a sum of squares.
///
/// \f[ \tau : D = 2 \mu\, D' : D' + (\lambda + \tfrac23 \mu) (\operatorname{tr} D)^2 \ge 0, \qquad
///     D' = D - \tfrac13 \operatorname{tr}(D)\, I \f]
///
/// @equation{D A.8} Never negative if and only if mu >= 0 and lambda >= -2 mu/3.
/// @param law  constants that validate() accepts
/// @param D    rate of deformation [1/s]
/// @return dissipation [W/m^3]
template <class S>
S dissipation(const Newtonian& law, const Tensor<S>& D) {
  const S expansion = D.trace();
  const Tensor<S> shear = D - expansion / 3.0 * Tensor<S>::Identity();
  return 2.0 * law.mu * shear.cwiseProduct(shear).sum() + (law.lambda + 2.0 / 3.0 * law.mu) * expansion * expansion;
}

}  // namespace particulate::continuum
