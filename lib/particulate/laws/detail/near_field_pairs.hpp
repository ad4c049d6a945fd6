#pragma once

// The near field over all pairs j > i, for the instructions that the including source is compiled with.
//
// A Vector is as many doubles as one register holds; +, -, *, / and comparisons act on all of them at once, and
// `mask ? a : b` picks entry by entry (the vector extensions of GCC and Clang). A few particles i, the rows, meet one
// vector of partners j after the other, so that what is loaded and stored for the partners is shared by all rows.
// What is written for a value V below serves a Vector and a plain double alike.

#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstring>
#ifdef __AVX512F__
#include <immintrin.h>
#endif

#include <particulate/laws/detail/near_field_kernels.hpp>

namespace particulate::laws::detail {
namespace {

#if defined(__AVX512F__)
constexpr int lanes = 8;
constexpr int rows = 4;  // as many as the 32 registers hold with their sums
#elif defined(__AVX2__)
constexpr int lanes = 4;
constexpr int rows = 2;  // 16 registers
#else
constexpr int lanes = 2;
constexpr int rows = 2;
#endif
static_assert(padded_to % lanes == 0 && lanes % rows == 0);

using Vector __attribute__((vector_size(lanes * sizeof(double)))) = double;
using Numbers __attribute__((vector_size(lanes * sizeof(double)))) = std::int64_t;

Vector load(const double* from) {
  Vector v{};
  std::memcpy(&v, from, sizeof v);
  return v;
}

void store(Vector v, double* to) { std::memcpy(to, &v, sizeof v); }

// The first entries of a Vector, or the last ones.
template <int n>
using Short __attribute__((vector_size(n * sizeof(double)))) = double;

// Halves are added to one another: three additions one after the other for eight lanes, not seven.
template <int n = lanes>
double sum(Short<n> v) {
  if constexpr (n == 2) {
    return v[0] + v[1];
  } else {
    Short<n / 2> low{}, high{};
    std::memcpy(&low, &v, sizeof low);
    std::memcpy(&high, reinterpret_cast<const char*>(&v) + sizeof low, sizeof high);
    return sum<n / 2>(low + high);
  }
}

double inverse_root(double x) { return 1.0 / std::sqrt(x); }

Vector inverse_root(Vector x) {
#ifdef __AVX512F__
  // The processor's estimate y is good to 2^-14. With h = 1 - x y^2 what is sought is y (1 - h)^(-1/2), and the first
  // five terms of the binomial series leave h^5/4 < 1e-20. It takes half the time of a square root and a division.
  const Vector y = _mm512_maskz_rsqrt14_pd(0xff, x);
  const Vector h = 1.0 - x * (y * y);
  return y + (y * h) * (1.0 / 2.0 + h * (3.0 / 8.0 + h * (5.0 / 16.0 + h * (35.0 / 128.0))));
#else
  Vector root{};
  for (int k = 0; k < lanes; ++k) root[k] = std::sqrt(x[k]);
  return 1.0 / root;
#endif
}

double real_power(double x, double exponent) { return std::pow(x, exponent); }

Vector real_power(Vector x, double exponent) {
  for (int k = 0; k < lanes; ++k) x[k] = std::pow(x[k], exponent);
  return x;
}

// x^exponent for a whole number that is known when this is compiled: nothing but the products is left.
template <int exponent, class V>
V whole_power(V x) {
  if constexpr (exponent == 0) {
    return V{} + 1.0;
  } else if constexpr (exponent % 2 == 1) {
    return x * whole_power<exponent - 1>(x);
  } else {
    const V half = whole_power<exponent / 2>(x);
    return half * half;
  }
}

// Powers of the inverse distance with exponents that are known when this is compiled.
template <int beta1, int beta2>
struct FixedPowers {
  template <class V>
  V first(V inverse) const {
    return whole_power<beta1>(inverse);
  }
  template <class V>
  V second(V inverse) const {
    return whole_power<beta2>(inverse);
  }
};

// Powers with any exponents: by multiplication where they are whole, in the order kinematics::power uses.
class AnyPowers {
 public:
  explicit AnyPowers(const PairForce& law) : beta1_(exponent(law.beta1)), beta2_(exponent(law.beta2)) {}

  template <class V>
  V first(V inverse) const {
    return power(inverse, beta1_);
  }
  template <class V>
  V second(V inverse) const {
    return power(inverse, beta2_);
  }

 private:
  struct Exponent {
    double value;
    int whole;  // -1 if it is not, or is large
  };

  static Exponent exponent(double value) {
    constexpr double largest = 64.0;
    return {value, value <= largest && value == std::floor(value) ? static_cast<int>(value) : -1};
  }

  template <class V>
  static V power(V x, const Exponent& exponent) {
    if (exponent.whole < 0) return real_power(x, exponent.value);
    V product = V{} + 1.0;
    for (int left = exponent.whole; left > 0; left /= 2) {
      if (left % 2 == 1) product *= x;
      x *= x;
    }
    return product;
  }

  Exponent beta1_, beta2_;
};

// Particle i with what its force is multiplied by.
struct Row {
  double x, y, z, alpha1, alpha2;
};

Row row_of(const PairForce& law, const Columns& c, std::int64_t i) {
  return {c.x[i], c.y[i], c.z[i], law.alpha1 * c.factor[i], law.alpha2 * c.factor[i]};
}

// Force on a row's particle over the distance, so that its product with r_j - r_i is the force.
template <class Powers, class V>
V force_over_distance(const Powers& powers, const Row& row, V factor, V square) {
  const V inverse = inverse_root(square);
  const V strength = row.alpha1 * powers.first(inverse) - row.alpha2 * powers.second(inverse);
  return strength * (factor * inverse);
}

// Smallest and largest square of a distance so far.
template <class V>
struct Range {
  V smallest = V{} + 1.0, largest = V{} + 1.0;

  void include(V square) {
    smallest = square < smallest ? square : smallest;
    largest = square > largest ? square : largest;
  }
};

// See is_full() of the near field.
bool is_full(const Range<double>& range) { return range.smallest >= DBL_MIN && range.largest <= DBL_MAX; }

bool is_full(const Range<Vector>& range) {
  bool all = true;
  for (int k = 0; k < lanes; ++k) all = all && is_full(Range<double>{range.smallest[k], range.largest[k]});
  return all;
}

struct Sums {
  Vector x{}, y{}, z{};
};

// The rows from particle i on against the partners from j on. Where some are no pair, because j <= i or j >= N, they
// are given distance 1 and factor 0.
template <bool some_are_no_pair, class Powers>
void meet(const Powers& powers, const Columns& c, const Row* row, std::int64_t i, std::int64_t j, std::int64_t N,
          Sums* action, Range<Vector>& range) {
  const Vector x = load(c.x + j), y = load(c.y + j), z = load(c.z + j), factor = load(c.factor + j);
  Vector reaction_x = load(c.reaction_x + j), reaction_y = load(c.reaction_y + j), reaction_z = load(c.reaction_z + j);
#pragma GCC unroll 4
  for (int k = 0; k < rows; ++k) {
    const Vector dx = x - row[k].x, dy = y - row[k].y, dz = z - row[k].z;
    Vector square = dx * dx + dy * dy + dz * dz, partner = factor;
    if constexpr (some_are_no_pair) {
      Numbers number{};
      for (int lane = 0; lane < lanes; ++lane) number[lane] = j + lane;
      const Numbers is_pair = (number > i + k) & (number < N);
      square = is_pair ? square : Vector{} + 1.0;
      partner = is_pair ? factor : Vector{};
    }
    range.include(square);
    const Vector over_d = force_over_distance(powers, row[k], partner, square);
    action[k].x += over_d * dx, action[k].y += over_d * dy, action[k].z += over_d * dz;
    reaction_x -= over_d * dx, reaction_y -= over_d * dy, reaction_z -= over_d * dz;
  }
  store(reaction_x, c.reaction_x + j), store(reaction_y, c.reaction_y + j), store(reaction_z, c.reaction_z + j);
}

// The rows from particle i on against all partners behind them. Flattened: everything above becomes part of it, and
// rows and sums stay in registers.
template <class Powers>
__attribute__((flatten)) void add_rows(const Powers& powers, const PairForce& law, const Columns& c, std::int64_t i,
                                       std::int64_t N, Range<Vector>& range) {
  Row row[rows];
  Sums action[rows];
  Range<Vector> seen = range;
  for (int k = 0; k < rows; ++k) row[k] = row_of(law, c, i + k);
  std::int64_t j = i / lanes * lanes;
  meet<true>(powers, c, row, i, j, N, action, seen);
  for (j += lanes; j + lanes <= N; j += lanes) meet<false>(powers, c, row, i, j, N, action, seen);
  if (j < N) meet<true>(powers, c, row, i, j, N, action, seen);
  for (int k = 0; k < rows; ++k) {
    c.action_x[i + k] += sum(action[k].x);
    c.action_y[i + k] += sum(action[k].y);
    c.action_z[i + k] += sum(action[k].z);
  }
  range = seen;
}

// The same for one particle and a handful of partners, without vector registers.
template <class Powers>
void add_row(const Powers& powers, const PairForce& law, const Columns& c, std::int64_t i, std::int64_t N,
             Range<double>& range) {
  const Row row = row_of(law, c, i);
  double x = 0.0, y = 0.0, z = 0.0;
  for (std::int64_t j = i + 1; j < N; ++j) {
    const double dx = c.x[j] - row.x, dy = c.y[j] - row.y, dz = c.z[j] - row.z;
    const double square = dx * dx + dy * dy + dz * dz;
    range.include(square);
    const double over_d = force_over_distance(powers, row, c.factor[j], square);
    x += over_d * dx, y += over_d * dy, z += over_d * dz;
    c.reaction_x[j] -= over_d * dx, c.reaction_y[j] -= over_d * dy, c.reaction_z[j] -= over_d * dz;
  }
  c.action_x[i] += x, c.action_y[i] += y, c.action_z[i] += z;
}

template <class Powers>
bool add_all(const Powers& powers, const PairForce& law, const Columns& c, std::int64_t N) {
  if (N <= few) {
    Range<double> range;
    for (std::int64_t i = 0; i < N; ++i) add_row(powers, law, c, i, N, range);
    return is_full(range);
  }
  Range<Vector> range;
  for (std::int64_t i = 0; i < N; i += rows) add_rows(powers, law, c, i, N, range);
  return is_full(range);
}

// The exponents that are met most have code of their own.
bool add_pairs(const PairForce& law, const Columns& c, std::int64_t N) {
  if (law.beta1 == 1.0 && law.beta2 == 2.0) return add_all(FixedPowers<1, 2>{}, law, c, N);
  if (law.beta1 == 2.0 && law.beta2 == 3.0) return add_all(FixedPowers<2, 3>{}, law, c, N);
  return add_all(AnyPowers(law), law, c, N);
}

// How a force ends at its cut-off distance: by a factor of 1 - u^2 (3 - 2 u), u from 0 to 1 over the taper's width.
class Taper {
 public:
  explicit Taper(const Within& within)
      : start_(within.cutoff - within.taper), per_width_(within.taper > 0.0 ? 1.0 / within.taper : 0.0) {}

  Vector operator()(Vector d) const {
    Vector u = (d - start_) * per_width_;
    u = u > 0.0 ? u : Vector{};
    u = u < 1.0 ? u : Vector{} + 1.0;
    return 1.0 - u * u * (3.0 - 2.0 * u);
  }

 private:
  double start_, per_width_;
};

// The component of the nearest image; see separation() of space.
double nearest(double d, double length) {
  return std::fabs(d) > 0.5 * length ? d - length * std::nearbyint(d / length) : d;
}

// Partners of a particle within reach, side by side: as many as are met at once.
struct Met {
  static constexpr int most = 64;
  alignas(64) double dx[most], dy[most], dz[most], square[most], factor[most];
  std::int32_t number[most];
  int n = 0;
};

// A particle against those partners. Lanes are filled with partners within reach alone, in ascending order, so that
// sums do not depend on which others were candidates.
template <class Powers>
__attribute__((flatten)) void meet_within(const Powers& powers, const Taper& taper, const Row& row, const Columns& c,
                                          Met& met, Sums& action, Range<Vector>& range) {
  for (int k = met.n; k % lanes != 0; ++k) met.dx[k] = met.dy[k] = met.dz[k] = met.factor[k] = 0.0, met.square[k] = 1.0;
  for (int first = 0; first < met.n; first += lanes) {
    const Vector dx = load(met.dx + first), dy = load(met.dy + first), dz = load(met.dz + first);
    const Vector square = load(met.square + first);
    range.include(square);
    const Vector over_d =
        force_over_distance(powers, row, load(met.factor + first), square) * taper(square * inverse_root(square));
    const Vector x = over_d * dx, y = over_d * dy, z = over_d * dz;
    action.x += x, action.y += y, action.z += z;
    const int used = met.n - first < lanes ? met.n - first : lanes;
    for (int lane = 0; lane < used; ++lane) {
      const std::int32_t j = met.number[first + lane];
      c.reaction_x[j] -= x[lane], c.reaction_y[j] -= y[lane], c.reaction_z[j] -= z[lane];
    }
  }
  met.n = 0;
}

template <class Powers>
bool add_all_within(const Powers& powers, const PairForce& law, const Within& within, const Columns& c,
                    std::int64_t N) {
  const Taper taper(within);
  const double reach = within.cutoff * within.cutoff;
  Range<Vector> range;
  Met met;
  for (std::int64_t i = 0; i < N; ++i) {
    const Row row = row_of(law, c, i);
    Sums action;
    const auto look_at = [&](std::int64_t j) {
      const double dx = nearest(c.x[j] - row.x, within.lengths[0]), dy = nearest(c.y[j] - row.y, within.lengths[1]),
                   dz = nearest(c.z[j] - row.z, within.lengths[2]);
      const double square = dx * dx + dy * dy + dz * dz;
      met.dx[met.n] = dx, met.dy[met.n] = dy, met.dz[met.n] = dz, met.square[met.n] = square;
      met.factor[met.n] = c.factor[j], met.number[met.n] = static_cast<std::int32_t>(j);
      met.n += square < reach ? 1 : 0;
      if (met.n == Met::most) meet_within(powers, taper, row, c, met, action, range);
    };
    if (within.first) {
      for (std::uint32_t k = within.first[i]; k < within.first[i + 1]; ++k) look_at(within.partner[k]);
    } else {
      for (std::int64_t j = i + 1; j < N; ++j) look_at(j);
    }
    if (met.n > 0) meet_within(powers, taper, row, c, met, action, range);
    c.action_x[i] += sum(action.x), c.action_y[i] += sum(action.y), c.action_z[i] += sum(action.z);
  }
  return is_full(range);
}

bool add_pairs_within(const PairForce& law, const Within& within, const Columns& c, std::int64_t N) {
  if (law.beta1 == 1.0 && law.beta2 == 2.0) return add_all_within(FixedPowers<1, 2>{}, law, within, c, N);
  if (law.beta1 == 2.0 && law.beta2 == 3.0) return add_all_within(FixedPowers<2, 3>{}, law, within, c, N);
  return add_all_within(AnyPowers(law), law, within, c, N);
}

}  // namespace
}  // namespace particulate::laws::detail
