// The fluxes' kernel for processors with AVX2 and FMA, where the compiler is allowed to use it.

#if defined(__AVX2__) && defined(__FMA__)

#include <particulate/fluid/detail/flux_rows.hpp>

const particulate::fluid::detail::Kernels particulate::fluid::detail::fluxes_avx2 = all_fluxes;

#else

#include <particulate/fluid/detail/fluxes.hpp>

const particulate::fluid::detail::Kernels particulate::fluid::detail::fluxes_avx2 = {};

#endif
