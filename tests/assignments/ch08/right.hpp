#pragma once

#include <cstddef>

#include "flux.hpp"

// What a student may well write, for both variants.
namespace right {

inline double mean(double a, double b) { return 0.5 * (a + b); }
inline double P(const Gas& gas, const Cell& x) { return x.rho * gas.R * x.theta; }

// Of either variant, by its mass flux.
inline Three split(const Gas& gas, const Cell& l, const Cell& r, double m) {
  return {m, m * mean(l.u, r.u) + mean(P(gas, l), P(gas, r)),
          m * (gas.c * mean(l.theta, r.theta) + 0.5 * l.u * r.u) + mean(l.u * P(gas, r), r.u * P(gas, l))};
}

inline Three of_means(const Gas& gas, const Cell& l, const Cell& r) {
  return split(gas, l, r, mean(l.rho, r.rho) * mean(l.u, r.u));
}
inline Three of_products(const Gas& gas, const Cell& l, const Cell& r) {
  return split(gas, l, r, mean(l.rho * l.u, r.rho * r.u));
}

inline Three minus(const Three& a, const Three& b, double over) {
  return {(a.mass - b.mass) * over, (a.momentum - b.momentum) * over, (a.energy - b.energy) * over};
}

inline std::vector<Three> ring(const Flux& flux, const std::vector<Cell>& cells, double h) {
  const std::size_t n = cells.size();
  std::vector<Three> rates;
  for (std::size_t i = 0; i < n; ++i) {
    rates.push_back(minus(flux(cells[(i + n - 1) % n], cells[i]), flux(cells[i], cells[(i + 1) % n]), 1.0 / h));
  }
  return rates;
}

}  // namespace right
