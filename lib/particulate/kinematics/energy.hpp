#pragma once

#include <particulate/kinematics/particles.hpp>

/// @file
/// Sums over all particles. Arrays of different lengths are refused with std::invalid_argument.

namespace particulate::kinematics {

/// Kinetic energy of a set of particles.
///
/// \f[ T = \tfrac12 \sum_i m_i\, v_i \cdot v_i \f]
///
/// @equation{M 1.17}
/// @param mass      m_i, N [kg]
/// @param velocity  v_i, N x 3 [m/s]
/// @return T, >= 0 [J]
double kinetic_energy(const ScalarsIn& mass, const VectorsIn& velocity);

/// Kinetic energy per unit mass, split into the motion of the whole and the motion about it.
struct KineticEnergy {
  double bulk = 0.0;      ///< of the centre of mass, >= 0 [J/kg]
  double relative = 0.0;  ///< about the centre of mass, >= 0 [J/kg]
};

/// Splits the kinetic energy per unit mass into bulk and relative motion.
///
/// \f[ \frac{T}{M} = \tfrac12\, v_{cm} \cdot v_{cm} + \frac{1}{2M}\sum_i m_i\, \delta v_i \cdot \delta v_i,
///     \qquad \delta v_i = v_i - v_{cm} \f]
///
/// @equation{M 2.28}
/// @param mass      m_i > 0, N >= 1 [kg]
/// @param velocity  v_i, N x 3 [m/s]
/// @return both parts
/// @throws std::invalid_argument if there is no particle
KineticEnergy split_kinetic_energy(const ScalarsIn& mass, const VectorsIn& velocity);

/// Power of the forces on a set of particles, which is the rate of its kinetic energy.
///
/// \f[ \frac{dT}{dt} = \sum_i \Psi_i \cdot v_i \f]
///
/// @equation{M 1.16}
/// @param force     Psi_i, N x 3 [N]
/// @param velocity  v_i, N x 3 [m/s]
/// @return power [W]
double power_of(const VectorsIn& force, const VectorsIn& velocity);

/// Work done on a set of particles between two moments, by the trapezoidal rule along the path.
///
/// \f[ W_{1 \to 2} = \sum_i \int \Psi_i \cdot dr_i \approx \sum_i \tfrac12 (\Psi_i^1 + \Psi_i^2) \cdot (r_i^2 - r_i^1),
///     \qquad T_2 = T_1 + W_{1 \to 2} \f]
///
/// @equation{M 1.15} Summed over short pieces of a path it converges to the integral with order 2.
/// @param force_1     forces at the first moment, N x 3 [N]
/// @param position_1  positions at the first moment, N x 3 [m]
/// @param force_2     forces at the second moment, N x 3 [N]
/// @param position_2  positions at the second moment, N x 3 [m]
/// @return work [J]
double work_between(const VectorsIn& force_1, const VectorsIn& position_1, const VectorsIn& force_2,
                    const VectorsIn& position_2);

}  // namespace particulate::kinematics
