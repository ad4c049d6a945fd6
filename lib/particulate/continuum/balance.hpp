#pragma once

#include <particulate/continuum/deformation.hpp>

/// @file
/// Balance laws at a point, each as what is left over: zero for what obeys it. A rate is that of one point of the
/// matter (material_rate()); derivatives are taken in the places of now.

namespace particulate::continuum {

/// The rate that a point of the matter sees of a field.
///
/// \f[ \dot\varphi = \frac{\partial \varphi}{\partial t} + v \cdot \nabla \varphi \f]
///
/// @equation{D A.5}
/// @param local     rate at a fixed place
/// @param v         velocity [m/s]
/// @param gradient  of the field
/// @return rate along the motion
template <class S>
S material_rate(S local, const Vector<S>& v, const Vector<S>& gradient) {
  return local + v.cwiseProduct(gradient).sum();
}
/// The same of a vector field: of the velocity itself, the acceleration
/// \f$ \dot v = \partial v/\partial t + (\nabla v)\, v \f$.
///
/// @equation{D A.5}
/// @param local     rate at a fixed place
/// @param v         velocity [m/s]
/// @param gradient  of the field, component by row
/// @return rate along the motion
template <class S>
Vector<S> material_rate(const Vector<S>& local, const Vector<S>& v, const Tensor<S>& gradient) {
  return local + gradient * v;
}

/// Mass, of one point of the matter since the start.
///
/// \f[ \rho J - \rho_0 = 0 \f]
///
/// @equation{D A.5}
/// @param rho    density [kg/m^3]
/// @param F      deformation gradient [-]
/// @param rho_0  density at the start [kg/m^3]
/// @return what is left over [kg/m^3]
template <class S>
S mass_since_start(S rho, const Tensor<S>& F, S rho_0) {
  return rho * jacobian(F) - rho_0;
}

/// Mass, at a place.
///
/// \f[ \dot\rho + \rho\, \nabla \cdot v = 0 \f]
///
/// @equation{D A.5}
/// @param rho       density [kg/m^3]
/// @param rho_rate  its rate along the motion [kg/(m^3 s)]
/// @param L         gradient of velocity [1/s]
/// @return what is left over [kg/(m^3 s)]
template <class S>
S mass_residual(S rho, S rho_rate, const Tensor<S>& L) {
  return rho_rate + rho * L.trace();
}

/// Momentum.
///
/// \f[ \rho\, \dot v - \nabla \cdot \sigma - f = 0 \f]
///
/// @equation{D A.5}
/// @param rho           density [kg/m^3]
/// @param acceleration  rate of the velocity along the motion [m/s^2]
/// @param div_sigma     \f$ \partial \sigma_{ij}/\partial x_j \f$ [N/m^3]
/// @param f             force from outside, per volume [N/m^3]
/// @return what is left over [N/m^3]
template <class S>
Vector<S> momentum_residual(S rho, const Vector<S>& acceleration, const Vector<S>& div_sigma, const Vector<S>& f) {
  return rho * acceleration - div_sigma - f;
}

/// Angular momentum: the torque per volume that a stress exerts on the matter itself, which has nothing to take it.
///
/// \f[ m_i = \epsilon_{ijk}\, \sigma_{kj} = 0, \qquad\text{and}\qquad \sigma = \sigma^T \f]
///
/// @equation{D A.6}
/// @param sigma  stress [Pa]
/// @return m, zero if and only if sigma is symmetric [N m/m^3]
template <class S>
Vector<S> angular_momentum_residual(const Tensor<S>& sigma) {
  return {sigma(2, 1) - sigma(1, 2), sigma(0, 2) - sigma(2, 0), sigma(1, 0) - sigma(0, 1)};
}

/// The first law of thermodynamics: what is left of the energy once the motion's has been taken off.
///
/// \f[ \rho\, \dot e - \sigma : \nabla v + \nabla \cdot h - q = 0 \f]
///
/// @equation{D A.7} In this library's fluids e = c theta and h = -K grad theta.
/// @param rho     density [kg/m^3]
/// @param e_rate  rate of the internal energy per mass along the motion [W/kg]
/// @param power   stress_power() [W/m^3]
/// @param div_h   divergence of the flow of heat h [W/m^3]
/// @param q       heat from elsewhere, per volume [W/m^3]
/// @return what is left over [W/m^3]
template <class S>
S energy_residual(S rho, S e_rate, S power, S div_h, S q) {
  return rho * e_rate - power + div_h - q;
}

}  // namespace particulate::continuum
