// The near field's kernel for processors with AVX2 and FMA, where the compiler is allowed to use it.

#if defined(__AVX2__) && defined(__FMA__)

#include <particulate/laws/detail/near_field_pairs.hpp>

const particulate::laws::detail::AddPairs particulate::laws::detail::add_pairs_avx2 = add_pairs;
const particulate::laws::detail::AddPairsWithin particulate::laws::detail::add_pairs_within_avx2 = add_pairs_within;
const particulate::laws::detail::AddPairsChosen particulate::laws::detail::add_pairs_chosen_avx2 = add_pairs_chosen;

#else

#include <particulate/laws/detail/near_field_kernels.hpp>

const particulate::laws::detail::AddPairs particulate::laws::detail::add_pairs_avx2 = nullptr;
const particulate::laws::detail::AddPairsWithin particulate::laws::detail::add_pairs_within_avx2 = nullptr;
const particulate::laws::detail::AddPairsChosen particulate::laws::detail::add_pairs_chosen_avx2 = nullptr;

#endif
