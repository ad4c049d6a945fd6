// The near field's kernel for processors with AVX-512, where the compiler is allowed to use it.

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__) && defined(__FMA__)

#include <particulate/laws/detail/near_field_pairs.hpp>

const particulate::laws::detail::AddPairs particulate::laws::detail::add_pairs_avx512 = add_pairs;
const particulate::laws::detail::AddPairsWithin particulate::laws::detail::add_pairs_within_avx512 = add_pairs_within;
const particulate::laws::detail::AddPairsChosen particulate::laws::detail::add_pairs_chosen_avx512 = add_pairs_chosen;

#else

#include <particulate/laws/detail/near_field_kernels.hpp>

const particulate::laws::detail::AddPairs particulate::laws::detail::add_pairs_avx512 = nullptr;
const particulate::laws::detail::AddPairsWithin particulate::laws::detail::add_pairs_within_avx512 = nullptr;
const particulate::laws::detail::AddPairsChosen particulate::laws::detail::add_pairs_chosen_avx512 = nullptr;

#endif
