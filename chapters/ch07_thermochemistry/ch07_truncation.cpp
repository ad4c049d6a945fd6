//! @page ch07_truncation Chapter 7: Where a near field may end
//! @brief Why a near field is cut off, between which two distances, and what a chain of particles gains by it.
//! @tableofcontents
//!
//! @section ch07_truncation_question Long-range instability
//!
//! A near field \f$ C(d) = \alpha_1 d^{-\beta_1} - \alpha_2 d^{-\beta_2} \f$ balances at \f$ d_e \f$, and its potential
//! is convex about that. It is not everywhere. From where the attraction falls faster than the repulsion, the
//! inflection (particulate::kinematics::inflection_distance)
//!
//! \f[ d^* = \left(\frac{\beta_2 \alpha_2}{\beta_1 \alpha_1}\right)^{1/(\beta_2-\beta_1)}
//!         = \left(\frac{\beta_2}{\beta_1}\right)^{1/(\beta_2-\beta_1)} d_e, \f]
//!
//! on, two particles that come nearer to one another attract each other more: along their line of centres the pair is
//! unstable. The monograph's advice is to cut the force off at a distance \f$ d_c \f$ with
//!
//! \f[ d_e < d_c \le d^* : \f]
//!
//! below \f$ d_e \f$ nothing would attract any more, and beyond \f$ d^* \f$ pairs are not convex.
//!
//! @figure{ch07_inflection, Force of a pair\, its equilibrium and its inflection: Figure 7.2.}
//!
//! @figure{ch07_cutoff, The same force cut off at once\, and tapered before that: Figure 7.3.}
//!
//! The library tapers (particulate::laws::tapering): over \f$ [d_c - w, d_c] \f$ the force is multiplied by
//! \f$ S = 1 - u^2(3 - 2u) \f$, \f$ u = (d - d_c + w)/w \f$, and the potential is the integral of what is left, not
//! \f$ S V \f$, so that \f$ V' = S C \f$ and energy is kept. A near field that attracts and repels must attract
//! somewhere, \f$ d_e < d_c - w \f$, else it is refused. That \f$ d_c \f$ lies below \f$ d^* \f$ is advice; a fluid
//! cannot follow it. And the taper is concave itself: cutting off does not make the law convex, it keeps the pairs of a
//! lattice off the part that is not.
//!
//! @section ch07_truncation_program The program

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <particulate/kinematics/central_force.hpp>
#include <particulate/laws/near_field.hpp>

#include "ch07_thermochemistry.hpp"

namespace ch07 {
namespace {

//! Of a pair of unit masses everything is drawn from the library's own functions:

void write_pair(const report::Output& output, report::Checks& checks) {
  const kinematics::CentralForce pair = laws::pair_law(near_field, 1.0, 1.0);
  laws::NearField cut = near_field;
  cut.cutoff = kinematics::inflection_distance(pair);
  cut.taper = 0.4 * cut.cutoff;
  report::Table forces({"distance [m]", "force [N]", "tapered [N]", "potential of that [J]"});
  report::Table stiffness(
      {"distance [m]", "along the line of centres [N/m]", "across it [N/m]", "sum of all three [N/m]"});
  double off = 0.0;
  for (const double d : evenly(300, 1.5)) {
    if (d < 0.3) continue;
    const double tapered = laws::tapering(cut, d) * kinematics::strength(pair, d);
    forces.add({d, kinematics::strength(pair, d), tapered, laws::potential(cut, pair, d)});
    const double h = 1e-4, slope = (laws::potential(cut, pair, d + h) - laws::potential(cut, pair, d - h)) / (2.0 * h);
    off = worse_of(off, std::abs(slope - tapered));
  }
  const double d_e = kinematics::equilibrium_distance(pair);
  for (const double of : {0.5, 1.0, 1.5, 2.0, 3.0, 4.0}) {
    const double along = kinematics::normal_stiffness(pair, of * d_e),
                 across = kinematics::transverse_stiffness(pair, of * d_e);
    stiffness.add({of * d_e, along, across, along + 2.0 * across});
  }
  output.write("pair", forces);
  output.write("stiffness", stiffness);
  report::Table distances({"distance", "value [m]"});
  distances.add({"equilibrium d_e", d_e});
  distances.add({"inflection d*", cut.cutoff});
  distances.add({"cut-off d_c", cut.cutoff});
  distances.add({"taper begins d_c - w", cut.cutoff - cut.taper});
  output.write("distances", distances);
  checks.add("slope of the tapered potential off the tapered force [N]", off, 1e-6);
}

//! @section ch07_chain A chain
//!
//! The simplest lattice is a ring of N particles, each at the distance \f$ a = d_e \f$ from the next, which move along
//! it. Its stiffness matrix is circulant, so that its eigenvalues are known,
//!
//! \f[ \lambda_m = \sum_{k \ge 1} 2\, V''(k a) \left(1 - \cos\frac{2\pi m k}{N}\right), \f]
//!
//! over all neighbours to half of the ring, whose last one is there once, or over the next two alone. One of them is
//! zero: all move together. If another is negative, the chain gives way.

double eigenvalue(int N, int neighbours, int m) {
  const kinematics::CentralForce pair = laws::pair_law(near_field, 1.0, 1.0);
  const double a = kinematics::equilibrium_distance(pair);
  double sum = 0.0;
  for (int k = 1; k <= neighbours; ++k) {
    const double twice = 2 * k == N ? 1.0 : 2.0;
    sum += twice * kinematics::normal_stiffness(pair, k * a) * (1.0 - std::cos(2.0 * std::numbers::pi * m * k / N));
  }
  return sum;
}

double least_eigenvalue(int N, int neighbours) {
  double least = std::numeric_limits<double>::infinity();
  for (int m = 1; m < N; ++m) least = std::min(least, eigenvalue(N, neighbours, m));
  return least;
}

void write_chain(const report::Output& output, report::Checks& checks) {
  report::Table chain({"particles", "least eigenvalue but the zero, all pairs [N/m]", "cut off at d* [N/m]"});
  double stable = 0.0, unstable = 0.0;
  for (const int N : {16, 32, 64}) {
    const double all = least_eigenvalue(N, N / 2), cut = least_eigenvalue(N, 2);
    chain.add({N, all, cut});
    stable += all < 0.0 ? 0.0 : 1.0;
    unstable += cut > 0.0 ? 0.0 : 1.0;
  }
  output.write("chain", chain);
  constexpr int longest = 64;
  report::Table waves({"wave length / spacing [-]", "all pairs [N/m]", "cut off at d* [N/m]"});
  for (int m = 1; m <= longest / 2; ++m) {
    waves.add({static_cast<double>(longest) / m, eigenvalue(longest, longest / 2, m), eigenvalue(longest, 2, m)});
  }
  output.write("waves", waves);
  checks.add("chains that are stable with all pairs", stable, 0.0);
  checks.add("chains that are unstable though cut off at d*", unstable, 0.0);
}

}  // namespace

void truncation(const report::Output& output, report::Checks& checks) {
  write_pair(output, checks);
  write_chain(output, checks);
}

}  // namespace ch07

//! @section ch07_truncation_results What comes of it
//!
//! @table{ch07_distances}
//!
//! @table{ch07_chain}
//!
//! @figure{ch07_waves, Eigenvalues of the longest chain by the length of their wave: below zero it gives way.}
//!
//! With all pairs the chain is unstable, the more so the longer it is; cut off at the inflection it is stable. Its
//! least stiffness then belongs to the longest wave, and falls with \f$ N^{-2} \f$ as that of any chain of springs
//! does.
//!
//! @subsection ch07_three_dimensions In three dimensions
//!
//! This is a matter of one dimension. In three, a pair also resists, or helps, motion across its line of centres:
//!
//! @table{ch07_stiffness}
//!
//! A pair that attracts, beyond \f$ d_e \f$, is stiff across its line of centres, twice, and with \f$ \beta_1 < 2 \f$
//! that outweighs what is lost along it: the sum of all three stiffnesses,
//! \f$ \alpha_1 (2 - \beta_1)\, d^{-\beta_1-1} - \alpha_2 (2 - \beta_2)\, d^{-\beta_2-1} \f$, has a positive part of
//! the attraction. So for the exponents used here we claim no instability of a lattice in space, and what a cut-off is
//! worth there is something else: pairs beyond it need no force, and the cost grows with \f$ N \f$ and not with
//! \f$ N^2 \f$.
//!
//! @section ch07_truncation_exercises Exercises
//!
//! 1. Derive \f$ d^* \f$. For which exponents does it lie at infinity, so that no pair gives way?
//! 2. Cut the chain off farther out, with more neighbours in `least_eigenvalue`. From which on does it give way? Is the
//!    advice necessary, or is it enough?
//! 3. Let the particles of the chain leave their line. Which eigenvalues appear, and is the chain stable against them?
