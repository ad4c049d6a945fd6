#include <particulate/fluid/flow.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace particulate::fluid {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr const char* axes = "xyz";

template <class Law>
constexpr bool varies = !std::same_as<Law, continuum::ConstantViscosity>;

std::string face_name(int face) { return fmt::format("{} {}", axes[face / 2], face % 2 == 0 ? "low" : "high"); }

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
        refuse(fmt::format("a wall must move along itself, got {} m/s across it", wall->velocity[face / 2]));
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
Flow<Dim, E, V>::Flow(Grid<Dim> grid, Fluid<E, V> fluid, Boundaries<Dim> boundaries, int threads, laws::Kernel)
    : grid_(std::move(grid)), fluid_(std::move(fluid)), boundaries_(std::move(boundaries)), threads_(threads) {
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
  padded_ = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    cells_[a] = a < Dim ? grid_.cells[a] : 1;
    ghosts_[a] = a < Dim ? 1 : 0;
    stride_[a] = padded_;
    padded_ *= cells_[a] + 2 * ghosts_[a];
  }
  cells_with_ghosts_.assign(static_cast<std::size_t>(padded_ * (numbers + 1 + (varies<V> ? 1 : 0))), 0.0);
}

template <int Dim, class E, class V>
double Flow<Dim, E, V>::pressure_of(double rho, double theta) const {
  if constexpr (has_heat) {
    return pressure(fluid_.state, rho, theta);
  } else {
    return pressure(fluid_.state, rho);
  }
}

// What is measured of cells, from what is conserved; false where a cell has no density or temperature.
template <int Dim, class E, class V>
bool Flow<Dim, E, V>::fill_cells(schemes::In y) const {
  const Eigen::Index N = grid_.size(), n = cells_[0];
  double* const rho = cells_with_ghosts_.data();
  double* const P = rho + (Dim + 1) * padded_;
  [[maybe_unused]] double* const theta = rho + (Dim + 2) * padded_;
  [[maybe_unused]] double* const mu = rho + (numbers + 1) * padded_;
  int bad = 0;
#pragma omp parallel for schedule(static) reduction(+ : bad) num_threads(threads_) if (threads_ > 1)
  for (Eigen::Index row = 0; row < cells_[1] * cells_[2]; ++row) {
    const Eigen::Index j = row % cells_[1], k = row / cells_[1];
    const Eigen::Index to = ghosts_[0] + (j + ghosts_[1]) * stride_[1] + (k + ghosts_[2]) * stride_[2];
    const double* from = y.data() + row * n;
    for (Eigen::Index i = 0; i < n; ++i) {
      const double density = from[i], over = 1.0 / density;
      double squares = 0.0;
      for (int c = 0; c < Dim; ++c) {
        const double u = from[i + (1 + c) * N] * over;
        rho[to + i + (1 + c) * padded_] = u;
        squares += u * u;
      }
      double warm = 1.0;
      if constexpr (has_heat) {
        warm = (from[i + (1 + Dim) * N] * over - 0.5 * squares) / fluid_.c;
        theta[to + i] = warm;
      }
      rho[to + i] = density;
      P[to + i] = pressure_of(density, warm);
      const bool good = (density > 0.0) & (warm > 0.0) & (std::abs(P[to + i]) + density + warm + squares < infinity);
      bad += good ? 0 : 1;
    }
    if constexpr (varies<V>) {
      for (Eigen::Index i = 0; i < n; ++i) mu[to + i] = viscosity(fluid_.viscosity, theta[to + i]);
    }
  }
  return bad == 0;
}

// Faces in their order, each with the ghosts of those before: so edges and corners have values too.
template <int Dim, class E, class V>
void Flow<Dim, E, V>::fill_ghosts(double t) const {
  for (int face = 0; face < 2 * Dim; ++face) fill_face(t, face);
}

template <int Dim, class E, class V>
void Flow<Dim, E, V>::fill_face(double t, int face) const {
  const int a = face / 2;
  const auto axis = static_cast<std::size_t>(a);
  const bool high = face % 2 == 1;
  const Eigen::Index n = cells_[axis];
  std::array<Eigen::Index, 3> low{}, end = cells_;
  for (std::size_t b = 0; b < axis; ++b) low[b] = -ghosts_[b], end[b] = cells_[b] + ghosts_[b];
  low[axis] = high ? n : -1;
  end[axis] = low[axis] + 1;
  const Eigen::Index inwards = (high ? -1 : 1) * stride_[axis], around = (high ? -n : n) * stride_[axis];
  const Boundary<Dim>& boundary = boundaries_[static_cast<std::size_t>(face)];
  double* const data = cells_with_ghosts_.data();
  constexpr int kept = numbers + 1 + (varies<V> ? 1 : 0);
  std::array<Eigen::Index, 3> cell{};
  for (cell[2] = low[2]; cell[2] < end[2]; ++cell[2]) {
    for (cell[1] = low[1]; cell[1] < end[1]; ++cell[1]) {
      for (cell[0] = low[0]; cell[0] < end[0]; ++cell[0]) {
        Eigen::Index at = 0;
        for (std::size_t b = 0; b < 3; ++b) at += (cell[b] + ghosts_[b]) * stride_[b];
        const auto q = [&](int f) -> double& { return data[at + f * padded_]; };
        const auto in = [&](int f) { return data[at + inwards + f * padded_]; };
        const auto next = [&](int f) { return data[at + 2 * inwards + f * padded_]; };
        if (std::holds_alternative<Periodic>(boundary)) {
          for (int f = 0; f < kept; ++f) q(f) = data[at + around + f * padded_];
        } else if (const auto* wall = std::get_if<Wall<Dim>>(&boundary)) {
          q(0) = in(0);
          for (int c = 0; c < Dim; ++c)
            q(1 + c) = wall->slips && c != a ? in(1 + c) : 2.0 * wall->velocity[c] - in(1 + c);
          q(Dim + 1) = 2.0 * in(Dim + 1) - next(Dim + 1);
          if constexpr (has_heat) q(Dim + 2) = wall->theta ? 2.0 * *wall->theta - in(Dim + 2) : in(Dim + 2);
          if constexpr (varies<V>) {
            q(Dim + 3) = wall->theta ? 2.0 * viscosity(fluid_.viscosity, *wall->theta) - in(Dim + 3) : in(Dim + 3);
          }
        } else if (const auto* given = std::get_if<Given<Dim>>(&boundary)) {
          std::array<Eigen::Index, Dim> place{};
          std::copy_n(cell.begin(), Dim, place.begin());
          const Local<Dim> there = given->fluid(t, grid_.centre(place));
          q(0) = there.rho;
          for (int c = 0; c < Dim; ++c) q(1 + c) = there.v[c];
          q(Dim + 1) = pressure_of(there.rho, there.theta);
          if constexpr (has_heat) q(Dim + 2) = there.theta;
          if constexpr (varies<V>) q(Dim + 3) = viscosity(fluid_.viscosity, there.theta);
        } else {
          for (int f = 0; f < kept; ++f) q(f) = 2.0 * in(f)-next(f);
          q(Dim + 1) = 2.0 * std::get<Outflow>(boundary).P - in(Dim + 1);
        }
      }
    }
  }
}

// Whether pressure works at a face: at a wall nothing that moves is pushed.
template <int Dim, class E, class V>
double Flow<Dim, E, V>::work_at(int face) const {
  return std::holds_alternative<Wall<Dim>>(boundaries_[static_cast<std::size_t>(face)]) ? 0.0 : 1.0;
}

// The fluxes across the faces between cells first + i and those after them along a, field by field.
template <int Dim, class E, class V>
template <int a>
void Flow<Dim, E, V>::fluxes(Eigen::Index first, Eigen::Index count, double work, double* f) const {
  const Eigen::Index next = stride_[static_cast<std::size_t>(a)];
  const double* const rho = cells_with_ghosts_.data() + first;
  const double* const P = rho + (Dim + 1) * padded_;
  [[maybe_unused]] const double* const theta = rho + (Dim + 2) * padded_;
  [[maybe_unused]] const double* const viscosities = rho + (numbers + 1) * padded_;
  const double over_h = 1.0 / grid_.h(a), second = fluid_.lambda_over_mu;
  std::array<double, 3> quarter{};
  for (int b = 0; b < Dim; ++b) quarter[static_cast<std::size_t>(b)] = 0.25 / grid_.h(b);
  double constant = 0.0;
  if constexpr (!varies<V>) constant = viscosity(fluid_.viscosity);
#pragma omp simd
  for (Eigen::Index i = 0; i < count; ++i) {
    double mean[Dim], slope[Dim];  // of velocities, across the face
    for (int c = 0; c < Dim; ++c) {
      const double u0 = rho[i + (1 + c) * padded_], u1 = rho[i + next + (1 + c) * padded_];
      mean[c] = 0.5 * (u0 + u1);
      slope[c] = (u1 - u0) * over_h;
    }
    double mu = constant;
    if constexpr (varies<V>) mu = 0.5 * (viscosities[i] + viscosities[i + next]);
    double expansion = slope[a], shear[Dim];
    for (int b = 0; b < Dim; ++b) {
      if (b == a) continue;
      const Eigen::Index s = stride_[static_cast<std::size_t>(b)];
      const auto along = [&](int c) {
        const double* const u = rho + i + (1 + c) * padded_;
        return (u[s] - u[-s] + u[next + s] - u[next - s]) * quarter[static_cast<std::size_t>(b)];
      };
      expansion += along(b);
      shear[b] = mu * (slope[b] + along(a));
    }
    shear[a] = mu * (2.0 * slope[a] + second * expansion);
    const double pressure = 0.5 * (P[i] + P[i + next]), m = 0.5 * (rho[i] + rho[i + next]) * mean[a];
    f[i] = m;
    for (int c = 0; c < Dim; ++c) f[i + (1 + c) * count] = m * mean[c] - shear[c] + (c == a ? pressure : 0.0);
    if constexpr (has_heat) {
      double kinetic = 0.0, friction = 0.0;
      for (int c = 0; c < Dim; ++c) {
        kinetic += rho[i + (1 + c) * padded_] * rho[i + next + (1 + c) * padded_];
        friction += shear[c] * mean[c];
      }
      const double u0 = rho[i + (1 + a) * padded_], u1 = rho[i + next + (1 + a) * padded_];
      f[i + (1 + Dim) * count] = m * (0.5 * fluid_.c * (theta[i] + theta[i + next]) + 0.5 * kinetic) +
                                 0.5 * work * (u0 * P[i + next] + u1 * P[i]) - friction -
                                 fluid_.K * (theta[i + next] - theta[i]) * over_h;
    }
  }
}

// Rows of cells from first to last, numbered y before z: each gets what comes through its faces.
template <int Dim, class E, class V>
void Flow<Dim, E, V>::add_rows(Eigen::Index first, Eigen::Index last, double* dy) const {
  const Eigen::Index n = cells_[0], N = grid_.size();
  const auto padded = [&](Eigen::Index j, Eigen::Index k) {
    return ghosts_[0] + (j + ghosts_[1]) * stride_[1] + (k + ghosts_[2]) * stride_[2];
  };
  std::vector<double> along((n + 1) * numbers), low(n * numbers), high(n * numbers),
      below(Dim > 2 ? n * numbers * cells_[1] : 0);
  const auto subtract = [&](const double* before, const double* after, double over_h, Eigen::Index row) {
    for (int f = 0; f < numbers; ++f) {
      for (Eigen::Index i = 0; i < n; ++i) dy[row * n + i + f * N] -= (after[i + f * n] - before[i + f * n]) * over_h;
    }
  };
  const auto y_flux = [&](Eigen::Index j, Eigen::Index k, double* to) {  // between j - 1 and j
    if constexpr (Dim > 1) fluxes<1>(padded(j - 1, k), n, j == 0 ? work_at(2) : j == cells_[1] ? work_at(3) : 1.0, to);
  };
  const auto z_flux = [&](Eigen::Index j, Eigen::Index k, double* to) {
    if constexpr (Dim > 2) fluxes<2>(padded(j, k - 1), n, k == 0 ? work_at(4) : k == cells_[2] ? work_at(5) : 1.0, to);
  };
  for (Eigen::Index row = first; row < last; ++row) {
    const Eigen::Index j = row % cells_[1], k = row / cells_[1];
    fluxes<0>(padded(j, k) - 1, n + 1, 1.0, along.data());
    for (const int face : {0, 1}) {
      if (work_at(face) == 1.0) continue;
      std::array<double, numbers> alone{};
      fluxes<0>(padded(j, k) + face * n - 1, 1, work_at(face), alone.data());
      for (int f = 0; f < numbers; ++f)
        along[static_cast<std::size_t>(face * n + f * (n + 1))] = alone[static_cast<std::size_t>(f)];
    }
    for (int f = 0; f < numbers; ++f) {
      const double* const flux = along.data() + f * (n + 1);
      const double over_h = 1.0 / grid_.h(0);
      for (Eigen::Index i = 0; i < n; ++i) dy[row * n + i + f * N] = (flux[i] - flux[i + 1]) * over_h;
    }
    if constexpr (Dim > 1) {
      if (row == first || j == 0) y_flux(j, k, low.data());
      y_flux(j + 1, k, high.data());
      subtract(low.data(), high.data(), 1.0 / grid_.h(1), row);
      low.swap(high);
    }
    if constexpr (Dim > 2) {
      double* const under = below.data() + j * n * numbers;
      if (row - first < cells_[1]) z_flux(j, k, under);
      z_flux(j, k + 1, high.data());
      subtract(under, high.data(), 1.0 / grid_.h(2), row);
      std::copy(high.begin(), high.end(), under);
    }
  }
}

template <int Dim, class E, class V>
bool Flow<Dim, E, V>::rate(double t, schemes::In y, schemes::Out dy) const {
  if (!fill_cells(y)) return false;
  fill_ghosts(t);
  const Eigen::Index rows = cells_[1] * cells_[2];
  const auto parts = std::min<Eigen::Index>(threads_, rows);
#pragma omp parallel for schedule(static, 1) num_threads(threads_) if (threads_ > 1)
  for (Eigen::Index part = 0; part < parts; ++part) {
    add_rows(rows * part / parts, rows * (part + 1) / parts, dy.data());
  }
  return dy.allFinite();
}

template <int Dim, class E, class V>
schemes::Part Flow<Dim, E, V>::part(std::size_t k) const {
  const schemes::Range range = ranges()[k];
  return {.first = range.first, .size = range.size};
}

template <int Dim, class E, class V>
bool Flow<Dim, E, V>::solve(std::size_t k, const schemes::State& from, double dt, const schemes::State& seen,
                            schemes::State& to) const {
  rates_.resize(seen.y.size());
  if (!rate(from.t + dt, seen.y, rates_)) return false;
  const schemes::Part own = part(k);
  to.y.segment(own.first, own.size) = from.y.segment(own.first, own.size) + dt * rates_.segment(own.first, own.size);
  return true;
}

template <int Dim, class E, class V>
Local<Dim> Flow<Dim, E, V>::local(const schemes::State& at, Eigen::Index cell) const {
  const Eigen::Index N = grid_.size();
  Local<Dim> here{.rho = at.y[cell]};
  for (int a = 0; a < Dim; ++a) here.v[a] = at.y[cell + (1 + a) * N] / here.rho;
  if constexpr (has_heat) here.theta = (at.y[cell + (1 + Dim) * N] / here.rho - 0.5 * here.v.squaredNorm()) / fluid_.c;
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
    if (!(here.rho > 0.0 && here.theta > 0.0 && here.v.allFinite() && std::isfinite(here.rho * here.theta))) {
      throw std::invalid_argument(fmt::format(
          "flow: a start must have positive densities and temperatures, and be finite; got {} kg/m^3, {} K and {} m/s "
          "in cell {}",
          here.rho, here.theta, here.v.norm(), n));
    }
    state.y[n] = here.rho;
    for (int a = 0; a < Dim; ++a) state.y[n + (1 + a) * N] = here.rho * here.v[a];
    if constexpr (has_heat) {
      state.y[n + (1 + Dim) * N] = here.rho * (fluid_.c * here.theta + 0.5 * here.v.squaredNorm());
    }
  }
  return state;
}

template <int Dim, class E, class V>
std::string Flow<Dim, E, V>::why_no_value(const schemes::State& at) const {
  for (Eigen::Index n = 0; n < grid_.size(); ++n) {
    const Local<Dim> here = local(at, n);
    if (here.rho > 0.0 && here.theta > 0.0 && std::isfinite(here.rho * here.theta) && here.v.allFinite()) continue;
    return fmt::format("cell {} has a density of {} kg/m^3 and a temperature of {} K", n, here.rho, here.theta);
  }
  return {};
}

template <int Dim, class E, class V>
std::vector<schemes::Range> Flow<Dim, E, V>::ranges() const {
  const Eigen::Index N = grid_.size();
  std::vector<schemes::Range> all{{.name = "density", .first = 0, .size = N},
                                  {.name = "momentum", .first = N, .size = Dim * N}};
  if (has_heat) all.push_back({.name = "energy", .first = (1 + Dim) * N, .size = N});
  return all;
}

template <int Dim, class E, class V>
std::vector<schemes::TimeScale> Flow<Dim, E, V>::step_limits(const schemes::State& at) const {
  double inverse_squares = 0.0, oscillates = 0.0, viscous = 0.0, conducts = 0.0;
  for (int a = 0; a < Dim; ++a) inverse_squares += 1.0 / (grid_.h(a) * grid_.h(a));
  for (Eigen::Index n = 0; n < grid_.size(); ++n) {
    const Local<Dim> here = local(at, n);
    double sound = 0.0, mu = 0.0, carried = 0.0;
    if constexpr (has_heat) {
      sound = speed_of_sound(fluid_.state, here.rho, here.theta, fluid_.c);
      conducts = std::max(conducts, 4.0 * fluid_.K / (here.rho * fluid_.c) * inverse_squares);
    } else {
      sound = speed_of_sound(fluid_.state, here.rho);
    }
    mu = viscosity(fluid_.viscosity, here.theta);
    for (int a = 0; a < Dim; ++a) carried += std::abs(here.v[a]) / grid_.h(a);
    oscillates = std::max(oscillates, carried + sound * std::sqrt(inverse_squares));
    viscous = std::max(viscous, 4.0 * (2.0 + fluid_.lambda_over_mu) * mu / here.rho * inverse_squares);
  }
  using Kind = schemes::TimeScale::Kind;
  std::vector<schemes::TimeScale> all{
      {.name = "sound, carried along", .kind = Kind::oscillates, .seconds = 1.0 / oscillates}};
  if (viscous > 0.0) all.push_back({.name = "viscosity", .kind = Kind::decays, .seconds = 1.0 / viscous});
  if (conducts > 0.0) all.push_back({.name = "conduction", .kind = Kind::decays, .seconds = 1.0 / conducts});
  return all;
}

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
