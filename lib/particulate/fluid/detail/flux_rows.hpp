#pragma once

// The fluxes between cells and the rates that they leave, for the instructions that the including source is compiled
// with: loops along x that the compiler makes into vectors.

#include <particulate/fluid/detail/fluxes.hpp>

namespace particulate::fluid::detail {
namespace {

using Index = std::int64_t;

// Columns of numbers along a row of faces: one for each field.
struct Row {
  double* f;
  Index apart;
};

// The first cell of a row, j - 1 and k - 1 for a neighbour.
inline Index place(const Cells& q, Index j, Index k) {
  return q.ghosts[0] + (j + q.ghosts[1]) * q.stride[1] + (k + q.ghosts[2]) * q.stride[2];
}

template <int Dim, bool has_heat>
bool measure_row(const Cells& q, Index row, const double* y) {
  const Index n = q.cells[0], N = n * q.cells[1] * q.cells[2];
  double* const rho = q.rho + place(q, row % q.cells[1], row / q.cells[1]);
  double* const theta = rho + (2 + Dim) * q.apart;
  const double *const mx = y + row * n + N, *const my = mx + (Dim > 1 ? N : 0), *const mz = my + (Dim > 2 ? N : 0);
  const double *const density = y + row * n, *const energy = mx + Dim * N;
  const double over_c = has_heat ? 1.0 / q.c : 0.0;
  double bad = 0.0;
#pragma omp simd reduction(+ : bad)
  for (Index i = 0; i < n; ++i) {
    const double over = 1.0 / density[i], u = mx[i] * over;
    double squares = u * u, warm = 1.0;
    rho[i] = density[i];
    rho[i + q.apart] = u;
    if (Dim > 1) {
      const double v = my[i] * over;
      rho[i + 2 * q.apart] = v;
      squares += v * v;
    }
    if (Dim > 2) {
      const double w = mz[i] * over;
      rho[i + 3 * q.apart] = w;
      squares += w * w;
    }
    if (has_heat) theta[i] = warm = (energy[i] * over - 0.5 * squares) * over_c;
    const double sum = density[i] + squares + warm;
    bad += (density[i] > 0.0 ? 0.0 : 1.0) + (warm > 0.0 ? 0.0 : 1.0) + 0.0 * sum;
  }
  return bad == 0.0;
}

// The difference of u across a cell along a direction, as the mean over the two cells at a face.
inline double across(const double* u, Index next, Index along, double quarter_over_h) {
  return (u[along] - u[-along] + u[next + along] - u[next - along]) * quarter_over_h;
}

// Mass, momentum and perhaps energy through the faces between `count` cells from `first` on and those after them along
// a, at which pressure works, or does not.
template <int Dim, int a, bool with_energy, bool varies>
void fluxes(const Cells& q, Index first, Index count, bool works, Row to) {
  constexpr int b = (a + 1) % Dim, d = (a + 2) % Dim;
  const Index next = q.stride[a], along_b = q.stride[b], along_d = q.stride[d];
  const double* const rho = q.rho + first;
  const double* const ua = rho + (1 + a) * q.apart;
  const double* const ub = rho + (1 + b) * q.apart;
  const double* const ud = rho + (1 + d) * q.apart;
  const double* const P = rho + (1 + Dim) * q.apart;
  const double* const theta = P + q.apart;
  const double* const viscosity = theta + q.apart;
  double* const mass = to.f;
  double* const fa = to.f + (1 + a) * to.apart;
  double* const fb = to.f + (1 + b) * to.apart;
  double* const fd = to.f + (1 + d) * to.apart;
  double* const energy_flux = to.f + (1 + Dim) * to.apart;
  const double over_h = q.over_h[a], quarter_b = 0.25 * q.over_h[b], quarter_d = 0.25 * q.over_h[d];
  const double constant = q.mu, second = q.second;
  const double half_c = 0.5 * q.c, half = works ? 0.5 : 0.0, conductance = q.K * over_h;
#pragma omp simd
  for (Index i = 0; i < count; ++i) {
    const double u0 = ua[i], u1 = ua[i + next], P0 = P[i], P1 = P[i + next];
    const double mean_a = 0.5 * (u0 + u1), slope_a = (u1 - u0) * over_h;
    const double m = 0.5 * (rho[i] + rho[i + next]) * mean_a;
    const double mu = varies ? 0.5 * (viscosity[i] + viscosity[i + next]) : constant;
    double expansion = slope_a, friction = 0.0, kinetic = u0 * u1;
    if (Dim > 1) {
      const double v0 = ub[i], v1 = ub[i + next], mean = 0.5 * (v0 + v1);
      const double shear = mu * ((v1 - v0) * over_h + across(ua + i, next, along_b, quarter_b));
      expansion += across(ub + i, next, along_b, quarter_b);
      fb[i] = m * mean - shear;
      friction += shear * mean;
      kinetic += v0 * v1;
    }
    if (Dim > 2) {
      const double w0 = ud[i], w1 = ud[i + next], mean = 0.5 * (w0 + w1);
      const double shear = mu * ((w1 - w0) * over_h + across(ua + i, next, along_d, quarter_d));
      expansion += across(ud + i, next, along_d, quarter_d);
      fd[i] = m * mean - shear;
      friction += shear * mean;
      kinetic += w0 * w1;
    }
    const double stretch = mu * (2.0 * slope_a + second * expansion);
    mass[i] = m;
    fa[i] = m * mean_a - stretch + 0.5 * (P0 + P1);
    if (with_energy) {
      friction += stretch * mean_a;
      energy_flux[i] = m * (half_c * (theta[i] + theta[i + next]) + 0.5 * kinetic) + half * (u0 * P1 + u1 * P0) -
                       friction - conductance * (theta[i + next] - theta[i]);
    }
  }
}

// Mass alone.
template <int a>
void mass_fluxes(const Cells& q, Index first, Index count, double* mass) {
  const Index next = q.stride[a];
  const double* const rho = q.rho + first;
  const double* const ua = rho + (1 + a) * q.apart;
#pragma omp simd
  for (Index i = 0; i < count; ++i) mass[i] = 0.5 * (rho[i] + rho[i + next]) * (0.5 * (ua[i] + ua[i + next]));
}

// What is wanted through the faces of a row.
template <int Dim, int a, bool has_heat, bool varies>
void wanted_fluxes(const Cells& q, unsigned wanted, Index first, Index count, bool works, Row to) {
  if (wanted == density) return mass_fluxes<a>(q, first, count, to.f);
  if constexpr (has_heat) {
    if ((wanted & energy) != 0) return fluxes<Dim, a, true, varies>(q, first, count, works, to);
  }
  fluxes<Dim, a, false, varies>(q, first, count, works, to);
}

// The fluxes into a row through its faces, before and behind.
struct Through {
  Row low, high;
};

template <int Dim>
double subtract(const Cells& q, int field, Through x, Through y, Through z, double* dy) {
  const Index n = q.cells[0];
  const auto column = [&](Row row) { return row.f + field * row.apart; };
  const double *const x0 = column(x.low), *const x1 = column(x.high), *const y0 = column(y.low),
                      *const y1 = column(y.high), *const z0 = column(z.low), *const z1 = column(z.high);
  const double over_x = q.over_h[0], over_y = q.over_h[1], over_z = q.over_h[2];
  double not_finite = 0.0;
#pragma omp simd reduction(+ : not_finite)
  for (Index i = 0; i < n; ++i) {
    double rate = (x0[i] - x1[i]) * over_x;
    if (Dim > 1) rate += (y0[i] - y1[i]) * over_y;
    if (Dim > 2) rate += (z0[i] - z1[i]) * over_z;
    dy[i] = rate;
    not_finite += 0.0 * rate;
  }
  return not_finite;
}

template <int Dim, bool has_heat, bool varies>
bool add_fluxes(const Cells& q, unsigned wanted, Index block, double* buffer, double* dy) {
  constexpr Index numbers = 1 + Dim + (has_heat ? 1 : 0);
  const Index n = q.cells[0], N = n * q.cells[1] * q.cells[2], apart = n + 1;
  const Index j_blocks = blocks_along(q.cells[1], block_rows);
  const Index j0 = block % j_blocks * block_rows, k0 = block / j_blocks * block_planes;
  const Index j1 = j0 + block_rows < q.cells[1] ? j0 + block_rows : q.cells[1];
  const Index k1 = k0 + block_planes < q.cells[2] ? k0 + block_planes : q.cells[2];
  const auto row = [&](Index which) { return Row{buffer + which * numbers * apart, apart}; };
  const Row x = row(0);
  const auto x_fluxes = [&](Index j, Index k) {
    const Index first = place(q, j, k) - 1;
    wanted_fluxes<Dim, 0, has_heat, varies>(q, wanted, first, n + 1, true, x);
    if (q.wall[0]) wanted_fluxes<Dim, 0, has_heat, varies>(q, wanted, first, 1, false, x);
    if (q.wall[1]) wanted_fluxes<Dim, 0, has_heat, varies>(q, wanted, first + n, 1, false, {x.f + n, apart});
  };
  // Between row j - 1 and j, plane k - 1 and k.
  const auto y_fluxes = [&]([[maybe_unused]] Index j, [[maybe_unused]] Index k, [[maybe_unused]] Row to) {
    if constexpr (Dim > 1) {
      const bool works = !(j == 0 && q.wall[2]) && !(j == q.cells[1] && q.wall[3]);
      wanted_fluxes<Dim, 1, has_heat, varies>(q, wanted, place(q, j - 1, k), n, works, to);
    }
  };
  const auto z_fluxes = [&]([[maybe_unused]] Index j, [[maybe_unused]] Index k, [[maybe_unused]] Row to) {
    if constexpr (Dim > 2) {
      const bool works = !(k == 0 && q.wall[4]) && !(k == q.cells[2] && q.wall[5]);
      wanted_fluxes<Dim, 2, has_heat, varies>(q, wanted, place(q, j, k - 1), n, works, to);
    }
  };
  Row y_low = row(1), y_high = row(2), z_high = row(3), z_low[block_rows];
  for (Index r = 0; r < block_rows; ++r) z_low[r] = row(4 + r);
  double not_finite = 0.0;
  for (Index k = k0; k < k1; ++k) {
    y_fluxes(j0, k, y_low);
    for (Index j = j0; j < j1; ++j) {
      x_fluxes(j, k);
      y_fluxes(j + 1, k, y_high);
      if (k == k0) z_fluxes(j, k, z_low[j - j0]);
      z_fluxes(j, k + 1, z_high);
      double* const rates = dy + (j + k * q.cells[1]) * n;
      for (int f = 0; f < numbers; ++f) {
        if ((wanted & (f == 0 ? density : f <= Dim ? momentum : energy)) == 0) continue;
        not_finite +=
            subtract<Dim>(q, f, {x, {x.f + 1, apart}}, {y_low, y_high}, {z_low[j - j0], z_high}, rates + f * N);
      }
      const Row y = y_low, z = z_low[j - j0];
      y_low = y_high, y_high = y;
      z_low[j - j0] = z_high, z_high = z;
    }
  }
  return not_finite == 0.0;
}

constexpr Kernels all_fluxes = {{{add_fluxes<1, false, false>, add_fluxes<1, true, false>, add_fluxes<1, true, true>},
                                 {add_fluxes<2, false, false>, add_fluxes<2, true, false>, add_fluxes<2, true, true>},
                                 {add_fluxes<3, false, false>, add_fluxes<3, true, false>, add_fluxes<3, true, true>}},
                                {{measure_row<1, false>, measure_row<1, true>},
                                 {measure_row<2, false>, measure_row<2, true>},
                                 {measure_row<3, false>, measure_row<3, true>}}};

}  // namespace
}  // namespace particulate::fluid::detail
