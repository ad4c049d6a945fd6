#pragma once

#include <particulate/laws/detail/near_field_kernels.hpp>
#include <particulate/laws/near_field.hpp>

// What laws share that use the near field's kernels.

namespace particulate::laws::detail {

// The code of a kernel for so many particles, a few of which have the same bits whatever the processor. Throws
// std::invalid_argument if it is not available.
AddPairs add_pairs_of(Kernel kernel, std::int64_t N);

// The columns of a scene's scratch, filled.
Columns filled(Scratch& scratch, const double* position, const double* factor, Eigen::Index N);

// Adds what the columns hold to the forces; false if one of these is not finite then.
bool add_components(const Columns& c, Eigen::Index N, Forces force);

}  // namespace particulate::laws::detail
