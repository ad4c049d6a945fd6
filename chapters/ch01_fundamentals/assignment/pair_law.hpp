#pragma once

/// @file
/// The header to keep: write these functions in pair_law.cpp, and change nothing here. The law C(d) is that of your
/// variant, which the head of the score table names: run the check once to learn it.

/// Constants of the law between two bodies. Attraction comes first, repulsion second; both strengths are positive.
struct PairLaw {
  double alpha1 = 0.0;  ///< strength of attraction
  double alpha2 = 0.0;  ///< strength of repulsion
  double beta1 = 0.0;   ///< exponent of attraction, positive
  double beta2 = 0.0;   ///< exponent of repulsion, positive
};

/// Strength of the force along the line of centres, attraction positive.
/// @param law  constants
/// @param d    distance, > 0 [m]
/// @return C(d) [N]
double strength(const PairLaw& law, double d);

/// Potential energy, which is zero at a distance of reference and has the slope C(d).
/// @param law    constants, of which any exponent may be 1 or close to it
/// @param d      distance, > 0 [m]
/// @param d_ref  distance at which the energy is zero, > 0 [m]
/// @return V(d) - V(d_ref) [J]
double potential(const PairLaw& law, double d, double d_ref);

/// Distance at which attraction and repulsion balance.
/// @param law  constants with a stable equilibrium
/// @return d_e [m]
double equilibrium_distance(const PairLaw& law);

/// Stiffness at the equilibrium distance.
/// @param law  constants with a stable equilibrium
/// @return V''(d_e) [N/m]
double stiffness(const PairLaw& law);

/// Period of small oscillations of two bodies about their equilibrium distance; both of them move.
/// @param law  constants with a stable equilibrium
/// @param m_i  mass of one body, > 0 [kg]
/// @param m_j  mass of the other, > 0 [kg]
/// @return T [s]
double period(const PairLaw& law, double m_i, double m_j);
