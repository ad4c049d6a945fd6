// One body in a beam: rays in the places of quadrature rules, so that the tracer is held against many digits.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/quadrature/gauss.hpp>

#include <harness/case.hpp>
#include <harness/uniform.hpp>
#include <particulate/report/table.hpp>
#include <particulate/scattering/beam.hpp>
#include <particulate/scattering/red_cell.hpp>
#include <particulate/scattering/stepped.hpp>

namespace verification::lone_bodies {

using namespace particulate;
using namespace particulate::scattering;
using Eigen::Vector3d;

// One ray for each node of Gauss's rule over the distance from the axis, rho = width sin phi: its power is that of its
// ring, of a beam along x of 1 W/m^2. In so many panels that kinks of a profile do not matter.
Rays ring_rays(double width, int panels) {
  using Gauss = boost::math::quadrature::gauss<double, 30>;
  std::vector<std::pair<double, double>> rings;
  const double panel = 0.5 * std::numbers::pi / panels;
  for (int k = 0; k < panels; ++k) {
    const auto add = [&](double node, double weight) {
      const double phi = panel * (k + 0.5 * (1.0 + node)), rho = width * std::sin(phi);
      rings.emplace_back(rho, 0.5 * panel * weight * 2.0 * std::numbers::pi * rho * width * std::cos(phi));
    };
    for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i) {
      add(Gauss::abscissa()[i], Gauss::weights()[i]);
      add(-Gauss::abscissa()[i], Gauss::weights()[i]);
    }
  }
  const auto n = static_cast<Eigen::Index>(rings.size());
  Rays rays{.place = kinematics::Vectors(n, 3),
            .direction = Vector3d::UnitX().transpose().replicate(n, 1),
            .power = Eigen::VectorXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& [rho, power] = rings[static_cast<std::size_t>(i)];
    rays.place.row(i) << -2.0 * width, rho * 0.6, rho * 0.8;
    rays.power[i] = power;
  }
  return rays;
}

template <class B>
Cloud<B> alone(B body) {
  const double half = 2.0 * bounding_radius(body);
  return Cloud<B>({std::move(body)}, {.lengths = Vector3d::Constant(2.0 * half), .corner = Vector3d::Constant(-half)});
}

// What the first hits reflect of the power that meets the body.
template <class B, class Law>
double first_reflected(const B& body, double width, const Law& law, int panels) {
  const Ledger ledger = trace(alone(body), law, ring_rays(width, panels), {.most_hits = 0}).ledger;
  return ledger.cut_off / (ledger.cut_off + ledger.absorbed);
}

const Case sphere{{.name = "lone_sphere",
                   .claim = "the tracer gives the closed forms of a sphere in a beam, for light and for sound",
                   .equation = "D 9.3.2",
                   .reference = Reference::closed_form},
                  [](Rows& rows) {
                    const Sphere ball{.radius = 0.7};
                    const auto row = [&](const std::string& what, double expected, double computed) {
                      rows.compare(what,
                                   {.expected = expected,
                                    .computed = computed,
                                    .tolerance = relative(1e-12),
                                    .because = "Gauss's rule of a smooth function, and the rounding of a reflection"});
                    };
                    for (const auto& [n, F, x] : {std::array{1.5, 0.091777959342351, 0.0393268730564126},
                                                  {2.0, 0.160596637069606, 0.0367182622878926},
                                                  {4.0, 0.366638056497679, 0.00684355927494563},
                                                  {10.0, 0.640174994374749, -0.0198041189561911}}) {
                      const Ledger ledger = trace(alone(ball), Fresnel{n}, ring_rays(0.7, 2)).ledger;
                      row(fmt::format("F, n^ = {}", n), F, 1.0 - ledger.absorbed / ledger.incident);
                      row(fmt::format("I_x, n^ = {}", n), x, ledger.x / ledger.incident);
                    }
                    row("F, n^ = mu^ = 10", 0.0897307074344240, first_reflected(ball, 0.7, Fresnel{10.0, 10.0}, 2));
                    row("sound, F(2, 0.5)", 0.0619340148799528, first_reflected(ball, 0.7, FluidFluid{2.0, 0.5}, 2));
                    row("sound, F(10, 0.5)", 0.533293227938267, first_reflected(ball, 0.7, FluidFluid{10.0, 0.5}, 2));
                  }};

const Case shapes{
    {.name = "lone_shapes",
     .claim =
         "first hits of an oblate spheroid along its axis, and of a red cell face-on, reflect what quadrature says",
     .equation = "D 9.3.3",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const Spheroid oblate{.axis = Vector3d::UnitX(), .equatorial = 1.0, .polar = 0.25};
      const RedCell cell{.axis = Vector3d::UnitX(), .radius = 3.91};
      const auto row = [&](const std::string& what, double expected, double computed, double off) {
        rows.compare(what, {.expected = expected,
                            .computed = computed,
                            .tolerance = relative(off),
                            .because = "Gauss's rule in panels, of a profile that is smooth in the angle"});
      };
      for (const auto& [n, F] :
           {std::pair{1.5, 0.0446552408628878}, {2.0, 0.115728638618480}, {10.0, 0.666383215542096}}) {
        row(fmt::format("oblate 4:1, n^ = {}", n), F, first_reflected(oblate, 1.0, Fresnel{n}, 4), 1e-12);
      }
      for (const auto& [n, F] : {std::pair{1.075, 0.00739844048936529}, {1.5, 0.0585701568222044}}) {
        row(fmt::format("red cell, n^ = {}", n), F, first_reflected(cell, cell.radius, Fresnel{n}, 64), 1e-12);
      }
    }};

// Of a mirror the cosine of the deflection is uniform: sixteen bins.
const Case mirror{
    {.name = "mirror_sphere",
     .claim = "a mirror sphere scatters alike in all directions",
     .equation = "D 9.3.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      Uniform uniform(11);
      const Eigen::Index n = rows.quick() ? 20000 : 500000;
      const Beam beam{.shape = Beam::Shape::disc, .centre = {-2.0, 0.0, 0.0}, .width = 2.0};
      const Traced traced = trace(alone(Sphere{}), Fresnel{1e8}, rays_of(beam, n, [&] { return uniform(); }));
      std::array<double, 16> bins{};
      for (Eigen::Index i = 0; i < n; ++i) {
        bins[static_cast<std::size_t>(std::clamp(8.0 * (1.0 + traced.rays.direction(i, 0)), 0.0, 15.0))] += 1.0;
      }
      const double each = static_cast<double>(n) / 16.0;
      double chi_square = 0.0;
      for (const double bin : bins) chi_square += (bin - each) * (bin - each) / each;
      rows.at_most("chi-square of 15 degrees of freedom",
                   {.limit = boost::math::quantile(boost::math::chi_squared(15.0), 1.0 - 1e-4),
                    .computed = chi_square,
                    .because = "one seed in ten thousand is beyond"});
    }};

// The standard error of the reflectance of a sphere, whose disc is parted into rings of equal width, and ring k into
// 8k + 4 parts: R changes within a part with its distance from the axis, which is even there, but in the four parts at
// the diagonals of the square that the disc is the map of; there it is the larger one of two even numbers.
double stratified_error(const Fresnel& law, int edge) {
  const int rings = edge / 2;
  double sum = 0.0;
  for (int k = 0; k < rings; ++k) {
    const auto variance = [&](bool diagonal) {
      const auto moment = [&](int power) {
        return boost::math::quadrature::gauss<double, 30>::integrate(
            [&](double s) {
              const double rho = (k + s) / rings;
              return (diagonal ? 2.0 * s : 1.0) * std::pow(reflectance(law, std::sqrt(1.0 - rho * rho)), power);
            },
            0.0, 1.0);
      };
      return moment(2) - moment(1) * moment(1);
    };
    sum += 8.0 * k * variance(false) + 4.0 * variance(true);
  }
  return std::sqrt(sum) / (edge * edge);
}

const Case rates{
    {.name = "beams_converge",
     .claim = "errors of random and of stratified beams have the size that the variance of the reflectance gives them",
     .equation = "R 9.3",
     .reference = Reference::statistics},
    [](Rows& rows) {
      const Fresnel law{2.0};
      const double F = 0.160596637069606;
      const Cloud<Sphere> cloud = alone(Sphere{});
      report::Table table({"rays", "random", "expected of random", "stratified", "expected of stratified"});
      const int repeats = rows.quick() ? 20 : 100;
      for (const int edge : {16, 32, 64, 128}) {
        const auto error = [&](Beam::Points points) {
          double square = 0.0;
          for (int k = 0; k < repeats; ++k) {
            Uniform uniform(static_cast<std::uint64_t>(1000 * edge + k));
            const Beam beam{.shape = Beam::Shape::disc, .centre = {-2.0, 0.0, 0.0}, .width = 2.0, .points = points};
            const Ledger ledger = trace(cloud, law, rays_of(beam, edge * edge, [&] { return uniform(); })).ledger;
            const double off = 1.0 - ledger.absorbed / ledger.incident - F;
            square += off * off / repeats;
          }
          return std::sqrt(square);
        };
        const auto row = [&](const char* what, double expected, double computed) {
          rows.compare(fmt::format("{}, {} rays: root mean square of the error of F", what, edge * edge),
                       {.expected = expected,
                        .computed = computed,
                        .tolerance = relative(3.5 / std::sqrt(2.0 * repeats)),
                        .because = "three and a half standard errors of the root mean square of so many repeats"});
        };
        // The variance of R over the disc is that of one part, of even rho^2.
        const double second = boost::math::quadrature::gauss<double, 30>::integrate(
            [&](double c) { return 2.0 * c * std::pow(reflectance(law, c), 2); }, 0.0, 1.0);
        const double random = error(Beam::Points::random), stratified = error(Beam::Points::stratified);
        const std::array<double, 2> expected{std::sqrt(second - F * F) / edge, stratified_error(law, edge)};
        row("random", expected[0], random);
        row("stratified", expected[1], stratified);
        table.add({edge * edge, random, expected[0], stratified, expected[1]});
      }
      rows.write("beams", table);
    }};

// The lone sphere of the stepped tracer, at two steps, from which the limit is taken.
const Case stepping{
    {.name = "stepping_slope",
     .claim = "the stepped tracer converges to the exact one with the slope of its closed form",
     .equation = "D 9.3",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      Uniform uniform(3);
      const auto draw = [&] { return uniform(); };
      const Cloud<Sphere> cloud = alone(Sphere{});
      const Beam beam{
          .shape = Beam::Shape::disc, .centre = {-2.0, 0.0, 0.0}, .width = 2.0, .points = Beam::Points::stratified};
      const Eigen::Index n = rows.quick() ? 200 * 200 : 1000 * 1000;
      report::Table table({"n^", "xi", "I_x less its limit, over xi", "slope S"});
      for (const auto& [n_hat, S] :
           {std::pair{1.5, 0.153271905669549}, {2.0, 0.180184246116391}, {10.0, 0.320666631117923}}) {
        std::vector<double> slopes;
        for (const double xi : {0.1, 0.05}) {
          const Ledger stepped =
              trace_in_steps(cloud, Fresnel{n_hat}, rays_of(beam, n, draw), {.xi = xi, .phase = draw}).ledger;
          slopes.push_back((stepped.x / stepped.incident - sphere_x_irradiance(Fresnel{n_hat})) / xi);
          table.add({n_hat, xi, slopes.back(), S});
        }
        rows.compare(fmt::format("slope, extrapolated, n^ = {}", n_hat),
                     {.expected = S,
                      .computed = 2.0 * slopes[1] - slopes[0],
                      .tolerance = absolute(rows.quick() ? 0.02 : 0.006),
                      .because = "the phase of each ray is random: 0.3 over the root of the rays, over xi"});
      }
      rows.write("stepping", table);
    }};

}  // namespace verification::lone_bodies
