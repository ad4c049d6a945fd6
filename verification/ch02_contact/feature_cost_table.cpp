// What every feature of a scene costs, absent, idle and used: instructions counted by valgrind, allocations by malloc.

#include <array>
#include <cstdio>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <particulate/report/table.hpp>

namespace verification::feature_cost_table {

constexpr double particles = 64.0;

// What the program of ./feature_cost/ says of one run, and valgrind about it.
struct Counted {
  long steps = 0, impacts = 0, allocations = 0, bytes = 0;
  long long instructions = 0;
};

std::string output_of(const std::string& command) {
  struct Closed {
    void operator()(std::FILE* pipe) const { pclose(pipe); }
  };
  const std::unique_ptr<std::FILE, Closed> pipe(popen((command + " 2>&1").c_str(), "r"));
  if (!pipe) throw std::runtime_error("feature_cost: no process can be started for " + command);
  std::string all;
  std::array<char, 4096> part;
  while (std::fgets(part.data(), static_cast<int>(part.size()), pipe.get())) all += part.data();
  return all;
}

Counted counted(const std::string& scene, long steps) {
  // The whole process is counted, starting and setting up included: differences of two runs do not contain them.
  const std::string said = output_of(fmt::format("valgrind --tool=callgrind --callgrind-out-file=/dev/null '{}' {} {}",
                                                 PARTICULATE_FEATURE_COST, scene, steps));
  Counted is;
  const std::size_t line = said.find("steps "), total = said.find("Collected : ");
  const bool told =
      line != std::string::npos && std::sscanf(said.c_str() + line, "steps %ld impacts %ld allocations %ld bytes %ld",
                                               &is.steps, &is.impacts, &is.allocations, &is.bytes) == 4;
  const bool collected =
      total != std::string::npos && std::sscanf(said.c_str() + total, "Collected : %lld", &is.instructions) == 1;
  if (!told || !collected || is.steps != steps) {
    throw std::runtime_error(
        "feature_cost: instructions were not measured; valgrind (with its tool callgrind) must be "
        "installed and run this program, but it said: " +
        said);
  }
  return is;
}

// Cost of a step, from two runs of different length.
struct Cost {
  double instructions = 0.0;  // per particle and step
  double allocations = 0.0;   // per step
  double bytes = 0.0;         // per particle and step
  double impacts = 0.0;       // per step
};

class Costs {
 public:
  explicit Costs(bool quick) : short_(50), long_(quick ? 100 : 250) {}

  const Cost& of(const std::string& scene) {
    const auto [at, is_new] = known_.try_emplace(scene);
    if (is_new) {
      const Counted few = counted(scene, short_), many = counted(scene, long_);
      const auto steps = static_cast<double>(long_ - short_);
      at->second = {.instructions = static_cast<double>(many.instructions - few.instructions) / (steps * particles),
                    .allocations = static_cast<double>(many.allocations - few.allocations) / steps,
                    .bytes = static_cast<double>(many.bytes - few.bytes) / (steps * particles),
                    .impacts = static_cast<double>(many.impacts - few.impacts) / steps};
    }
    return at->second;
  }

 private:
  long short_, long_;
  std::map<std::string, Cost> known_;
};

// Scenes of the program by feature and state; everything else in them is alike.
struct Feature {
  const char *name, *surroundings, *absent, *idle, *used;
};
constexpr std::array features{
    Feature{"near field", "gravity", "near_field_absent", "near_field_idle", "near_field_used"},
    Feature{"gravity", "near field", "gravity_absent", "gravity_idle", "near_field_used"},
    Feature{"contact", "gravity, near field, box", "contact_absent", "contact_idle", "contact_used"},
    Feature{"wall", "gravity, near field, contact", "wall_absent", "wall_idle", "contact_used"},
    Feature{"friction", "gravity, near field, box, contact", "contact_used", "friction_idle", "friction_used"},
    Feature{"restitution law", "gravity, near field, box, contact", "contact_used", "restitution_law_idle",
            "restitution_law_used"}};

void add_line(particulate::report::Table& table, const std::string& feature, const std::string& state,
              const std::string& surroundings, const Cost& cost) {
  table.add({feature, state, surroundings, cost.instructions, cost.allocations, cost.bytes, cost.impacts});
}

void claim_composition(Rows& rows, Costs& costs) {
  const auto compare = [&](const char* what, const char* scene, const char* by_hand) {
    rows.at_most(fmt::format("{}: instructions beyond a problem written by hand, per particle and step", what),
                 {.limit = 12.0,
                  .computed = costs.of(scene).instructions - costs.of(by_hand).instructions,
                  .because = "the same loop of the library over the same forces, written as a problem by hand: what is "
                             "absent leaves nothing but the composition, maps over the state and checks of lengths; no "
                             "pass over pairs, nor more than a few over the state"});
  };
  compare("gravity, contact and walls absent", "gravity_absent", "hand_problem_near_field");
  compare("contact absent", "contact_absent", "hand_problem_both");
  compare("near field and contact absent", "near_field_absent", "hand_problem_gravity");
}

// The loop itself: what the library checks and remembers, beyond what the shortest program does.
void claim_loop(Rows& rows, Costs& costs) {
  const auto compare = [&](const char* what, const char* scene, const char* by_hand) {
    rows.at_most(fmt::format("{}: instructions beyond the shortest loop by hand, per particle and step", what),
                 {.limit = 125.0,
                  .computed = costs.of(scene).instructions - costs.of(by_hand).instructions,
                  .because = "checks that state and accelerations are finite, the comparison that finds the kept "
                             "acceleration, and copies for a step that may be refused: 3 components, some ten passes "
                             "of a few instructions; no pass over pairs"});
  };
  compare("gravity", "near_field_absent", "hand_loop_gravity");
  compare("near field", "gravity_absent", "hand_loop_near_field");
  compare("gravity and near field", "contact_absent", "hand_loop_both");
  rows.at_most("near field: instructions over those of the shortest loop by hand",
               {.limit = 1.28,
                .computed = costs.of("gravity_absent").instructions / costs.of("hand_loop_near_field").instructions,
                .because = "the same overhead, at most 125 instructions, against 2016 pairs taken four at once with "
                           "AVX2, some 460 instructions a particle: a quarter here, falling as 1/N, and less where "
                           "the processor takes two at once"});
}

void claim_states(Rows& rows, Costs& costs) {
  for (const Feature& feature : features) {
    rows.at_least(fmt::format("{}: instructions idle over absent", feature.name),
                  {.limit = 0.999,
                   .computed = costs.of(feature.idle).instructions / costs.of(feature.absent).instructions,
                   .because = "what is absent has no code; two programs are laid out differently by the compiler, "
                              "which alone moves the count by about 0.1 per mille"});
  }
  for (const char* const scene :
       {"near_field_absent", "near_field_used", "gravity_absent", "gravity_idle", "contact_absent", "contact_idle"}) {
    rows.compare(fmt::format("{}: allocations a step", scene),
                 {.expected = 0.0,
                  .computed = costs.of(scene).allocations,
                  .tolerance = absolute(0.0),
                  .because = "a step without impacts needs no memory that the step before did not have"});
  }
  for (const char* const scene : {"contact_used", "friction_used", "restitution_law_used"}) {
    rows.at_least(fmt::format("{}: impacts a step", scene),
                  {.limit = 1.0, .computed = costs.of(scene).impacts, .because = "else it is not used"});
  }
  rows.compare("contact_idle: impacts a step", {.expected = 0.0,
                                                .computed = costs.of("contact_idle").impacts,
                                                .tolerance = absolute(0.0),
                                                .because = "else it is not idle"});
}

const Case feature_cost{
    {.name = "feature_cost",
     .claim = "a feature that a scene leaves out costs nothing: at most 12 instructions per particle and step beside "
              "the same forces written by hand, none of them over pairs",
     .equation = "R 2.2",
     .reference = Reference::independent_method},
    [](Rows& rows) {
      Costs costs(rows.quick());
      particulate::report::Table table({"feature", "state", "surroundings", "instructions per particle and step",
                                        "allocations per step", "bytes per particle and step", "impacts per step"});
      for (const Feature& feature : features) {
        add_line(table, feature.name, "absent", feature.surroundings, costs.of(feature.absent));
        add_line(table, feature.name, "idle", feature.surroundings, costs.of(feature.idle));
        add_line(table, feature.name, "used", feature.surroundings, costs.of(feature.used));
      }
      for (const char* const forces : {"gravity", "near_field", "both"}) {
        add_line(table, "none", "problem by hand", forces, costs.of(fmt::format("hand_problem_{}", forces)));
        add_line(table, "none", "shortest loop by hand", forces, costs.of(fmt::format("hand_loop_{}", forces)));
      }
      rows.write("feature_cost", table);
      claim_composition(rows, costs);
      claim_loop(rows, costs);
      claim_states(rows, costs);
    }};

}  // namespace verification::feature_cost_table
