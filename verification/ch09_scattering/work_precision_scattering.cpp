// Error against run time of a lone sphere's I_x, exact tracing of more and more rays, stepped tracing in smaller and
// smaller steps; and of the mean temperature of a cloud.

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include <harness/case.hpp>
#include <harness/uniform.hpp>
#include <particulate/scattering/beam.hpp>
#include <particulate/scattering/placement.hpp>
#include <particulate/scattering/stepped.hpp>

namespace verification::work_precision_scattering {

using namespace particulate;
using namespace particulate::scattering;
using scattering::Cloud;

constexpr Fresnel law{10.0};
const Task task{.start = {0.0, 0.0, 0.0, 1.0}, .rate = {10.0}, .outputs = {1.0}};

// What is traced, and which number is wanted of it.
struct Lit {
  Cloud<Sphere> cloud;
  Beam beam;  // whatever its points
  std::function<double(const Ledger&)> number;
  double expected;
};

Rays rays_in(const Lit& lit, Beam::Points points, int edge, const std::function<double()>& draw) {
  Beam beam = lit.beam;
  beam.points = points;
  return rays_of(beam, edge * edge, draw);
}

// Root mean square of the errors of several seeds; nothing but rays is drawn and traced.
template <class Trace>
Prepared prepared(const Lit& lit, int edge, Beam::Points points, int seeds, long evaluations, const Trace& trace_rays) {
  const auto all = [=](const Cloud<Sphere>& cloud) {
    double squares = 0.0;
    for (int seed = 0; seed < seeds; ++seed) {
      Uniform uniform(static_cast<std::uint64_t>(seed + 1));
      const auto draw = [&] { return uniform(); };
      const Ledger ledger = trace_rays(cloud, rays_in(lit, points, edge, draw), draw);
      squares += std::pow(lit.number(ledger) - lit.expected, 2) / seeds;
    }
    return std::sqrt(squares);
  };
  const auto error = std::make_shared<double>(missing);
  const Counts counts{.evaluations = evaluations};
  const Cloud<Sphere> nothing({}, lit.cloud.box());
  return {.task = task,
          .run = [=] { return *error = all(lit.cloud), counts; },
          .errors =
              [=] {
                return Errors{*error, *error};
              },
          // What is not reflection: the same rays where no body is.
          .replay = [=] { return (void)all(nothing), counts; }};
}

// Evaluations are rays.
Competitor exact(const Lit& lit, const std::string& name, Beam::Points points, std::optional<double> slope,
                 const std::vector<double>& settings) {
  const int seeds = 16;
  return {.name = name, .slope = slope, .settings = settings, .prepare = [=](double setting) {
            const auto edge = static_cast<int>(std::lround(1.0 / setting));
            return prepared(lit, edge, points, seeds, static_cast<long>(seeds) * edge * edge,
                            [](const Cloud<Sphere>& cloud, const Rays& rays, const auto&) {
                              return trace(cloud, law, rays).ledger;
                            });
          }};
}

// Evaluations are the steps of rays that pass the sphere.
Competitor stepped(const Lit& lit, int edge, const std::vector<double>& settings) {
  return {.name = "stepped", .slope = 1.0, .settings = settings, .prepare = [=](double xi) {
            return prepared(lit, edge, Beam::Points::stratified, 1, std::lround(4.0 / xi) * edge * edge,
                            [xi](const Cloud<Sphere>& cloud, const Rays& rays, const auto& draw) {
                              return trace_in_steps(cloud, law, rays, {.xi = xi, .phase = draw}).ledger;
                            });
          }};
}

const Case lone_sphere{
    {.name = "work_precision_scattering",
     .claim = "error against run time of a lone sphere: order 1/2 in the number of random rays, nearly 1 in that of "
              "stratified ones, 1 in the step",
     .equation = "R 9.3",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const kinematics::Box box{.lengths = Eigen::Vector3d::Constant(4.0), .corner = Eigen::Vector3d::Constant(-2.0)};
      const Lit lit{.cloud = Cloud<Sphere>({Sphere{}}, box),
                    .beam = {.shape = Beam::Shape::disc, .centre = {-2.0, 0.0, 0.0}, .width = 2.0},
                    .number = [](const Ledger& ledger) { return ledger.x / ledger.incident; },
                    .expected = -0.0198041189561911};
      std::vector<double> random{1.0 / 48, 1.0 / 64, 1.0 / 80, 1.0 / 104, 1.0 / 136},
          stratified{1.0 / 24, 1.0 / 32, 1.0 / 48, 1.0 / 64, 1.0 / 96};
      std::vector<double> xi{0.4, 0.2, 0.1, 0.05, 0.028, 0.022, 0.017, 0.013, 0.01};
      if (rows.full()) {
        random.insert(random.end(), {1.0 / 176});
        stratified.insert(stratified.end(), {1.0 / 128, 1.0 / 176});
        xi.insert(xi.end(), {0.0055, 0.003});
      }
      rows.work_precision(
          {.problem = "lone_sphere",
           .reference = "quadrature in 25 digits",
           .floor = 1e-14,
           .competitors = {exact(lit, "exact, random rays", Beam::Points::random, 0.5, random),
                           exact(lit, "exact, stratified rays", Beam::Points::stratified, 1.0, stratified),
                           stepped(lit, rows.quick() ? 128 : 160, xi)}});
    }};

// Fifty spheres of L = 0.325 in a beam over half of the face: the mean rise after a pulse is proportional to what is
// absorbed.
Lit lit_cloud(int edge) {
  Uniform uniform(1);
  const auto draw = [&] { return uniform(); };
  const double radius = 0.325 / std::cbrt(50.0);
  Lit lit{.cloud = Cloud<Sphere>(place_spheres(50, radius, {.inside = kinematics::Inside::spheres}, draw).bodies, {}),
          .beam = {.centre = {0.0, 0.5, 0.5}, .width = 0.5},
          .number = [](const Ledger& ledger) { return ledger.absorbed; },
          .expected = 0.0};
  lit.expected = trace(lit.cloud, law, rays_in(lit, Beam::Points::stratified, edge, draw)).ledger.absorbed;
  return lit;
}

const Case mean_temperature{
    {.name = "work_precision_mean_temperature",
     .claim = "error against run time of the mean temperature of a cloud after a pulse: order 1/2 in the number of "
              "random rays, stratified ones err less",
     .equation = "R 9.5",
     .reference = Reference::convergence},
    [](Rows& rows) {
      const int many = rows.quick() ? 500 : 2000;
      const Lit lit = lit_cloud(many);
      const double other = trace(lit.cloud, law, rays_in(lit, Beam::Points::regular, many, {})).ledger.absorbed;
      std::vector<double> settings{1.0 / 12, 1.0 / 16, 1.0 / 22, 1.0 / 30, 1.0 / 40};
      if (rows.full()) settings.insert(settings.end(), {1.0 / 56, 1.0 / 80, 1.0 / 110});
      rows.work_precision({.problem = "mean_temperature",
                           .reference = "stratified rays, hundreds of times as many, checked by regular ones",
                           .floor = std::abs(other - lit.expected),
                           .competitors = {exact(lit, "random rays", Beam::Points::random, {}, settings),
                                           exact(lit, "stratified rays", Beam::Points::stratified, {}, settings)},
                           .no_ruler = "no reference is a thousand times better than so many rays"});
      const auto errors = [&](const std::string& method) {
        std::vector<double> all;
        for (const WorkPrecisionPoint& point : rows.points()) {
          if (point.method == method) all.push_back(point.errors->end);
        }
        return all;
      };
      const std::vector<double> random = errors("random rays"), stratified = errors("stratified rays");
      rows.compare("order in the edge of the square of random rays, twice that in their number",
                   {.expected = 1.0,
                    .computed = fitted_order(settings, random),
                    .tolerance = absolute(0.4),
                    .because = "two standard errors of a slope through points of sixteen seeds each"});
      const auto size = [](const std::vector<double>& all) {
        return std::sqrt(std::inner_product(all.begin(), all.end(), all.begin(), 0.0));
      };
      rows.at_most("errors of stratified rays over those of as many random ones",
                   {.limit = 0.9,
                    .computed = size(stratified) / size(random),
                    .because = "their variance lacks that between the parts of the beam; a tenth is left to luck"});
    }};

}  // namespace verification::work_precision_scattering
