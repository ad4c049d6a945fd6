#include <particulate/fluid/hats.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace particulate::fluid {

namespace hats {

// std::floor, which the baseline of the architecture has no instruction for, of what is no larger than a grid.
int whole_below(double x) {
  const int towards_zero = static_cast<int>(x);
  return towards_zero - (x < towards_zero ? 1 : 0);
}

// The rows of cells of one place: across, then plane by plane. Planes before `begin` and from `end` on are left out.
struct Block {
  const int *row, *plane;
  const double *row_weight, *plane_weight;
  int rows, planes;
  Eigen::Index row_stride, plane_stride;
  int begin = 0, end = std::numeric_limits<int>::max();
};

constexpr int no_cell = 0;
constexpr double whole = 1.0;

// In fewer than three directions there is one row a plane, or one row.
template <int Dim, class RunOf>
Block block_of(const RunOf& run, const std::array<Eigen::Index, 3>& stride) {
  Block all{&no_cell, &no_cell, &whole, &whole, 1, 1, 0, 0};
  if constexpr (Dim > 1) {
    const auto up = run(Dim - 1);
    all.plane = up.cell, all.plane_weight = up.weight, all.planes = up.count, all.plane_stride = stride[Dim - 1];
  }
  if constexpr (Dim > 2) {
    const auto across = run(1);
    all.row = across.cell, all.row_weight = across.weight, all.rows = across.count, all.row_stride = stride[1];
  }
  return all;
}

// Up to so many cells along x at once, a number that the compiler knows.
constexpr int longest = 8;
template <int n>
using Cells = Eigen::Array<double, n, 1>;

template <int n>
void read_cells(const double* first, std::span<const Eigen::Index> columns, const double* x, const Block& block,
                double* out) {
  const Cells<n> along = Eigen::Map<const Cells<n>>(x);
  for (const Eigen::Index column : columns) {
    Cells<n> sum = Cells<n>::Zero();
    for (int k = 0; k < block.planes; ++k) {
      const double* const plane = first + column + block.plane[k] * block.plane_stride;
      for (int j = 0; j < block.rows; ++j) {
        const double weight = block.plane_weight[k] * block.row_weight[j];
        sum += weight * Eigen::Map<const Cells<n>>(plane + block.row[j] * block.row_stride);
      }
    }
    *out++ += (sum * along).sum();
  }
}

template <int n>
void add_to_cells(double* first, std::span<const double> values, double scale, Eigen::Index apart, const double* x,
                  const Block& block) {
  for (const double value : values) {
    const Cells<n> along = scale * value * Eigen::Map<const Cells<n>>(x);
    for (int k = 0; k < block.planes; ++k) {
      if (block.plane[k] < block.begin || block.plane[k] >= block.end) continue;
      double* const plane = first + block.plane[k] * block.plane_stride;
      for (int j = 0; j < block.rows; ++j) {
        const double weight = block.plane_weight[k] * block.row_weight[j];
        Eigen::Map<Cells<n>>(plane + block.row[j] * block.row_stride) += weight * along;
      }
    }
    first += apart;
  }
}

constexpr std::array reads = {read_cells<1>, read_cells<2>, read_cells<3>, read_cells<4>,
                              read_cells<5>, read_cells<6>, read_cells<7>, read_cells<8>};
constexpr std::array adds = {add_to_cells<1>, add_to_cells<2>, add_to_cells<3>, add_to_cells<4>,
                             add_to_cells<5>, add_to_cells<6>, add_to_cells<7>, add_to_cells<8>};

// Calls with the first cell, the weights and the number of cells that follow one another along x.
template <class Visit>
void for_pieces(const detail::Run& along, const Visit& visit) {
  for (int from = 0, m = 1; from < along.count; ++m) {
    if (m < along.count && m - from < longest && along.cell[m] == along.cell[m - 1] + 1) continue;
    visit(along.cell[from], along.weight + from, m - from);
    from = m;
  }
}

}  // namespace hats

template <int Dim>
Hats<Dim>::Hats(const Grid<Dim>& grid, const Boundaries<Dim>& boundaries, Eigen::VectorXd half_width, int threads)
    : grid_(grid), half_width_(std::move(half_width)), threads_(threads) {
  validate(grid_);
  double largest = 0.0;
  for (int a = 0; a < Dim; ++a) {
    periodic_[static_cast<std::size_t>(a)] =
        std::holds_alternative<Periodic>(boundaries[static_cast<std::size_t>(2 * a)]);
    largest = std::max(largest, grid_.h(a));
  }
  if (threads < 1 || threads > 1024) {
    throw std::invalid_argument(fmt::format("hats: threads must be from 1 to 1024, got {}", threads));
  }
  const double half = 0.5 * grid_.lengths.minCoeff();
  for (Eigen::Index i = 0; i < size(); ++i) {
    const double w = half_width_[i];
    // A hat as wide as a cell by design may come out narrower by roundings.
    if (w >= largest * (1.0 - 1e-12) && w <= half * (1.0 + 1e-12)) continue;
    throw std::invalid_argument(fmt::format(
        "hats: the half-width w must lie between the largest edge of a cell, {:.6g} m, and half the shortest edge of "
        "the box, {:.6g} m, got {:.6g} m for particle {}: {}",
        largest, half, w, i, w < largest ? "take smaller cells, or a larger w" : "take a larger box, or a smaller w"));
  }
  for (int a = 0; a < Dim && size() > 0; ++a) {
    const double cells = 2.0 * half_width_.maxCoeff() / grid_.h(a);
    room_ = std::max(room_, static_cast<std::size_t>(std::ceil(cells)) + 1);
  }
  count_.resize(static_cast<std::size_t>(size() * Dim));
  cell_.resize(count_.size() * room_);
  weight_.resize(cell_.size());
}

template <int Dim>
Columns Hats<Dim>::columns(const double* first, int count) const {
  Columns all{.first = first, .stride = {1, grid_.cells[0], Dim > 1 ? grid_.cells[0] * grid_.cells[1 % Dim] : 0}};
  for (; all.count < count; ++all.count) all.offset[static_cast<std::size_t>(all.count)] = all.count * grid_.size();
  return all;
}

template <int Dim>
bool Hats<Dim>::contains(const Eigen::Vector3d& x) const {
  bool inside = x.allFinite();
  for (int a = 0; a < Dim; ++a) {
    const double into = x[a] - grid_.corner[a];
    // Farther away a double does not know in which cell a place is.
    const bool near = std::abs(into) < 4e15 * grid_.h(a);
    inside = inside && near && (periodic_[static_cast<std::size_t>(a)] || (into >= 0.0 && into <= grid_.lengths[a]));
  }
  return inside;
}

// Strictly within w, in units of cells: at its edge a hat is zero.
template <int Dim>
void Hats<Dim>::place_along(Eigen::Index i, int axis, double x) {
  const auto a = static_cast<std::size_t>(axis);
  const int cells = static_cast<int>(grid_.cells[a]);
  const double n = cells, over_h = n / grid_.lengths[axis], reach = half_width_[i] * over_h, slope = 1.0 / reach;
  double s = (x - grid_.corner[axis]) * over_h - 0.5;
  if (periodic_[a] && !(s >= 0.0 && s < n)) s -= n * std::floor(s / n);
  int low = hats::whole_below(s - reach) + 1, high = -hats::whole_below(-s - reach) - 1;
  if (!periodic_[a]) low = std::max(low, 0), high = std::min(high, cells - 1);
  // A hat as wide as the box by roundings would meet a cell twice.
  high = std::min(high, low + cells - 1);
  const std::size_t at = static_cast<std::size_t>(i) * Dim + a;
  int* const cell = cell_.data() + at * room_;
  double* const weight = weight_.data() + at * room_;
  double sum = 0.0;
  for (int q = low; q <= high; ++q) {
    cell[q - low] = q < 0 ? q + cells : q >= cells ? q - cells : q;
    sum += weight[q - low] = std::max(0.0, 1.0 - slope * std::abs(q - s));
  }
  count_[at] = high - low + 1;
  const double over = 1.0 / sum;
  for (int m = 0; m < count_[at]; ++m) weight[m] *= over;
}

template <int Dim>
bool Hats<Dim>::place(schemes::In r) {
  const Eigen::Index N = size();
  if (r.size() != 3 * N) {
    throw std::invalid_argument(
        fmt::format("hats: {} places must hold {} numbers, whatever directions there are, got {}", N, 3 * N, r.size()));
  }
  double outside = 0.0;
#pragma omp parallel for schedule(static) reduction(+ : outside) num_threads(threads_) if (threads_ > 1)
  for (Eigen::Index i = 0; i < N; ++i) {
    if (contains({r[i], r[i + N], r[i + 2 * N]})) {
      for (int a = 0; a < Dim; ++a) place_along(i, a, r[i + a * N]);
    } else {
      outside += 1.0;
    }
  }
  return outside == 0.0;
}

template <int Dim>
void Hats<Dim>::gather(const Columns& from, double* out) const {
  const std::span<const Eigen::Index> offsets(from.offset.data(), static_cast<std::size_t>(from.count));
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (Eigen::Index i = 0; i < size(); ++i) {
    const hats::Block block = hats::block_of<Dim>([&](int axis) { return run(i, axis); }, from.stride);
    double* const sum = out + i * from.count;
    std::fill_n(sum, from.count, 0.0);
    hats::for_pieces(run(i, 0), [&](int cell, const double* x, int cells) {
      hats::reads[static_cast<std::size_t>(cells - 1)](from.first + cell, offsets, x, block, sum);
    });
  }
}

// Each thread has planes of its own, across the last direction, and adds what all places give to them, in the order of
// the places: so the sums do not know how many there are.
template <int Dim>
void Hats<Dim>::spread(const double* from, Eigen::Index apart, int count, double scale, double* to) const {
  const std::array<Eigen::Index, 3> stride = columns(to, 0).stride;
  const int planes = Dim == 1 ? 1 : static_cast<int>(grid_.cells[Dim - 1]), sharing = Dim == 1 ? 1 : threads_;
#pragma omp parallel for schedule(static, 1) num_threads(sharing) if (sharing > 1)
  for (int thread = 0; thread < sharing; ++thread) {
    for (Eigen::Index i = 0; i < size(); ++i) {
      hats::Block block = hats::block_of<Dim>([&](int axis) { return run(i, axis); }, stride);
      block.begin = planes * thread / sharing, block.end = planes * (thread + 1) / sharing;
      const std::span<const double> values(from + i * apart, static_cast<std::size_t>(count));
      hats::for_pieces(run(i, 0), [&](int cell, const double* x, int cells) {
        hats::adds[static_cast<std::size_t>(cells - 1)](to + cell, values, scale, grid_.size(), x, block);
      });
    }
  }
}

template class Hats<1>;
template class Hats<2>;
template class Hats<3>;

}  // namespace particulate::fluid
