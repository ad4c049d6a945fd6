// What every feature of a swarm costs, absent, idle and used: instructions counted by valgrind, allocations by malloc.

#include <array>

#include <harness/case.hpp>
#include <harness/instruction_count.hpp>

namespace verification::swarm_cost_table {

constexpr std::array features{
    CountedFeature{"obstacles", "members_alone", "obstacles_idle", "obstacles_used", 4.0,
                   "one call a step that finds no obstacle"},
    CountedFeature{"target", "members_alone", "target_idle", "target_used", 4.0,
                   "one call a step that finds no strength"},
    CountedFeature{"drag", "members_alone", "drag_idle", "drag_used", 24.0,
                   "three multiplications and subtractions a member, and velocities handed on"},
    CountedFeature{"speed limit", "members_alone", "limit_idle", "limit_used", 60.0,
                   "a copy of the velocities, and the length of each"},
    CountedFeature{"loss", "loss_absent", "loss_idle", "loss_used", 16.0,
                   "a member far from all obstacles is compared with one side of the box around them"}};

const Case swarm_cost{
    {.name = "swarm_cost",
     .claim = "what a swarm leaves out costs nothing, and what it has but does not use no pass over pairs",
     .equation = "R 6.1",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      const StepCosts costs = step_costs(PARTICULATE_SWARM_COST, {.few = 10, .many = rows.quick() ? 20 : 60});
      rows.write("swarm_cost", judge_features(rows, costs, features, "member"));
    }};

}  // namespace verification::swarm_cost_table
