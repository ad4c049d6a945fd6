#pragma once

#include <cstdint>

// What the near field's kernels are given. They are compiled from one source, near_field_pairs.hpp, some of them with
// instructions that not every processor has. So neither header includes anything that could leave a shared inline
// function behind: the linker would keep one copy of it for the whole program, perhaps the one with those instructions.

namespace particulate::laws::detail {

// Strengths and exponents of attraction and repulsion, before scaling factors, and where a potential energy is zero.
struct PairForce {
  double alpha1, alpha2, beta1, beta2, d_ref;
};

// At<> and scaling factors of N particles, and where their forces go: a particle's action is the force that the
// particles behind it exert on it, its reactions are those to what the particles in front of it feel. They may be one
// column.
struct Columns {
  const double *x, *y, *z, *factor;
  double *action_x, *action_y, *action_z;
  double *reaction_x, *reaction_y, *reaction_z;
};

// Some particles against others; or, where both are the same, against those behind them. The force on a row is an
// action, that on a partner a reaction.
struct Block {
  Columns row, partner;
  std::int64_t rows, partners;
  bool same;
};

// Up to so many particles are taken pair by pair, by the baseline. The columns of more are read and written to the next
// multiple of the second number, the longest vector register of any kernel: they must be padded with finite numbers.
// Rows that meet others must be as many as a multiple of it.
constexpr std::int64_t few = 10;
constexpr std::int64_t padded_to = 8;

// Adds the forces of all pairs of a block, and to an energy, if one is given, their potential energy. False if a
// distance has no square that a double holds to full precision, or powers of it that come near the ends of what a
// double holds: products with them might be rounded to nothing.
using AddPairs = bool (*)(const PairForce& law, const Block& block, double* energy);

// The same of a few particles among themselves, without energy.
bool add_few_pairs(const PairForce& law, const Columns& columns, std::int64_t N);

// Which pairs may be within reach, and how the force ends there: the Candidates of Neighbours, the cut-off distance,
// the width over which it is tapered, and the periods of space.
struct Within {
  const std::uint32_t* first;
  const std::int32_t* partner;
  std::int64_t N;
  double cutoff, taper;
  double lengths[3];
};

// The same for those pairs alone that are nearer than the cut-off distance. Columns need no padding.
using AddPairsWithin = bool (*)(const PairForce& law, const Within& within, const Columns& columns);

// Pairs, each once, in any order, however far apart.
struct Chosen {
  const std::int32_t *row, *partner;
  std::int64_t n;
};

// The same for those pairs alone. Columns need no padding.
using AddPairsChosen = bool (*)(const PairForce& law, const Chosen& pairs, const Columns& columns);

// One for each set of instructions; null where this build has no such code.
extern const AddPairs add_pairs_baseline;
extern const AddPairs add_pairs_avx2;
extern const AddPairs add_pairs_avx512;
extern const AddPairsWithin add_pairs_within_baseline;
extern const AddPairsWithin add_pairs_within_avx2;
extern const AddPairsWithin add_pairs_within_avx512;
extern const AddPairsChosen add_pairs_chosen_baseline;
extern const AddPairsChosen add_pairs_chosen_avx2;
extern const AddPairsChosen add_pairs_chosen_avx512;

}  // namespace particulate::laws::detail
