// Red cells by straight lines: volume, surface, chords, shadow and thickness from nothing but entries of rays.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>

#include <harness/case.hpp>
#include <harness/uniform.hpp>
#include <particulate/scattering/placement.hpp>
#include <particulate/scattering/red_cell.hpp>

namespace verification::red_cell_chords {

using namespace particulate::scattering;
using Eigen::Vector3d;

// A human cell, in micrometres.
RedCell human(const Vector3d& axis) { return {.axis = axis, .radius = 3.91}; }

// Where a line enters the cell, in order. A line that goes on inwards from an entry is told the next one, as the root
// where it starts is divided out.
std::vector<double> entries(const RedCell& cell, const Vector3d& from, const Vector3d& direction) {
  std::vector<double> all;
  for (double t = first_entry(cell, from, direction); t < nowhere;) {
    all.push_back(t);
    t += next_entry(cell, from + t * direction, direction);
  }
  return all;
}

// What lies inside of a line through the foot of the perpendicular from the centre: where it leaves, the line in the
// opposite direction enters.
struct Inside {
  std::size_t entered = 0, left = 0;
  double length = 0.0;
};
Inside inside(const RedCell& cell, const Vector3d& foot, const Vector3d& direction) {
  const std::vector<double> in = entries(cell, foot - 10.0 * direction, direction),
                            out = entries(cell, foot + 10.0 * direction, -direction);
  Inside found{.entered = in.size(), .left = out.size()};
  for (const double t : in) found.length += 10.0 - t;
  for (const double t : out) found.length += 10.0 - t;
  return found;
}

// A mean, and its standard error.
struct Sample {
  double n = 0.0, sum = 0.0, squares = 0.0;

  void add(double x) { n += 1.0, sum += x, squares += x * x; }
  double mean() const { return sum / n; }
  double error() const { return std::sqrt((squares / n - mean() * mean()) / n); }
};

const Case chords{
    {.name = "red_cell_chords",
     .claim = "lines in all directions find the volume, the surface, the mean chord and the mean shadow of a red cell",
     .equation = "R B.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      Uniform uniform(rows.case_seed());
      const auto draw = [&] { return uniform(); };
      const RedCell cell = human(random_direction(draw));
      // All lines that meet the ball about the cell: V = A <length>, S = 4 A <pieces>, shadow A <whether there is one>.
      const double A = std::numbers::pi * cell.radius * cell.radius, chord = 2.80680987267606;
      Sample length, pieces, shadow, off_chord;
      long uneven = 0, several = 0;
      for (long k = 0; k < (rows.quick() ? 50000 : 1000000); ++k) {
        const Vector3d d = random_direction(draw), aside = d.cross(random_direction(draw)).normalized();
        const Inside found = inside(cell, cell.radius * std::sqrt(draw()) * aside, d);
        uneven += found.entered == found.left ? 0 : 1;
        several += found.entered > 1 ? 1 : 0;
        const auto n = static_cast<double>(found.entered);
        length.add(found.length);
        pieces.add(n);
        shadow.add(std::min(n, 1.0));
        off_chord.add(found.length - n * chord);
      }
      const auto row = [&](const char* what, double expected, double scale, const Sample& sample) {
        rows.compare(what, {.expected = expected,
                            .computed = scale * sample.mean(),
                            .tolerance = absolute(4.0 * scale * sample.error()),
                            .because = "four standard errors"});
      };
      row("volume [um^3]", 94.0910641006, A, length);
      row("surface [um^2]", 134.0896866817, 4.0 * A, pieces);
      row("mean shadow, a quarter of the convex hull's surface [um^2]", 131.043613676571 / 4.0, A, shadow);
      rows.compare("mean chord, each piece by itself [um]",
                   {.expected = chord,
                    .computed = length.mean() / pieces.mean(),
                    .tolerance = absolute(4.0 * off_chord.error() / pieces.mean()),
                    .because = "four standard errors of a ratio"});
      rows.none("lines that enter more or less often than they leave", uneven,
                "a line comes from outside, and ends there");
      rows.at_least("lines that enter twice",
                    {.limit = 0.005 * length.n,
                     .computed = static_cast<double>(several),
                     .because = "convex bodies have none, and these counts would say nothing of dimples"});
    }};

// The chord of a line along the axis.
double thickness(double rho) {
  const Vector3d axis = Vector3d(2.0, -1.0, 2.0) / 3.0, across = Vector3d(1.0, 2.0, 0.0) / std::sqrt(5.0);
  return inside(human(axis), rho * across, axis).length;
}

const Case along_the_axis{
    {.name = "red_cell_thickness",
     .claim = "rays along its axis find how thick a red cell is, where most, and its volume to the last digits",
     .equation = "R B.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      // Smooth in the angle of rho = R_0 sin(phi).
      const auto ring = [](double phi) {
        const double rho = 3.91 * std::sin(phi);
        return thickness(rho) * 2.0 * std::numbers::pi * rho * 3.91 * std::cos(phi);
      };
      const double half = 0.25 * std::numbers::pi;
      using Gauss = boost::math::quadrature::gauss<double, 30>;
      rows.compare("volume [um^3]",
                   {.expected = 94.0910641006,
                    .computed = Gauss::integrate(ring, 0.0, half) + Gauss::integrate(ring, half, 2.0 * half),
                    .tolerance = relative(1e-12),
                    .because = "twelve digits were given"});
      rows.compare("thin in the middle [um]",
                   {.expected = 0.81, .computed = thickness(0.0), .tolerance = relative(1e-13), .because = "rounding"});
      const auto [rho, thick] =
          boost::math::tools::brent_find_minima([](double r) { return -thickness(r); }, 1.0, 3.9, 50);
      rows.compare("thickest at [um]", {.expected = 2.73781417506947,
                                        .computed = rho,
                                        .tolerance = absolute(1e-6),
                                        .because = "a maximum hides half of the digits"});
      rows.compare("there [um]", {.expected = 2.5656737,
                                  .computed = -thick,
                                  .tolerance = absolute(5e-8),
                                  .because = "eight digits were given"});
    }};

}  // namespace verification::red_cell_chords
