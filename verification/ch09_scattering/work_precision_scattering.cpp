// Error against run time of a lone sphere's I_x: exact tracing of more and more rays, stepped tracing in smaller and
// smaller steps.

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <harness/case.hpp>
#include <harness/uniform.hpp>
#include <particulate/scattering/beam.hpp>
#include <particulate/scattering/stepped.hpp>

namespace verification::work_precision_scattering {

using namespace particulate;
using namespace particulate::scattering;

constexpr double expected = -0.0198041189561911;  // of n^ = 10
constexpr Fresnel law{10.0};
const kinematics::Box box{.lengths = Eigen::Vector3d::Constant(4.0), .corner = Eigen::Vector3d::Constant(-2.0)};
const Task task{.start = {0.0, 0.0, 0.0, 1.0}, .rate = {10.0}, .outputs = {1.0}};

Beam beam_of(Beam::Points points) {
  return {.shape = Beam::Shape::disc, .centre = {-2.0, 0.0, 0.0}, .width = 2.0, .points = points};
}

// Root mean square of the errors of several seeds; nothing but rays is drawn and traced.
template <class Trace>
Prepared prepared(int edge, Beam::Points points, int seeds, long evaluations, const Trace& trace_rays) {
  const auto all = [=](const Cloud<Sphere>& cloud) {
    double squares = 0.0;
    for (int seed = 0; seed < seeds; ++seed) {
      Uniform uniform(static_cast<std::uint64_t>(seed + 1));
      const auto draw = [&] { return uniform(); };
      const Ledger ledger = trace_rays(cloud, rays_of(beam_of(points), edge * edge, draw), draw);
      squares += std::pow(ledger.x / ledger.incident - expected, 2) / seeds;
    }
    return std::sqrt(squares);
  };
  const auto error = std::make_shared<double>(missing);
  const Counts counts{.evaluations = evaluations};
  const Cloud<Sphere> cloud({Sphere{}}, box), nothing({}, box);
  return {.task = task,
          .run = [=] { return *error = all(cloud), counts; },
          .errors =
              [=] {
                return Errors{*error, *error};
              },
          // What is not reflection: the same rays where no body is.
          .replay = [=] { return (void)all(nothing), counts; }};
}

// Evaluations are rays.
Competitor exact(const std::string& name, Beam::Points points, double slope, const std::vector<double>& settings) {
  const int seeds = 16;
  return {.name = name, .slope = slope, .settings = settings, .prepare = [=](double setting) {
            const auto edge = static_cast<int>(std::lround(1.0 / setting));
            return prepared(edge, points, seeds, static_cast<long>(seeds) * edge * edge,
                            [](const Cloud<Sphere>& cloud, const Rays& rays, const auto&) {
                              return trace(cloud, law, rays).ledger;
                            });
          }};
}

// Evaluations are the steps of rays that pass the sphere.
Competitor stepped(int edge, const std::vector<double>& settings) {
  return {.name = "stepped", .slope = 1.0, .settings = settings, .prepare = [=](double xi) {
            return prepared(edge, Beam::Points::stratified, 1, std::lround(4.0 / xi) * edge * edge,
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
      std::vector<double> random{1.0 / 48, 1.0 / 64, 1.0 / 80, 1.0 / 104, 1.0 / 136},
          stratified{1.0 / 24, 1.0 / 32, 1.0 / 48, 1.0 / 64, 1.0 / 96};
      std::vector<double> xi{0.4, 0.2, 0.1, 0.05, 0.028, 0.022, 0.017, 0.013, 0.01};
      if (rows.full()) {
        random.insert(random.end(), {1.0 / 176});
        stratified.insert(stratified.end(), {1.0 / 128, 1.0 / 176});
        xi.insert(xi.end(), {0.0055, 0.003});
      }
      rows.work_precision({.problem = "lone_sphere",
                           .reference = "quadrature in 25 digits",
                           .floor = 1e-14,
                           .competitors = {exact("exact, random rays", Beam::Points::random, 0.5, random),
                                           exact("exact, stratified rays", Beam::Points::stratified, 1.0, stratified),
                                           stepped(rows.quick() ? 128 : 160, xi)}});
    }};

}  // namespace verification::work_precision_scattering
