// Red cells: every first hit, and every next one after a reflection, against interval bisection.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <harness/case.hpp>
#include <harness/uniform.hpp>
#include <particulate/scattering/placement.hpp>
#include <particulate/scattering/red_cell.hpp>

namespace verification::red_cells {

using namespace particulate::scattering;
using Eigen::Vector3d;

// Numbers between two bounds, rounded outwards by more than the operations round.
struct Interval {
  double low, high;
};
Interval widened(double low, double high) {
  const double by = 4e-16 * std::max(std::abs(low), std::abs(high));
  return {low - by, high + by};
}
Interval operator+(Interval a, Interval b) { return widened(a.low + b.low, a.high + b.high); }
Interval operator-(Interval a, Interval b) { return widened(a.low - b.high, a.high - b.low); }
Interval operator*(Interval a, Interval b) {
  const auto [low, high] = std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return widened(low, high);
}
Interval squared(Interval a) {
  const double low = a.low * a.low, high = a.high * a.high;
  const bool holds_zero = a.low <= 0.0 && a.high >= 0.0;
  return widened(holds_zero ? 0.0 : std::min(low, high), std::max(low, high));
}
Interval operator/(Interval a, Interval b) {
  const auto [low, high] = std::minmax({a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high});
  return widened(low, high);
}
Interval exactly(double x) { return {x, x}; }

// A function over an interval, and its derivative.
struct Function {
  Interval value, slope = exactly(0.0);
};
Function operator+(const Function& a, const Function& b) { return {a.value + b.value, a.slope + b.slope}; }
Function operator-(const Function& a, const Function& b) { return {a.value - b.value, a.slope - b.slope}; }
Function operator*(const Function& a, const Function& b) {
  return {a.value * b.value, a.value * b.slope + a.slope * b.value};
}
Function squared(const Function& a) { return {squared(a.value), exactly(2.0) * a.value * a.slope}; }
Function constant(double x) { return {exactly(x)}; }

// A ray about a cell of radius 1 whose axis is z.
struct Line {
  Vector3d from, direction;

  Function coordinate(int k, Interval t) const {
    return {exactly(from[k]) + t * exactly(direction[k]), exactly(direction[k])};
  }
};
// u and P of the part of a line between two distances.
Function squared_radius(const Line& line, Interval t) {
  return squared(line.coordinate(0, t)) + squared(line.coordinate(1, t));
}
Function shape(const Line& line, Interval t) {
  const Function u = squared_radius(line, t), zeta = constant(2.0) * line.coordinate(2, t);
  const Function f = constant(RedCell::C0) + u * (constant(RedCell::C1) + u * constant(RedCell::C2));
  return (constant(1.0) - u) * squared(f) - squared(zeta);
}

// What is left of an interval, on which the slope has one sign, by the interval form of Newton's method.
Interval narrowed(Interval t, const Function& P, const Function& middle_P) {
  const double middle = 0.5 * (t.low + t.high);
  const Interval image = exactly(middle) - middle_P.value / P.slope;
  return {std::max(t.low, image.low), std::min(t.high, image.high)};
}

// The first place at which the cell may be entered: parts of the line that are certainly outside are left out, until
// what is left is shorter than 1e-12. Negative: the line misses the cell for certain. `certain` says whether it is
// entered there for certain, or only touched to 1e-12 or missed by less.
double bisected(const Line& line, Interval t, bool& certain) {
  if (!(t.low <= t.high) || squared_radius(line, t).value.low > 1.0) return -1.0;
  const double middle = 0.5 * (t.low + t.high);
  const Function P = shape(line, t), middle_P = shape(line, exactly(middle));
  if (P.value.high < 0.0 || (middle_P.value + P.slope * (t - exactly(middle))).high < 0.0) return -1.0;
  if (t.high - t.low < 1e-12) {
    certain = shape(line, exactly(t.high + 1e-9)).value.low > 0.0;
    return t.low;
  }
  if (P.slope.low > 0.0 || P.slope.high < 0.0) {
    const Interval left = narrowed(t, P, middle_P);
    if (left.high - left.low < 0.5 * (t.high - t.low)) return bisected(line, left, certain);
  }
  const double first = bisected(line, {t.low, middle}, certain);
  return first >= 0.0 ? first : bisected(line, {middle, t.high}, certain);
}

// What differs between the library and bisection, of many lines.
struct Found {
  long missed = 0, invented = 0, hits = 0, doubtful = 0;
  double farthest = 0.0;  // between the two [radii]
};
void compare(const Line& line, double begin, double t, Found& found) {
  bool certain = false;
  const double expected = bisected(line, {begin, 5.0}, certain);
  if (expected < 0.0) {
    found.invented += t < nowhere ? 1 : 0;
  } else if (!certain) {
    ++found.doubtful;
  } else {
    ++found.hits;
    found.missed += t < nowhere ? 0 : 1;
    if (t < nowhere) found.farthest = std::max(found.farthest, std::abs(t - expected));
  }
}

// The ray where it is after its reflection at a distance. Bisection begins 1e-9 beyond: up to there, if the slope is
// negative for certain, the ray only gets farther away from the cell.
void compare_again(const RedCell& cell, const Eigen::Matrix3d& turned, Line line, double t, Found& found) {
  line.from += t * line.direction;
  const Vector3d normal = outward_normal(RedCell{.radius = 1.0}, line.from);
  line.direction = (line.direction - 2.0 * line.direction.dot(normal) * normal).normalized();
  const double begin = 1e-9;
  if (!(shape(line, {0.0, begin}).slope.high < 0.0)) return (void)++found.doubtful;
  compare(line, begin, next_entry(cell, turned * line.from, turned * line.direction), found);
}

const Case first_hits{
    {.name = "red_cell_first_hits",
     .claim = "no ray misses a red cell that it meets, and none meets one that it misses: against interval bisection",
     .equation = "R B.2",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      Uniform uniform(21);
      const auto draw = [&] { return uniform(); };
      const Vector3d axis = random_direction(draw);
      const RedCell cell{.axis = axis, .radius = 1.0};
      const Eigen::Matrix3d turned = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), axis).toRotationMatrix();
      const long rays = rows.quick() ? 20000 : 1000000;
      const auto entry = [&](const Line& line) {
        return first_entry(cell, turned * line.from, turned * line.direction);
      };
      Found any, tangent, again;
      for (long k = 0; k < rays; ++k) {
        const Vector3d d = random_direction(draw), aside = 1.05 * std::sqrt(uniform()) * random_direction(draw);
        const Line line{aside - aside.dot(d) * d - 2.0 * d, d};
        const double t = entry(line);
        compare(line, 0.0, t, any);
        if (t < nowhere) compare_again(cell, turned, line, t, again);
      }
      // Through places within 1e-9 above a place of the surface, along it.
      for (long k = 0; k < rays / 10; ++k) {
        const double rho = std::sqrt(uniform()), phi = 2.0 * std::numbers::pi * uniform();
        const RedCell upright{.radius = 1.0};
        const Vector3d on(rho * std::cos(phi), rho * std::sin(phi), half_thickness(upright, rho));
        const Vector3d normal = outward_normal(upright, on), d = normal.cross(random_direction(draw)).normalized();
        const Line line{on + (2.0 * uniform() - 1.0) * 1e-9 * normal - 2.0 * d, d};
        compare(line, 0.0, entry(line), tangent);
      }
      for (const auto& [what, found] : {std::pair{"any rays", any},
                                        {"rays within 1e-9 of a tangent", tangent},
                                        {"any rays, after a reflection", again}}) {
        rows.none(fmt::format("{}: missed", what), found.missed, "roots are bracketed, none is stepped over");
        rows.none(fmt::format("{}: met where nothing is", what), found.invented, "likewise");
        rows.at_least(fmt::format("{}: that meet the cell for certain", what),
                      {.limit = 0.2 * static_cast<double>(found.hits + found.doubtful + 1),
                       .computed = static_cast<double>(found.hits),
                       .because = "else the others say little"});
      }
      for (const auto& [what, found] : {std::pair{"any rays", any}, {"any rays, after a reflection", again}}) {
        rows.at_most(fmt::format("{}: farthest from the bisected place [radii]", what),
                     {.limit = 2e-9, .computed = found.farthest, .because = "1e-12 over the cosine at near tangents"});
      }
    }};

}  // namespace verification::red_cells
