// What every feature of a swarm costs, absent, idle and used: instructions counted by valgrind, allocations by malloc.

#include <array>
#include <string>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/instruction_count.hpp>
#include <particulate/report/table.hpp>

namespace verification::swarm_cost_table {

// Scenes of the program by feature and state; everything else in them is alike.
struct Feature {
  const char *name, *absent, *idle, *used;
  double most_idle;  // instructions that it may cost idle, per member and step
  const char* because;
};
constexpr std::array features{
    Feature{"obstacles", "members_alone", "obstacles_idle", "obstacles_used", 4.0,
            "one call a step that finds no obstacle"},
    Feature{"target", "members_alone", "target_idle", "target_used", 4.0, "one call a step that finds no strength"},
    Feature{"drag", "members_alone", "drag_idle", "drag_used", 24.0,
            "three multiplications and subtractions a member, and velocities handed on"},
    Feature{"speed limit", "members_alone", "limit_idle", "limit_used", 60.0,
            "a copy of the velocities, and the length of each"},
    Feature{"loss", "loss_absent", "loss_idle", "loss_used", 16.0,
            "a member far from all obstacles is compared with one side of the box around them"}};

const Case swarm_cost{
    {.name = "swarm_cost",
     .claim = "what a swarm leaves out costs nothing, and what it has but does not use no pass over pairs",
     .equation = "R 6.1",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      const StepCosts costs = step_costs(PARTICULATE_SWARM_COST, {.few = 10, .many = rows.quick() ? 20 : 60});
      particulate::report::Table table({"feature", "state", "instructions per member and step", "allocations per step",
                                        "bytes per member and step"});
      const auto add_line = [&](const Feature& feature, const char* state, const StepCost& cost) {
        table.add({feature.name, state, cost.instructions, cost.allocations, cost.bytes});
      };
      for (const Feature& feature : features) {
        const StepCost &absent = costs.of(feature.absent), &idle = costs.of(feature.idle);
        add_line(feature, "absent", absent);
        add_line(feature, "idle", idle);
        add_line(feature, "used", costs.of(feature.used));
        rows.at_most(fmt::format("{}: instructions idle beyond absent, per member and step", feature.name),
                     {.limit = feature.most_idle,
                      .computed = idle.instructions - absent.instructions,
                      .because = feature.because});
        rows.at_least(fmt::format("{}: instructions used over absent", feature.name),
                      {.limit = 1.0 + 1e-3,
                       .computed = costs.of(feature.used).instructions / absent.instructions,
                       .because = "else it is not used"});
      }
      rows.write("swarm_cost", table);
    }};

}  // namespace verification::swarm_cost_table
