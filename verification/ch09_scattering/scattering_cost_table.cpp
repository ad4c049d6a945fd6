// What a segment of a ray's path costs, by the shape of bodies, with and without what is told of it, and in steps:
// instructions counted by valgrind, allocations by malloc.

#include <array>

#include <harness/case.hpp>
#include <harness/instruction_count.hpp>
#include <particulate/report/table.hpp>

namespace verification::scattering_cost_table {

using namespace particulate;

constexpr std::array features{
    CountedFeature{"ledger and paths", "bare", "spheres", "paths", 270.0,
                   "of the three segments of a ray: one start and one end, looked at and booked"},
    CountedFeature{"spheroids", "spheres", "rounds", "oblates", 900.0,
                   "the same bodies, each of which is stretched, by 1, whenever it is asked"}};

const Case scattering_cost{
    {.name = "scattering_cost",
     .claim = "tracing costs little beyond hits and reflections, and nothing for paths that are not asked for",
     .equation = "R 9.3",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      // A step of the counter is all rays once.
      const StepCosts costs = step_costs(PARTICULATE_SCATTERING_COST, {.few = 1, .many = rows.quick() ? 2 : 20});
      report::Table table = judge_features(rows, costs, features, "segment", "trace");
      for (const auto& [feature, state, scene] :
           {std::array{"red cells", "used", "red_cells"}, {"steps of half a radius", "used", "stepped"}}) {
        const StepCost& cost = costs.of(scene);
        table.add({feature, state, cost.instructions, cost.allocations, cost.bytes});
      }
      rows.write("scattering_cost", table);
    }};

}  // namespace verification::scattering_cost_table
