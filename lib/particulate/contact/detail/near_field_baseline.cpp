// The near field's kernel for every processor of this architecture.

#include <particulate/contact/detail/near_field_pairs.hpp>

const particulate::contact::detail::AddPairs particulate::contact::detail::add_pairs_baseline = add_pairs;
