// What a right-hand side of a flow and of a suspension costs by what it has, absent, idle and used, and beside the
// least that anyone can write; instructions counted by valgrind, allocations by malloc.

#include <array>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/instruction_count.hpp>
#include <particulate/report/table.hpp>

namespace verification::fluid_cost_table {

using namespace particulate;

constexpr std::array features{
    CountedFeature{"viscous stress", "bare", "inviscid", "barotropic", 80.0,
                   "ghosts, finite numbers looked for, and stresses that are zero"},
    CountedFeature{"heat", "barotropic", "heat_idle", "liquid", 150.0,
                   "the flux of energy through three faces, and a temperature"},
    CountedFeature{"walls", "liquid", "walls_idle", "walls_used", 60.0,
                   "faces along x at which pressure does no work are made anew, two of 17 in a row"},
    CountedFeature{"variable viscosity", "liquid", "thinning_idle", "thinning_used", 100.0,
                   "one exponential function a cell, and a mean a face"},
    CountedFeature{"particles, one in 64 cells", "liquid", "particles_none", "particles", 5.0, "nothing to be placed"},
    CountedFeature{"heat that they exchange", "particles", "exchange_idle", "exchange", 5.0,
                   "a flux of nothing, and a temperature a particle"},
    CountedFeature{"near fields between them", "exchange", "near_idle", "near_used", 60.0,
                   "neighbours that are looked for, of which none is near enough"}};

const Case fluid_cost{
    {.name = "fluid_cost",
     .claim = "what a flow or a suspension leaves out costs nothing, what it has but does not use little, and only "
              "near fields ask for memory",
     .equation = "R 8.2",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      // A step of the counter is one right-hand side.
      const StepCosts costs = step_costs(PARTICULATE_FLUID_COST, {.few = 2, .many = rows.quick() ? 4 : 20});
      report::Table table = judge_features(rows, costs, features, "cell", "right-hand side");
      const StepCost& sweep = costs.of("sweep");
      table.add(
          {"a sweep over density, momentum and energy", "used", sweep.instructions, sweep.allocations, sweep.bytes});
      rows.write("fluid_cost", table);
      rows.at_most("instructions of a sweep over those of a right-hand side",
                   {.limit = 2.5,
                    .computed = sweep.instructions / costs.of("liquid").instructions,
                    .because = "cells are measured three times, but each field's own fluxes are formed alone"});
      rows.at_most("instructions without viscosity and heat over a bare loop",
                   {.limit = 1.3,
                    .computed = costs.of("inviscid").instructions / costs.of("bare").instructions,
                    .because = "one kernel serves fluids with viscosity and without"});
      double asked = 0.0;
      for (const auto& [scene, cost] : costs.scenes) {
        asked += scene.starts_with("made_") || scene.starts_with("near_") ? 0.0 : cost.allocations;
      }
      rows.none("allocations of right-hand sides and sweeps, all scenes without near fields", static_cast<long>(asked),
                "all that they need is made with the flow and the suspension");
      for (const char* scene : {"near_idle", "near_used"}) {
        rows.at_most(fmt::format("allocations of a right-hand side, {}", scene),
                     {.limit = 1.0, .computed = costs.of(scene).allocations, .because = "neighbours are looked for"});
      }
      for (const char* fluid : {"barotropic", "liquid", "thinning"}) {
        rows.at_most(fmt::format("own scratch of 32 x 32 x 32 cells, {} [doubles a cell]", fluid),
                     {.limit = 10.0,
                      .computed = costs.of(fmt::format("made_{}", fluid)).bytes / 8.0,
                      .because = "what is measured of a cell, ghosts, and a few rows of fluxes"});
      }
    }};

}  // namespace verification::fluid_cost_table
