#include <particulate/fluid/hats.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace particulate::fluid {

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
  run_.resize(static_cast<std::size_t>(size() * Dim));
  weight_.resize(run_.size() * room_);
}

template <int Dim>
double Hats<Dim>::period(int axis) const {
  return axis < Dim && periodic_[static_cast<std::size_t>(axis)] ? grid_.lengths[axis]
                                                                 : std::numeric_limits<double>::infinity();
}

template <int Dim>
Columns Hats<Dim>::columns(const double* first, int count) const {
  Columns all{.first = first, .stride = {1, grid_.cells[0], Dim > 1 ? grid_.cells[0] * grid_.cells[1 % Dim] : 0}};
  for (int c = 0; c < count; ++c) all.offset.push_back(c * grid_.size());
  return all;
}

template <int Dim>
bool Hats<Dim>::contains(const Eigen::Vector3d& x) const {
  bool inside = x.allFinite();
  for (int a = 0; a < Dim; ++a) {
    const double into = x[a] - grid_.corner[a];
    inside = inside && (periodic_[static_cast<std::size_t>(a)] || (into >= 0.0 && into <= grid_.lengths[a]));
  }
  return inside;
}

// Strictly within w, in units of cells: at its edge a hat is zero.
template <int Dim>
void Hats<Dim>::place_along(Eigen::Index i, int axis, double x) {
  const auto a = static_cast<std::size_t>(axis);
  const auto n = static_cast<double>(grid_.cells[a]);
  const double h = grid_.h(axis), reach = half_width_[i] / h;
  double s = (x - grid_.corner[axis]) / h - 0.5;
  if (periodic_[a]) s -= n * std::floor(s / n);
  double low = std::floor(s - reach) + 1.0, high = std::ceil(s + reach) - 1.0;
  if (!periodic_[a]) low = std::max(low, 0.0), high = std::min(high, n - 1.0);
  // A hat as wide as the box by roundings would meet a cell twice.
  high = std::min(high, low + n - 1.0);
  Run& run = run_[static_cast<std::size_t>(i * Dim + axis)];
  const auto first = static_cast<int>(low), cells = static_cast<int>(grid_.cells[a]);
  run.count = static_cast<int>(high - low) + 1;
  run.first = first < 0 ? first + cells : first >= cells ? first - cells : first;
  double* const w = weight_.data() + (static_cast<std::size_t>(i) * Dim + a) * room_;
  double sum = 0.0;
  for (int m = 0; m < run.count; ++m) sum += w[m] = std::max(0.0, 1.0 - std::abs(low + m - s) / reach);
  for (int m = 0; m < run.count; ++m) w[m] /= sum;
}

template <int Dim>
bool Hats<Dim>::place(schemes::In r) {
  const Eigen::Index N = size();
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
auto Hats<Dim>::pieces(Eigen::Index i) const -> std::array<Piece, 2> {
  const Run& along = run(i, 0);
  const int before = std::min(along.count, static_cast<int>(grid_.cells[0]) - along.first);
  return {{{along.first, 0, before}, {0, before, along.count - before}}};
}

template <int Dim>
template <class Visit>
void Hats<Dim>::visit_rows(Eigen::Index i, const Visit& visit) const {
  const auto next = [&](int cell, int axis) {
    return cell + 1 == static_cast<int>(grid_.cells[static_cast<std::size_t>(axis)]) ? 0 : cell + 1;
  };
  if constexpr (Dim == 1) {
    visit(0, 0, 1.0);
  } else {
    constexpr int last = Dim - 1;
    const Run across = run(i, 1), up = run(i, last);
    int k = Dim == 3 ? up.first : 0;
    for (int p = 0; p < (Dim == 3 ? up.count : 1); ++p, k = next(k, last)) {
      const double above = Dim == 3 ? weights(i, last)[p] : 1.0;
      int j = across.first;
      for (int o = 0; o < across.count; ++o, j = next(j, 1)) visit(j, k, above * weights(i, 1)[o]);
    }
  }
}

template <int Dim>
void Hats<Dim>::gather(const Columns& from, double* out) const {
  const auto columns = static_cast<Eigen::Index>(from.offset.size());
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (Eigen::Index i = 0; i < size(); ++i) {
    double* const sum = out + i * columns;
    std::fill_n(sum, columns, 0.0);
    const std::array<Piece, 2> along = pieces(i);
    const double* const x = weights(i, 0);
    visit_rows(i, [&](int j, int k, double weight) {
      const double* const row = from.first + j * from.stride[1] + k * from.stride[2];
      for (Eigen::Index c = 0; c < columns; ++c) {
        const double* const column = row + from.offset[static_cast<std::size_t>(c)];
        double all = 0.0;
        for (const Piece& piece : along) {
          for (int m = 0; m < piece.count; ++m) all += x[piece.weight + m] * column[piece.cell + m];
        }
        sum[c] += weight * all;
      }
    });
  }
}

// Each thread has planes of its own, across the last direction, and adds what all places give to them, in the order of
// the places: so the sums do not know how many there are.
template <int Dim>
void Hats<Dim>::spread(const double* from, Eigen::Index apart, int count, double scale, double* to) const {
  const Eigen::Index n = grid_.cells[0], rows = Dim > 1 ? grid_.cells[1 % Dim] : 1, cells = grid_.size();
  const Eigen::Index planes = Dim == 3 ? grid_.cells[Dim - 1] : Dim == 2 ? rows : 1;
  const int sharing = Dim == 1 ? 1 : threads_;
#pragma omp parallel for schedule(static, 1) num_threads(sharing) if (sharing > 1)
  for (int thread = 0; thread < sharing; ++thread) {
    const Eigen::Index begin = planes * thread / sharing, end = planes * (thread + 1) / sharing;
    for (Eigen::Index i = 0; i < size(); ++i) {
      const std::array<Piece, 2> along = pieces(i);
      const double* const x = weights(i, 0);
      visit_rows(i, [&](int j, int k, double weight) {
        const Eigen::Index plane = Dim == 3 ? k : j;
        if (plane < begin || plane >= end) return;
        double* const row = to + (j + k * rows) * n;
        for (int c = 0; c < count; ++c) {
          const double given = scale * weight * from[i * apart + c];
          double* const column = row + c * cells;
          for (const Piece& piece : along) {
            for (int m = 0; m < piece.count; ++m) column[piece.cell + m] += given * x[piece.weight + m];
          }
        }
      });
    }
  }
}

template class Hats<1>;
template class Hats<2>;
template class Hats<3>;

}  // namespace particulate::fluid
