#include "flux.hpp"

// Fill the holes. The brief is README.md; what each function must do stands in flux.hpp.

Three face_flux([[maybe_unused]] const Gas& gas, [[maybe_unused]] const Cell& left,
                [[maybe_unused]] const Cell& right) {
  return {};
}

std::vector<Three> ring_rates([[maybe_unused]] const Flux& flux, const std::vector<Cell>& cells,
                              [[maybe_unused]] double h) {
  return std::vector<Three>(cells.size());
}
