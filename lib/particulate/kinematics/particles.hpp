#pragma once

#include <vector>

#include <Eigen/Core>

namespace particulate::kinematics {

/// N vectors, one a row: three contiguous columns, all x, all y, all z.
using Vectors = Eigen::Matrix<double, Eigen::Dynamic, 3>;

using VectorsIn = Eigen::Ref<const Vectors>;          ///< N vectors that are read
using VectorsOut = Eigen::Ref<Vectors>;               ///< N vectors that are written
using ScalarsIn = Eigen::Ref<const Eigen::VectorXd>;  ///< one number a particle, read

/// Where a set of particles starts, and what stays with each of them.
///
/// The monograph idealizes its flows as spheres without spin (chapter 2).
struct Particles {
  Vectors position;        ///< r_i, N x 3 [m]
  Vectors velocity;        ///< v_i, N x 3 [m/s]
  Eigen::VectorXd mass;    ///< m_i > 0, N [kg]
  Eigen::VectorXd radius;  ///< b_i >= 0, N [m]

  /// Particles that no force and no impact moves; empty: every particle moves. Their masses still scale the near field.
  std::vector<bool> immovable = {};

  /// @return the number of particles N [-]
  Eigen::Index size() const { return mass.size(); }
};

/// Refuses particles that are none, naming the first offender.
///
/// @param particles  a start; no particle at all is allowed
/// @throws std::invalid_argument if lengths differ, a position or velocity is not finite, a mass is not positive and
///         finite, or a radius is negative or not finite
void validate(const Particles& particles);

/// Inverse masses, zero for particles that are immovable.
///
/// @param particles  the set
/// @return 1/m_i or 0, N entries [1/kg]
Eigen::VectorXd inverse_masses(const Particles& particles);

/// Reads the vector of one particle.
///
/// @param of  N vectors
/// @param i   particle, 0 <= i < N
/// @return its vector
inline Eigen::Vector3d vector(const VectorsIn& of, Eigen::Index i) { return of.row(i).transpose(); }

/// Writes the vector of one particle.
///
/// @param of     N vectors
/// @param i      particle, 0 <= i < N
/// @param value  its new vector
inline void set_vector(VectorsOut of, Eigen::Index i, const Eigen::Vector3d& value) { of.row(i) = value.transpose(); }

/// Motion of one particle as seen from another, \f$ r_{i-j} = r_i - r_j \f$, \f$ v_{i-j} = v_i - v_j \f$.
///
/// @equation{M 1.12}
struct RelativeMotion {
  Eigen::Vector3d position;  ///< r_i - r_j [m]
  Eigen::Vector3d velocity;  ///< v_i - v_j [m/s]
};

/// Motion of particle i as seen from particle j in unbounded space.
///
/// @equation{M 1.12}
/// @param particles  the set
/// @param i          the particle that is seen, 0 <= i < N
/// @param j          the particle that sees it, 0 <= j < N
/// @return relative position and velocity
RelativeMotion relative_motion(const Particles& particles, Eigen::Index i, Eigen::Index j);

}  // namespace particulate::kinematics
