#pragma once

#include <complex>

#include <Eigen/Core>

/// @file
/// How matter deforms that fills space: lines, areas and volumes, strain, and the rates of all of them.
///
/// A motion takes the place X, where a point of the matter was at the start, to the place x where it is now. Functions
/// take S = double or std::complex<double>. No product conjugates, so that whatever is made of them can be
/// differentiated to rounding by a complex step, \f$ f'(s) = \operatorname{Im} f(s + i h)/h \f$.

namespace particulate::continuum {

template <class S>
using Vector = Eigen::Matrix<S, 3, 1>;  ///< three components
template <class S>
using Tensor = Eigen::Matrix<S, 3, 3>;  ///< of second order: derivatives of a component stand in its row

/// Gradient of a vector field: of a motion the deformation gradient F, of a velocity its gradient L.
///
/// \f[ F_{ij} = \frac{\partial x_i}{\partial X_j}, \qquad L_{ij} = \frac{\partial v_i}{\partial x_j} \f]
///
/// @equation{D A.1} By a complex step of 1e-50, to the rounding of the field itself.
/// @param field  callable, analytic: takes a Vector<std::complex<double>> and returns one
/// @param at     where [m]
/// @return derivatives, component by row
template <class Field>
Tensor<double> gradient(const Field& field, const Vector<double>& at) {
  constexpr double h = 1e-50;
  Tensor<double> result;
  for (int j = 0; j < 3; ++j) {
    Vector<std::complex<double>> beside = at.cast<std::complex<double>>();
    beside[j] += std::complex<double>(0.0, h);
    const Vector<std::complex<double>> value = field(beside);
    result.col(j) = value.imag() / h;
  }
  return result;
}

/// What F does to areas, \f$ \operatorname{cof} F = J F^{-T} \f$, without dividing by J.
///
/// @equation{D A.1}
/// @param F  deformation gradient [-]
/// @return the cofactors; of any F, with an inverse or without
template <class S>
Tensor<S> cofactor(const Tensor<S>& F) {
  Tensor<S> result;
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      result(i, j) = F(i1, j1) * F(i2, j2) - F(i1, j2) * F(i2, j1);
    }
  }
  return result;
}

/// The Jacobian of the deformation gradient: a volume over what it was.
///
/// \f[ J = \det F \f]
///
/// @equation{D A.2}
/// @param F  deformation gradient [-]
/// @return J, positive in every motion of matter [-]
template <class S>
S jacobian(const Tensor<S>& F) {
  return F.row(0).cwiseProduct(cofactor(F).row(0)).sum();
}

/// Refuses what no motion does: to leave no volume, or a mirror image.
///
/// @param F  deformation gradient
/// @throws std::invalid_argument unless every entry is finite and J is above the rounding of its own terms
void validate_deformation(const Tensor<double>& F);

/// A line element, \f$ dx = F\, dX \f$.
///
/// @equation{D A.1}
/// @param F   deformation gradient [-]
/// @param dX  at the start, short [m]
/// @return dx [m]
template <class S>
Vector<S> deformed_line(const Tensor<S>& F, const Vector<S>& dX) {
  return F * dX;
}

/// An area element, Nanson's formula.
///
/// \f[ n\, da = J F^{-T} N\, dA \f]
///
/// @equation{D A.1}
/// @param F     deformation gradient [-]
/// @param N_dA  unit normal times area, at the start [m^2]
/// @return unit normal times area, now [m^2]
template <class S>
Vector<S> deformed_area(const Tensor<S>& F, const Vector<S>& N_dA) {
  return cofactor(F) * N_dA;
}

/// A volume element, \f$ dv = J\, dV \f$.
///
/// @equation{D A.2}
/// @param F   deformation gradient [-]
/// @param dV  at the start [m^3]
/// @return dv [m^3]
template <class S>
S deformed_volume(const Tensor<S>& F, S dV) {
  return jacobian(F) * dV;
}

/// The strain after Green and Lagrange: how the squares of lengths change, \f$ |dx|^2 - |dX|^2 = 2\, dX \cdot E\, dX
/// \f$.
///
/// \f[ E = \tfrac12 (F^T F - I) \f]
///
/// @equation{D A.1} A rotation makes none.
/// @param F  deformation gradient [-]
/// @return E, symmetric [-]
template <class S>
Tensor<S> green_lagrange(const Tensor<S>& F) {
  return 0.5 * (F.transpose() * F - Tensor<S>::Identity());
}

/// The gradient of velocity in the places of now, from the rate of F at one point of the matter.
///
/// \f[ L = \nabla v = \dot F F^{-1} \f]
///
/// @equation{D A.2}
/// @param F       deformation gradient [-]
/// @param F_rate  its rate there [1/s]
/// @return L [1/s]
/// @throws std::invalid_argument as validate_deformation() does
template <class S>
Tensor<S> velocity_gradient(const Tensor<S>& F, const Tensor<S>& F_rate) {
  validate_deformation(F.real());
  return F_rate * cofactor(F).transpose() / jacobian(F);
}

/// The part of a velocity's gradient that changes lengths and angles.
///
/// \f[ D = \tfrac12 (L + L^T) \f]
///
/// @equation{D A.2}
/// @param L  gradient of velocity [1/s]
/// @return D, symmetric [1/s]
template <class S>
Tensor<S> rate_of_deformation(const Tensor<S>& L) {
  return 0.5 * (L + L.transpose());
}

/// The part of a velocity's gradient that only turns.
///
/// \f[ W = \tfrac12 (L - L^T) \f]
///
/// @equation{D A.2}
/// @param L  gradient of velocity [1/s]
/// @return W, antisymmetric: W a is half the curl of the velocity, times a as a cross product [1/s]
template <class S>
Tensor<S> spin(const Tensor<S>& L) {
  return 0.5 * (L - L.transpose());
}

/// How fast a volume grows.
///
/// \f[ \dot J = J \operatorname{tr} D = J\, \nabla \cdot v \f]
///
/// @equation{D A.2}
/// @param F  deformation gradient [-]
/// @param L  gradient of velocity, of which only the diagonal counts [1/s]
/// @return rate of J at one point of the matter [1/s]
template <class S>
S jacobian_rate(const Tensor<S>& F, const Tensor<S>& L) {
  return jacobian(F) * L.trace();
}

}  // namespace particulate::continuum
