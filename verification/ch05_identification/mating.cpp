// What mating does to the spread of a population: theory of random numbers against the library's children.

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

#include <harness/case.hpp>
#include <particulate/identification/genetic_algorithm.hpp>
#include <particulate/identification/mating.hpp>

#include "test_functions.hpp"

namespace verification::mating {

using namespace particulate::identification;

// Values of independent repeats against their expectation.
void compare_mean(Rows& rows, const std::string& quantity, double expected, const Eigen::ArrayXd& x) {
  const double n = static_cast<double>(x.size());
  rows.compare(quantity,
               {.expected = expected,
                .computed = x.mean(),
                .tolerance = absolute(4.0 * std::sqrt((x - x.mean()).square().sum() / (n * (n - 1.0)))),
                .because = fmt::format("four standard errors, from the scatter of {:.0f} independent repeats", n)});
}

// A repeat is a pair of parents with components of unit variance, and the mean over its two children.
struct Moments {
  Eigen::ArrayXd first, second, mixed;  // of a_1 c_1, of c_1^2 and of c_1^2 c_2^2
};
template <class Mate>
Moments moments(std::uint64_t seed, Eigen::Index pairs, const Mate& mate) {
  boost::random::mt19937_64 engine(seed);
  boost::random::uniform_01<double> uniform;
  const auto parent = [&] {
    return Eigen::Vector2d::NullaryExpr([&] { return std::sqrt(12.0) * (uniform(engine) - 0.5); });
  };
  Moments all{.first = Eigen::ArrayXd(pairs), .second = Eigen::ArrayXd(pairs), .mixed = Eigen::ArrayXd(pairs)};
  for (Eigen::Index k = 0; k < pairs; ++k) {
    const Eigen::VectorXd a = parent(), b = parent(), one = mate(a, b, engine), other = mate(a, b, engine);
    all.first[k] = 0.5 * a[0] * (one[0] + other[0]);
    all.second[k] = 0.5 * (one[0] * one[0] + other[0] * other[0]);
    all.mixed[k] = 0.5 * (one.array().square().prod() + other.array().square().prod());
  }
  return all;
}

const Case random_pairs{
    {.name = "mating_of_random_pairs",
     .claim = "children of randomly paired parents have 2/3 of their variance, and components that are independent: "
              "4/9, where a shared Phi would give 7/15",
     .equation = "R 5.1",
     .reference = Reference::statistics},
    [](Rows& rows) {
      const Eigen::Index pairs = rows.quick() ? 200'000 : 2'000'000;
      boost::random::uniform_01<double> uniform;
      const Moments own = moments(rows.case_seed(), pairs, [&](const auto& a, const auto& b, auto& engine) {
        return mated(a, b, [&] { return uniform(engine); });
      });
      compare_mean(rows, "covariance with the first parent over its variance", 0.5, own.first);
      compare_mean(rows, "variance of children over that of parents", 2.0 / 3.0, own.second);
      compare_mean(rows, "E[c1^2 c2^2] over the square of that variance", 4.0 / 9.0, own.mixed);
      const Moments shared = moments(rows.case_seed() + 1, pairs, [&](const auto& a, const auto& b, auto& engine) {
        const double phi = uniform(engine);
        return mated(a, b, [phi] { return phi; });
      });
      compare_mean(rows, "variance with a Phi that the components share", 2.0 / 3.0, shared.second);
      compare_mean(rows, "E[c1^2 c2^2] with it", 7.0 / 15.0, shared.mixed);
    }};

// With S = 2K and the parameter itself as its cost, the K parents are, over the next one in rank, independent and
// uniform in [0, 1], but in order: mates are neighbours, 12/((K+1)(K+2)) short of fully correlated.
Eigen::ArrayXd spread_of_children(std::uint64_t seed, Eigen::Index K, Eigen::Index repeats) {
  const GeneticAlgorithm algorithm{.S = 2 * K, .K = K};
  const Box box = cube(1, 0.0, 1.0);
  Eigen::ArrayXd spread(repeats);
  for (Eigen::Index n = 0; n < repeats; ++n) {
    std::vector<double> asked;
    const Cost cost = [&](const Eigen::VectorXd& x) { return asked.emplace_back(x[0]); };
    Population population = first_population(box, algorithm, seed + static_cast<std::uint64_t>(n));
    evolve(cost, box, algorithm, {.generations = 1}, population);
    const double next = population.strings(0, K);
    evolve(cost, box, algorithm, {.generations = 2}, population);
    const Eigen::ArrayXd children = Eigen::Map<Eigen::ArrayXd>(asked.data(), 3 * K).tail(K) / next;
    spread[n] = 12.0 * (children - 0.5).square().mean();
  }
  return spread;
}

const Case neighbours{
    {.name = "mating_of_neighbours",
     .claim = "children of neighbours in rank keep 1 - 4/((K+1)(K+2)) of the variance: 2/3 for two parents, nearly all "
              "for many",
     .equation = "R 5.1",
     .reference = Reference::statistics},
    [](Rows& rows) {
      for (const Eigen::Index K : {2, 6, 20, 60}) {
        const double k = static_cast<double>(K);
        compare_mean(rows, fmt::format("variance of children over that of parents, K = {}", K),
                     1.0 - 4.0 / ((k + 1.0) * (k + 2.0)),
                     spread_of_children(rows.case_seed() + static_cast<std::uint64_t>(K) * 1'000'000'000, K,
                                        (rows.quick() ? 60'000 : 600'000) / K));
      }
    }};

const Case span{{.name = "mating_within_the_span",
                 .claim = "no child lies outside the box that its parents span, by a rounding either",
                 .equation = "R 5.1",
                 .reference = Reference::identity},
                [](Rows& rows) {
                  constexpr GeneticAlgorithm algorithm{.S = 20, .K = 6};
                  const TestFunction f = rosenbrock(4);
                  std::vector<Eigen::VectorXd> asked;
                  const Cost cost = [&](const Eigen::VectorXd& x) {
                    asked.push_back(x);
                    return f.cost(x);
                  };
                  Population population = first_population(f.box, algorithm, rows.case_seed());
                  evolve(cost, f.box, algorithm, {.generations = 1}, population);
                  long outside = 0, between = 0;
                  for (long generation = 2; generation <= 500; ++generation) {
                    asked.clear();
                    const Eigen::MatrixXd parents = population.strings.leftCols(6);
                    evolve(cost, f.box, algorithm, {.generations = generation}, population);
                    for (Eigen::Index k = 0; k < 6; ++k) {
                      const Eigen::ArrayXd child = asked[static_cast<std::size_t>(k)], a = parents.col(k - k % 2),
                                           b = parents.col(k - k % 2 + 1);
                      outside += (child < a.min(b)).any() || (child > a.max(b)).any() ? 1 : 0;
                      between += (child > a.min(b)).all() && (child < a.max(b)).all() ? 1 : 0;
                    }
                  }
                  rows.none("children of 499 generations outside the span of ranks 1 and 2, 3 and 4, 5 and 6", outside,
                            "each component is a mean of theirs, kept between them");
                  rows.at_least("children between them in every parameter",
                                {.limit = 30.0,
                                 .computed = static_cast<double>(between),
                                 .because = "those of the first five generations, whose parents are apart"});
                }};

}  // namespace verification::mating
