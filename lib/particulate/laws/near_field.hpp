#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <string_view>

#include <particulate/kinematics/central_force.hpp>
#include <particulate/laws/law.hpp>

namespace particulate::laws {

/// What a near field's strengths are counted per.
enum class Scaling {
  mass,  ///< \f$ \alpha_{ij} = \alpha\, m_i m_j \f$: the remark below (2.3)
  area,  ///< \f$ \alpha_{ij} = \alpha\, a_i a_j \f$ with the surface \f$ a_i = 4\pi b_i^2 \f$: its footnote
  pair   ///< \f$ \alpha_{ij} = \alpha \f$: the same for every pair
};

/// The code that adds the forces of all pairs: one source, compiled for different sets of instructions. Each forms its
/// sums in another order; one kernel gives the same bits every time.
enum class Kernel {
  best,      ///< the last of the following that this build has for this processor: best_kernel()
  baseline,  ///< what every processor of the architecture understands
  avx2,      ///< x86-64 with AVX2 and FMA: 4 pairs at once
  avx512     ///< x86-64 with AVX-512 (F, DQ, VL): 8 pairs at once
};

/// The name of a kernel, as a stamp says it.
///
/// @param kernel  a kernel
/// @return its name in the enumeration, "none" for what is no kernel
std::string_view name(Kernel kernel);

/// Whether a kernel can be run here.
///
/// @param kernel  a kernel
/// @return true for best, and for what this build has and this processor understands
bool is_available(Kernel kernel);

/// What Kernel::best stands for here.
///
/// @return avx512, else avx2, else baseline, by what is available
Kernel best_kernel();

/// The monograph's near field: every particle attracts and repels every other along the line of centres.
///
/// \f[ \Psi_i^{nf} = \sum_{j \ne i} \left(\alpha_{1ij}\, d^{-\beta_1} - \alpha_{2ij}\, d^{-\beta_2}\right) n_{ij},
///     \qquad d = \|r_i - r_j\|, \quad n_{ij} = \frac{r_j - r_i}{d} \f]
///
/// @equation{M 2.3} By default strengths are per unit mass squared.
struct NearField {
  double alpha1 = 0.0;              ///< attraction, >= 0 [N m^beta1 / kg^2]
  double alpha2 = 0.0;              ///< repulsion, >= 0 [N m^beta2 / kg^2]
  double beta1 = 1.0;               ///< exponent of attraction, >= -1: below 0 it grows with distance [-]
  double beta2 = 2.0;               ///< exponent of repulsion, >= -1 [-]
  double d_ref = 1.0;               ///< distance at which a pair's potential energy is zero, > 0 [m]
  Scaling scaling = Scaling::mass;  ///< what the strengths are counted per; units of the strengths follow it
  Kernel kernel = Kernel::best;     ///< what adds the forces in Space
  /// d_c, at which the force ends; infinite: nowhere. With both attraction and repulsion d_c - w must lie beyond their
  /// equilibrium. Beyond the inflection, d_c > d*, the pair law is no longer convex, which every fluid needs [m]
  double cutoff = std::numeric_limits<double>::infinity();
  double taper = 0.0;  ///< w, over which it ends, up to d_c; 0: at once [m]
  int threads = 1;     ///< that share all pairs in Space, 1 to 1024; the same bits for any number [-]
};

/// How much is left of the force of a near field that is cut off.
///
/// \f[ C \to S(d)\, C, \qquad S = 1 - u^2 (3 - 2u), \quad u = \frac{d - (d_c - w)}{w} \f]
///
/// @equation{R 7.3} S is 1 up to \f$ d_c - w \f$ and 0 from \f$ d_c \f$ on; its slope is zero at both.
/// @param law  the near field
/// @param d    distance of a pair [m]
/// @return S [-]
inline double tapering(const NearField& law, double d) {
  if (d >= law.cutoff) return 0.0;
  const double into = d - (law.cutoff - law.taper), u = into > 0.0 ? into / law.taper : 0.0;
  return 1.0 - u * u * (3.0 - 2.0 * u);
}

/// How far a near field reaches: from there on it is exactly zero.
///
/// @param law  the near field
/// @return d_c; infinite where it is not cut off [m]
inline double reach(const NearField& law) { return law.cutoff; }

/// Refuses constants that are no near field, and a kernel that is not there. Called once, where a law enters a scene.
///
/// @param law  the constants
/// @throws std::invalid_argument naming the constant, what must hold and what was given
void validate(const NearField& law);

/// Refuses a near field that reaches farther than half the shortest period of space. Called once, where both enter a
/// scene.
///
/// @param law     constants that validate() accepts
/// @param domain  space
/// @throws std::invalid_argument saying what must hold, what was given and what to do
void validate(const NearField& law, const kinematics::Space& domain);

/// The force law between two particles, with their masses or areas in its strengths.
///
/// @equation{M 2.3}
/// @param law       the near field
/// @param factor_i  what scales particle i: m_i [kg], 4 pi b_i^2 [m^2] or 1, as law.scaling says
/// @param factor_j  the same of particle j
/// @return constants of the pair
kinematics::CentralForce pair_law(const NearField& law, double factor_i, double factor_j);

/// Potential energy of a pair: of the tapered force, so that V' = S C.
///
/// \f[ V(d) = -\int_d^{d_c} S(x)\, C(x)\, dx \f]
///
/// @equation{D 7.3} Zero from d_c on; without a cut-off zero at d_ref. Over the taper by quadrature, to some 1e-13.
/// @param law   the near field
/// @param pair  pair_law()
/// @param d     distance, > 0 [m]
/// @return V [J]
double potential(const NearField& law, const kinematics::CentralForce& pair, double d);

/// What scales each particle's near field.
///
/// @param law  the near field
/// @param at   the particles
/// @return m_i, 4 pi b_i^2 or 1, N entries
Eigen::VectorXd scaling_factors(const NearField& law, const At<>& at);

/// Whether a squared distance is held to full precision: not below the smallest normal number, and not infinite.
///
/// @param square  squared distance [m^2]
/// @return true for distances from 1.5e-154 to 1.3e154 m
inline bool is_full(double square) {
  return square >= std::numeric_limits<double>::min() && square <= std::numeric_limits<double>::max();
}

/// Whether two particles feel anything of each other: the pair has a strength, and one of them can move.
///
/// @param law     the near field
/// @param at      the particles
/// @param factor  scaling_factors()
/// @param i       one particle
/// @param j       the other
/// @return false: it does not matter where they are
inline bool feels(const NearField& law, const At<>& at, const Eigen::VectorXd& factor, Eigen::Index i, Eigen::Index j) {
  const kinematics::CentralForce pair = pair_law(law, factor[i], factor[j]);
  return (pair.alpha1 > 0.0 || pair.alpha2 > 0.0) && (at.inverse_mass[i] > 0.0 || at.inverse_mass[j] > 0.0);
}

/// Pairs of which some are within reach: in a domain of one's own, and without a cut-off, all.
///
/// @param at  the particles
/// @return candidates
template <kinematics::Domain D>
Candidates candidates(const NearField&, const D&, const At<>& at) {
  return {at.mass.size(), nullptr, nullptr};
}

/// The same in space: those that the scene's neighbour search finds, where the near field is cut off.
///
/// @param law     constants that validate() accepts
/// @param domain  forms the separations
/// @param at      the particles; their scratch remembers neighbours
/// @return candidates, until neighbours are asked again
Candidates candidates(const NearField& law, const kinematics::Space& domain, const At<>& at);

/// Adds the near-field forces over all pairs in space, whose walls the near field does not feel.
///
/// @equation{M 2.3} One pass over the pairs j > i with both forces from one evaluation, so that the total force
/// vanishes to rounding. Cost N (N - 1)/2 pairs. The law's kernel takes 2, 4 or 8 of them at once in vector registers;
/// up to ten particles are taken pair by pair, with the same bits whatever the kernel. Exponents (1, 2) and (2, 3) have
/// code of their own, other whole numbers up to 64 are formed by multiplication, any others by one logarithm of the
/// squared distance and two exponentials of its multiples: std::pow, entry by entry, takes up to ten particles alone. A
/// pair errs by less than 1e-14 of the sum of its attraction and repulsion for exponents up to 13. The inverse distance
/// of whole exponents is a rounded square root and a rounded division; avx512 refines the processor's estimate instead,
/// and errs less. Distances with powers beyond some 1e+-240 are taken pair by pair. More than ten particles are copied
/// into padded columns of the scene's scratch, 80 bytes a particle.
///
/// More than 512 particles are taken in blocks of so many against so many, in rounds in which every block meets one
/// other: threads share a round, if the library was built with OpenMP, and the sums do not depend on how many there
/// are.
///
/// Where the near field is cut off the neighbours of each particle are searched, and only pairs within reach are
/// evaluated, by one thread, at a cost that grows with N. Sums are formed over those pairs alone, by ascending numbers.
/// @param law    constants that validate() accepts
/// @param at     the particles
/// @param force  receives the forces, added to what it holds [N]
/// @return false where two particles that feel each other coincide, their squared distance is none (is_full()) or a
///         force is too large for a double; the forces are then meaningless
/// @throws std::invalid_argument if the law's kernel is not available
bool add_force(const NearField& law, const kinematics::Space&, const At<>& at, Forces force);

/// Chooses the pairs whose forces change much over a step, for schemes that take these in steps of their own.
///
/// \f[ \Delta t^2\, (w_i + w_j) \sum_k (1 + \beta_k)\, \alpha_{k,ij}\, d^{-\beta_k - 1} > \kappa
///     \qquad\text{or}\qquad d < \zeta\, \tfrac12 \Delta t\, \|v_i - v_j\| \f]
///
/// @equation{D 3.4} d is the smallest distance on straight paths over the step, w an inverse mass. The first holds
/// where the force is stiff, the second where partners pass each other so near that the polynomial of a step, whose
/// radius of convergence is \f$ d/\|v_i - v_j\| \f$, would not resolve it. \f$ \kappa = 0.07,\ \zeta = 3 \f$.
/// @param law     constants that validate() accepts
/// @param domain  space
/// @param at      the particles, with velocities; their scratch receives the pairs
/// @param dt      the step, > 0 [s]
/// @return false where the particles have no finite places and velocities
bool choose_close(const NearField& law, const kinematics::Space& domain, const At<Velocity>& at, double dt);

/// Adds the forces of those pairs alone, as add_force() forms them.
///
/// @param law     constants that validate() accepts
/// @param domain  space
/// @param at      the particles, whose scratch holds the pairs
/// @param force   receives the forces, added to what it holds [N]
/// @return as add_force()
/// @throws std::invalid_argument if the law's kernel is not available
bool add_close_force(const NearField& law, const kinematics::Space& domain, const At<>& at, Forces force);

/// Adds the near-field forces between two particles.
///
/// @equation{M 2.3}
/// @param law     constants that validate() accepts
/// @param domain  forms the separation
/// @param at      the particles
/// @param factor  scaling_factors()
/// @param i       one particle
/// @param j       the other
/// @param force   receives the forces, added to what it holds [N]
/// @return false where they feel each other and their squared distance is none: is_full()
template <kinematics::Domain D>
bool add_pair(const NearField& law, const D& domain, const At<>& at, const Eigen::VectorXd& factor, Eigen::Index i,
              Eigen::Index j, Forces force) {
  const Eigen::Vector3d towards = separation(domain, at.position.row(i), at.position.row(j));
  const double square = towards.squaredNorm();
  if (square >= law.cutoff * law.cutoff && std::isfinite(law.cutoff)) return true;
  if (!is_full(square)) return !feels(law, at, factor, i, j);
  const double d = std::sqrt(square);
  // The unit vector first: over the distance a force may be too small or too large for a double.
  const Eigen::Vector3d pull = tapering(law, d) * strength(pair_law(law, factor[i], factor[j]), d) * (towards / d);
  force.row(i) += pull;
  force.row(j) -= pull;
  return true;
}

/// Adds the near-field forces over all pairs in a domain of one's own, pair by pair.
///
/// @equation{M 2.3}
/// @param law     constants that validate() accepts
/// @param domain  forms the separations
/// @param at      the particles
/// @param force   receives the forces, added to what it holds [N]
/// @return false where two particles that feel each other coincide, their squared distance is none (is_full()) or a
///         force is too large for a double; the forces are then meaningless
template <kinematics::Domain D>
bool add_force(const NearField& law, const D& domain, const At<>& at, Forces force) {
  const Eigen::VectorXd factor = scaling_factors(law, at);
  const Candidates near = candidates(law, domain, at);
  bool all_full = true;
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    near.behind(i, [&](Eigen::Index j) { all_full = add_pair(law, domain, at, factor, i, j, force) && all_full; });
  }
  return all_full && force.allFinite();
}

/// Why two particles have no near field: of pairs that feel each other, the first whose squared distance is none.
///
/// @param law    the near field
/// @param at     the particles
/// @param apart   gives the distance of a pair [m]
/// @return its numbers, its distance and what to do; empty: there is none
std::string why_no_force(const NearField& law, const At<>& at,
                         const std::function<double(Eigen::Index, Eigen::Index)>& apart);

/// @param law     the near field
/// @param domain  forms the separations
/// @param at      the particles
/// @return which two particles have no near field there, and what to do; empty: all have, or a force is too large
template <kinematics::Domain D>
std::string why_no_force(const NearField& law, const D& domain, const At<>& at) {
  return why_no_force(law, at, [&](Eigen::Index i, Eigen::Index j) {
    return kinematics::length(separation(domain, at.position.row(i), at.position.row(j)));
  });
}

/// Potential energy of the near field over all pairs.
///
/// \f[ V = \sum_{i<j} \big(V_{ij}(d) - V_{ij}(d_{ref})\big), \qquad \Psi_i^{nf} = -\nabla_i V \f]
///
/// @equation{D 2.3} With a cut-off over the pairs within reach, each zero at d_c instead of d_ref.
/// @param law     constants that validate() accepts
/// @param domain  forms the separations
/// @param at      the particles
/// @return energy, without that of coincident particles that do not feel each other; infinite or NaN where others
///         coincide [J]
template <kinematics::Domain D>
double potential_energy(const NearField& law, const D& domain, const At<>& at) {
  const Eigen::VectorXd factor = scaling_factors(law, at);
  const Candidates near = candidates(law, domain, at);
  double sum = 0.0;
  for (Eigen::Index i = 0; i < at.mass.size(); ++i) {
    near.behind(i, [&](Eigen::Index j) {
      const double d = kinematics::length(separation(domain, at.position.row(i), at.position.row(j)));
      if (d == 0.0 && !feels(law, at, factor, i, j)) return;
      sum += potential(law, pair_law(law, factor[i], factor[j]), d);
    });
  }
  return sum;
}

/// The same in space, of more than ten particles and without a cut-off by the law's kernel.
///
/// @equation{D 2.3} One logarithm of the squared distance and two exponentials, whatever the exponents; threads share
/// the pairs as add_force() says. The same value as the general one to rounding.
/// @param law     constants that validate() accepts
/// @param domain  space
/// @param at      the particles
/// @return energy, as above [J]
/// @throws std::invalid_argument if the law's kernel is not available
double potential_energy(const NearField& law, const kinematics::Space& domain, const At<>& at);

/// Adds the forces, and their potential energy, of all pairs: what add_force() and potential_energy() do, in space in
/// one pass.
///
/// @equation{D 2.3}
/// @param law     constants that validate() accepts
/// @param domain  forms the separations
/// @param at      the particles
/// @param force   receives the forces, added to what it holds, as add_force() adds them [N]
/// @param energy  receives the energy, added to what it holds [J]
/// @return as add_force(); where false, forces and energy are meaningless
/// @throws std::invalid_argument in space, if the law's kernel is not available
template <kinematics::Domain D>
bool add_force_and_energy(const NearField& law, const D& domain, const At<>& at, Forces force, double& energy) {
  energy += potential_energy(law, domain, at);
  return add_force(law, domain, at, force);
}

/// @copydoc add_force_and_energy
bool add_force_and_energy(const NearField& law, const kinematics::Space& domain, const At<>& at, Forces force,
                          double& energy);

}  // namespace particulate::laws
