// What a right-hand side of a liquid with viscosity and heat costs, by each kernel: against a triad that moves 120
// bytes a cell, three streams of five numbers each; against its own time per cell where all fits the cache; without
// heat; and by two threads. Then what particles in it cost: finding their hats, reading the fluid by them and spreading
// what acts, against a loop over the same cells with ready weights; and a right-hand side of a thousand of them on 32^3
// cells, against that of the fluid. Each ratio is the median of pairs that alternate within this run.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <particulate/fluid/suspension.hpp>

using namespace particulate;
using namespace particulate::fluid;

namespace {

using Work = std::function<void()>;

double seconds(const Work& work, int times) {
  const auto start = std::chrono::steady_clock::now();
  for (int k = 0; k < times; ++k) work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / times;
}

double median(std::vector<double> of) {
  std::nth_element(of.begin(), of.begin() + static_cast<std::ptrdiff_t>(of.size() / 2), of.end());
  return of[of.size() / 2];
}

struct Compared {
  double one, ratio;  // seconds of one; of it in units of the other
};

Compared compare(const Work& one, const Work& other) {
  constexpr int pairs = 9;
  const auto times = [](const Work& work) { return std::max(1, static_cast<int>(0.02 / seconds(work, 2))); };
  const int ones = times(one), others = times(other);
  std::vector<double> first, ratio;
  for (int k = 0; k < pairs; ++k) {
    first.push_back(seconds(one, ones));
    ratio.push_back(first.back() / seconds(other, others));
  }
  return {median(first), median(ratio)};
}

template <class F>
class Rate {
 public:
  Rate(Eigen::Index n, laws::Kernel kernel, int threads = 1)
      : flow_({.cells = {n, n, n}}, {}, {}, threads, kernel),
        state_(flow_.start([](const Vector<3>& x) {
          const Vector<3> s = (2.0 * std::numbers::pi * x).array().sin();
          return Local<3>{.rho = 1000.0 + s[0], .v = {s[1], s[2], s[0]}, .theta = 300.0 + s[1]};
        })),
        dy_(Eigen::VectorXd::Zero(state_.y.size())) {}
  void operator()() {
    if (!flow_.rate(0.0, state_.y, dy_)) throw std::runtime_error("there is no rate");
  }

 private:
  F flow_;
  schemes::State state_;
  Eigen::VectorXd dy_;
};

class Triad {
 public:
  explicit Triad(Eigen::Index n) : a_(5 * n * n * n), b_(a_.size()), c_(a_.size()) {
    a_.setZero(), b_.setOnes(), c_.setOnes();
  }
  // Eigen writes it in vectors.
  void operator()() { a_.noalias() = b_ + 3.0 * c_; }

 private:
  Eigen::VectorXd a_, b_, c_;
};

// Particles that drift apart from each other, on a lattice that does not fit the cells.
kinematics::Particles scattered(int along) {
  std::vector<kinematics::Particle> all;
  const double gap = 1.0 / along;
  for (int k = 0; k < along * along * along; ++k) {
    const Eigen::Vector3d node(k % along, k / along % along, k / (along * along));
    const Eigen::Vector3d off = 0.2 * (Eigen::Vector3d(2.1, 3.7, 1.3) * k).array().sin();
    all.push_back({.position = gap * (node + off), .velocity = off, .mass = 0.1, .radius = 0.02});
    all.back().temperature = 600.0, all.back().heat_capacity = 1000.0;
  }
  return kinematics::particles(all);
}

// What is read of a liquid at each particle, density, velocity, temperature and viscosity, and what is spread: impulse
// and power.
constexpr int seen_numbers = 6, given_numbers = 4;

// The library's way, from places on.
class ByHats {
 public:
  ByHats(Eigen::Index n, double w, const kinematics::Particles& particles)
      : hats_(Grid<3>{.cells = {n, n, n}}, {}, Eigen::VectorXd::Constant(particles.size(), w)),
        r_(particles.position.reshaped()),
        from_(Eigen::VectorXd::Ones(seen_numbers * n * n * n)),
        to_(Eigen::VectorXd::Zero(given_numbers * n * n * n)),
        at_(Eigen::VectorXd::Ones(seen_numbers * particles.size())) {}
  void operator()() {
    if (!hats_.place(r_)) throw std::runtime_error("a particle is not in the box");
    hats_.gather(hats_.columns(from_.data(), seen_numbers), at_.data());
    hats_.spread(at_.data(), seen_numbers, given_numbers, 1e-9, to_.data());
  }

 private:
  Hats<3> hats_;
  Eigen::VectorXd r_, from_, to_, at_;
};

// What nobody can leave out: the same cells of each particle, row by row, their weights known before.
class ByReadyWeights {
 public:
  ByReadyWeights(Eigen::Index n, double w, const kinematics::Particles& particles)
      : n_(n),
        from_(Eigen::VectorXd::Ones(seen_numbers * n * n * n)),
        to_(Eigen::VectorXd::Zero(given_numbers * n * n * n)),
        at_(Eigen::VectorXd::Ones(seen_numbers * particles.size())) {
    begin_.push_back(0);
    for (Eigen::Index i = 0; i < particles.size(); ++i) {
      add(particles.position.row(i) * static_cast<double>(n), w * static_cast<double>(n));
      begin_.push_back(row_.size());
    }
  }
  void operator()() {
    for (std::size_t i = 0; i + 1 < begin_.size(); ++i) gather(i);
    for (std::size_t i = 0; i + 1 < begin_.size(); ++i) spread(i);
  }

 private:
  // A run of neighbouring cells along x.
  struct Row {
    Eigen::Index first;
    std::size_t weight;
    int count;
  };
  void add(const Eigen::Vector3d& x, double reach) {
    std::array<std::vector<std::pair<Eigen::Index, double>>, 3> along;
    for (int a = 0; a < 3; ++a) {
      for (auto q = static_cast<Eigen::Index>(std::floor(x[a] - reach)); static_cast<double>(q) <= x[a] + reach; ++q) {
        const double hat = 1.0 - std::abs(x[a] - 0.5 - static_cast<double>(q)) / reach;
        if (hat > 0.0) along[static_cast<std::size_t>(a)].emplace_back((q + n_) % n_, hat / reach);
      }
    }
    for (const auto& [k, up] : along[2]) {
      for (const auto& [j, across] : along[1]) {
        Eigen::Index last = -2;
        for (const auto& [i, hat] : along[0]) {
          if (i != last + 1) row_.push_back({(k * n_ + j) * n_ + i, weight_.size(), 0});
          weight_.push_back(hat * across * up), ++row_.back().count, last = i;
        }
      }
    }
  }
  void gather(std::size_t i) {
    double* const sum = at_.data() + static_cast<Eigen::Index>(i) * seen_numbers;
    std::fill_n(sum, seen_numbers, 0.0);
    for (std::size_t r = begin_[i]; r < begin_[i + 1]; ++r) {
      const double* const w = weight_.data() + row_[r].weight;
      for (int c = 0; c < seen_numbers; ++c) {
        const double* const column = from_.data() + c * n_ * n_ * n_ + row_[r].first;
        double all = 0.0;
        for (int m = 0; m < row_[r].count; ++m) all += w[m] * column[m];
        sum[c] += all;
      }
    }
  }
  void spread(std::size_t i) {
    const double* const from = at_.data() + static_cast<Eigen::Index>(i) * seen_numbers;
    for (std::size_t r = begin_[i]; r < begin_[i + 1]; ++r) {
      const double* const w = weight_.data() + row_[r].weight;
      for (int c = 0; c < given_numbers; ++c) {
        const double amount = 1e-9 * from[c];
        double* const column = to_.data() + c * n_ * n_ * n_ + row_[r].first;
        for (int m = 0; m < row_[r].count; ++m) column[m] += amount * w[m];
      }
    }
  }

  Eigen::Index n_;
  std::vector<std::size_t> begin_;
  std::vector<Row> row_;
  std::vector<double> weight_;
  Eigen::VectorXd from_, to_, at_;
};

void measure_hats(Eigen::Index n, double cells_wide, const kinematics::Particles& particles) {
  const double w = cells_wide / static_cast<double>(n);
  ByHats ours(n, w, particles);
  ByReadyWeights bare(n, w, particles);
  const Compared seen = compare(std::ref(ours), std::ref(bare));
  fmt::print("{:>6}^3{:>12}{:>12.2f}{:>12.2f}\n", n, cells_wide, seen.one / static_cast<double>(particles.size()) * 1e9,
             seen.ratio);
}

template <class S>
Work rate_of(const S& suspension, schemes::State at) {
  return [&suspension, at, a = Eigen::VectorXd(at.r.size()), dy = Eigen::VectorXd(at.y.size())]() mutable {
    if (!suspension.rates(0.0, at.r, at.v, at.y, a, dy)) throw std::runtime_error("there is no rate");
  };
}
void measure_suspension(double w, int threads) {
  const LiquidFlow<3> flow(Grid<3>{.cells = {32, 32, 32}}, {}, {}, threads);
  const Suspension with(flow, scattered(10), Spreading{.w = w}, HeatExchange{.h_c = 1.0});
  const Suspension without(flow, kinematics::Particles{}, Spreading{}, HeatExchange{.h_c = 1.0});
  const auto rest = [](const Vector<3>&) { return Local<3>{.rho = 1000.0}; };
  const Compared seen = compare(rate_of(with, with.start(rest)), rate_of(without, without.start(rest)));
  fmt::print("{:>12}{:>12}{:>12.2f}{:>12.2f}\n", w, threads, seen.one * 1e3, seen.ratio);
}

void measure(laws::Kernel kernel, Eigen::Index n) {
  Rate<LiquidFlow<3>> small(16, kernel), flow(n, kernel), shared(n, kernel, 2);
  Rate<BarotropicFlow<3>> cold(n, kernel);
  Triad triad(n);
  const auto cells = static_cast<double>(n * n * n);
  const Compared moved = compare(std::ref(flow), std::ref(triad));
  const double cache = compare(std::ref(flow), std::ref(small)).ratio / cells * 4096.0;
  const double heatless = compare(std::ref(cold), std::ref(flow)).ratio;
  const double threads = compare(std::ref(flow), std::ref(shared)).ratio;
  fmt::print("{:<10}{:>6}^3{:>12.2f}{:>12.2f}{:>12.2f}{:>12.2f}{:>12.2f}\n", laws::name(kernel), n,
             moved.one / cells * 1e9, moved.ratio, cache, heatless, threads);
}

}  // namespace

int main() {
  fmt::print(
      "ns a cell of a right-hand side with viscosity and heat; the same in units of a triad of 120 bytes a cell, and "
      "of\n"
      "its own time at 16^3; without heat, in units of it; and how much faster two threads are: medians of nine\n"
      "alternating pairs of runs.\n\n"
      "{:<10}{:>8}{:>12}{:>12}{:>12}{:>12}{:>12}\n",
      "kernel", "cells", "ns", "triad", "cache", "no heat", "threads");
  for (const laws::Kernel kernel : {laws::Kernel::baseline, laws::Kernel::avx2, laws::Kernel::avx512}) {
    if (!laws::is_available(kernel)) continue;
    for (const Eigen::Index n : {16, 64, 128}) measure(kernel, n);
  }
  fmt::print(
      "\nns a particle to place its hat, read {} numbers and spread {}; the same in units of ready weights.\n\n"
      "{:>8}{:>12}{:>12}{:>12}\n",
      seen_numbers, given_numbers, "cells", "w/h", "ns", "ready");
  for (const double cells_wide : {1.0, 2.0, 4.0}) measure_hats(32, cells_wide, scattered(10));
  fmt::print(
      "\nms of a right-hand side with 1000 particles on 32^3 cells; the same in units of that without.\n\n"
      "{:>12}{:>12}{:>12}{:>12}\n",
      "w", "threads", "ms", "without");
  for (const double w : {1.0 / 32.0, 0.125}) {
    for (const int threads : {1, 2}) measure_suspension(w, threads);
  }
}
