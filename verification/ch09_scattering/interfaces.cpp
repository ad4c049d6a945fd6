// What interfaces reflect: against fifty digits, closed forms and numbers of the textbooks.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>

#include <harness/case.hpp>
#include <harness/uniform.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/scattering/interface.hpp>

namespace verification::interfaces {

using namespace particulate::scattering;
using Wide = boost::multiprecision::cpp_dec_float_50;

constexpr double degree = std::numbers::pi / 180.0;

// As they are printed, in fifty digits.
Wide printed(const Fresnel& law, const Wide& c) {
  const Wide n = law.n_hat, mu = law.mu_hat, square = n * n - 1 + c * c;
  if (square <= 0) return 1;
  const Wide s = sqrt(square), along = (n * n / mu * c - s) / (n * n / mu * c + s),
             across = (c - s / mu) / (c + s / mu);
  return (along * along + across * across) / 2;
}
Wide printed(const FluidFluid& law, const Wide& c) {
  const Wide square = 1 - Wide(law.c_hat) * law.c_hat * (1 - c * c);
  if (square <= 0) return 1;
  const Wide t = sqrt(square), r = (law.Z_hat * c - t) / (law.Z_hat * c + t);
  return r * r;
}

// Cosines at random, and as near to grazing, to normal incidence and to the edge of total reflection as doubles get.
std::vector<double> cosines(double edge) {
  Uniform uniform(5);
  std::vector<double> all{0.0, 1.0};
  for (int k = 0; k < 300; ++k) {
    const double small = std::pow(10.0, -14.0 * uniform());
    for (const double c : {uniform(), small, 1.0 - small, edge + small, edge - small}) {
      if (c >= 0.0 && c <= 1.0) all.push_back(c);
    }
  }
  return all;
}

// The largest error in units in the last place.
template <class Law>
double units_off(const Law& law, double edge) {
  double worst = 0.0;
  for (const double c : cosines(edge)) {
    const Wide exact = printed(law, c);
    const double nearest = exact.template convert_to<double>(), unit = std::nextafter(nearest, 2.0) - nearest;
    worst = particulate::report::worse_of(
        worst, Wide(abs(Wide(reflectance(law, c)) - exact) / unit).template convert_to<double>());
  }
  return worst;
}

const Case last_place{
    {.name = "reflectance_to_the_last_place",
     .claim = "reflectance is right to four units in the last place, from equal indices to 1e6, from grazing to normal "
              "incidence, and at the edge of total reflection",
     .equation = "D 9.2.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const char* const because = "formed with twice the digits of a double, and rounded a few times";
      for (const double mu : {1.0, 2.0, 10.0, 0.3}) {
        for (const double n : {1.0 - 1e-12, 1.0 + 1e-12, 0.67, 1.075, 1.5, 2.0, 10.0, 1e6}) {
          const double edge = n < 1.0 ? std::sqrt((1.0 - n) * (1.0 + n)) : 0.5;
          rows.at_most(fmt::format("n^ = {}, mu^ = {} [units in the last place]", n, mu),
                       {.limit = 4.0, .computed = units_off(Fresnel{n, mu}, edge), .because = because});
        }
      }
      for (const auto& [Z, c] : {std::pair{2.0, 0.5}, {10.0, 0.5}, {2.0, 1.0}, {0.5, 2.0}, {3566.3, 4.35}}) {
        const double edge = c > 1.0 ? std::sqrt((1.0 - 1.0 / c) * (1.0 + 1.0 / c)) : 0.5;
        rows.at_most(fmt::format("Z^ = {}, c^ = {} [units in the last place]", Z, c),
                     {.limit = 4.0, .computed = units_off(FluidFluid{Z, c}, edge), .because = because});
      }
    }};

const Case numbers{
    {.name = "fresnel_numbers",
     .claim = "glass reflects what its closed form says at 30, 60 and 85 degrees, and nothing of one amplitude at "
              "Brewster's angle",
     .equation = "D 9.2.4",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const Fresnel glass{1.5};
      for (const auto& [angle, R] :
           {std::pair{30.0, 0.041522625975822}, {60.0, 0.089186712802213}, {85.0, 0.61279964526483}}) {
        rows.compare(fmt::format("R at {} degrees", angle), {.expected = R,
                                                             .computed = reflectance(glass, std::cos(angle * degree)),
                                                             .tolerance = relative(2e-14),
                                                             .because = "fourteen digits were given"});
      }
      rows.compare("Brewster's angle [degrees]", {.expected = 56.30993247,
                                                  .computed = brewster_angle(1.5) / degree,
                                                  .tolerance = absolute(5e-9),
                                                  .because = "eight decimals were given"});
      rows.compare("r_parallel there", {.expected = 0.0,
                                        .computed = r_parallel(glass, std::cos(brewster_angle(1.5))),
                                        .tolerance = absolute(2e-16),
                                        .because = "rounding of the cosine"});
      rows.compare("R at 60 degrees from both amplitudes",
                   {.expected = 0.089186712802213,
                    .computed = 0.5 * (std::pow(r_parallel(glass, 0.5), 2) + std::pow(r_perpendicular(glass, 0.5), 2)),
                    .tolerance = relative(2e-14),
                    .because = "fourteen digits were given"});
    }};

const Case integrated{
    {.name = "integrated_reflectance",
     .claim = "integrals of reflectance over a sphere have the values of 25-digit quadrature",
     .equation = "D 9.3.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const auto row = [&](const std::string& what, double expected, double computed) {
        rows.compare(what, {.expected = expected,
                            .computed = computed,
                            .tolerance = relative(2e-14),
                            .because = "sums of a few hundred terms of one sign, or fewer of several"});
      };
      for (const auto& [n, F] : {std::pair{1.075, 0.0197331224069517},
                                 {1.5, 0.091777959342351},
                                 {2.0, 0.160596637069606},
                                 {4.0, 0.366638056497679},
                                 {10.0, 0.640174994374749},
                                 {32.0, 0.858761459011613},
                                 {100.0, 0.950161171239651}}) {
        row(fmt::format("F, n^ = {}", n), F, sphere_reflectance(Fresnel{n}));
      }
      row("F, n^ = mu^ = 2", 0.0737571144330509, sphere_reflectance(Fresnel{2.0, 2.0}));
      row("F, n^ = mu^ = 10", 0.0897307074344240, sphere_reflectance(Fresnel{10.0, 10.0}));
      for (const auto& [n, x] : {std::pair{1.5, 0.0393268730564126},
                                 {2.0, 0.0367182622878926},
                                 {4.0, 0.00684355927494563},
                                 {10.0, -0.0198041189561911}}) {
        row(fmt::format("I_x of a lone sphere, n^ = {}", n), x, sphere_x_irradiance(Fresnel{n}));
      }
      for (const auto& [n, S] :
           {std::pair{1.5, 0.153271905669549}, {2.0, 0.180184246116391}, {10.0, 0.320666631117923}}) {
        row(fmt::format("slope of stepping, n^ = {}", n), S, stepping_slope(Fresnel{n}));
      }
      row("sound, F(2, 0.5)", 0.0619340148799528, sphere_reflectance(FluidFluid{2.0, 0.5}));
      row("sound, F(2, 1)", 1.0 / 9.0, sphere_reflectance(FluidFluid{2.0, 1.0}));
      row("sound, F(2, 2)", 22.0 / 27.0, sphere_reflectance(FluidFluid{2.0, 2.0}));
      row("sound, F(10, 0.5)", 0.533293227938267, sphere_reflectance(FluidFluid{10.0, 0.5}));
      row("sound, F(10, 2)", 0.939328074923321, sphere_reflectance(FluidFluid{10.0, 2.0}));
      // Both ways of the library against a third: Kronrod's rule of the printed formulas, in long double.
      for (const double n : {1.05, 1.3, 1.5, 3.0}) {
        const auto printed_in_long_double = [&](long double c) {
          const long double s = std::sqrt((n - 1.0L) * (n + 1.0L) + c * c), p = static_cast<long double>(n) * n;
          const long double along = (p * c - s) / (p * c + s), across = (c - s) / (c + s);
          return c * (along * along + across * across);
        };
        using Kronrod = boost::math::quadrature::gauss_kronrod<long double, 61>;
        row(fmt::format("F, n^ = {}, by Kronrod's rule", n),
            static_cast<double>(Kronrod::integrate(printed_in_long_double, 0.0L, 1.0L, 15, 1e-18L)),
            sphere_reflectance(Fresnel{n}));
      }
      for (const auto& [n, F] : {std::pair{1.5, 0.06798}, {2.0, 0.13804}, {10.0, 0.65313}}) {
        rows.compare(fmt::format("planar quarter, n^ = {}", n), {.expected = F,
                                                                 .computed = planar_reflectance(Fresnel{n}),
                                                                 .tolerance = absolute(5e-6),
                                                                 .because = "five digits were given"});
      }
    }};

}  // namespace verification::interfaces
