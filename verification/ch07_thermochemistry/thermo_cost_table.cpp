// What heat, bonds and what else a scene of chapter 7 has cost, absent, idle and used: instructions counted by
// valgrind, allocations by malloc.

#include <array>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/instruction_count.hpp>
#include <particulate/contact/contact.hpp>
#include <particulate/report/table.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/thermo/impact_heat.hpp>

namespace verification::thermo_cost_table {

using namespace particulate;

constexpr std::array features{
    CountedFeature{"heat of impacts", "heat_absent", "heat_idle", "heat_used", 24.0,
                   "temperatures are carried from step to step"},
    CountedFeature{"cooling", "cooling_absent", "cooling_idle", "cooling_used", 400.0,
                   "a temperature that rides along through four stages, and a flux that is zero"},
    CountedFeature{"binding", "binding_absent", "binding_idle", "binding_used", 150.0,
                   "neighbours that are remembered, and one comparison a pair of them"},
    CountedFeature{"softening", "heat_used", "softening_idle", "softening_used", 40.0,
                   "one factor a contact, which is 1"},
    CountedFeature{"obstacle", "obstacle_absent", "obstacle_idle", "obstacle_used", 200.0,
                   "the others move past it, so that lists of neighbours age"}};

void add_line(report::Table& table, const char* feature, const char* state, const StepCost& cost) {
  table.add({feature, state, cost.instructions, cost.allocations, cost.bytes});
}

// Particles and a state with heat, and without.
long bytes_of_heat(bool warm) {
  kinematics::Particles two = kinematics::particles({{.position = {0.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.1},
                                                     {.position = {1.0, 0.0, 0.0}, .mass = 1.0, .radius = 0.1}});
  const contact::Contact<contact::ConstantRestitution> contact;
  const auto bytes = [](const auto& scene) {
    const kinematics::Particles& all = scene.particles();
    return 8L * (scenes::start(scene).y.size() + all.temperature.size() + all.heat_capacity.size());
  };
  if (!warm) return bytes(scenes::Scene(two, kinematics::Space{}, contact));
  two.temperature = two.heat_capacity = Eigen::VectorXd::Ones(2);
  return bytes(scenes::Scene(two, kinematics::Space{}, contact, thermo::ImpactHeat{}));
}

const Case thermo_cost{
    {.name = "thermo_cost",
     .claim = "what a scene leaves out of chapter 7 costs nothing, and what it has but does not use next to nothing",
     .equation = "R 7.4",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      const StepCosts costs = step_costs(PARTICULATE_THERMO_COST, {.few = 5, .many = rows.quick() ? 10 : 60});
      report::Table table = judge_features(rows, costs, features, "particle");
      add_line(table, "heat of impacts", "the same impacts without it", costs.of("impacts_alone"));
      for (const char* state : {"absent", "idle", "used"}) {
        add_line(table, "cut-off", state, costs.of(fmt::format("cutoff_{}", state)));
      }
      rows.none("bytes of temperatures and heat capacities without heat", bytes_of_heat(false),
                "absent arrays are empty");
      rows.equal("the same of two particles with heat",
                 {.expected = 48,
                  .computed = bytes_of_heat(true),
                  .because = "two arrays of the particles and one of the state, of two doubles each"});
      rows.write("thermo_cost", table);
    }};

}  // namespace verification::thermo_cost_table
