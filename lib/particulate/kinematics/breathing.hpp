#pragma once

#include <particulate/kinematics/particles.hpp>

namespace particulate::kinematics {

/// Constants of the radial equation that every breathing motion here obeys.
///
/// \f[ \ddot r = -\frac{A}{r^2} + \frac{B}{r^3} \f]
///
/// @equation{D 1.4.1} From the near field with (beta1, beta2) = (2, 3).
struct RadialForce {
  double A = 0.0;  ///< attraction, > 0 [m^3/s^2]
  double B = 0.0;  ///< repulsion, > 0 [m^4/s^2]
};

/// Radial constants of a pair's separation.
///
/// \f[ A = \alpha_1 (m_i + m_j), \qquad B = \alpha_2 (m_i + m_j) + \ell_z^2, \qquad \ell_z = r^2 \dot\varphi \f]
///
/// @equation{D 1.4.1} Rotation adds the centrifugal term, so that the period becomes the radial one.
/// @param alpha1  attraction per unit mass squared [N m^2/kg^2]
/// @param alpha2  repulsion per unit mass squared [N m^3/kg^2]
/// @param m_i     mass of one body, > 0 [kg]
/// @param m_j     mass of the other, > 0 [kg]
/// @param l_z     specific angular momentum of the relative motion r^2 dphi/dt [m^2/s]
/// @return A and B for the separation
RadialForce breathing_pair(double alpha1, double alpha2, double m_i, double m_j, double l_z = 0.0);

/// Radial constants of equal bodies at the corners of a body that looks the same from every corner.
///
/// \f[ A = \frac{\alpha_1 m}{2}\sum_{k \ne i}\frac{1}{s_{ik}}, \qquad
///     B = \frac{\alpha_2 m}{2}\sum_{k \ne i}\frac{1}{s_{ik}^2}, \qquad s_{ik} = \|x_i - x_k\| \f]
///
/// @equation{D 1.4.1} The pull of corner k on corner i along the radius is \f$ C(d_{ik})\, d_{ik}/(2R) \f$ with
/// \f$ d_{ik} = R\, s_{ik} \f$. For a regular N-gon this is \f$ A = (\alpha_1 m/4)\sum \csc(\pi k/N) \f$ and
/// \f$ B = (\alpha_2 m/8)(N^2-1)/3 \f$.
/// @param alpha1   attraction per unit mass squared [N m^2/kg^2]
/// @param alpha2   repulsion per unit mass squared [N m^3/kg^2]
/// @param m        mass of each body, > 0 [kg]
/// @param corners  unit vectors from the centre to the corners, N x 3, N >= 2 [-]
/// @return A and B for the circumradius R
/// @throws std::invalid_argument if there are fewer than two corners, one is not a unit vector, or the corners do not
/// all see the same sums to
///         1e-12 relative or feel a force across their radius
RadialForce breathing_body(double alpha1, double alpha2, double m, const Vectors& corners);

/// Corners of a regular N-gon in the plane z = 0, on the unit circle.
///
/// @param N  number of corners, >= 2
/// @return unit vectors, N x 3 [-]
/// @throws std::invalid_argument if N < 2
Vectors regular_polygon(int N);

/// Corners of a regular solid about the origin, on the unit sphere.
///
/// @param faces  4, 6, 8, 12 or 20
/// @return unit vectors: 4, 8, 6, 20 or 12 of them [-]
/// @throws std::invalid_argument for any other number
Vectors regular_solid(int faces);

/// Radius and its rate at one moment.
struct Radial {
  double r = 0.0;  ///< [m]
  double v = 0.0;  ///< dr/dt [m/s]
};

/// The exact radial motion that starts at rest, a Kepler orbit in disguise.
///
/// \f[ r = a (1 - \varepsilon \cos\xi), \qquad \sqrt{\frac{a^3}{A}}\,(\xi - \varepsilon\sin\xi) = t + \text{const},
///     \qquad a = \frac{A}{2|E|}, \quad E = -\frac{A}{r_0} + \frac{B}{2 r_0^2}, \quad
///     \varepsilon = \left|\frac{r_0}{a} - 1\right| \f]
///
/// @equation{D 1.4.1} The product of the turning points is B/(2|E|), which gives the inner one without cancellation.
/// Kepler's equation is solved in extended precision: r and v are good to a few units in the last place of their
/// largest values.
class Breathing {
 public:
  /// A motion that starts at rest.
  ///
  /// @param force  A > 0 and B > 0, finite
  /// @param r_0    start, > B/(2A): nearer than that the body flies apart [m]
  /// @throws std::invalid_argument if the motion is not bounded, saying where the limit lies
  Breathing(const RadialForce& force, double r_0);

  /// @return time from one start at rest to the next, \f$ 2\pi\sqrt{a^3/A} \f$ [s]
  double period() const { return static_cast<double>(period_); }
  /// @return the inner turning point [m]
  double nearest() const { return static_cast<double>(near_); }
  /// @return the outer turning point [m]
  double farthest() const { return static_cast<double>(far_); }
  /// State at a time after the start.
  ///
  /// @param t  time since the start at rest, finite [s]
  /// @return radius and its rate
  /// @throws std::invalid_argument for a time that is not finite
  Radial at(double t) const;

 private:
  long double near_, far_, period_;
  bool starts_near_;
};

}  // namespace particulate::kinematics
