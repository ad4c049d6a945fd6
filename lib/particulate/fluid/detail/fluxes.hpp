#pragma once

#include <cstdint>

// What the kernel that adds a flow's fluxes is given. It is compiled from one source, flux_rows.hpp, some of it with
// instructions that not every processor has: neither header includes anything that could leave a shared inline function
// behind, of which the linker would keep one copy for the whole program, perhaps that with those instructions.

namespace particulate::fluid::detail {

// What is measured of a flow's cells, with a layer of ghosts around them in each direction that there is: density,
// velocity, pressure and, with heat, temperature, then a viscosity that varies. x is fastest; each begins `apart`
// numbers after the last.
struct Cells {
  double* rho = nullptr;
  std::int64_t apart = 0;
  std::int64_t cells[3] = {}, ghosts[3] = {}, stride[3] = {};  // one cell and no ghost in a direction that is not there
  double over_h[3] = {};
  bool wall[6] = {};    // x low, x high, y low and so on: there pressure does no work
  double mu = 0.0;      // where it does not vary
  double second = 0.0;  // viscosity over mu
  double c = 0.0, K = 0.0;
};

// Which fields are asked for, as a sum.
constexpr unsigned density = 1, momentum = 2, energy = 4;

// Cells are shared in blocks of rows along x.
constexpr std::int64_t block_rows = 8, block_planes = 32;

inline std::int64_t blocks_along(std::int64_t cells, std::int64_t size) { return (cells + size - 1) / size; }

inline std::int64_t blocks(const Cells& q) {
  return blocks_along(q.cells[1], block_rows) * blocks_along(q.cells[2], block_planes);
}

// Numbers that a block needs beside.
inline std::int64_t buffer_size(const Cells& q, std::int64_t numbers) {
  return (q.cells[0] + 1) * (4 + block_rows) * numbers;
}

// What is measured of the cells of a row, from what is conserved of them: density, velocity and temperature. False if
// one has none that can be.
using MeasureRow = bool (*)(const Cells& q, std::int64_t row, const double* y);

// Writes the rates of a block's cells for the fields that are asked for. False if one is not finite.
using AddFluxes = bool (*)(const Cells& q, unsigned wanted, std::int64_t block, double* buffer, double* dy);

// By the number of directions less one; then barotropic, with heat, with heat and a viscosity that varies.
struct Kernels {
  AddFluxes add[3][3];
  MeasureRow measure[3][2];
};

// Null pointers where this build does not have a kernel.
extern const Kernels fluxes_baseline, fluxes_avx2, fluxes_avx512;

}  // namespace particulate::fluid::detail
