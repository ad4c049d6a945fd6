#include <particulate/fluid/flow.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include <particulate/fluid/detail/fluxes.hpp>

namespace particulate::fluid {

// What limits a step, the largest of all cells: how many cells sound crosses a second, volume and viscosity per mass,
// and what a step of forward Euler adds.
struct detail::Rates {
  double waves = 0.0, light = 0.0, viscous = 0.0, drifts = 0.0;
};

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr const char* axes = "xyz";

// Numbers that are kept of a cell.
template <class F>
constexpr int kept = F::numbers + 1 + (F::varies ? 1 : 0);

const detail::Kernels& kernels(laws::Kernel kernel) {
  if (kernel == laws::Kernel::avx512) return detail::fluxes_avx512;
  return kernel == laws::Kernel::avx2 ? detail::fluxes_avx2 : detail::fluxes_baseline;
}

std::string face_name(int face) { return fmt::format("{} {}", axes[face / 2], face % 2 == 0 ? "low" : "high"); }

// The laws at a temperature, of which a barotropic one does not ask.
template <class E>
double pressure_at(const E& law, double rho, [[maybe_unused]] double theta) {
  if constexpr (HasTemperature<E>) {
    return pressure(law, rho, theta);
  } else {
    return pressure(law, rho);
  }
}
template <class E>
double sound_at(const E& law, double rho, [[maybe_unused]] double theta, [[maybe_unused]] double c) {
  if constexpr (HasTemperature<E>) {
    return speed_of_sound(law, rho, theta, c);
  } else {
    return speed_of_sound(law, rho);
  }
}

template <int Dim>
bool is_value(const Local<Dim>& here) {
  return here.rho > 0.0 && here.theta > 0.0 && std::isfinite(here.rho * here.theta) && here.v.allFinite();
}

template <int Dim>
std::string text_of(const Local<Dim>& here, bool has_heat) {
  const std::string warmth = has_heat ? fmt::format(", {} K", here.theta) : "";
  return fmt::format("{} kg/m^3{} and {} m/s", here.rho, warmth, here.v.norm());
}

}  // namespace

template <int Dim>
void validate(const Grid<Dim>& grid) {
  for (int a = 0; a < Dim; ++a) {
    const Eigen::Index n = grid.cells[static_cast<std::size_t>(a)];
    if (n < 4) {
      throw std::invalid_argument(
          fmt::format("grid: there must be at least 4 cells in each direction, got {} in {}", n, axes[a]));
    }
    if (!(grid.lengths[a] > 0.0 && std::isfinite(grid.lengths[a]) && std::isfinite(grid.corner[a]))) {
      throw std::invalid_argument(
          fmt::format("grid: its corner must be finite and its lengths positive and finite, got {} m from {} m in {}",
                      grid.lengths[a], grid.corner[a], axes[a]));
    }
  }
}

template <int Dim>
void validate(const Boundaries<Dim>& boundaries, bool has_heat) {
  for (int face = 0; face < 2 * Dim; ++face) {
    const auto refuse = [&](const std::string& why) {
      throw std::invalid_argument(fmt::format("boundary {}: {}", face_name(face), why));
    };
    const Boundary<Dim>& here = boundaries[static_cast<std::size_t>(face)];
    if (std::holds_alternative<Periodic>(here) !=
        std::holds_alternative<Periodic>(boundaries[static_cast<std::size_t>(face ^ 1)])) {
      refuse(fmt::format("it must be periodic if {} is, and only then", face_name(face ^ 1)));
    }
    if (const auto* wall = std::get_if<Wall<Dim>>(&here)) {
      if (!wall->velocity.allFinite() || wall->velocity[face / 2] != 0.0) {
        refuse(fmt::format("a wall must move along itself, finitely fast, got {} m/s of which {} across it",
                           wall->velocity.norm(), wall->velocity[face / 2]));
      }
      if (wall->theta && !has_heat) refuse("a barotropic fluid has no temperature: give the wall none");
      if (wall->theta && !(*wall->theta > 0.0 && std::isfinite(*wall->theta))) {
        refuse(fmt::format("the temperature of a wall must be positive and finite, got {} K", *wall->theta));
      }
    }
    if (const auto* given = std::get_if<Given<Dim>>(&here); given && !given->fluid) refuse("the fluid must be given");
    if (const auto* out = std::get_if<Outflow>(&here); out && !std::isfinite(out->P)) {
      refuse(fmt::format("the pressure must be finite, got {} Pa", out->P));
    }
  }
}

template <int Dim, class E, class V>
Flow<Dim, E, V>::Flow(Grid<Dim> grid, Fluid<E, V> fluid, Boundaries<Dim> boundaries, int threads, laws::Kernel kernel)
    : grid_(std::move(grid)),
      fluid_(std::move(fluid)),
      boundaries_(std::move(boundaries)),
      threads_(threads),
      kernel_(kernel == laws::Kernel::best ? laws::best_kernel() : kernel) {
  validate(grid_);
  validate(fluid_.state);
  validate(fluid_.viscosity);
  validate(boundaries_, has_heat);
  const auto require = [](bool holds, const char* what, double given) {
    if (!holds) throw std::invalid_argument(fmt::format("fluid: {}, got {}", what, given));
  };
  require(fluid_.lambda_over_mu >= -2.0 / 3.0 && std::isfinite(fluid_.lambda_over_mu),
          "lambda_over_mu must be finite and at least -2/3: less would gain energy", fluid_.lambda_over_mu);
  if (has_heat) {
    require(fluid_.c > 0.0 && std::isfinite(fluid_.c), "c must be positive and finite", fluid_.c);
    require(fluid_.K >= 0.0 && std::isfinite(fluid_.K), "K must be finite and not negative", fluid_.K);
  }
  require(threads >= 1 && threads <= 1024, "threads must be from 1 to 1024", threads);
  if (!laws::is_available(kernel_)) {
    throw std::invalid_argument(
        fmt::format("fluid: this build has no kernel {} for this processor: take best", laws::name(kernel_)));
  }
  padded_ = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    cells_[a] = a < Dim ? grid_.cells[a] : 1;
    ghosts_[a] = a < Dim ? 1 : 0;
    stride_[a] = padded_;
    padded_ *= cells_[a] + 2 * ghosts_[a];
  }
  measured_.resize(static_cast<std::size_t>(padded_ * kept<Flow>));
  buffer_size_ = detail::buffer_size(cells(), numbers);
  buffers_.resize(static_cast<std::size_t>(threads_ * buffer_size_));
}

template <int Dim, class E, class V>
detail::Cells Flow<Dim, E, V>::cells() const {
  detail::Cells q;
  q.rho = measured_.data(), q.apart = padded_;
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    q.cells[a] = cells_[axis], q.ghosts[a] = ghosts_[axis], q.stride[a] = stride_[axis];
    q.over_h[a] = a < Dim ? 1.0 / grid_.h(a) : 0.0;
  }
  for (int face = 0; face < 2 * Dim; ++face) {
    q.wall[face] = std::holds_alternative<Wall<Dim>>(boundaries_[static_cast<std::size_t>(face)]);
  }
  if constexpr (!varies) q.mu = viscosity(fluid_.viscosity);
  q.second = fluid_.lambda_over_mu, q.c = fluid_.c, q.K = fluid_.K;
  return q;
}

template <int Dim, class E, class V>
void Flow<Dim, E, V>::gather(const Hats<Dim>& hats, std::vector<Stream>& streams) const {
  Columns columns{.first = row_of(0), .stride = stride_};
  for (int c = 0; c < kept<Flow>; ++c) {
    // Nobody asks for the pressure.
    if (c != 1 + Dim) columns.offset[static_cast<std::size_t>(columns.count++)] = c * padded_;
  }
  const auto count = static_cast<std::size_t>(columns.count);
  gathered_.resize(streams.size() * count);
  hats.gather(columns, gathered_.data());
  for (std::size_t i = 0; i < streams.size(); ++i) {
    const double* const here = gathered_.data() + i * count;
    streams[i].rho = here[0];
    for (int a = 0; a < Dim; ++a) streams[i].v[a] = here[1 + a];
    if constexpr (has_heat) streams[i].theta = here[1 + Dim];
    if constexpr (varies) {
      streams[i].mu = here[2 + Dim];
    } else {
      streams[i].mu = viscosity(fluid_.viscosity);
    }
  }
}

template <int Dim, class E, class V>
void Flow<Dim, E, V>::require_size(Eigen::Index size) const {
  const Eigen::Index N = grid_.size();
  if (size == N * numbers) return;
  throw std::invalid_argument(
      fmt::format("flow: a state of {} cells must hold {} numbers, {} a cell, got {}", N, N * numbers, numbers, size));
}

// What the laws make of a row's densities and temperatures: whether all of it is finite.
template <int Dim, class E, class V>
bool Flow<Dim, E, V>::apply_laws(double* rho) const {
  const Eigen::Index n = cells_[0];
  double* const P = rho + (1 + Dim) * padded_;
  [[maybe_unused]] const double* const theta = rho + (2 + Dim) * padded_;
  const E law = fluid_.state;
  double not_finite = 0.0;
#pragma omp simd reduction(+ : not_finite)
  for (Eigen::Index i = 0; i < n; ++i) {
    P[i] = pressure_at(law, rho[i], has_heat ? theta[i] : 1.0);
    not_finite += 0.0 * P[i];
  }
  if constexpr (varies) {
    double* const mu = rho + (3 + Dim) * padded_;
    for (Eigen::Index i = 0; i < n; ++i) not_finite += 0.0 * (mu[i] = viscosity(fluid_.viscosity, theta[i]));
  }
  return not_finite == 0.0;
}

// Where a row of cells stands.
template <int Dim, class E, class V>
double* Flow<Dim, E, V>::row_of(Eigen::Index row) const {
  const Eigen::Index j = row % cells_[1] + ghosts_[1], k = row / cells_[1] + ghosts_[2];
  return measured_.data() + ghosts_[0] + j * stride_[1] + k * stride_[2];
}

// The same, with its densities, velocities and temperatures.
template <int Dim, class E, class V>
const double* Flow<Dim, E, V>::measured_row(Eigen::Index row, const double* y) const {
  kernels(kernel_).measure[Dim - 1][has_heat ? 1 : 0](cells(), row, y);
  return row_of(row);
}

template <int Dim, class E, class V>
bool Flow<Dim, E, V>::measure(double t, schemes::In y) const {
  require_size(y.size());
  const detail::Cells q = cells();
  const detail::MeasureRow measure_row = kernels(kernel_).measure[Dim - 1][has_heat ? 1 : 0];
  double bad = 0.0;
#pragma omp parallel for schedule(static) reduction(+ : bad) num_threads(threads_) if (threads_ > 1)
  for (Eigen::Index row = 0; row < cells_[1] * cells_[2]; ++row) {
    const bool good = measure_row(q, row, y.data()) && apply_laws(row_of(row));
    bad += good ? 0.0 : 1.0;
  }
  if (bad > 0.0) return false;
  // Each face with the ghosts of those before: so edges and corners have values too.
  for (int face = 0; face < 2 * Dim; ++face) fill_face(t, face);
  return true;
}

// The ghosts beyond a face, row by row along x. A function of the caller is asked by one thread alone.
template <int Dim, class E, class V>
void Flow<Dim, E, V>::fill_face(double t, int face) const {
  const auto axis = static_cast<std::size_t>(face / 2);
  std::array<Eigen::Index, 3> low{}, end = cells_;
  for (std::size_t b = 0; b < axis; ++b) low[b] = -ghosts_[b], end[b] = cells_[b] + ghosts_[b];
  low[axis] = face % 2 == 1 ? cells_[axis] : -1;
  end[axis] = low[axis] + 1;
  const Eigen::Index count = end[0] - low[0], across = end[1] - low[1], rows = across * (end[2] - low[2]);
  const auto fill = [&](Eigen::Index row) {
    fill_row(t, face, {low[0], low[1] + row % across, low[2] + row / across}, count);
  };
  if (std::holds_alternative<Given<Dim>>(boundaries_[static_cast<std::size_t>(face)])) {
    for (Eigen::Index row = 0; row < rows; ++row) fill(row);  // it may throw
  } else {
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1 && rows > 64)
    for (Eigen::Index row = 0; row < rows; ++row) fill(row);
  }
}

template <int Dim, class E, class V>
void Flow<Dim, E, V>::fill_row(double t, int face, std::array<Eigen::Index, 3> cell, Eigen::Index count) const {
  const int a = face / 2;
  const auto axis = static_cast<std::size_t>(a);
  const Eigen::Index towards = face % 2 == 1 ? -1 : 1;
  Eigen::Index at = 0;
  for (std::size_t b = 0; b < 3; ++b) at += (cell[b] + ghosts_[b]) * stride_[b];
  const auto column = [&](int field) { return measured_.data() + at + field * padded_; };
  const auto each = [&](int field, auto&& of) {
    double* const q = column(field);
    const double *const in = q + towards * stride_[axis], *const next = in + towards * stride_[axis],
                        *const third = next + towards * stride_[axis];
    for (Eigen::Index i = 0; i < count; ++i) q[i] = of(in[i], next[i], third[i]);
  };
  const auto mirror = [&](int field, double value) {
    each(field, [=](double in, double, double) { return 2.0 * value - in; });
  };
  const auto copy = [&](int field) { each(field, [](double in, double, double) { return in; }); };
  const auto go_on = [&](int field) { each(field, [](double in, double next, double) { return 2.0 * in - next; }); };
  // The cubic whose second derivative falls along a straight line to zero at the face: one that is zero
  // in the last cell already would take away what diffuses there, and be of order 1.
  const auto flow_on = [&](int field) {
    each(field, [](double in, double next, double third) { return (7.0 * in - 5.0 * next + third) / 3.0; });
  };
  const Boundary<Dim>& boundary = boundaries_[static_cast<std::size_t>(face)];
  if (std::holds_alternative<Periodic>(boundary)) {
    const Eigen::Index around = towards * cells_[axis] * stride_[axis];
    for (int field = 0; field < kept<Flow>; ++field) {
      double* const q = column(field);
      if (count == 1) {
        *q = q[around];
      } else {
        std::copy_n(q + around, count, q);
      }
    }
  } else if (const auto* wall = std::get_if<Wall<Dim>>(&boundary)) {
    copy(0);
    for (int c = 0; c < Dim; ++c) wall->slips&& c != a ? copy(1 + c) : mirror(1 + c, wall->velocity[c]);
    go_on(1 + Dim);
    if constexpr (has_heat) wall->theta ? mirror(2 + Dim, *wall->theta) : copy(2 + Dim);
    if constexpr (varies) wall->theta ? mirror(3 + Dim, viscosity(fluid_.viscosity, *wall->theta)) : copy(3 + Dim);
  } else if (const auto* out = std::get_if<Outflow>(&boundary)) {
    for (int field = 0; field < kept<Flow>; ++field) field == 1 + Dim ? mirror(field, out->P) : flow_on(field);
  } else {
    for (Eigen::Index i = 0; i < count; ++i, ++cell[0]) {
      std::array<Eigen::Index, Dim> place{};
      std::copy_n(cell.begin(), Dim, place.begin());
      const Local<Dim> there = std::get<Given<Dim>>(boundary).fluid(t, grid_.centre(place));
      column(0)[i] = is_value(there) ? there.rho : std::numeric_limits<double>::quiet_NaN();
      for (int c = 0; c < Dim; ++c) column(1 + c)[i] = there.v[c];
      column(1 + Dim)[i] = pressure_at(fluid_.state, there.rho, there.theta);
      if constexpr (has_heat) column(2 + Dim)[i] = there.theta;
      if constexpr (varies) column(3 + Dim)[i] = viscosity(fluid_.viscosity, there.theta);
    }
  }
}

template <int Dim, class E, class V>
bool Flow<Dim, E, V>::add_fluxes(unsigned wanted, double* dy) const {
  const detail::Cells q = cells();
  const detail::AddFluxes add = kernels(kernel_).add[Dim - 1][(has_heat ? 1 : 0) + (varies ? 1 : 0)];
  const Eigen::Index blocks = detail::blocks(q);
  double bad = 0.0;
#pragma omp parallel for schedule(static, 1) reduction(+ : bad) num_threads(threads_) if (threads_ > 1)
  for (int thread = 0; thread < threads_; ++thread) {
    for (Eigen::Index block = thread; block < blocks; block += threads_) {
      bad += add(q, wanted, block, buffers_.data() + thread * buffer_size_, dy) ? 0.0 : 1.0;
    }
  }
  return bad == 0.0;
}

template <int Dim, class E, class V>
bool Flow<Dim, E, V>::rate(double t, schemes::In y, schemes::Out dy) const {
  return measure(t, y) && add_fluxes(detail::density + detail::momentum + detail::energy, dy.data());
}

template <int Dim, class E, class V>
double Flow<Dim, E, V>::field_size(std::size_t k, schemes::In y) const {
  const schemes::Part own = part(k);
  if (k != 1) return y.segment(own.first, own.size).template lpNorm<1>();
  double size = 0.0;
  for (Eigen::Index n = 0; n < grid_.size(); ++n) {
    const Local<Dim> here = local(y, n);
    size += here.rho * sound_at(fluid_.state, here.rho, here.theta, fluid_.c);
  }
  return size;
}

template <int Dim, class E, class V>
bool Flow<Dim, E, V>::solve(std::size_t k, double t, schemes::In from, double dt, schemes::In seen,
                            schemes::Out to) const {
  // All of `seen` has been read before anything is written: it may be `to`.
  if (!measure(t + dt, seen) || !add_fluxes(1U << k, to.data())) return false;
  const schemes::Part own = part(k);
  to.segment(own.first, own.size) = from.segment(own.first, own.size) + dt * to.segment(own.first, own.size);
  return to.segment(own.first, own.size).allFinite();
}

template <int Dim, class E, class V>
schemes::Part Flow<Dim, E, V>::part(std::size_t k) const {
  const Eigen::Index N = grid_.size();
  return {.first = k == 0 ? 0 : k == 1 ? N : (1 + Dim) * N, .size = k == 1 ? Dim * N : N};
}

template <int Dim, class E, class V>
Local<Dim> Flow<Dim, E, V>::local(schemes::In y, Eigen::Index cell) const {
  const Eigen::Index N = grid_.size();
  Local<Dim> here{.rho = y[cell]};
  const double over = 1.0 / here.rho;
  for (int a = 0; a < Dim; ++a) here.v[a] = y[cell + (1 + a) * N] * over;
  if constexpr (has_heat) here.theta = (y[cell + (1 + Dim) * N] * over - 0.5 * here.v.squaredNorm()) / fluid_.c;
  return here;
}

template <int Dim, class E, class V>
schemes::State Flow<Dim, E, V>::start(const std::function<Local<Dim>(const Vector<Dim>& x)>& fluid) const {
  const Eigen::Index N = grid_.size();
  schemes::State state{.y = Eigen::VectorXd(N * numbers)};
  std::array<Eigen::Index, Dim> cell{};
  for (Eigen::Index n = 0; n < N; ++n) {
    Eigen::Index rest = n;
    for (std::size_t a = 0; a < Dim; ++a) cell[a] = rest % grid_.cells[a], rest /= grid_.cells[a];
    const Local<Dim> here = fluid(grid_.centre(cell));
    if (!is_value(here)) {
      throw std::invalid_argument(fmt::format(
          "flow: a start must have a positive density and temperature everywhere, and be finite; cell {} has {}", n,
          text_of(here, has_heat)));
    }
    state.y[n] = here.rho;
    for (int a = 0; a < Dim; ++a) state.y[n + (1 + a) * N] = here.rho * here.v[a];
    if constexpr (has_heat) {
      state.y[n + (1 + Dim) * N] = here.rho * (fluid_.c * here.theta + 0.5 * here.v.squaredNorm());
    }
  }
  return state;
}

// As the kernel sees it: next to zero, local() may round to the other side. Where kinetic energy leaves a temperature
// of some roundings, the next stage of a step has none.
template <int Dim, class E, class V>
std::string Flow<Dim, E, V>::why_no_value(schemes::In y) const {
  require_size(y.size());
  std::string about_to;
  for (Eigen::Index n = 0; n < grid_.size(); ++n) {
    const Eigen::Index row = n / cells_[0], i = n % cells_[0];
    const double* const rho = i == 0 ? measured_row(row, y.data()) : row_of(row);
    Local<Dim> here{.rho = rho[i]};
    for (int a = 0; a < Dim; ++a) here.v[a] = rho[i + (1 + a) * padded_];
    if constexpr (has_heat) here.theta = rho[i + (2 + Dim) * padded_];
    if (!is_value(here)) return fmt::format("cell {} has {}", n, text_of(here, has_heat));
    if (has_heat && fluid_.c * here.theta < 1e-9 * here.v.squaredNorm()) {
      about_to = fmt::format("cell {} has hardly any temperature left, {}", n, text_of(here, has_heat));
    }
  }
  return about_to;
}

template <int Dim, class E, class V>
std::vector<schemes::Range> Flow<Dim, E, V>::ranges() const {
  const Eigen::Index N = grid_.size();
  std::vector<schemes::Range> all{{.name = "density", .first = 0, .size = N},
                                  {.name = "momentum", .first = N, .size = Dim * N}};
  if (has_heat) all.push_back({.name = "energy", .first = (1 + Dim) * N, .size = N});
  return all;
}

// The largest of a row of cells; those without a value are left out.
template <int Dim, class E, class V>
void Flow<Dim, E, V>::look_at_row(const double* rho, detail::Rates& all) const {
  const double *const u = rho + padded_, *const v = u + (Dim > 1 ? padded_ : 0), *const w = v + (Dim > 2 ? padded_ : 0);
  [[maybe_unused]] const double* const theta = rho + (2 + Dim) * padded_;
  const E law = fluid_.state;
  const auto viscous = fluid_.viscosity;
  const double over_x = 1.0 / grid_.h(0), over_y = Dim > 1 ? 1.0 / grid_.h(1) : 0.0,
               over_z = Dim > 2 ? 1.0 / grid_.h(Dim - 1) : 0.0, c = fluid_.c;
  const double waves = std::sqrt(over_x * over_x + over_y * over_y + over_z * over_z);
  detail::Rates row;
  for (Eigen::Index i = 0; i < cells_[0]; ++i) {
    const double warm = has_heat ? theta[i] : 1.0, sound = sound_at(law, rho[i], warm, c);
    // Cells that the fluid, and sound, cross a second.
    const double carried = std::abs(u[i]) * over_x + std::abs(v[i]) * over_y + std::abs(w[i]) * over_z;
    const double sounds = sound * waves, over = 1.0 / rho[i];
    if (!(rho[i] > 0.0 && warm > 0.0 && carried + sounds + over < infinity)) continue;
    row.waves = std::max(row.waves, carried + sounds);
    row.light = std::max(row.light, over);
    row.viscous = std::max(row.viscous, viscosity(viscous, warm) * over);
    row.drifts = std::max(row.drifts, carried * (carried + 0.5 * sounds) / sound);
  }
  all = {.waves = std::max(all.waves, row.waves),
         .light = std::max(all.light, row.light),
         .viscous = std::max(all.viscous, row.viscous),
         .drifts = std::max(all.drifts, row.drifts)};
}

template <int Dim, class E, class V>
std::vector<schemes::TimeScale> Flow<Dim, E, V>::step_limits(schemes::In y) const {
  require_size(y.size());
  detail::Rates all;
  for (Eigen::Index row = 0; row < cells_[1] * cells_[2]; ++row) look_at_row(measured_row(row, y.data()), all);
  double sum = 0.0, largest = 0.0;  // of 1/h^2
  for (int a = 0; a < Dim; ++a) sum += std::pow(grid_.h(a), -2), largest = std::max(largest, std::pow(grid_.h(a), -2));
  // In three dimensions a wave along the diagonal may outrun those along an edge, by an eighth.
  const double stress = 1.0 + fluid_.lambda_over_mu, diagonal = Dim == 3 && stress > 3.0 ? 1.125 : 1.0;
  using Kind = schemes::TimeScale::Kind;
  std::vector<schemes::TimeScale> scales;
  const auto add = [&](const char* name, Kind kind, double rate) {
    if (rate > 0.0) scales.push_back({.name = name, .kind = kind, .seconds = 1.0 / rate});
  };
  add("sound, carried along", Kind::waves, all.waves);
  add("viscosity", Kind::decays, 4.0 * (sum + diagonal * stress * largest) * all.viscous);
  add("conduction", Kind::decays, has_heat ? 4.0 * fluid_.K / fluid_.c * sum * all.light : 0.0);
  add("advection, where one sweep drives it", Kind::drifts, 3.0 * grid_.lengths.minCoeff() * all.drifts);
  return scales;
}

template void validate(const Grid<1>&);
template void validate(const Grid<2>&);
template void validate(const Grid<3>&);
template void validate(const Boundaries<1>&, bool);
template void validate(const Boundaries<2>&, bool);
template void validate(const Boundaries<3>&, bool);
template class Flow<1, continuum::Barotropic>;
template class Flow<2, continuum::Barotropic>;
template class Flow<3, continuum::Barotropic>;
template class Flow<1, continuum::LinearizedState>;
template class Flow<2, continuum::LinearizedState>;
template class Flow<3, continuum::LinearizedState>;
template class Flow<1, continuum::IdealGas>;
template class Flow<2, continuum::IdealGas>;
template class Flow<3, continuum::IdealGas>;
template class Flow<2, continuum::LinearizedState, continuum::ExponentialViscosity>;
template class Flow<3, continuum::LinearizedState, continuum::ExponentialViscosity>;

}  // namespace particulate::fluid
