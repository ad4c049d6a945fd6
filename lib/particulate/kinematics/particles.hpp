#pragma once

#include <initializer_list>
#include <limits>
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

  Eigen::VectorXd temperature = {};    ///< theta_i > 0 at the start, N; empty without heat [K]
  Eigen::VectorXd heat_capacity = {};  ///< c_i > 0, N; empty without heat [J/(kg K)]

  /// @return the number of particles N [-]
  Eigen::Index size() const { return mass.size(); }
};

/// Refuses particles that are none, naming the first offender.
///
/// @param particles  a start; no particle at all is allowed
/// @throws std::invalid_argument if lengths differ, a position or velocity is not finite, a mass is not positive and
///         finite, a radius is negative or not finite, or temperatures and heat capacities are not positive and finite
void validate(const Particles& particles);

/// One particle of a list. What it must be given is no number until it is; what is left out of the rest does nothing.
struct Particle {
  /// r_i, must be given [m]
  Eigen::Vector3d position = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();               ///< v_i; left out: at rest [m/s]
  double mass = std::numeric_limits<double>::quiet_NaN();           ///< m_i > 0, must be given [kg]
  double radius = std::numeric_limits<double>::quiet_NaN();         ///< b_i >= 0, must be given; 0: a point [m]
  bool immovable = false;                                           ///< whether no force and no impact moves it
  double temperature = std::numeric_limits<double>::quiet_NaN();    ///< theta_i > 0; left out of all: no heat [K]
  double heat_capacity = std::numeric_limits<double>::quiet_NaN();  ///< c_i > 0, likewise [J/(kg K)]
};

/// Particles from a list, one after the other:
///
///     particles({{.position = {-0.5, 0.0, 0.0}, .mass = 1.0, .radius = 0.1},
///                {.position = {0.5, 0.0, 0.0}, .velocity = {-1.0, 0.0, 0.0}, .mass = 2.0, .radius = 0.1}})
///
/// @param list  each with its position, mass and radius
/// @return the same as arrays
/// @throws std::invalid_argument naming the first particle of which something is not given, and as validate() does
Particles particles(const std::vector<Particle>& list);

/// Some of a set of particles.
///
/// @param particles  a set
/// @param numbers    of those that are wanted, in the order in which they are
/// @return these
/// @throws std::invalid_argument for a particle that is not there
Particles chosen(const Particles& particles, const std::vector<Eigen::Index>& numbers);

/// Refuses arrays that belong to one set of particles and differ in length: read against each other they would give a
/// number all the same.
///
/// @param lengths  entries of each array, one a particle [-]
/// @throws std::invalid_argument naming the lengths
void require_one_length(std::initializer_list<Eigen::Index> lengths);

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
/// @throws std::invalid_argument for a particle that is not there
RelativeMotion relative_motion(const Particles& particles, Eigen::Index i, Eigen::Index j);

}  // namespace particulate::kinematics
