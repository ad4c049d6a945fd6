// The fluxes' kernel for processors with AVX-512, where the compiler is allowed to use it.

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__) && defined(__FMA__)

#include <particulate/fluid/detail/flux_rows.hpp>

const particulate::fluid::detail::Kernels particulate::fluid::detail::fluxes_avx512 = all_fluxes;

#else

#include <particulate/fluid/detail/fluxes.hpp>

const particulate::fluid::detail::Kernels particulate::fluid::detail::fluxes_avx512 = {};

#endif
