// Numbers that parameters are to lead to: what a misfit counts, and what is said of those out of reach.

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/identification/genetic_algorithm.hpp>
#include <particulate/identification/misfit.hpp>
#include <particulate/identification/polishing.hpp>
#include <particulate/scattering/interface.hpp>

namespace verification::wanted_numbers {

using namespace particulate;
using namespace particulate::identification;
using Eigen::Vector2d, Eigen::Vector3d;

const Case shares{
    {.name = "misfit_of_equal_shares",
     .claim = "numbers that are all off by the same share cost that share, whatever their weights, sizes and signs",
     .equation = "R 9.7",
     .reference = Reference::identity},
    [](Rows& rows) {
      const Vector3d values(-0.1, 400.0, 1e-6);
      for (const Vector3d& weights : {Vector3d(1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0), Vector3d(1.0, 2.0, 7.0),
                                      Vector3d(5e-3, 0.0, 1e-3), Vector3d(0.0, 1e6, 0.0)}) {
        std::vector<Wanted> wanted;
        for (int k = 0; k < 3; ++k) {
          wanted.push_back({.name = fmt::format("number {}", k), .value = values[k], .weight = weights[k]});
        }
        // Above, below, above.
        const Misfit misfit(
            wanted, [&](const auto&) -> Eigen::VectorXd { return values.cwiseProduct(Vector3d(1.07, 0.93, 1.07)); });
        const Vector2d anywhere = Vector2d::Zero();
        const auto row = [&](const char* what, double expected, double computed) {
          rows.compare(fmt::format("{}, weights {}, {} and {}", what, weights[0], weights[1], weights[2]),
                       {.expected = expected,
                        .computed = computed,
                        .tolerance = relative(1e-13),
                        .because = "rounding of a difference of 7 %"});
        };
        row("cost", 0.07, misfit(anywhere).cost);
        row("sum of squares", 0.07 * 0.07, misfit.residuals(anywhere).squaredNorm());
      }
    }};

// What a sphere reflects of a beam, and the volume fraction of a cloud: each of one parameter alone, n^ and L.
Eigen::VectorXd light_and_room(const Eigen::VectorXd& parameters) {
  return Vector2d(scattering::sphere_reflectance(scattering::Fresnel{parameters[0]}),
                  4.0 / 3.0 * std::numbers::pi * std::pow(parameters[1], 3));
}

// The best parameters of the genetic algorithm, polished.
Eigen::VectorXd best_for(const Misfit& misfit, const identification::Box& box, std::uint64_t seed) {
  const GeneticAlgorithm algorithm;
  Population population = first_population(box, algorithm, seed);
  const Evolution ended = evolve(misfit, box, algorithm, {.generations = 60}, population);
  return polish([&](const auto& at) { return misfit.residuals(at); }, box, ended.best.parameters, {.tolerance = 1e-14})
      .parameters;
}

const Case reach{
    {.name = "numbers_out_of_reach",
     .claim = "a search for numbers that can be reached finds their parameters; of one that cannot it says how near it "
              "came, which is where a bound is",
     .equation = "R 9.7",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      const identification::Box box{.lower = Vector2d(1.5, 0.25), .upper = Vector2d(100.0, 0.4)};
      const auto misfit_to = [](double reflected, double fraction) {
        return Misfit(
            {{.name = "reflected [-]", .value = reflected}, {.name = "volume fraction [-]", .value = fraction}},
            light_and_room);
      };
      for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const Misfit near = misfit_to(0.858761459011613, 0.143793313748683);
        const Eigen::VectorXd found = best_for(near, box, seed);
        const auto row = [&](const char* what, double expected, double computed, double off) {
          rows.compare(fmt::format("{}, seed {}", what, seed),
                       {.expected = expected, .computed = computed, .tolerance = relative(off), .because = "polished"});
        };
        row("n^ of F = 0.858761459011613", 32.0, found[0], 1e-6);
        row("L of a fraction of 0.143793313748683", 0.325, found[1], 1e-6);
        rows.equal(fmt::format("out of reach, seed {}", seed),
                   {.expected = "", .computed = unreached(near.reached(found), 1e-6), .because = "nothing is"});
        const Misfit far = misfit_to(0.99, 0.143793313748683);
        rows.equal(fmt::format("out of reach of n^ up to 100, seed {}", seed),
                   {.expected = "\"reflected [-]\": 0.99 is wanted, 0.950161 came nearest",
                    .computed = unreached(far.reached(best_for(far, box, seed)), 1e-6),
                    .because = "F(100) = 0.950161171239651, and the other number is reached"});
      }
    }};

}  // namespace verification::wanted_numbers
