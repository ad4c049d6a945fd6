#include "driver.hpp"

#include <cstdint>
#include <random>

#include "cloud.hpp"
#include "mating.hpp"

namespace {

using Numbers = std::vector<double>;

Uniform uniform_from(std::mt19937_64& engine) {
  return [&engine] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
}

std::uint64_t seed_of(double number) { return static_cast<std::uint64_t>(number); }

// Inputs: K S spread seed. How many parameters and strings there are afterwards, the strings before, the strings after.
// Parents have three parameters, which differ by up to the spread; what is to be replaced lies far from them. Those of
// spread 0 are the number below 1, whose last digit is odd: sums half way to a neighbour are rounded to the neighbour.
Numbers mated_once(const Numbers& x) {
  const auto K = static_cast<Eigen::Index>(x[0]), S = static_cast<Eigen::Index>(x[1]);
  const auto at = cloud::shares(seed_of(x[3]), static_cast<std::size_t>(S));
  Eigen::MatrixXd before(3, S);
  for (Eigen::Index n = 0; n < S; ++n) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      const double share = at[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)];
      before(k, n) = 1.0 - 0x1p-53 + x[2] * share + (n < K ? 0.0 : 9.0);
    }
  }
  Eigen::MatrixXd after = before;
  std::mt19937_64 engine(seed_of(x[3] + 1.0));
  mate(after, K, uniform_from(engine));
  Numbers all{static_cast<double>(after.rows()), static_cast<double>(after.cols())};
  if (after.rows() != 3 || after.cols() != S) after = before;
  for (const Eigen::MatrixXd& strings : {before, after}) all.insert(all.end(), strings.data(), strings.data() + 3 * S);
  return all;
}

// Inputs: K calls seed. The mean over the first child, the third, and so on, of calls whose parents have parameters of
// 1 or -1 by chance: each is independent of the others, and may be judged together with the child behind it.
template <class Of>
Numbers mean(const Numbers& x, const Of& of) {
  const auto K = static_cast<Eigen::Index>(x[0]);
  std::mt19937_64 signs(seed_of(x[2])), engine(seed_of(x[2] + 1.0));
  const Uniform uniform = uniform_from(engine);
  double sum = 0.0;
  for (double call = 0.0; call < x[1]; call += 1.0) {
    Eigen::MatrixXd strings = Eigen::MatrixXd::Zero(2, 2 * K);
    for (Eigen::Index n = 0; n < 2 * K; ++n) strings(n % 2, n / 2) = signs() >> 63 ? 1.0 : -1.0;
    mate(strings, K, uniform);
    for (Eigen::Index n = K; n < 2 * K; n += 2) sum += of(strings.col(n), strings.col(n + 1));
  }
  return {2.0 * sum / (x[0] * x[1])};
}

}  // namespace

int main(int argc, char** argv) {
  return driver::answer(
      argc, argv,
      {{"mate", mated_once},
       {"mean_of_squares",
        [](const Numbers& x) { return mean(x, [](const auto& c, const auto&) { return c[0] * c[0]; }); }},
       {"mean_of_squares_of_two_parameters",
        [](const Numbers& x) { return mean(x, [](const auto& c, const auto&) { return c[0] * c[0] * c[1] * c[1]; }); }},
       {"mean_product_of_two_children",
        [](const Numbers& x) { return mean(x, [](const auto& c, const auto& next) { return c[0] * next[0]; }); }}});
}
