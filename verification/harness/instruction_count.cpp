#include <harness/instruction_count.hpp>

#include <array>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace verification {
namespace {

// What a program says of one run, and callgrind about it.
struct Counted {
  long particles = 0, steps = 0, impacts = 0, allocations = 0, bytes = 0;
  long long instructions = -1;
};

// What came out of one process: counts by the mark of the run, and the words to quote if they are not complete.
struct Said {
  std::map<std::string, Counted> runs;
  std::string words;
  bool is_profile = false;  // callgrind's own lines have begun
  std::string mark;         // of the part that callgrind is writing
};

// Callgrind writes a profile a mark: "desc: Trigger: Client Request: <mark>", then "totals: <count>" among much else.
void read(const std::string& line, Said& said) {
  const std::string marked = "desc: Trigger: Client Request: ";
  std::array<char, 128> name;
  Counted is;
  long long total = 0;
  if (line.starts_with(marked)) {
    said.mark = line.substr(marked.size(), line.find_last_not_of('\n') + 1 - marked.size());
  } else if (std::sscanf(line.c_str(), "totals: %lld", &total) == 1) {
    if (!said.mark.empty()) said.runs[std::exchange(said.mark, {})].instructions = total;
  } else if (std::sscanf(line.c_str(), "counted %127s particles %ld steps %ld impacts %ld allocations %ld bytes %ld",
                         name.data(), &is.particles, &is.steps, &is.impacts, &is.allocations, &is.bytes) == 6) {
    Counted& run = said.runs[fmt::format("{} {}", name.data(), is.steps)];
    is.instructions = run.instructions;
    run = is;
  }
  said.is_profile = said.is_profile || line.starts_with("# callgrind format");
  if (!said.is_profile || line.starts_with("==") || line.starts_with("counted")) said.words += line;
}

Said said_by(const std::string& command) {
  std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("no process can be started for " + command);
  Said said;
  std::string line;
  std::array<char, 4096> part;
  while (std::fgets(part.data(), static_cast<int>(part.size()), pipe) != nullptr) {
    line += part.data();
    if (line.back() != '\n') continue;
    read(line, said);
    line.clear();
  }
  if (pclose(pipe) != 0) said.runs.clear();
  said.words += line;
  return said;
}

[[noreturn]] void refuse(const std::string& program, const std::string& words) {
  throw std::runtime_error(
      fmt::format("{}: instructions were not measured; valgrind (with its tool callgrind, and its header when this is "
                  "built) must be installed and run this program, but it said: {}",
                  program, words));
}

}  // namespace

const StepCost& StepCosts::of(const std::string& scene) const {
  const auto found = scenes.find(scene);
  if (found != scenes.end()) return found->second;
  throw std::invalid_argument(fmt::format(
      "instruction_count: the scene must be one of the program's, got \"{}\". Run it without arguments to list them.",
      scene));
}

StepCosts step_costs(const std::string& program, const RunLengths& lengths) {
  const auto& [few_steps, many_steps] = lengths;
  const Said said =
      said_by(fmt::format("valgrind --tool=callgrind --combine-dumps=yes --callgrind-out-file=/dev/stdout '{}' {} {}",
                          program, few_steps, many_steps));
  StepCosts costs;
  for (const auto& [mark, few] : said.runs) {
    if (few.steps == many_steps) continue;
    const std::string scene = mark.substr(0, mark.find(' '));
    const auto other = said.runs.find(fmt::format("{} {}", scene, many_steps));
    if (few.steps != few_steps || few.instructions < 0 || other == said.runs.end()) refuse(program, said.words);
    const Counted& many = other->second;
    if (many.steps != many_steps || many.instructions < 0) refuse(program, said.words);
    const auto steps = static_cast<double>(many_steps - few_steps);
    const double shares = steps * static_cast<double>(few.particles);
    costs.scenes[scene] = {.instructions = static_cast<double>(many.instructions - few.instructions) / shares,
                           .allocations = static_cast<double>(many.allocations - few.allocations) / steps,
                           .bytes = static_cast<double>(many.bytes - few.bytes) / shares,
                           .impacts = static_cast<double>(many.impacts - few.impacts) / steps};
  }
  if (costs.scenes.empty()) refuse(program, said.words);
  return costs;
}

particulate::report::Table judge_features(Rows& rows, const StepCosts& costs, std::span<const CountedFeature> features,
                                          const char* each, const char* step) {
  particulate::report::Table table({"feature", "state", fmt::format("instructions per {} and {}", each, step),
                                    fmt::format("allocations per {}", step),
                                    fmt::format("bytes per {} and {}", each, step)});
  for (const CountedFeature& feature : features) {
    const StepCost &absent = costs.of(feature.absent), &idle = costs.of(feature.idle), &used = costs.of(feature.used);
    for (const auto& [state, cost] : {std::pair{"absent", &absent}, {"idle", &idle}, {"used", &used}}) {
      table.add({feature.name, state, cost->instructions, cost->allocations, cost->bytes});
    }
    rows.at_most(
        fmt::format("{}: instructions idle beyond absent, per {} and {}", feature.name, each, step),
        {.limit = feature.most_idle, .computed = idle.instructions - absent.instructions, .because = feature.because});
    rows.at_least(
        fmt::format("{}: instructions used over absent", feature.name),
        {.limit = 1.0 + 1e-3, .computed = used.instructions / absent.instructions, .because = "else it is not used"});
  }
  return table;
}

}  // namespace verification
