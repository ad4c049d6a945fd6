#include <harness/run.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <set>
#include <stdexcept>
#include <tuple>

#include <fmt/format.h>

#include <harness/registry.hpp>
#include <harness/results.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/report/command_line.hpp>
#include <particulate/report/guarded.hpp>
#include <particulate/report/output.hpp>
#include <particulate/report/progress.hpp>
#include <particulate/report/spelling.hpp>
#include <particulate/report/stamp.hpp>
#include <particulate/report/wrapped.hpp>

namespace verification {
namespace {

namespace report = particulate::report;

bool is_blank(const std::string& text) { return text.find_first_not_of(' ') == std::string::npos; }

// Two cases of one name would hide one another, in --case and in every table.
void check(const std::vector<const Case*>& cases) {
  std::set<std::string> names;
  for (const Case* one : cases) {
    const auto& [name, claim, equation, reference] = one->claim();
    if (name.empty() || name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != std::string::npos) {
      throw std::invalid_argument(fmt::format(
          "a case's name must be lower-case letters, digits and underscores, got \"{}\". Rename it.", name));
    }
    if (!names.insert(name).second) {
      throw std::invalid_argument(fmt::format("names of cases must differ, got \"{}\" twice. Rename one.", name));
    }
    if (is_blank(claim) || is_blank(equation)) {
      throw std::invalid_argument(
          fmt::format("case {} must state its claim and its equation, got \"{}\" and \"{}\". Fill them in.", name,
                      claim, equation));
    }
  }
}

std::vector<const Case*> sorted_cases() {
  std::vector<const Case*> cases = registry();
  std::sort(cases.begin(), cases.end(), [](const Case* a, const Case* b) {
    return std::tie(a->source(), a->claim().name) < std::tie(b->source(), b->claim().name);
  });
  check(cases);
  return cases;
}

std::vector<const Case*> chosen_cases(const std::vector<const Case*>& all, const std::vector<std::string>& wanted) {
  std::vector<std::string> names;
  for (const Case* one : all) names.push_back(one->claim().name);
  for (const std::string& name : wanted) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const std::vector<std::string> near = report::near_matches(name, names);
    throw std::invalid_argument(
        fmt::format("--case must name a case of this program, got \"{}\". {}", name,
                    near.empty() ? "See --list." : "Did you mean " + report::either(near) + "?"));
  }
  if (wanted.empty()) return all;
  std::vector<const Case*> chosen;
  for (const Case* one : all) {
    if (std::find(wanted.begin(), wanted.end(), one->claim().name) != wanted.end()) chosen.push_back(one);
  }
  return chosen;
}

std::string listed(const std::vector<const Case*>& cases) {
  report::Table table({"case", "equation", "reference", "claim"});
  for (const Case* one : cases) {
    const auto& [name, claim, equation, reference] = one->claim();
    table.add({name, equation, name_of(reference), claim});
  }
  return table.text();
}

// More cases than fit a screen are printed by theme, that is by source file.
constexpr std::size_t screen_lines = 40;

// How one case ended, or several.
struct Tally {
  std::size_t cases = 0, rows = 0, failed = 0;
  double seconds = 0.0;

  void add(const CaseResult& result) {
    ++cases, rows += result.rows.size(), failed += result.failed(), seconds += result.seconds;
  }
  std::string line(const std::string& name) const {
    return fmt::format("{}  {:<45}  {:>5} {:<4}  {:>8.2f} s{}\n", failed == 0 ? "pass" : "FAIL", name, rows,
                       rows == 1 ? "row" : "rows", seconds, failed == 0 ? "" : fmt::format("  {} failed", failed));
  }
};

std::vector<CaseResult> prove_all(const std::vector<const Case*>& cases, const Rows::Settings& settings, bool verbose) {
  std::vector<CaseResult> results;
  if (cases.empty()) return results;
  const bool by_theme = !verbose && cases.size() > screen_lines;
  report::Progress progress("cases", static_cast<double>(cases.size()), 0.0);
  Tally theme;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    progress.label(cases[i]->claim().name);
    progress.at(static_cast<double>(i));
    const CaseResult& result = results.emplace_back(prove(*cases[i], settings));
    progress.wipe();
    Tally alone;
    alone.add(result), theme.add(result);
    if (!by_theme || alone.failed > 0) fmt::print("{}", alone.line(result.claim.name));
    for (const Row& row : result.rows) {
      if (verbose) fmt::print("{}", row_in_brief(row));
    }
    if (i + 1 == cases.size() || cases[i + 1]->source() != result.source) {
      const std::string name = std::filesystem::path(result.source).stem().native();
      if (by_theme)
        fmt::print("{}", theme.line(fmt::format("{}, {} case{}", name, theme.cases, theme.cases == 1 ? "" : "s")));
      theme = {};
    }
    std::fflush(stdout);
  }
  return results;
}

void write_all(const report::Output& output, const std::string& chapter, const std::vector<CaseResult>& results,
               bool quick) {
  output.write("rows", rows_table(chapter, results, quick));
  output.write("cases", cases_table(chapter, results));
  output.write("work_precision", work_precision_table(chapter, results));
  output.write("stability", stability_table(chapter, results));
}

// Of a case, that many failures are printed in full: what breaks all its rows breaks them alike.
constexpr std::size_t failures_in_full = 5;

// Prints the failures, and what the run comes to; the exit status is the verdict.
int conclude(const std::vector<CaseResult>& results, bool verbose) {
  Tally all;
  for (const CaseResult& result : results) {
    all.add(result);
    std::size_t failed = 0;
    for (const Row& row : result.rows) {
      if (!row.passed && (++failed <= failures_in_full || verbose)) fmt::print("\n{}", failure_in_full(result, row));
    }
    if (failed > failures_in_full && !verbose) {
      fmt::print("\n{}: {} more rows failed; --verbose prints them\n", result.claim.name, failed - failures_in_full);
    }
  }
  fmt::print("\n{} rows, {} failed\n", all.rows, all.failed);
  return all.failed == 0 && all.rows > 0 ? 0 : 1;
}

int run_cases(const report::CommandLine& command, std::string_view chapter, std::string_view title) {
  const report::Common& common = command.common();
  const std::vector<const Case*> cases = chosen_cases(sorted_cases(), common.cases);
  if (common.list) {
    fmt::print("{}", listed(cases));
    return 0;
  }
  const report::Output output(common.out);
  const std::string kernel(particulate::laws::name(particulate::laws::best_kernel()));
  const report::Stamp stamp = report::make_stamp(command.line(), common.seed, kernel);
  fmt::print("{}: {}, {} run\n{}\n\n", chapter, title, common.quick ? "quick" : "full",
             report::wrapped(report::one_line(stamp)));
  const std::vector<CaseResult> results =
      prove_all(cases, {.quick = common.quick, .seed = common.seed, .threads = common.threads, .output = &output},
                common.verbose);
  write_all(output, std::string(chapter), results, common.quick);
  output.finish(stamp);
  const int status = conclude(results, common.verbose);
  fmt::print("Every row: {}\n", (output.folder() / "rows.csv").native());
  return status;
}

}  // namespace

int run(int argc, const char* const* argv, std::string_view chapter, std::string_view title) {
  const std::string program = fmt::format("verify_{}", chapter);
  return report::guarded(program, [&] {
    report::CommandLine command(
        {.name = program,
         .summary = fmt::format("the claims of {} ({}), each against an independent reference", chapter, title),
         .has_cases = true});
    if (const std::optional<int> status = command.parse(argc, argv)) return *status;
    return run_cases(command, chapter, title);
  });
}

}  // namespace verification
