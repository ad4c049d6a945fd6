#include <particulate/scattering/red_cell.hpp>

#include <algorithm>
#include <array>
#include <numbers>

#include <particulate/scattering/detail/quadrature.hpp>

namespace particulate::scattering {

namespace {

// A polynomial on [0, 1] by its coefficients in Bernstein's basis: mean values of them are all that is ever formed.
template <std::size_t degree>
using Bernstein = std::array<double, degree + 1>;

constexpr std::size_t degree_of_shape = 10;

// C0 + C1 u + C2 u^2.
double profile_of(double u) { return RedCell::C0 + u * (RedCell::C1 + u * RedCell::C2); }
double slope_of_profile(double u) { return RedCell::C1 + 2.0 * u * RedCell::C2; }

constexpr double binomial(std::size_t n, std::size_t k) {
  double b = 1.0;
  for (std::size_t i = 0; i < k; ++i) b = b * static_cast<double>(n - i) / static_cast<double>(i + 1);
  return b;
}

// How much the product of coefficients i and j weighs in that of two polynomials.
template <std::size_t m, std::size_t n>
constexpr auto product_weights = [] {
  std::array<std::array<double, n + 1>, m + 1> weights{};
  for (std::size_t i = 0; i <= m; ++i) {
    for (std::size_t j = 0; j <= n; ++j) weights[i][j] = binomial(m, i) * binomial(n, j) / binomial(m + n, i + j);
  }
  return weights;
}();

template <std::size_t m, std::size_t n>
Bernstein<m + n> times(const Bernstein<m>& a, const Bernstein<n>& b) {
  Bernstein<m + n> c{};
  for (std::size_t i = 0; i <= m; ++i) {
    for (std::size_t j = 0; j <= n; ++j) c[i + j] += product_weights<m, n>[i][j] * a[i] * b[j];
  }
  return c;
}

// P of the line between two places, of which it knows u = rho^2/R0^2 and zeta = 2 z/R0.
struct Line {
  Bernstein<2> u;
  std::array<double, 2> zeta;
};
Bernstein<degree_of_shape> shape_along(const Line& line) {
  constexpr Bernstein<2> one{1.0, 1.0, 1.0};
  constexpr Bernstein<8> constant{1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
  const Bernstein<2>& u = line.u;
  Bernstein<4> profile = times<2, 2>(u, u);
  const Bernstein<4> linear = times<2, 2>(u, one);
  for (std::size_t k = 0; k < profile.size(); ++k) {
    profile[k] = RedCell::C0 + RedCell::C1 * linear[k] + RedCell::C2 * profile[k];
  }
  const Bernstein<2> to_rim{1.0 - u[0], 1.0 - u[1], 1.0 - u[2]};
  const auto [from, to] = line.zeta;
  const Bernstein<degree_of_shape> height = times<2, 8>({from * from, from * to, to * to}, constant);
  Bernstein<degree_of_shape> P = times<2, 8>(to_rim, times<4, 4>(profile, profile));
  for (std::size_t k = 0; k < P.size(); ++k) P[k] -= height[k];
  return P;
}

template <std::size_t n>
int sign_changes(const std::array<double, n>& b) {
  int changes = 0;
  bool positive = b[0] > 0.0;
  for (std::size_t k = 1; k < n; ++k) {
    if (b[k] == 0.0) continue;
    changes += (b[k] > 0.0) != positive ? 1 : 0;
    positive = b[k] > 0.0;
  }
  return changes;
}

// The halves of a polynomial, by de Casteljau.
template <std::size_t n>
void split(const std::array<double, n>& b, std::array<double, n>& left, std::array<double, n>& right) {
  std::array<double, n> work = b;
  left[0] = work[0], right[n - 1] = work[n - 1];
  for (std::size_t level = 1; level < n; ++level) {
    for (std::size_t k = 0; k + level < n; ++k) work[k] = 0.5 * (work[k] + work[k + 1]);
    left[level] = work[0], right[n - 1 - level] = work[n - 1 - level];
  }
}

// An interval in which a polynomial that is not positive before becomes so, once; empty: it does not.
struct Bracket {
  double low = 1.0, high = 0.0;
  bool empty() const { return low > high; }
};

// The first of them in [low, high], over which the polynomial is given. Parts that are shorter than roundings cannot
// hold a body.
template <std::size_t n>
Bracket first_rise(const std::array<double, n>& b, double low = 0.0, double high = 1.0) {
  const int changes = sign_changes(b);
  if (changes == 0) return {};
  if (changes == 1) return b[0] > 0.0 ? Bracket{} : Bracket{low, high};
  const double middle = 0.5 * (low + high);
  if (!(high - low > 2e-16)) return {};
  std::array<double, n> left, right;
  split(b, left, right);
  const Bracket first = first_rise(left, low, middle);
  return first.empty() ? first_rise(right, middle, high) : first;
}

// The place in a bracket at which P becomes positive, by Newton's iteration, and bisection where that leads outside.
double polished(const Line& line, Bracket in) {
  const auto [u_0, u_1, u_2] = line.u;
  const double first = 2.0 * (u_1 - u_0), second = (u_2 - u_1) - (u_1 - u_0), rise = line.zeta[1] - line.zeta[0];
  double s = 0.5 * (in.low + in.high);
  for (int k = 0; k < 100; ++k) {
    const double u = u_0 + s * (first + s * second), zeta = line.zeta[0] + s * rise, f = profile_of(u);
    const double P = (1.0 - u) * f * f - zeta * zeta;
    const double slope =
        f * (2.0 * (1.0 - u) * slope_of_profile(u) - f) * (first + 2.0 * s * second) - 2.0 * zeta * rise;
    (P > 0.0 ? in.high : in.low) = s;
    double next = s - P / slope;
    if (!(next > in.low && next < in.high)) next = 0.5 * (in.low + in.high);
    if (!(std::abs(next - s) > 1e-16)) return next;
    s = next;
  }
  return s;
}

// A vector as the cell sees it, in radii: along its axis, and across it.
struct Seen {
  double along;
  Eigen::Vector3d across;
};
Seen seen(const RedCell& body, const Eigen::Vector3d& x) {
  const double along = x.dot(body.axis);
  return {along, x - along * body.axis};
}

// Whether a line passes the ball that contains the cell: most of those that are asked for do, and cost no more.
bool passes_by(const RedCell& body, const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d to_centre = body.centre - from;
  return (to_centre - to_centre.dot(direction) * direction).squaredNorm() > body.radius * body.radius;
}

using Part = std::array<double, 2>;  // of a line, between two distances in radii

// The part of a ray that lies within the cylinder u <= 1; empty: none.
Part within_cylinder(const Seen& from, const Seen& direction) {
  const double square = direction.across.squaredNorm();
  if (square == 0.0) return {0.0, from.across.squaredNorm() <= 1.0 ? nowhere : 0.0};
  const double middle = -from.across.dot(direction.across) / square;
  const double left = 1.0 - (from.across + middle * direction.across).squaredNorm();
  if (!(left > 0.0)) return {0.0, 0.0};
  const double half = std::sqrt(left / square);
  return {std::max(0.0, middle - half), middle + half};
}

// The largest of z/R0, rounded up: no cell is thicker.
constexpr double thickest = 0.3281;

// What of it lies within the slab that the cell fills.
Part within_slab(const Part& part, const Seen& from, const Seen& direction) {
  if (direction.along == 0.0) return std::abs(from.along) <= thickest ? part : Part{0.0, 0.0};
  const double one = (-thickest - from.along) / direction.along, other = (thickest - from.along) / direction.along;
  return {std::max(part[0], std::min(one, other)), std::min(part[1], std::max(one, other))};
}

// P along the part of a ray that can meet a cell.
struct Passage {
  Part part{};
  Line line{};
  Bernstein<degree_of_shape> P{};

  bool empty() const { return !(part[1] > part[0]); }
  double distance(const RedCell& body, const Bracket& rise) const {
    return rise.empty() ? nowhere : body.radius * (part[0] + polished(line, rise) * (part[1] - part[0]));
  }
};
Passage passage(const RedCell& body, const Eigen::Vector3d& place, const Eigen::Vector3d& along) {
  const Seen from = seen(body, (place - body.centre) / body.radius), direction = seen(body, along);
  Passage found{.part = within_slab(within_cylinder(from, direction), from, direction)};
  if (found.empty()) return found;
  const auto [begin, end] = found.part;
  const Eigen::Vector3d first = from.across + begin * direction.across, last = from.across + end * direction.across;
  found.line = {.u = {first.squaredNorm(), first.dot(last), last.squaredNorm()},
                .zeta = {2.0 * (from.along + begin * direction.along), 2.0 * (from.along + end * direction.along)}};
  found.P = shape_along(found.line);
  return found;
}

// The surface of a cell of radius 1, from the meridian rho = sin phi, z = 1/2 cos phi f(sin^2 phi), which is smooth.
double unit_area() {
  const auto ring = [](double phi) {
    const double sine = std::sin(phi), cosine = std::cos(phi), u = sine * sine;
    const double dz = 0.5 * sine * (2.0 * cosine * cosine * slope_of_profile(u) - profile_of(u));
    return sine * std::hypot(cosine, dz);
  };
  return 4.0 * std::numbers::pi * detail::integral(ring, 0.0, 0.5 * std::numbers::pi);
}

}  // namespace

void validate(const RedCell& body) {
  validate(Spheroid{.centre = body.centre, .axis = body.axis, .equatorial = body.radius, .polar = body.radius});
}

double half_thickness(const RedCell& body, double rho) {
  const double x = rho / body.radius;
  return 0.5 * body.radius * std::sqrt((1.0 - x) * (1.0 + x)) * profile_of(x * x);
}

Spheroid bounding_spheroid(const RedCell& body) {
  return {.centre = body.centre,
          .axis = body.axis,
          .equatorial = 4.054 / 3.91 * body.radius,
          .polar = 1.921 / 3.91 * body.radius};
}

double first_entry(const RedCell& body, const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
  if (passes_by(body, from, direction)) return nowhere;
  const Passage passing = passage(body, from, direction);
  if (passing.empty()) return nowhere;
  // At the rim roundings may begin the part inside.
  return passing.P[0] > 0.0 ? body.radius * passing.part[0] : passing.distance(body, first_rise(passing.P));
}

double next_entry(const RedCell& body, const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
  const Passage passing = passage(body, from, direction);
  if (passing.empty()) return nowhere;
  if (passing.part[0] > 0.0) return passing.distance(body, first_rise(passing.P));
  Bernstein<degree_of_shape - 1> rest{};
  for (std::size_t k = 0; k < rest.size(); ++k) {
    rest[k] = passing.P[k + 1] * static_cast<double>(degree_of_shape) / static_cast<double>(k + 1);
  }
  return passing.distance(body, first_rise(rest));
}

Eigen::Vector3d outward_normal(const RedCell& body, const Eigen::Vector3d& place) {
  const Seen at = seen(body, (place - body.centre) / body.radius);
  const double u = at.across.squaredNorm(), f = profile_of(u);
  return ((f * f - 2.0 * (1.0 - u) * f * slope_of_profile(u)) * at.across + 4.0 * at.along * body.axis).normalized();
}

bool contains(const RedCell& body, const Eigen::Vector3d& place) {
  const Seen at = seen(body, (place - body.centre) / body.radius);
  const double u = at.across.squaredNorm(), f = profile_of(u);
  return u < 1.0 && (1.0 - u) * f * f > 4.0 * at.along * at.along;
}

double volume(const RedCell& body) {
  const double shape = 2.0 / 3.0 * RedCell::C0 + 4.0 / 15.0 * RedCell::C1 + 16.0 / 105.0 * RedCell::C2;
  return std::numbers::pi * shape * body.radius * body.radius * body.radius;
}

double area(const RedCell& body) {
  static const double of_one = unit_area();
  return of_one * body.radius * body.radius;
}

}  // namespace particulate::scattering
