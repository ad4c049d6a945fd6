// A sphere that light heats, in a steady beam and after a pulse, against closed forms.

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include <harness/case.hpp>
#include <harness/uniform.hpp>
#include <particulate/scattering/beam.hpp>

#include "heated.hpp"

namespace verification::light_that_heats {

using namespace particulate;
using namespace particulate::scattering;

// n^ = 10: what a sphere reflects of a beam, and the heat capacity per volume of all cases.
constexpr Fresnel law{10.0};
constexpr double F = 0.640174994374749, rho_c = 2e6;

Eigen::VectorXd after(const HeatedBodies& bodies, double theta_0, double t) {
  return heated(bodies, start(bodies, theta_0), t, 1e-12).y;
}

// A ball of 1 mm in the middle of a disc that it fills.
constexpr double b = 1e-3, shadow = std::numbers::pi * b * b;
const Cloud<Sphere> lone({{.radius = b}}, {.lengths = Eigen::Vector3d::Constant(4.0 * b),
                                           .corner = Eigen::Vector3d::Constant(-2.0 * b)});
Rays disc_of_rays(double irradiance, int edge) {
  Uniform uniform(41);
  const Beam beam{.shape = Beam::Shape::disc,
                  .centre = {-2.0 * b, 0.0, 0.0},
                  .width = 2.0 * b,
                  .irradiance = irradiance,
                  .points = Beam::Points::stratified};
  return rays_of(beam, edge * edge, [&] { return uniform(); });
}

// Four standard errors of the absorbed share of that disc, if rays were random: stratified ones have less.
double allowance(int edge) {
  const double second = boost::math::quadrature::gauss<double, 30>::integrate(
      [](double c) { return 2.0 * c * std::pow(reflectance(law, c), 2); }, 0.0, 1.0);
  return 4.0 * std::sqrt(second - F * F) / edge;
}

HeatedBodies lone_in_beam(double irradiance, const thermo::Cooling& cooling) {
  HeatedBodies bodies = heated_bodies(lone, rho_c, cooling);
  bodies.power[0] = (1.0 - F) * irradiance * shadow;
  return bodies;
}

const Case steady{
    {.name = "lone_sphere_in_steady_beam",
     .claim = "a sphere in a steady beam ends at the temperature at which it radiates what it absorbs, and gets there "
              "in the time of the closed form",
     .equation = "R 9.5",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const thermo::Cooling radiation{.emissivity = 1.0};
      for (const auto& [irradiance, end] : {std::pair{1e4, 393.451288231247}, {1e6, 1123.71932603170}}) {
        const HeatedBodies bodies = lone_in_beam(irradiance, radiation);
        const auto row = [&](const char* what, double computed, double off, const char* because) {
          rows.compare(fmt::format("{} in {:.0e} W/m^2 [K]", what, irradiance),
                       {.expected = end, .computed = computed, .tolerance = relative(off), .because = because});
        };
        row("end", equilibrium_temperatures(bodies)[0], 1e-14, "bisection to rounding");
        row("where a run ends", after(bodies, 300.0, 3000.0)[0], 1e-11, "after sixty times what it takes, or more");
      }
      const HeatedBodies bodies = lone_in_beam(1e6, radiation);
      HeatedBodies traced = bodies;
      const int edge = rows.quick() ? 200 : 1000;
      traced.power = trace(lone, law, disc_of_rays(1e6, edge)).absorbed;
      for (const auto& [theta, t] : {std::pair{400.0, 0.744638296813794}, {1000.0, 6.68720530188183}}) {
        rows.compare(fmt::format("after {} s in 1e6 W/m^2 [K]", t), {.expected = theta,
                                                                     .computed = after(bodies, 300.0, t)[0],
                                                                     .tolerance = relative(1e-9),
                                                                     .because = "1e-12 of a step"});
        rows.compare(fmt::format("after {} s in 1e6 W/m^2, with the power of {} rays [K]", t, edge * edge),
                     {.expected = theta,
                      .computed = after(traced, 300.0, t)[0],
                      .tolerance = absolute(allowance(edge) * 1e6 * shadow * t / (rho_c * 4.0 / 3.0 * shadow * b)),
                      .because = "four standard errors of the power, times t/(m c): radiation makes that less"});
      }
    }};

const Case convection{
    {.name = "convection_against_radiation",
     .claim = "a sphere between a hot flow and cold surroundings comes to rest where both balance",
     .equation = "R 9.5",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const HeatedBodies bodies =
          heated_bodies(lone, rho_c, {.h_c = 100.0, .theta_o = 600.0, .emissivity = 1.0, .theta_s = 300.0});
      const auto row = [&](const char* what, double computed, double off, const char* because) {
        rows.compare(
            what, {.expected = 551.961402904145, .computed = computed, .tolerance = relative(off), .because = because});
      };
      row("end [K]", equilibrium_temperatures(bodies)[0], 1e-14, "bisection to rounding");
      row("where a run ends [K]", after(bodies, 300.0, 300.0)[0], 1e-11, "after sixty times what it takes");
    }};

const Case pulse{
    {.name = "lone_sphere_after_pulse",
     .claim =
         "a pulse warms a sphere by 3 (1 - F) H/(4 rho c b), a ray along its axis by what it does not reflect there",
     .equation = "R 9.5",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const HeatedBodies bodies = heated_bodies(lone, rho_c);
      const Eigen::VectorXd cold = start(bodies, 300.0).y;
      const int edge = rows.quick() ? 200 : 1000;
      const double H = 1e5, of_all = 3.0 * H / (4.0 * rho_c * b);
      const double warm = warmed_by(bodies, cold, trace(lone, law, disc_of_rays(H, edge)).absorbed)[0];
      rows.compare("rise after 1e5 J/m^2 [K]", {.expected = (1.0 - F) * of_all,
                                                .computed = warm - 300.0,
                                                .tolerance = absolute(allowance(edge) * of_all),
                                                .because = "four standard errors of so many random rays"});
      const Rays ray{.place = Eigen::Vector3d(-2.0 * b, 0.0, 0.0).transpose(),
                     .direction = Eigen::Vector3d::UnitX().transpose(),
                     .power = Eigen::VectorXd::Constant(1, 1e-3)};
      const Traced traced = trace(lone, law, ray, {.keeps_paths = true});
      rows.compare("rise after a ray of 1 mJ along the axis [K]",
                   {.expected = 40.0 / 121.0 * 1e-3 / (rho_c * 4.0 / 3.0 * shadow * b),
                    .computed = warmed_by(bodies, cold, traced.absorbed)[0] - 300.0,
                    .tolerance = absolute(1e-12),
                    .because = "R = (9/11)^2, and rounding of 300 K"});
      const std::vector<HeatJump> jumps = heat_jumps(traced.paths);
      rows.equal("jumps of it", {.expected = 1, .computed = jumps.size(), .because = "it leaves a convex body"});
      rows.compare("time of flight of it [s]", {.expected = b / 299792458.0,
                                                .computed = jumps.at(0).t,
                                                .tolerance = relative(1e-15),
                                                .because = "rounding of a length over the speed of light"});
    }};

}  // namespace verification::light_that_heats
