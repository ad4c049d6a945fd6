// Clouds in a beam: published numbers of the set-up, ledgers, the dilute limit and its end.

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/uniform.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/report/table.hpp>
#include <particulate/scattering/beam.hpp>
#include <particulate/scattering/placement.hpp>
#include <particulate/scattering/stepped.hpp>

namespace verification::scattering_clouds {

using namespace particulate;
using namespace particulate::scattering;
using report::Mean, report::mean_of;

// Spheres wholly inside of the unit cube, and half of its face lit.
Cloud<Sphere> cloud_of(Eigen::Index N, double L, Uniform& uniform) {
  const double radius = L / std::cbrt(static_cast<double>(N));
  return Cloud<Sphere>(
      place_spheres(N, radius, {.inside = kinematics::Inside::spheres}, [&] { return uniform(); }).bodies, {});
}
const Beam beam{.centre = {0.0, 0.5, 0.5}, .width = 0.5};

Cloud<RedCell> cells(Uniform& uniform) {
  const RedCell one{.radius = 0.05};
  return Cloud<RedCell>(
      place_red_cells(300, one, {.inside = kinematics::Inside::spheres}, [&] { return uniform(); }).bodies, {});
}

const Case numbers{
    {.name = "cloud_numbers",
     .claim = "clouds of 1000 spheres scatter forward and absorb what an independent prototype found",
     .equation = "R 9.3",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      struct Known {
        double L, n_hat, x, x_error, absorbed, absorbed_error;
      };
      // Of the absorbed shares the last digit that was given counts as the error.
      const std::vector<Known> all{{0.325, 2.0, -0.0015, 0.0003, 0.9498, 0.0003},
                                   {0.325, 10.0, -0.1060, 0.0005, 0.6749, 0.0007},
                                   {0.275, 10.0, -0.0297, 0.0011, missing, missing}};
      report::Table table({"L", "n^", "I_x", "standard error of I_x", "absorbed", "standard error of absorbed"});
      const int realizations = rows.quick() ? 20 : 200;
      for (const Known& known : all) {
        std::vector<double> x, absorbed;
        for (int k = 0; k < realizations; ++k) {
          Uniform uniform(static_cast<std::uint64_t>(5000 + k));
          const Cloud<Sphere> cloud = cloud_of(1000, known.L, uniform);
          const Ledger ledger =
              trace(cloud, Fresnel{known.n_hat}, rays_of(beam, 4000, [&] { return uniform(); })).ledger;
          x.push_back(ledger.x / ledger.incident);
          absorbed.push_back(ledger.absorbed / ledger.incident);
        }
        const Mean of_x = mean_of(x), of_absorbed = mean_of(absorbed);
        table.add(
            {known.L, known.n_hat, of_x.value, of_x.standard_error, of_absorbed.value, of_absorbed.standard_error});
        const auto row = [&](const char* what, double expected, double expected_error, const Mean& found) {
          if (std::isnan(expected)) return;
          rows.compare(fmt::format("{}, L = {}, n^ = {}", what, known.L, known.n_hat),
                       {.expected = expected,
                        .computed = found.value,
                        .tolerance = absolute(4.0 * std::hypot(expected_error, found.standard_error)),
                        .because = "four joint standard errors"});
        };
        row("I_x", known.x, known.x_error, of_x);
        row("absorbed", known.absorbed, known.absorbed_error, of_absorbed);
      }
      rows.write("cloud_numbers", table);
    }};

double whole(const Ledger& ledger) {
  return std::accumulate(ledger.left.begin(), ledger.left.end(), ledger.absorbed + ledger.cut_off + ledger.inside);
}

const Case ledgers{
    {.name = "ledgers",
     .claim = "all power is somewhere, and rays keep their unit directions",
     .equation = "R 9.3",
     .reference = Reference::identity},
    [](Rows& rows) {
      Uniform uniform(31);
      const Cloud<Sphere> cloud = cloud_of(1000, 0.4, uniform);
      const Rays rays = rays_of(beam, rows.quick() ? 5000 : 100000, [&] { return uniform(); });
      const auto row = [&](const std::string& what, const Traced& traced) {
        rows.compare(what, {.expected = traced.ledger.incident,
                            .computed = whole(traced.ledger),
                            .tolerance = relative(1e-12),
                            .because = "sums of some 1e5 numbers, each rounded"});
        const double off = (traced.rays.direction.rowwise().norm().array() - 1.0).abs().maxCoeff();
        rows.compare(what + ": largest error of a direction's length",
                     {.expected = 0.0, .computed = off, .tolerance = absolute(4e-16), .because = "it is normalized"});
      };
      row("exact", trace(cloud, Fresnel{10.0}, rays));
      row("exact, cut off below 1e-3", trace(cloud, Fresnel{10.0}, rays, {.least_share = 1e-3}));
      row("exact, stopped on the way", trace(cloud, Fresnel{10.0}, rays, {.path_length = 0.5}));
      row("stepped", trace_in_steps(cloud, Fresnel{10.0}, rays, {.xi = 0.2}));
      const Traced of_cells = trace(cells(uniform), Fresnel{10.0}, rays);
      row("red cells", of_cells);
      rows.at_least("red cells: reflections by the one just left",
                    {.limit = 1.0,
                     .computed = static_cast<double>(of_cells.ledger.hits_again),
                     .because = "else none is booked"});
    }};

// All that tracing tells of power.
std::vector<double> numbers_of(const Traced& traced) {
  const Ledger& ledger = traced.ledger;
  std::vector<double> all(ledger.left.begin(), ledger.left.end());
  all.insert(all.end(), {ledger.incident, ledger.absorbed, ledger.cut_off, ledger.inside, ledger.x, ledger.forward,
                         static_cast<double>(ledger.hits), static_cast<double>(ledger.hits_again),
                         static_cast<double>(ledger.segments)});
  all.insert(all.end(), traced.absorbed.begin(), traced.absorbed.end());
  all.insert(all.end(), traced.rays.power.begin(), traced.rays.power.end());
  return all;
}

const Case threads{{.name = "ledgers_of_threads",
                    .claim = "any number of threads fills in the same ledger, bit by bit",
                    .equation = "R 9.3",
                    .reference = Reference::identity},
                   [](Rows& rows) {
                     Uniform uniform(32);
                     const auto differing = [&](const auto& cloud, int several) {
                       // The last block of rays is not a whole one.
                       const Rays rays = rays_of(beam, rows.quick() ? 3000 : 100000, [&] { return uniform(); });
                       const auto numbers_with = [&](int n) {
                         return numbers_of(trace(cloud, Fresnel{10.0}, rays, {.path_length = 2.0, .threads = n}));
                       };
                       const std::vector<double> one = numbers_with(1), many = numbers_with(several);
                       return std::inner_product(one.begin(), one.end(), many.begin(), 0L, std::plus<>(),
                                                 [](double a, double b) { return a == b ? 0L : 1L; });
                     };
                     const Cloud<Sphere> spheres = cloud_of(1000, 0.4, uniform);
                     const Cloud<RedCell> red_cells = cells(uniform);
                     for (const int n : {2, 3}) {
                       rows.none(fmt::format("spheres: numbers that differ between one thread and {}", n),
                                 differing(spheres, n), "sums are formed in the order of the rays");
                       rows.none(fmt::format("red cells: numbers that differ between one thread and {}", n),
                                 differing(red_cells, n), "likewise");
                     }
                   }};

// The share of a beam that goes through unscattered: exp(-n pi b^2 x) where spheres are few, less where they are many,
// as they cannot shade each other's places.
const Case dilute{
    {.name = "beer_lambert",
     .claim = "a dilute cloud lets through what Beer and Lambert's law says, a dense one does not",
     .equation = "D 9.3",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      report::Table table({"volume fraction", "optical depth", "unscattered", "standard error", "Beer-Lambert"});
      const int realizations = rows.quick() ? 20 : 100;
      double dense_over = missing;
      for (const double radius : {0.005, 0.0325}) {
        // Two thousandfold thinner in volume at the same optical depth.
        const double depth = 2.0, n = depth / (std::numbers::pi * radius * radius);
        const auto N = static_cast<Eigen::Index>(std::lround(n));
        std::vector<double> through;
        for (int k = 0; k < realizations; ++k) {
          Uniform uniform(static_cast<std::uint64_t>(7000 + k));
          const auto draw = [&] { return uniform(); };
          const Cloud<Sphere> cloud(place_spheres(N, radius, {.inside = kinematics::Inside::spheres}, draw).bodies, {});
          const Ledger ledger = trace(cloud, Fresnel{2.0}, rays_of(beam, 2000, draw), {.most_hits = 0}).ledger;
          through.push_back(ledger.forward_face() / ledger.incident);
        }
        const Mean found = mean_of(through);
        // Centres keep a radius from the faces: those that the beam meets are that much denser.
        const double inner = 1.0 - 2.0 * radius;
        const double law = std::exp(-static_cast<double>(N) * std::numbers::pi * radius * radius / (inner * inner));
        table.add({static_cast<double>(N) * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius, depth, found.value,
                   found.standard_error, law});
        if (radius < 0.01) {
          rows.compare(
              "unscattered share of a dilute cloud",
              {.expected = law,
               .computed = found.value,
               .tolerance = absolute(4.0 * found.standard_error + 0.028 * law),
               .because = "four standard errors, and the depth of 2 times the fraction 0.014 that excludes places"});
        } else {
          dense_over = found.value / law;
        }
      }
      rows.at_most("unscattered share of a dense cloud over the law",
                   {.limit = 0.97, .computed = dense_over, .because = "spheres that may not overlap shade more"});
      rows.write("beer_lambert", table);
    }};

// The same rays in the same clouds, exactly and in steps: their differences know less noise than either.
const Case in_steps{
    {.name = "stepped_in_clouds",
     .claim = "in clouds the stepped tracer converges to the exact one too: half of the step, half of the difference",
     .equation = "R 9.3",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      report::Table table({"xi", "I_x less that of exact tracing", "standard error"});
      const std::vector<double> steps{0.4, 0.2, 0.1, 0.05, 0.025};
      std::vector<std::vector<double>> off(steps.size());
      for (int k = 0; k < (rows.quick() ? 10 : 60); ++k) {
        Uniform uniform(static_cast<std::uint64_t>(9000 + k));
        const auto draw = [&] { return uniform(); };
        const Cloud<Sphere> cloud = cloud_of(1000, 0.325, uniform);
        const Rays rays = rays_of(beam, 2000, draw);
        const double exact = trace(cloud, Fresnel{10.0}, rays).ledger.x;
        for (std::size_t i = 0; i < steps.size(); ++i) {
          const Ledger ledger = trace_in_steps(cloud, Fresnel{10.0}, rays, {.xi = steps[i], .phase = draw}).ledger;
          off[i].push_back((ledger.x - exact) / ledger.incident);
        }
      }
      for (std::size_t i = 0; i < steps.size(); ++i) {
        const Mean mean = mean_of(off[i]);
        table.add({steps[i], mean.value, mean.standard_error});
      }
      std::vector<double> limit;
      for (std::size_t k = 0; k < off[0].size(); ++k) limit.push_back(2.0 * off[4][k] - off[3][k]);
      const Mean largest = mean_of(off[0]), extrapolated = mean_of(limit);
      rows.compare("difference of I_x, extrapolated from xi = 0.05 and 0.025",
                   {.expected = 0.0,
                    .computed = extrapolated.value,
                    .tolerance = absolute(4.0 * extrapolated.standard_error),
                    .because = "four standard errors"});
      rows.at_least("difference of I_x at xi = 0.4, in standard errors of the extrapolated one",
                    {.limit = 10.0,
                     .computed = std::abs(largest.value) / extrapolated.standard_error,
                     .because = "else noise would hide whether it converges"});
      rows.write("stepped_in_clouds", table);
    }};

}  // namespace verification::scattering_clouds
