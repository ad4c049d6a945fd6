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

template <int... lane>
struct Lanes {};

#if defined(__AVX512F__)
using AllLanes = Lanes<0, 1, 2, 3, 4, 5, 6, 7>;
constexpr int lanes = 8;
constexpr int rows = 4;  // as many as the 32 registers hold with their sums
#elif defined(__AVX2__)
using AllLanes = Lanes<0, 1, 2, 3>;
constexpr int lanes = 4;
constexpr int rows = 2;  // 16 registers
#else
using AllLanes = Lanes<0, 1>;
constexpr int lanes = 2;
constexpr int rows = 2;
#endif
static_assert(padded_to % lanes == 0 && lanes % rows == 0);

using Vector __attribute__((vector_size(lanes * sizeof(double)))) = double;
using Numbers __attribute__((vector_size(lanes * sizeof(double)))) = std::int64_t;
using Bits __attribute__((vector_size(lanes * sizeof(double)))) = std::uint64_t;

Vector load(const double* from) {
  Vector v{};
  std::memcpy(&v, from, sizeof v);
  return v;
}

void store(Vector v, double* to) { std::memcpy(to, &v, sizeof v); }

Bits bits_of(Vector v) {
  Bits bits{};
  std::memcpy(&bits, &v, sizeof bits);
  return bits;
}

Vector of_bits(Bits bits) {
  Vector v{};
  std::memcpy(&v, &bits, sizeof v);
  return v;
}

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

[[maybe_unused]] double inverse_root(double x) { return 1.0 / std::sqrt(x); }

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

bool is_whole(double exponent) { return exponent >= 0.0 && exponent <= 64.0 && exponent == std::floor(exponent); }

// Powers with other whole exponents, by multiplication in the order kinematics::power uses.
class WholePowers {
 public:
  explicit WholePowers(const PairForce& law)
      : beta1_(static_cast<int>(law.beta1)), beta2_(static_cast<int>(law.beta2)) {}

  template <class V>
  V first(V inverse) const {
    return power(inverse, beta1_);
  }
  template <class V>
  V second(V inverse) const {
    return power(inverse, beta2_);
  }

 private:
  template <class V>
  static V power(V x, int exponent) {
    V product = V{} + 1.0;
    for (int left = exponent; left > 0; left /= 2) {
      if (left % 2 == 1) product *= x;
      x *= x;
    }
    return product;
  }

  int beta1_, beta2_;
};

// A binary logarithm in two parts that need not be added: a whole number and what is left, -1/2 to 1/2.
struct Logarithm {
  Vector whole, rest;
};

// A minimax polynomial, found in 40 digits. Even and odd terms are summed apart, because what is waited for are chains
// of products. Coefficients are kept as wide as registers are: constants would be widened again for every product.
template <int n>
class Polynomial {
 public:
  explicit Polynomial(const double (&coefficient)[n]) {
    for (int k = 0; k < n; ++k) coefficient_[k] = Vector{} + coefficient[k];
  }

  Vector operator()(Vector x) const {
    const Vector square = x * x;
    Vector last = coefficient_[n - 1], before = coefficient_[n - 2];
#pragma GCC unroll 16
    for (int k = n - 3; k >= 0; k -= 2) {
      last = last * square + coefficient_[k];
      if (k > 0) before = before * square + coefficient_[k - 1];
    }
    return n % 2 == 1 ? before * x + last : last * x + before;
  }

 private:
  Vector coefficient_[n];
};

// Of normal positive numbers x = 2^k m, sqrt(1/2) < m < sqrt(2): log2 m = 2/ln 2 artanh z with z = (m - 1)/(m + 1), to
// 1.8e-16 of itself: a term more would gain nothing. The exponent becomes a double as the last digits of a number that
// is large enough.
class Log2 {
 public:
  Logarithm operator()(Vector x) const {
    constexpr std::uint64_t one = 0x3ff0000000000000, root = 0x3fe6a09e667f3bcd, digits = 0x000fffffffffffff;
    const Bits above = bits_of(x) + (one - root);
    const Vector whole = of_bits((above >> 52) | 0x4330000000000000) - (0x1p52 + 1023.0);
    const Vector m = of_bits((above & digits) + root);
    const Vector z = (m - 1.0) / (m + 1.0);
    return {whole, z * series_(z * z)};
  }

 private:
  Polynomial<7> series_{{2.885390081777927319, 0.96179669392430432448, 0.57707801725944989881, 0.41219839998190601164,
                         0.32061653426060250134, 0.26143951303894917997, 0.24297337509311963366}};
};

// Powers x^e from log2 x. The product of e and the logarithm's whole part would lose digits, a hundred times eps where
// it is a hundred; so its head, e to 40 digits times the whole part, is formed exactly.
class Power {
 public:
  // Of exponent (one + beta)/2, which is rounded; what rounding takes is added to the tail.
  Power(double one, double beta) {
    const double sum = one + beta, from_beta = sum - one, exponent = 0.5 * sum;
    std::uint64_t bits = 0;
    std::memcpy(&bits, &exponent, sizeof bits);
    bits &= ~std::uint64_t{0x1fff};
    double head = 0.0;
    std::memcpy(&head, &bits, sizeof bits);
    exponent_ += exponent, head_ += head;
    tail_ += (exponent - head) + 0.5 * ((one - (sum - from_beta)) + (beta - from_beta));
  }

  Vector operator()(const Logarithm& log) const {
    const Split s = split(log);
    return of_bits(bits_of(1.0 + s.growth) + s.exponent);
  }

  // The power less 1, to full precision where it is small.
  Vector minus_one(const Logarithm& log) const {
    const Split s = split(log);
    const Vector scale = of_bits(bits_of(Vector{} + 1.0) + s.exponent);
    return scale * s.growth + (scale - 1.0);
  }

 private:
  // 2^y = 2^n (1 + growth), n the whole number next to y, in the digits of an exponent.
  struct Split {
    Bits exponent;
    Vector growth;
  };

  // 2^r - 1 to 2.3e-16 of 2^r. Added to a large number, y is rounded to n: not with -ffast-math.
  Split split(const Logarithm& log) const {
    constexpr double large = 0x1.8p52;
    const Vector head = head_ * log.whole, tail = tail_ * log.whole + exponent_ * log.rest;
    const Vector shifted = (head + tail) + large;
    const Vector r = (head - (shifted - large)) + tail;
    return {bits_of(shifted) << 52, r * growth_(r)};
  }

  Vector exponent_{}, head_{}, tail_{};
  Polynomial<10> growth_{{0.69314718055994925189, 0.24022650695909082214, 0.055504108664476421254,
                          0.0096181291079887996464, 0.0013333558226747627094, 0.00015403529989479496921,
                          0.000015252658835720843417, 1.321565491468666873e-6, 1.0208443306486076687e-7,
                          7.0381153069630100004e-9}};
};

// Powers with any exponents. Those of a Vector are taken over the distance, from one logarithm of its square.
struct RealPowers {
  explicit RealPowers(const PairForce& law)
      : beta1(law.beta1), beta2(law.beta2), over_d1(-1.0, -law.beta1), over_d2(-1.0, -law.beta2) {}

  double first(double inverse) const { return std::pow(inverse, beta1); }
  double second(double inverse) const { return std::pow(inverse, beta2); }

  double beta1, beta2;
  Log2 log2;
  Power over_d1, over_d2;
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

Vector force_over_distance(const RealPowers& powers, const Row& row, Vector factor, Vector square) {
  const Logarithm log = powers.log2(square);
  return factor * (row.alpha1 * powers.over_d1(log) - row.alpha2 * powers.over_d2(log));
}

// No potential energy is asked for, and no code for it is left.
struct NoEnergy {
  explicit NoEnergy(const PairForce&) {}
  void add(const Row&, Vector, Vector) {}
  double total() const { return 0.0; }
};

// Sum of potential energies: of either power the integral of x^-beta from d_ref to the distance. See potential() of a
// central force.
class Energy {
 public:
  explicit Energy(const PairForce& law)
      : first_(law.beta1, law.d_ref), second_(law.beta2, law.d_ref), reference_(log2_(Vector{} + law.d_ref)) {}

  void add(const Row& row, Vector factor, Vector square) {
    const Logarithm log = log2_(square);
    const Logarithm ratio{log.whole - 2.0 * reference_.whole, log.rest - 2.0 * reference_.rest};
    sum_ += factor * (row.alpha1 * first_(ratio) - row.alpha2 * second_(ratio));
  }
  double total() const { return sum(sum_); }

 private:
  class Integral {
   public:
    Integral(double beta, double d_ref) : power_(1.0, -beta), is_logarithm_(beta == 1.0) {
      constexpr double half_ln2 = 0.34657359027997264;
      factor_ = is_logarithm_ ? half_ln2 : std::pow(d_ref, 1.0 - beta) / (1.0 - beta);
    }
    Vector operator()(const Logarithm& ratio) const {
      return factor_ * (is_logarithm_ ? ratio.whole + ratio.rest : power_.minus_one(ratio));
    }

   private:
    Power power_;
    bool is_logarithm_;
    double factor_;
  };

  Log2 log2_;
  Integral first_, second_;
  Logarithm reference_;
  Vector sum_{};
};

// Smallest and largest square of a distance so far.
template <class V>
struct Range {
  V smallest = V{} + 1.0, largest = V{} + 1.0;

  void include(V square) {
    smallest = square < smallest ? square : smallest;
    largest = square > largest ? square : largest;
  }
};

// The least p for which x lies between 2^-p and 2^p.
double powers_of_two(double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  const double below = static_cast<double>(bits >> 52) - 1023.0;
  return below < 0.0 ? -below : below + (bits << 12 == 0 ? 0.0 : 1.0);
}

// See is_full() of the near field; and powers of the distances, over a distance where energies are asked for, are so
// far from the ends of what a double holds that products with strengths lose nothing.
bool is_full(const PairForce& law, double from, const Range<double>& range) {
  if (!(range.smallest >= DBL_MIN && range.largest <= DBL_MAX && from >= DBL_MIN)) return false;
  const double low = powers_of_two(range.smallest), high = powers_of_two(range.largest);
  const double most = (low > high ? low : high) + 2.0 * powers_of_two(from);
  constexpr double far = 800.0;
  return 0.5 * (1.0 + std::fabs(law.beta1)) * most <= far && 0.5 * (1.0 + std::fabs(law.beta2)) * most <= far;
}

bool is_full(const PairForce& law, double from, const Range<Vector>& range) {
  Range<double> all;
  for (int k = 0; k < lanes; ++k) all.include(range.smallest[k]), all.include(range.largest[k]);
  return is_full(law, from, all);
}

struct Sums {
  Vector x{}, y{}, z{};
};

// The rows from particle i on against the partners from j on. Where some are no pair, because j <= i or j >= N, they
// are given distance 1 and factor 0.
template <bool some_are_no_pair, class Powers, class E>
void meet(const Powers& powers, const Columns& c, const Row* row, std::int64_t i, std::int64_t j, std::int64_t N,
          Sums* action, Range<Vector>& range, E& energy) {
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
    energy.add(row[k], partner, square);
    const Vector over_d = force_over_distance(powers, row[k], partner, square);
    action[k].x += over_d * dx, action[k].y += over_d * dy, action[k].z += over_d * dz;
    reaction_x -= over_d * dx, reaction_y -= over_d * dy, reaction_z -= over_d * dz;
  }
  store(reaction_x, c.reaction_x + j), store(reaction_y, c.reaction_y + j), store(reaction_z, c.reaction_z + j);
}

// The rows from particle i on against all their partners. Flattened: everything above becomes part of it, and rows and
// sums stay in registers.
template <class Powers, class E>
__attribute__((flatten)) void add_rows(const Powers& powers, const PairForce& law, const Block& block, std::int64_t i,
                                       Range<Vector>& range, E& energy) {
  const Columns own = block.row, c = block.partner;                        // copies: what is stored cannot change them
  const std::int64_t N = block.partners, before = block.same ? i : -rows;  // partners that are no pairs
  Row row[rows];
  Sums action[rows];
  Range<Vector> seen = range;
  for (int k = 0; k < rows; ++k) row[k] = row_of(law, own, i + k);
  std::int64_t j = 0;
  if (block.same) {
    j = i / lanes * lanes;
    meet<true>(powers, c, row, before, j, N, action, seen, energy);
    j += lanes;
  }
  for (; j + lanes <= N; j += lanes) meet<false>(powers, c, row, before, j, N, action, seen, energy);
  if (j < N) meet<true>(powers, c, row, before, j, N, action, seen, energy);
  for (int k = 0; k < rows; ++k) {
    own.action_x[i + k] += sum(action[k].x);
    own.action_y[i + k] += sum(action[k].y);
    own.action_z[i + k] += sum(action[k].z);
  }
  range = seen;
}

template <class E, class Powers>
bool add_many(const Powers& powers, const PairForce& law, const Block& block, double* total) {
  Range<Vector> range;
  E energy(law);
  for (std::int64_t i = 0; i < block.rows; i += rows) add_rows(powers, law, block, i, range, energy);
  if (total) *total += energy.total();
  return is_full(law, total ? law.d_ref : 1.0, range);
}

// Calls add with the powers of a law. The exponents that are met most have code of their own.
template <class Add>
bool by_powers(const PairForce& law, const Add& add) {
  if (law.beta1 == 1.0 && law.beta2 == 2.0) return add(FixedPowers<1, 2>{});
  if (law.beta1 == 2.0 && law.beta2 == 3.0) return add(FixedPowers<2, 3>{});
  return is_whole(law.beta1) && is_whole(law.beta2) ? add(WholePowers(law)) : add(RealPowers(law));
}

// What is left in the upper halves of registers makes code that does not know of them wait for them, three times as
// slow as it could be. The compiler does not see all that leaves them behind.
void clear_upper_halves() {
#ifdef __AVX__
  __builtin_ia32_vzeroupper();
#endif
}

bool add_pairs(const PairForce& law, const Block& block, double* energy) {
  const bool full = by_powers(law, [&](const auto& powers) {
    return energy ? add_many<Energy>(powers, law, block, energy) : add_many<NoEnergy>(powers, law, block, nullptr);
  });
  clear_upper_halves();
  return full;
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

// Not one by one: a vector that is written so and read as a whole would be waited for.
template <int... lane>
__attribute__((always_inline)) inline Vector gather(const double* from, const std::int32_t* j, Lanes<lane...>) {
  return Vector{from[j[lane]]...};
}
__attribute__((always_inline)) inline Vector gather(const double* from, const std::int32_t* j) {
  return gather(from, j, AllLanes{});
}

// One component of the nearest image in space that repeats itself; see separation() of space.
class Nearest {
 public:
  explicit Nearest(double length)
      : length_(length <= DBL_MAX ? length : 0.0), per_length_(length <= DBL_MAX ? 1.0 / length : 0.0) {}

  // Added to a large number, what is added is rounded to a whole one.
  Vector operator()(Vector d) const {
    constexpr double large = 0x1.8p52;
    return d - length_ * ((d * per_length_ + large) - large);
  }
  // Most pairs are near enough, and need no division.
  double operator()(double d) const {
    return length_ > 0.0 && std::fabs(d) > 0.5 * length_ ? d - length_ * std::nearbyint(d / length_) : d;
  }

 private:
  double length_, per_length_;
};

// Partners within reach, side by side.
struct Met {
  static constexpr int most = 64;
  alignas(64) double dx[most + lanes], dy[most + lanes], dz[most + lanes], square[most + lanes];
  std::int32_t number[most + lanes];
  int n = 0;

  // Forgets the first so many.
  void drop(int many) {
    n -= many;
    for (int k = 0; k < n; ++k) {
      dx[k] = dx[many + k], dy[k] = dy[many + k], dz[k] = dz[many + k], square[k] = square[many + k];
      number[k] = number[many + k];
    }
  }
};

// Looks which candidates are within reach of a particle.
struct Search {
  const Columns& c;
  Nearest x, y, z;
  double reach;  // squared

  // Some candidates, as many as there are lanes or fewer. Only AVX-512 can write some lanes side by side; without that
  // vectors gain nothing.
  __attribute__((always_inline)) inline void add(const Row& row, const std::int32_t* j, int used, Met& met) const {
#ifdef __AVX512F__
    const Vector dx = x(gather(c.x, j) - row.x), dy = y(gather(c.y, j) - row.y), dz = z(gather(c.z, j) - row.z);
    const Vector square = dx * dx + dy * dy + dz * dz;
    const auto inside =
        static_cast<__mmask8>(_mm512_cmp_pd_mask(square, _mm512_set1_pd(reach), _CMP_LT_OQ) & ((1U << used) - 1U));
    store(_mm512_maskz_compress_pd(inside, dx), met.dx + met.n);
    store(_mm512_maskz_compress_pd(inside, dy), met.dy + met.n);
    store(_mm512_maskz_compress_pd(inside, dz), met.dz + met.n);
    store(_mm512_maskz_compress_pd(inside, square), met.square + met.n);
    const __m256i numbers = _mm256_maskz_compress_epi32(inside, _mm256_maskz_loadu_epi32(inside, j));
    std::memcpy(met.number + met.n, &numbers, sizeof numbers);
    met.n += __builtin_popcount(inside);
#else
    for (int lane = 0; lane < used; ++lane) {
      const double dx = x(c.x[j[lane]] - row.x), dy = y(c.y[j[lane]] - row.y), dz = z(c.z[j[lane]] - row.z);
      const double square = dx * dx + dy * dy + dz * dz;
      met.dx[met.n] = dx, met.dy[met.n] = dy, met.dz[met.n] = dz, met.square[met.n] = square;
      met.number[met.n] = j[lane];
      met.n += square < reach ? 1 : 0;
    }
#endif
  }
};

// A particle against the first so many of those partners. Lanes are filled with partners within reach alone, in
// ascending order, so that sums do not depend on which others were candidates.
template <class Powers>
__attribute__((flatten)) void meet_within(const Powers& powers, const Taper& taper, const Row& row, const Columns& c,
                                          Met& met, int many, Sums& action, Range<Vector>& range) {
  for (int k = many; k % lanes != 0; ++k) {
    met.dx[k] = met.dy[k] = met.dz[k] = 0.0, met.square[k] = 1.0, met.number[k] = met.number[0];
  }
  for (int first = 0; first < many; first += lanes) {
    const Vector dx = load(met.dx + first), dy = load(met.dy + first), dz = load(met.dz + first);
    const Vector square = load(met.square + first), factor = gather(c.factor, met.number + first);
    range.include(square);
    const Vector over_d = force_over_distance(powers, row, factor, square) * taper(square * inverse_root(square));
    const Vector x = over_d * dx, y = over_d * dy, z = over_d * dz;
    action.x += x, action.y += y, action.z += z;
    const int used = many - first < lanes ? many - first : lanes;
    for (int lane = 0; lane < used; ++lane) {
      const std::int32_t j = met.number[first + lane];
      c.reaction_x[j] -= x[lane], c.reaction_y[j] -= y[lane], c.reaction_z[j] -= z[lane];
    }
  }
  met.drop(many);
}

template <class Powers>
bool add_all_within(const Powers& powers, const PairForce& law, const Within& within, const Columns& c) {
  const Taper taper(within);
  const Search search{.c = c,
                      .x = Nearest(within.lengths[0]),
                      .y = Nearest(within.lengths[1]),
                      .z = Nearest(within.lengths[2]),
                      .reach = within.cutoff * within.cutoff};
  Range<Vector> range;
  Met met;
  for (std::int64_t i = 0; i < within.N; ++i) {
    const Row row = row_of(law, c, i);
    Sums action;
    const auto look_at = [&](const std::int32_t* j, int used) {
      search.add(row, j, used, met);
      if (met.n >= Met::most) meet_within(powers, taper, row, c, met, Met::most, action, range);
    };
    const std::int64_t count = within.first ? within.first[i + 1] - within.first[i] : within.N - 1 - i;
    std::int64_t k = 0;
    for (; within.first && k + lanes <= count; k += lanes) look_at(within.partner + within.first[i] + k, lanes);
    for (; k < count; k += lanes) {
      const int used = count - k < lanes ? static_cast<int>(count - k) : lanes;
      std::int32_t j[lanes] = {};
      for (int lane = 0; lane < used; ++lane) {
        j[lane] =
            within.first ? within.partner[within.first[i] + k + lane] : static_cast<std::int32_t>(i + 1 + k + lane);
      }
      look_at(j, used);
    }
    if (met.n > 0) meet_within(powers, taper, row, c, met, met.n, action, range);
    c.action_x[i] += sum(action.x), c.action_y[i] += sum(action.y), c.action_z[i] += sum(action.z);
  }
  return is_full(law, 1.0, range);
}

bool add_pairs_within(const PairForce& law, const Within& within, const Columns& c) {
  const bool full = by_powers(law, [&](const auto& powers) { return add_all_within(powers, law, within, c); });
  clear_upper_halves();
  return full;
}

// So many pairs side by side, of any rows.
template <class Powers>
__attribute__((flatten)) void meet_chosen(const Powers& powers, const Row& one, const Columns& c, const std::int32_t* i,
                                          const std::int32_t* j, int used, Range<Vector>& range) {
  const Vector dx = gather(c.x, j) - gather(c.x, i), dy = gather(c.y, j) - gather(c.y, i);
  const Vector dz = gather(c.z, j) - gather(c.z, i), square = dx * dx + dy * dy + dz * dz;
  range.include(square);
  const Vector over_d = force_over_distance(powers, one, gather(c.factor, i) * gather(c.factor, j), square);
  alignas(64) double x[lanes], y[lanes], z[lanes];
  store(over_d * dx, x), store(over_d * dy, y), store(over_d * dz, z);
  for (int lane = 0; lane < used; ++lane) {
    c.action_x[i[lane]] += x[lane], c.action_y[i[lane]] += y[lane], c.action_z[i[lane]] += z[lane];
    c.reaction_x[j[lane]] -= x[lane], c.reaction_y[j[lane]] -= y[lane], c.reaction_z[j[lane]] -= z[lane];
  }
}

template <class Powers>
bool add_all_chosen(const Powers& powers, const PairForce& law, const Chosen& pairs, const Columns& c) {
  const Row one{.x = 0.0, .y = 0.0, .z = 0.0, .alpha1 = law.alpha1, .alpha2 = law.alpha2};
  Range<Vector> range;
  std::int64_t k = 0;
  for (; k + lanes <= pairs.n; k += lanes) {
    meet_chosen(powers, one, c, pairs.row + k, pairs.partner + k, lanes, range);
  }
  if (k < pairs.n) {
    std::int32_t i[lanes], j[lanes];
    for (int lane = 0; lane < lanes; ++lane) {
      const std::int64_t pair = k + lane < pairs.n ? k + lane : k;
      i[lane] = pairs.row[pair], j[lane] = pairs.partner[pair];
    }
    meet_chosen(powers, one, c, i, j, static_cast<int>(pairs.n - k), range);
  }
  return is_full(law, 1.0, range);
}

bool add_pairs_chosen(const PairForce& law, const Chosen& pairs, const Columns& c) {
  const bool full = by_powers(law, [&](const auto& powers) { return add_all_chosen(powers, law, pairs, c); });
  clear_upper_halves();
  return full;
}

}  // namespace
}  // namespace particulate::laws::detail
