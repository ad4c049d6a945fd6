// The fluxes' kernel for every processor of this architecture.

#include <particulate/fluid/detail/flux_rows.hpp>

const particulate::fluid::detail::Kernels particulate::fluid::detail::fluxes_baseline = all_fluxes;
