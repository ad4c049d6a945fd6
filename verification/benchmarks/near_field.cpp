// What the near field's kernels cost: against std::pow pair by pair, against their own arithmetic without loads, with
// the energy in the same pass, and by two threads. Each ratio is the median of pairs that alternate within this run.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <harness/near_field_cloud.hpp>
#include <particulate/laws/detail/near_field_kernels.hpp>

namespace laws = particulate::laws;

double bare_baseline(const laws::detail::PairForce& law, std::int64_t N);
#ifdef __x86_64__
double bare_avx2(const laws::detail::PairForce& law, std::int64_t N);
double bare_avx512(const laws::detail::PairForce& law, std::int64_t N);
#endif

namespace {

using Work = std::function<void()>;

double seconds(const Work& work, int times) {
  const auto start = std::chrono::steady_clock::now();
  for (int k = 0; k < times; ++k) work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / times;
}

double median(std::vector<double> of) {
  std::nth_element(of.begin(), of.begin() + of.size() / 2, of.end());
  return of[of.size() / 2];
}

struct Compared {
  double one, ratio;  // seconds of one; of the other in units of it
};

Compared compare(const Work& one, const Work& other) {
  constexpr int pairs = 9;
  const int times = std::max(1, static_cast<int>(0.02 / seconds(one, 1)));
  const int other_times = std::max(1, static_cast<int>(0.02 / seconds(other, 1)));
  std::vector<double> first, ratio;
  for (int k = 0; k < pairs; ++k) {
    first.push_back(seconds(one, times));
    ratio.push_back(seconds(other, other_times) / first.back());
  }
  return {median(first), median(ratio)};
}

class Field {
 public:
  Field(Eigen::Index N, const laws::NearField& law)
      : scene_(verification::random_cloud({.N = N}, 1), {}, law),
        state_(particulate::scenes::start(scene_)),
        force_(Eigen::VectorXd::Zero(3 * N)),
        law_(law) {}

  void add() { scene_.total_force(state_, force_); }
  void add_both() { scene_.total_force(state_, force_, energy_); }
  // Both forces of every pair from one evaluation.
  void add_plainly() {
    const particulate::kinematics::Particles& all = scene_.particles();
    particulate::schemes::MutableVectorsOf force(force_.data(), all.size(), 3);
    for (Eigen::Index i = 0; i < all.size(); ++i) {
      for (Eigen::Index j = i + 1; j < all.size(); ++j) {
        const Eigen::Vector3d d = all.position.row(j) - all.position.row(i);
        const double length = d.norm(), both = all.mass[i] * all.mass[j];
        const double strength =
            law_.alpha1 * both * std::pow(length, -law_.beta1) - law_.alpha2 * both * std::pow(length, -law_.beta2);
        force.row(i) += strength / length * d;
        force.row(j) -= strength / length * d;
      }
    }
  }

 private:
  verification::NearFieldScene scene_;
  particulate::schemes::State state_;
  Eigen::VectorXd force_;
  laws::NearField law_;
  double energy_ = 0.0;
};

double bare(const laws::NearField& law, Eigen::Index N) {
  const laws::detail::PairForce pair{law.alpha1, law.alpha2, law.beta1, law.beta2, law.d_ref};
#ifdef __x86_64__
  if (law.kernel == laws::Kernel::avx2) return bare_avx2(pair, N);
  if (law.kernel == laws::Kernel::avx512) return bare_avx512(pair, N);
#endif
  return bare_baseline(pair, N);
}

}  // namespace

int main() {
  constexpr Eigen::Index N = 1000, many = 4000;
  fmt::print(
      "ns a pair of {} particles; the same by std::pow, by arithmetic alone, and with the energy, in units of it;\n"
      "and how much faster two threads are with {}: medians of nine alternating pairs of runs.\n\n"
      "{:<10}{:<12}{:>10}{:>10}{:>10}{:>10}{:>10}\n",
      N, many, "kernel", "exponents", "ns", "std::pow", "no loads", "energy", "threads");
  volatile double kept = 0.0;
  for (const laws::Kernel kernel : {laws::Kernel::baseline, laws::Kernel::avx2, laws::Kernel::avx512}) {
    if (!laws::is_available(kernel)) continue;
    for (const auto& [beta1, beta2] : {std::pair{1.0, 2.0}, {2.0, 3.0}, {7.0, 13.0}, {1.5, 2.5}, {-1.0, 2.0}}) {
      laws::NearField law{.alpha1 = 0.5, .alpha2 = 0.25, .beta1 = beta1, .beta2 = beta2, .kernel = kernel};
      Field field(N, law), one(many, law);
      law.threads = 2;
      Field two(many, law);
      const Compared plain = compare([&] { field.add(); }, [&] { field.add_plainly(); });
      const double no_loads = compare([&] { field.add(); }, [&] { kept = bare(law, N); }).ratio;
      const double both = compare([&] { field.add(); }, [&] { field.add_both(); }).ratio;
      const double threads = compare([&] { two.add(); }, [&] { one.add(); }).ratio;
      fmt::print("{:<10}{:<12}{:>10.2f}{:>10.1f}{:>10.2f}{:>10.2f}{:>10.2f}\n", laws::name(kernel),
                 fmt::format("({:g}, {:g})", beta1, beta2), plain.one / (0.5 * N * (N - 1)) * 1e9, plain.ratio,
                 no_loads, both, threads);
    }
  }
}
