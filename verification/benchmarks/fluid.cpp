// What a right-hand side of a liquid with viscosity and heat costs, by each kernel: against a triad that moves 120
// bytes a cell, three streams of five numbers each; against its own time per cell where all fits the cache; without
// heat; and by two threads. Each ratio is the median of pairs that alternate within this run.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <particulate/fluid/flow.hpp>

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
}
