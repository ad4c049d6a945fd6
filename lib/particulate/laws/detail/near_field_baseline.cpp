// The near field's kernel for every processor of this architecture.

#include <particulate/laws/detail/near_field_pairs.hpp>

const particulate::laws::detail::AddPairs particulate::laws::detail::add_pairs_baseline = add_pairs;
const particulate::laws::detail::AddPairsWithin particulate::laws::detail::add_pairs_within_baseline = add_pairs_within;
