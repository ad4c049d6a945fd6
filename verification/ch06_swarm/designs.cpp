// Designs that the genetic algorithm finds, over seeds of the algorithm.

#include <cstdint>
#include <string>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/identification/genetic_algorithm.hpp>
#include <particulate/kinematics/energy.hpp>
#include <particulate/report/table.hpp>

#include "swarms.hpp"

namespace verification::designs {

using namespace particulate;

// How the best design of a seed flew over the course that it was made for.
struct Flown {
  long evaluations;
  std::size_t lost;
  double distance;      // of the members at the end, in the mean [m]
  double speed;         // likewise [m/s]
  double share_of_cap;  // of the energy that the swarm lost [-]
};

Flown designed(const kinematics::Particles& start, const swarm::Course& course, std::uint64_t seed, int threads) {
  const identification::GeneticAlgorithm algorithm{.S = 20, .K = 6, .threads = threads};
  identification::Population population = first_population(swarm::design_bounds(), algorithm, seed);
  const identification::Evolution ended =
      evolve(swarm::objective({start}, course), swarm::design_bounds(), algorithm, {.generations = 30}, population);
  const swarm::Design design = swarm::design_of(ended.best.parameters);
  const swarm::Flight flight = swarm::fly(design, course, start).flight;
  const auto scene = scene_of(start, design, course);
  const schemes::VectorsOf r = schemes::positions(flight.state), v = schemes::velocities(flight.state);
  const double fallen = scene.potential_energy(flight.state) + kinematics::kinetic_energy(start.mass, v) -
                        scene.potential_energy(scenes::start(scene));
  return {.evaluations = population.evaluations,
          .lost = flight.lost.size(),
          .distance = (r.rowwise() - course.target.transpose()).rowwise().norm().mean(),
          .speed = v.rowwise().norm().mean(),
          .share_of_cap = flight.outcome.energy_change / fallen};
}

const Case seeds{
    {.name = "designs_over_seeds",
     .claim =
         "whatever the seed of the algorithm, a design is found in 450 evaluations that loses nobody and homes in; "
         "without drag it does not, as the speed limit alone takes energy, and nothing where speeds are lower",
     .equation = "R 6.3",
     .reference = Reference::design},
    [](Rows& rows) {
      report::Table table(
          {"drag [1/s]", "seed", "evaluations", "lost", "final distance [m]", "final speed [m/s]", "share of the cap"});
      const kinematics::Particles start = swarm_at_rest(rows.quick() ? 16 : 32, 1);
      swarm::Course course = swarm::fence();
      for (const double c_d : {1.0, 0.0}) {
        course.c_d = c_d;
        const std::string drag = c_d > 0.0 ? "with drag" : "without drag";
        for (std::uint64_t seed = 1; seed <= (rows.quick() ? 2U : 5U); ++seed) {
          const Flown best = designed(start, course, seed, rows.threads());
          const std::string which = fmt::format("{}, seed {}: ", drag, seed);
          table.add({c_d, static_cast<long>(seed), best.evaluations, static_cast<long>(best.lost), best.distance,
                     best.speed, best.share_of_cap});
          rows.at_most(which + "evaluations", {.limit = 450.0,
                                               .computed = static_cast<double>(best.evaluations),
                                               .because = "20 strings, and 14 new ones in each generation"});
          rows.none(which + "lost", best.lost, "the penalty for one is more than a path around the fence costs");
          if (c_d > 0.0) {
            rows.at_most(which + "final distance [m]",
                         {.limit = 0.3, .computed = best.distance, .because = "the swarm homes in"});
          } else {
            rows.at_least(which + "final distance [m]",
                          {.limit = 0.35, .computed = best.distance, .because = "the swarm does not home in"});
            rows.at_least(which + "final speed over the limit",
                          {.limit = 0.3, .computed = best.speed / course.v_max, .because = "it still flies about"});
            rows.compare(which + "share of the speed limit in the energy lost",
                         {.expected = 1.0,
                          .computed = best.share_of_cap,
                          .tolerance = relative(0.05),
                          .because = "nothing else takes any, but for an error of order Dt"});
          }
        }
      }
      rows.write("designs_over_seeds", table);
    }};

}  // namespace verification::designs
