#pragma once

#include <particulate/kinematics/particles.hpp>

/// @file
/// Sums over all particles. Arrays of different lengths are refused with std::invalid_argument.

namespace particulate::kinematics {

/// Linear momentum of a set of particles.
///
/// \f[ G = \sum_i m_i v_i = M v_{cm} \f]
///
/// @equation{M 1.39}
/// @param mass      m_i, N [kg]
/// @param velocity  v_i, N x 3 [m/s]
/// @return G [kg m/s]
Eigen::Vector3d linear_momentum(const ScalarsIn& mass, const VectorsIn& velocity);

/// Angular momentum of a set of particles about the origin.
///
/// \f[ H_o = \sum_i r_i \times m_i v_i \f]
///
/// @equation{M 1.42}
/// @param mass      m_i, N [kg]
/// @param position  r_i, N x 3 [m]
/// @param velocity  v_i, N x 3 [m/s]
/// @return H_o [kg m^2/s]
Eigen::Vector3d angular_momentum(const ScalarsIn& mass, const VectorsIn& position, const VectorsIn& velocity);

/// Moment of the forces on a set of particles about the origin, which is the rate of its angular momentum.
///
/// \f[ M_o = \sum_i r_i \times \Psi_i = \frac{dH_o}{dt} \f]
///
/// @equation{M 1.43}
/// @param position  r_i, N x 3 [m]
/// @param force     Psi_i, N x 3 [N]
/// @return M_o [N m]
Eigen::Vector3d moment(const VectorsIn& position, const VectorsIn& force);

/// Mean of a vector over the mass: the centre of mass of positions, its velocity of velocities.
///
/// \f[ r_{cm} = \frac1M \sum_i m_i r_i, \qquad M = \sum_i m_i \f]
///
/// @equation{M 1.47}
/// @param mass  m_i > 0, N >= 1 [kg]
/// @param of    one vector a particle, N x 3
/// @return the mean, in the unit of the vectors
/// @throws std::invalid_argument if there is no particle
Eigen::Vector3d centre_of_mass(const ScalarsIn& mass, const VectorsIn& of);

/// Radius of gyration of bodies that count alike,
///
/// \f[ R_g^2 = \frac1n \sum_i \|r_i - \bar r\|^2 . \f]
///
/// @equation{R 6.3}
/// @param position  r_i, in unbounded space, N x 3 [m]
/// @return R_g [m]
double radius_of_gyration(const VectorsIn& position);

/// Impulse of the forces on a set of particles over a short time, by the trapezoidal rule.
///
/// \f[ \sum_i \int_{t_1}^{t_2} \Psi_i\, dt \approx \sum_i \tfrac12 (\Psi_i^1 + \Psi_i^2)(t_2 - t_1), \qquad
///     G(t_2) = G(t_1) + \text{impulse} \f]
///
/// @equation{M 1.38} Summed over short pieces of time it converges to the integral with order 2.
/// @param force_1  forces at the first moment, N x 3 [N]
/// @param force_2  forces at the second moment, N x 3 [N]
/// @param dt       time between them, t_2 - t_1 [s]
/// @return impulse on each particle, N x 3 [N s]
Vectors impulse_between(const VectorsIn& force_1, const VectorsIn& force_2, double dt);

}  // namespace particulate::kinematics
