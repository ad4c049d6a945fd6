// Evaluations per success of pagmo's sade and cmaes on the functions of chapter 5, over 31 seeds, and what an
// evaluation of a cost that takes nothing costs them. Not part of the build: pagmo is no dependency of the library.
//
//     g++ -std=c++20 -O2 -I lib -I verification -I /usr/include/eigen3 \
//         verification/benchmarks/pagmo.cpp lib/particulate/identification/cost.cpp -lpagmo -lboost_serialization -ltbb
//         -lfmt
#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/sade.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>

#include <ch05_identification/test_functions.hpp>

namespace {

using verification::TestFunction;
constexpr double goal = 1e-6;
constexpr unsigned strings = 20;

// A function as pagmo sees it.
struct Udp {
  const TestFunction* f = nullptr;
  pagmo::vector_double fitness(const pagmo::vector_double& x) const {
    return {f->cost(Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()))).cost};
  }
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    return {{f->box.lower.begin(), f->box.lower.end()}, {f->box.upper.begin(), f->box.upper.end()}};
  }
};

// Generation by generation, so that it ends once the goal is met; anew where it stands still for 100 of them.
template <class Make>
long evaluations_to_goal(const TestFunction& f, const Make& make, unsigned seed, long limit) {
  long evaluations = 0;
  for (unsigned start = 0; evaluations < limit; ++start) {
    pagmo::population all(pagmo::problem(Udp{&f}), strings, seed + 1000 * start);
    pagmo::algorithm one = make(seed + 1000 * start);
    double last = INFINITY;
    for (int still = 0; still < 100 && evaluations + static_cast<long>(all.get_problem().get_fevals()) < limit;) {
      all = one.evolve(all);
      const double now = all.champion_f()[0];
      if (now <= goal) return evaluations + static_cast<long>(all.get_problem().get_fevals());
      still = now < last ? 0 : still + 1;
      last = now;
    }
    evaluations += static_cast<long>(all.get_problem().get_fevals());
  }
  return -evaluations;
}

template <class Make>
void compare(const char* name, const TestFunction& f, const Make& make) {
  long total = 0;
  int successes = 0;
  for (unsigned seed = 1; seed <= 31; ++seed) {
    const long one = evaluations_to_goal(f, make, seed, 100'000);
    total += std::abs(one);
    successes += one > 0;
  }
  fmt::print("{:<24}{:<10}{:>4} of 31{:>12.0f} a success\n", f.name, name, successes,
             static_cast<double>(total) / std::max(successes, 1));
}

template <class Make>
double microseconds(const TestFunction& f, const Make& make) {
  std::vector<double> all;
  for (unsigned k = 0; k < 5; ++k) {
    pagmo::population some(pagmo::problem(Udp{&f}), strings, k);
    const auto start = std::chrono::steady_clock::now();
    some = make(k).evolve(some);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    all.push_back(1e6 * seconds / static_cast<double>(some.get_problem().get_fevals() - strings));
  }
  std::nth_element(all.begin(), all.begin() + 2, all.end());
  return all[2];
}

}  // namespace

int main() {
  const auto sade = [](unsigned generations) {
    return [=](unsigned seed) { return pagmo::algorithm(pagmo::sade(generations, 2, 1, 1e-12, 1e-12, true, seed)); };
  };
  const auto cmaes = [](unsigned generations) {
    return [=](unsigned seed) {
      return pagmo::algorithm(pagmo::cmaes(generations, -1, -1, -1, -1, 0.5, 1e-12, 1e-12, true, true, seed));
    };
  };
  for (const TestFunction& f : {verification::rastrigin(4), verification::rastrigin(4, -3.12, 7.12),
                                verification::rosenbrock(4), verification::ackley(4), verification::terraces(4)}) {
    compare("sade", f, sade(1));
    compare("cmaes", f, cmaes(1));
  }
  const TestFunction free{.name = "free",
                          .cost = [](const Eigen::VectorXd& x) { return x[0]; },
                          .residuals = {},
                          .box = verification::cube(4, -1.0, 1.0),
                          .best_at = -1.0};
  fmt::print("a free evaluation: sade {:.2f} us, cmaes {:.2f} us\n", microseconds(free, sade(2500)),
             microseconds(free, cmaes(2500)));
}
