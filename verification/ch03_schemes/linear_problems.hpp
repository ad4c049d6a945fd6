#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include <particulate/schemes/problem.hpp>

/// @file
/// Linear problems, and what one step of a one-step scheme makes of them in closed form.

namespace verification {

inline constexpr double eps = std::numeric_limits<double>::epsilon();  ///< spacing of doubles at 1

/// Keeps the larger of two deviations; a NaN, once seen, stays, so that it fails whatever it is compared with.
inline void keep_worst(double& worst, double deviation) {
  if (!std::isnan(worst) && !(deviation <= worst)) worst = deviation;
}

/// Linear drag, \f$ m \dot v = -c v \f$, as a force.
struct Drag {
  double c = 1.0;  ///< [kg/s]
  double m = 1.0;  ///< [kg]

  bool acceleration(double, particulate::schemes::In, particulate::schemes::In v, particulate::schemes::Out a) const {
    a = -(c / m) * v;
    return true;
  }
};

/// The same as a problem of first order for v.
struct DragRate {
  double c = 1.0;  ///< [kg/s]
  double m = 1.0;  ///< [kg]

  bool rate(double, particulate::schemes::In v, particulate::schemes::Out dv) const {
    dv = -(c / m) * v;
    return true;
  }
};

/// Springs that know nothing of each other, \f$ \ddot r_i = -\omega_i^2 r_i \f$.
struct Oscillators {
  Eigen::VectorXd omega;  ///< [1/s]

  bool acceleration(double, particulate::schemes::In r, particulate::schemes::Out a) const {
    a = -omega.array().square() * r.array();
    return true;
  }
};

/// One oscillator.
inline Oscillators oscillator(double omega) { return {.omega = Eigen::VectorXd::Constant(1, omega)}; }

/// Sums of absolute changes of places from iterate to iterate, or of values where there are no places, over no
/// denominator.
inline std::vector<double> changes(const std::vector<particulate::schemes::State>& iterates) {
  const auto unknowns = [](const particulate::schemes::State& at) -> const Eigen::VectorXd& {
    return at.r.size() > 0 ? at.r : at.y;
  };
  std::vector<double> of;
  for (std::size_t k = 1; k < iterates.size(); ++k) {
    of.push_back((unknowns(iterates[k]) - unknowns(iterates[k - 1])).lpNorm<1>());
  }
  return of;
}

/// The start of one oscillator.
inline particulate::schemes::State motion(double r, double v) {
  return {.t = 0.0, .r = Eigen::VectorXd::Constant(1, r), .v = Eigen::VectorXd::Constant(1, v)};
}

/// Energy of one oscillator per unit mass, doubled: \f$ v^2 + \omega^2 r^2 \f$.
inline double energy(double omega, const particulate::schemes::State& at) {
  return at.v[0] * at.v[0] + omega * omega * at.r[0] * at.r[0];
}

/// The phi scheme's step of one oscillator, its two equations solved by Cramer's rule.
///
/// With \f$ r_e = r + (1 - \phi)\Delta t\,v \f$ and \f$ v_e = v - (1 - \phi)\Delta t\,\omega^2 r \f$ it asks for
/// \f$ r' - \phi\Delta t\,v' = r_e,\ \phi\Delta t\,\omega^2 r' + v' = v_e \f$.
inline particulate::schemes::State phi_step(double phi, double omega, double dt,
                                            const particulate::schemes::State& from) {
  const double explicit_share = (1.0 - phi) * dt, implicit_share = phi * dt, stiffness = omega * omega;
  const double r_e = from.r[0] + explicit_share * from.v[0];
  const double v_e = from.v[0] - explicit_share * stiffness * from.r[0];
  const double determinant = 1.0 + implicit_share * implicit_share * stiffness;
  particulate::schemes::State to =
      motion((r_e + implicit_share * v_e) / determinant, (v_e - implicit_share * stiffness * r_e) / determinant);
  to.t = from.t + dt;
  return to;
}

/// How far one oscillator is from another in its phase plane, over the size of the orbit.
inline double apart(double omega, const particulate::schemes::State& one, const particulate::schemes::State& other) {
  const particulate::schemes::State difference{.t = 0.0, .r = one.r - other.r, .v = one.v - other.v};
  return std::sqrt(energy(omega, difference) / energy(omega, other));
}

/// Backward Euler's step of two coupled equations \f$ y' = -A y \f$, by Cramer's rule.
inline Eigen::Vector2d implicit_step(const Eigen::Matrix2d& A, double dt, const Eigen::Vector2d& y) {
  const double m11 = 1.0 + dt * A(0, 0), m12 = dt * A(0, 1), m21 = dt * A(1, 0), m22 = 1.0 + dt * A(1, 1);
  const double determinant = m11 * m22 - m12 * m21;
  return {(m22 * y[0] - m12 * y[1]) / determinant, (m11 * y[1] - m21 * y[0]) / determinant};
}

}  // namespace verification
