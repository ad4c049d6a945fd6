#include "driver.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "cloud.hpp"
#include "objective.hpp"

namespace {

using Numbers = std::vector<double>;

// Inputs: N n p T lost when w seed. Members fly straight and evenly from one place of a box of 10 m to another; moments
// are T (k/n)^p, and the first ones of the members are lost together.
Numbers of_straight_paths(const Numbers& x) {
  const auto N = static_cast<Eigen::Index>(x[0]), n = static_cast<Eigen::Index>(x[1]);
  const auto at = cloud::shares(static_cast<std::uint64_t>(x[7]), static_cast<std::size_t>(2 * N));
  Eigen::Matrix3Xd share(3, 2 * N);
  for (Eigen::Index i = 0; i < 2 * N; ++i) share.col(i) = Eigen::Vector3d(at[static_cast<std::size_t>(i)].data());
  Flight flight{Eigen::VectorXd(n + 1), {}, std::vector<int>(static_cast<std::size_t>(N), -1)};
  std::fill_n(flight.lost.begin(), static_cast<std::size_t>(x[4]), static_cast<int>(x[5] * x[1]));
  for (Eigen::Index k = 0; k <= n; ++k) {
    const double s = std::pow(static_cast<double>(k) / x[1], x[2]);
    flight.t[k] = x[3] * s;
    flight.place.emplace_back(10.0 * (share.leftCols(N) + s * (share.rightCols(N) - share.leftCols(N))));
  }
  return {objective(flight, {12.0, 5.0, 5.0}, x[6])};
}

// Inputs: n. One member, 10 m from its target, is pulled by 4 m/s^2 until it has 3 m/s, and is recorded for 3 s.
Numbers of_a_capped_fall(const Numbers& x) {
  Flight flight{Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(x[0]) + 1, 0.0, 3.0), {}, {-1}};
  for (const double t : flight.t) {
    const double way = t < 0.75 ? 2.0 * t * t : 1.125 + 3.0 * (t - 0.75);
    flight.place.emplace_back(Eigen::Vector3d(way, 0.0, 0.0));
  }
  return {objective(flight, {10.0, 0.0, 0.0}, 1.0)};
}

}  // namespace

int main(int argc, char** argv) {
  return driver::answer(argc, argv, {{"straight_paths", of_straight_paths}, {"capped_fall", of_a_capped_fall}});
}
