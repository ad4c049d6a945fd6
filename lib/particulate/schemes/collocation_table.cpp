#include <particulate/schemes/collocation_table.hpp>

#include <cstddef>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace particulate::schemes {

namespace {

using Extended = long double;
using ExtendedVector = Eigen::Matrix<Extended, Eigen::Dynamic, 1>;
using ExtendedMatrix = Eigen::Matrix<Extended, Eigen::Dynamic, Eigen::Dynamic>;

void require_stages(int s) {
  if (s < 1 || s > 16) throw std::invalid_argument(fmt::format("collocation: stages must be 1 to 16, got {}", s));
}

// P_s and P_{s-1} at x.
std::pair<Extended, Extended> legendre(int s, Extended x) {
  Extended p = 1.0L, previous = 0.0L;
  for (int k = 1; k <= s; ++k) {
    const Extended next = ((2 * k - 1) * x * p - (k - 1) * previous) / k;
    previous = std::exchange(p, next);
  }
  return {p, previous};
}

// All zeros in (0, 1) of a function of x = 2 c - 1, told apart by a grid and halved down to neighbouring numbers.
template <class Function>
std::vector<Extended> zeros(const Function& f) {
  constexpr int grid = 1000;  // the zeros of degree 16 lie more than five of its cells apart
  std::vector<Extended> found;
  for (int cell = 0; cell < grid; ++cell) {
    Extended low = static_cast<Extended>(cell) / grid, high = static_cast<Extended>(cell + 1) / grid;
    const auto positive = [&](Extended at) { return f(2.0L * at - 1.0L) > 0.0L; };
    const bool before = positive(low);
    if (before == positive(high)) continue;
    for (Extended middle = (low + high) / 2.0L; low < middle && middle < high; middle = (low + high) / 2.0L) {
      (positive(middle) == before ? low : high) = middle;
    }
    found.push_back(high);
  }
  return found;
}

struct Quadrature {
  ExtendedVector x, w;
};

// On [0, 1]: w = 1/((1 - x^2) P_s'(x)^2) in the variable of [-1, 1], halved twice.
Quadrature gauss_quadrature(int s) {
  const std::vector<Extended> nodes = gauss_nodes(s);
  Quadrature of{.x = ExtendedVector(s), .w = ExtendedVector(s)};
  for (int k = 0; k < s; ++k) {
    const Extended x = 2.0L * nodes[static_cast<std::size_t>(k)] - 1.0L;
    const auto [p, previous] = legendre(s, x);
    const Extended slope = s * (previous - x * p) / (1.0L - x * x);
    of.x[k] = nodes[static_cast<std::size_t>(k)];
    of.w[k] = 1.0L / ((1.0L - x * x) * slope * slope);
  }
  return of;
}

void require_nodes(const ExtendedVector& c) {
  for (Eigen::Index j = 0; j < c.size(); ++j) {
    if (!(c[j] > (j > 0 ? c[j - 1] : 0.0L) && c[j] <= 1.0L)) {
      throw std::invalid_argument(fmt::format("collocation: nodes must rise within (0, 1], got {} as number {}",
                                              static_cast<double>(c[j]), j + 1));
    }
  }
}

}  // namespace

std::vector<long double> gauss_nodes(int s) {
  require_stages(s);
  if (s == 1) return {0.5L};  // a zero on the grid
  std::vector<Extended> nodes = zeros([s](Extended x) { return legendre(s, x).first; });
  for (std::size_t j = 0; j < nodes.size() / 2; ++j) nodes[nodes.size() - 1 - j] = 1.0L - nodes[j];
  if (s % 2 == 1) nodes[nodes.size() / 2] = 0.5L;
  return nodes;
}

std::vector<long double> radau_nodes(int s) {
  require_stages(s);
  // Divided by x - 1, so that the zero at the end of the interval is none of those looked for.
  std::vector<Extended> nodes = s == 1 ? std::vector<Extended>() : zeros([s](Extended x) {
    const auto [p, previous] = legendre(s, x);
    return x < 1.0L ? (p - previous) / (x - 1.0L) : static_cast<Extended>(s);
  });
  nodes.push_back(1.0L);
  return nodes;
}

CollocationTable collocation_table(const std::vector<long double>& nodes) {
  const auto s = static_cast<Eigen::Index>(nodes.size());
  require_stages(static_cast<int>(s));
  const ExtendedVector c = Eigen::Map<const ExtendedVector>(nodes.data(), s);
  require_nodes(c);
  ExtendedVector top = ExtendedVector::Ones(s);
  for (Eigen::Index j = 0; j < s; ++j) {
    for (Eigen::Index m = 0; m < s; ++m) {
      if (m != j) top[j] /= c[j] - c[m];
    }
  }
  const Quadrature quadrature = gauss_quadrature(static_cast<int>(s));
  const auto integrals = [&](Extended theta) {
    ExtendedVector sum = ExtendedVector::Zero(s);
    for (Eigen::Index k = 0; k < s; ++k) {
      for (Eigen::Index j = 0; j < s; ++j) {
        Extended l = top[j];
        for (Eigen::Index m = 0; m < s; ++m) l *= m == j ? 1.0L : theta * quadrature.x[k] - c[m];
        sum[j] += theta * quadrature.w[k] * l;
      }
    }
    return sum;
  };
  ExtendedMatrix A(s, s);
  for (Eigen::Index i = 0; i < s; ++i) A.row(i) = integrals(c[i]).transpose();
  const ExtendedVector b = integrals(1.0L);
  const ExtendedMatrix A_bar = A * A;
  const ExtendedVector b_bar = A.transpose() * b;
  return {.c = c.cast<double>(),
          .b = b.cast<double>(),
          .A = A.cast<double>(),
          .b_bar = b_bar.cast<double>(),
          .A_bar = A_bar.cast<double>(),
          .top = top.cast<double>(),
          .x = quadrature.x.cast<double>(),
          .w = quadrature.w.cast<double>()};
}

StageWeights CollocationTable::basis(double theta) const {
  const Eigen::Index s = stages();
  StageWeights l = top;
  double before = 1.0, behind = 1.0;
  for (Eigen::Index j = 0; j < s; ++j) {
    l[j] *= before;
    before *= theta - c[j];
    l[s - 1 - j] *= behind;
    behind *= theta - c[s - 1 - j];
  }
  return l;
}

StageWeights CollocationTable::once(double theta) const {
  StageWeights sum = StageWeights::Zero(stages());
  for (Eigen::Index m = 0; m < stages(); ++m) sum += w[m] * basis(theta * x[m]);
  return theta * sum;
}

StageWeights CollocationTable::twice(double theta) const {
  const StageWeights at = once(theta);
  StageWeights sum = StageWeights::Zero(stages());
  for (Eigen::Index j = 0; j < stages(); ++j) sum += at[j] * A.row(j).transpose();
  return sum;
}

}  // namespace particulate::schemes
