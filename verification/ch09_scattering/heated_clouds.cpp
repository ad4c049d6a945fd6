// Clouds that light heats: energy books, jumps of a pulse, threads, CVODE, and how warm the monograph's cloud becomes.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/uniform.hpp>
#include <particulate/reference/integrator.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/scattering/beam.hpp>
#include <particulate/scattering/placement.hpp>
#include <particulate/scattering/stepped.hpp>

#include "heated.hpp"

namespace verification::heated_clouds {

using namespace particulate;
using namespace particulate::scattering;
using report::Mean, report::mean_of;
using std::numbers::pi;

// n^ = 10: what a sphere reflects of a beam, and the heat capacity per volume of all cases.
constexpr Fresnel law{10.0};
constexpr double F = 0.640174994374749, rho_c = 2e6;

Eigen::VectorXd after(const HeatedBodies& bodies, double theta_0, double t) {
  return heated(bodies, start(bodies, theta_0), t, 1e-12).y;
}

// The set of figures 9.13 to 9.18: a cube of 1 mm, half of whose face is lit by a pulse.
constexpr double edge_of_cube = 1e-3, fluence = 1.70e5;
const kinematics::Box cube{.lengths = Eigen::Vector3d::Constant(edge_of_cube)};
Beam pulse_beam(double irradiance = fluence) {
  return {
      .centre = {0.0, 0.5 * edge_of_cube, 0.5 * edge_of_cube}, .width = 0.5 * edge_of_cube, .irradiance = irradiance};
}
Cloud<Sphere> cloud_of(Eigen::Index N, double L, Uniform& uniform) {
  const double radius = L * edge_of_cube / std::cbrt(static_cast<double>(N));
  return Cloud<Sphere>(
      place_spheres(N, radius, {.box = cube, .inside = kinematics::Inside::spheres}, [&] { return uniform(); }).bodies,
      cube);
}

// A claim about three kinds of bodies, with the volume of one of each [m^3].
template <class Claim>
void of_each_shape(const Claim& claim) {
  Uniform uniform(42);
  const auto draw = [&] { return uniform(); };
  const kinematics::Addition to{.box = cube, .inside = kinematics::Inside::spheres};
  claim("spheres", cloud_of(300, 0.325, uniform), 4.0 / 3.0 * pi * std::pow(0.325 * edge_of_cube, 3) / 300.0);
  const Spheroid oblate{.equatorial = 5e-5, .polar = 1.25e-5};
  claim("oblates", Cloud<Spheroid>(place_spheroids(300, oblate, to, draw).bodies, cube),
        4.0 / 3.0 * pi * 5e-5 * 5e-5 * 1.25e-5);
  claim("red cells", Cloud<RedCell>(place_red_cells(300, {.radius = 5e-5}, to, draw).bodies, cube),
        94.0910641006 * std::pow(5e-5 / 3.91, 3));
}

// What exact and stepped tracing of a pulse leave in a cloud, up to a length of the paths.
struct Tracer {
  const char* name;
  double xi;  // 0: exact
};
constexpr Tracer tracers[] = {{"exact", 0.0}, {"stepped", 0.2}};
template <class B>
Traced traced_by(const Tracer& tracer, const Cloud<B>& cloud, const Rays& rays, const TraceSettings& settings = {}) {
  if (tracer.xi == 0.0) return trace(cloud, law, rays, settings);
  return trace_in_steps(cloud, law, rays, {.xi = tracer.xi, .bounds = settings});
}

const Case books{
    {.name = "heat_books",
     .claim = "what rays of a pulse have lost is what bodies hold in warmth, whatever the bodies and the tracer",
     .equation = "R 9.5",
     .reference = Reference::identity},
    [](Rows& rows) {
      Uniform uniform(43);
      const Rays rays = rays_of(pulse_beam(), rows.quick() ? 2000 : 20000, [&] { return uniform(); });
      const auto row = [&](const std::string& what, const auto& cloud, double volume) {
        const HeatedBodies bodies = heated_bodies(cloud, rho_c);
        const Eigen::VectorXd cold = start(bodies, 300.0).y;
        for (const Tracer& tracer : tracers) {
          const Traced traced = traced_by(tracer, cloud, rays);
          const Eigen::VectorXd rise = warmed_by(bodies, cold, traced.absorbed) - cold;
          rows.compare(fmt::format("{}, {}: warmth [J]", what, tracer.name),
                       {.expected = fluence * 0.25 * edge_of_cube * edge_of_cube - traced.rays.power.sum(),
                        .computed = rho_c * volume * rise.sum(),
                        .tolerance = relative(1e-11),
                        .because = "the volume of a red cell is known to 12 digits, 300 K are rounded"});
        }
      };
      of_each_shape(row);
    }};

// Temperatures after the jumps up to a time.
Eigen::VectorXd after_jumps(const HeatedBodies& bodies, Eigen::VectorXd theta, const std::vector<HeatJump>& jumps,
                            double t) {
  for (const HeatJump& jump : jumps) {
    if (jump.t > t) break;
    theta[jump.body] += jump.energy / bodies.capacity[jump.body];
  }
  return theta;
}

const Case jump_by_jump{
    {.name = "jump_by_jump",
     .claim = "the jumps of a pulse up to a time lead to the temperatures of a trace that is stopped there, hit by hit",
     .equation = "R 9.5",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      Uniform uniform(44);
      const Rays rays = rays_of(pulse_beam(), rows.quick() ? 1000 : 10000, [&] { return uniform(); });
      const auto row = [&](const std::string& what, const auto& cloud, double) {
        const HeatedBodies bodies = heated_bodies(cloud, rho_c);
        const Eigen::VectorXd cold = start(bodies, 300.0).y;
        for (const Tracer& tracer : tracers) {
          const std::vector<HeatJump> jumps =
              heat_jumps(traced_by(tracer, cloud, rays, {.least_share = 0.2, .keeps_paths = true}).paths);
          double off = 0.0;
          for (const double length : {0.31 * edge_of_cube, 0.77 * edge_of_cube, 1e9 * edge_of_cube}) {
            const Traced stopped = traced_by(tracer, cloud, rays, {.least_share = 0.2, .path_length = length});
            const Eigen::VectorXd theta = warmed_by(bodies, cold, stopped.absorbed);
            off = report::worse_of(
                off, (theta - after_jumps(bodies, cold, jumps, length / 299792458.0)).cwiseAbs().maxCoeff());
          }
          rows.compare(fmt::format("{}, {}: largest difference of a temperature at three times [K]", what, tracer.name),
                       {.expected = 0.0,
                        .computed = off,
                        .tolerance = absolute(1e-9),
                        .because = "roundings of a thousand jumps, where one ray warms by some kelvins"});
        }
      };
      of_each_shape(row);
    }};

const Case same_bits{{.name = "heat_of_threads",
                      .claim = "any number of threads warms bodies to the same bits, at the same times",
                      .equation = "R 9.5",
                      .reference = Reference::identity},
                     [](Rows& rows) {
                       Uniform uniform(45);
                       const Rays rays = rays_of(pulse_beam(), rows.quick() ? 3000 : 30000, [&] { return uniform(); });
                       const auto row = [&](const std::string& what, const auto& cloud, double) {
                         const HeatedBodies bodies = heated_bodies(cloud, rho_c);
                         const auto with = [&](int threads) {
                           const Traced traced = trace(cloud, law, rays, {.keeps_paths = true, .threads = threads});
                           std::vector<double> all;
                           for (const HeatJump& jump : heat_jumps(traced.paths))
                             all.insert(all.end(), {jump.t, jump.energy});
                           const Eigen::VectorXd theta = warmed_by(bodies, start(bodies, 300.0).y, traced.absorbed);
                           all.insert(all.end(), theta.begin(), theta.end());
                           return all;
                         };
                         const std::vector<double> one = with(1);
                         for (const int threads : {2, 3}) {
                           rows.equal(fmt::format("{}: the same with {} threads", what, threads),
                                      {.expected = true,
                                       .computed = with(threads) == one,
                                       .because = "paths and sums are in the order of the rays"});
                         }
                       };
                       of_each_shape(row);
                     }};

const Case equal_fluence{
    {.name = "pulse_and_beam",
     .claim = "without losses a pulse and a steady beam of the same fluence warm bodies alike",
     .equation = "R 9.5",
     .reference = Reference::identity},
    [](Rows& rows) {
      const double irradiance = 1e6;
      Uniform uniform(46);
      const Cloud<Sphere> cloud = cloud_of(300, 0.325, uniform);
      HeatedBodies bodies = heated_bodies(cloud, rho_c);
      const auto absorbed = [&](const Beam& beam) {
        Uniform same(47);
        return trace(cloud, law, rays_of(beam, 2000, [&] { return same(); })).absorbed;
      };
      const Eigen::VectorXd after_pulse = warmed_by(bodies, start(bodies, 300.0).y, absorbed(pulse_beam()));
      bodies.power = absorbed(pulse_beam(irradiance));
      const Eigen::VectorXd in_beam = after(bodies, 300.0, fluence / irradiance);
      const double off = (in_beam - after_pulse).cwiseQuotient(after_pulse).cwiseAbs().maxCoeff();
      rows.compare("largest relative difference of 300 temperatures [-]",
                   {.expected = 0.0, .computed = off, .tolerance = absolute(1e-13), .because = "a constant rate"});
      rows.at_least("warmest [K]",
                    {.limit = 600.0, .computed = in_beam.maxCoeff(), .because = "else little is compared"});
    }};

const Case against_cvode{
    {.name = "heated_cloud_against_cvode",
     .claim = "bodies of a cloud that cool from 1e4 K in the light of a beam have the temperatures of CVODE BDF",
     .equation = "R 9.5",
     .reference = Reference::sundials},
    [](Rows& rows) {
      Uniform uniform(48);
      const Cloud<Sphere> cloud = cloud_of(rows.quick() ? 50 : 300, 0.325, uniform);
      HeatedBodies bodies = heated_bodies(cloud, rho_c, {.h_c = 50.0, .theta_o = 350.0, .emissivity = 0.8});
      bodies.power = trace(cloud, law, rays_of(pulse_beam(1e6), 5000, [&] { return uniform(); })).absorbed;
      schemes::State judge = start(bodies, 1e4);
      for (const double t : {1e-3, 0.1, 10.0}) {
        require_reached(reference::integrate(
            bodies, judge, t,
            reference::Bdf{.relative = 1e-12, .absolute = 1e-9, .jacobian = reference::BandedJacobian{0, 0}}));
        const Eigen::VectorXd own = after(bodies, 1e4, t);
        rows.compare(fmt::format("largest relative difference after {} s [-]", t),
                     {.expected = 0.0,
                      .computed = (own - judge.y).cwiseQuotient(judge.y).cwiseAbs().maxCoeff(),
                      .tolerance = absolute(1e-8),
                      .because = "BDF comes to 2e-9"});
      }
    }};

const Case cloud_rise{
    {.name = "cloud_after_pulse",
     .claim = "the cloud of figures 9.13 to 9.18 becomes warmer by 100 K, its hottest sphere by ten times as much, "
              "which few rays exaggerate",
     .equation = "R 9.5",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      const int realizations = rows.quick() ? 12 : 100;
      const Eigen::Index many = rows.quick() ? 20000 : 40000;
      std::vector<double> mean, few_hottest, hottest;
      for (int k = 0; k < realizations; ++k) {
        Uniform uniform(static_cast<std::uint64_t>(5000 + k));
        const Cloud<Sphere> cloud = cloud_of(1000, 0.325, uniform);
        const HeatedBodies bodies = heated_bodies(cloud, rho_c);
        const auto rises = [&](Eigen::Index n) {
          const Rays rays = rays_of(pulse_beam(), n, [&] { return uniform(); });
          return warmed_by(bodies, Eigen::VectorXd::Zero(1000), trace(cloud, law, rays).absorbed);
        };
        const Eigen::VectorXd few = rises(1000);
        few_hottest.push_back(few.maxCoeff() / few.mean());
        const Eigen::VectorXd rise = rises(many);
        mean.push_back(rise.mean());
        hottest.push_back(rise.maxCoeff() / rise.mean());
      }
      const Mean of_mean = mean_of(mean), of_few = mean_of(few_hottest), of_hottest = mean_of(hottest);
      // What an independent prototype found is absorbed, over rho c of all spheres; the last digit it gave counts as
      // its error.
      const double rise_of_all =
          fluence * 0.25 * edge_of_cube * edge_of_cube / (rho_c * 4.0 / 3.0 * pi * std::pow(0.325 * edge_of_cube, 3));
      rows.compare("mean rise [K]",
                   {.expected = 0.6749 * rise_of_all,
                    .computed = of_mean.value,
                    .tolerance = absolute(4.0 * std::hypot(0.0007 * rise_of_all, of_mean.standard_error)),
                    .because = "four joint standard errors"});
      const auto hottest_row = [&](Eigen::Index rays, double expected, const Mean& found) {
        rows.compare(fmt::format("hottest over mean rise, {} rays", rays),
                     {.expected = expected,
                      .computed = found.value,
                      .tolerance = absolute(1.0),
                      .because = "the digits of an independent prototype, for many rays in their limit"});
      };
      hottest_row(1000, 14.0, of_few);
      hottest_row(many, 10.0, of_hottest);
      rows.at_least(
          "hottest over mean rise, many rays",
          {.limit = 3.0 * (1.0 - F) * fluence / (4.0 * rho_c * 0.0325 * edge_of_cube) / (0.6749 * rise_of_all),
           .computed = of_hottest.value,
           .because = "a sphere in full light, which others light too"});
    }};

}  // namespace verification::heated_clouds
