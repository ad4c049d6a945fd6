// Compares the rows of two runs: compare_rows BEFORE AFTER, each a folder with a rows.csv.
//
// Exit status: 0 if no verdict got worse, 1 if one did or a row is gone, 2 if the runs cannot be compared.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include <harness/claims.hpp>
#include <particulate/report/files.hpp>
#include <particulate/report/guarded.hpp>
#include <particulate/report/output.hpp>

namespace {

namespace report = particulate::report;
using verification::missing;

struct Line {
  std::string expected, computed, error, metric, tolerance, verdict, run;
};
using Lines = std::map<std::string, Line>;

std::optional<double> number_in(const std::string& text) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return number;
}

std::size_t column(const std::vector<std::string>& header, const std::string& name, const std::string& file) {
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (header[i] == name) return i;
  }
  throw std::runtime_error(fmt::format("{} must have a column \"{}\", and has none", file, name));
}

Lines lines_of(const std::filesystem::path& folder) {
  report::require_finished(folder);
  const std::filesystem::path file = folder / "rows.csv";
  const auto records = report::parse_csv(report::read_whole(file), file.native());
  if (records.empty()) throw std::runtime_error(fmt::format("{} must have a header, and is empty", file.native()));
  const auto at = [&](std::size_t row, const char* name) {
    return records[row][column(records[0], name, file.native())];
  };
  Lines lines;
  for (std::size_t row = 1; row < records.size(); ++row) {
    const std::string key = fmt::format("{}, {}, {}", at(row, "chapter"), at(row, "case"), at(row, "quantity"));
    std::string unique = key;
    for (int again = 2; lines.contains(unique); ++again) unique = fmt::format("{} ({})", key, again);
    lines[unique] = {at(row, "expected"),  at(row, "computed"), at(row, "error"), at(row, "metric"),
                     at(row, "tolerance"), at(row, "verdict"),  at(row, "run")};
  }
  return lines;
}

// What the row's tolerance is relative to: 1 if it is absolute, |expected| or the floor that a mixed one has instead.
// The floor is not in the file; the error is, in the same unit, and gives it back.
double scale_of(const Line& line) {
  const double expected = number_in(line.expected).value_or(missing),
               computed = number_in(line.computed).value_or(missing);
  if (line.metric == "relative") return std::abs(expected);
  if (line.metric != "mixed") return 1.0;
  const double error = number_in(line.error).value_or(missing);
  return error > 0.0 ? std::abs(computed - expected) / error : std::abs(expected);
}

// Whether the computed value moved by more than the row's tolerance. A one-sided claim has none: its verdict tells.
bool moved(const Line& before, const Line& after) {
  if (before.computed == after.computed || after.metric == "at most" || after.metric == "at least") return false;
  const auto from = number_in(before.computed), to = number_in(after.computed), tolerance = number_in(after.tolerance);
  if (!from || !to || !tolerance) return true;
  return !(std::abs(*to - *from) <= *tolerance * std::max(scale_of(before), scale_of(after)));
}

struct Differences {
  std::vector<std::string> worse, better, gone, added, moved;
};

Differences compare(const Lines& before, const Lines& after) {
  Differences found;
  for (const auto& [name, old] : before) {
    const auto match = after.find(name);
    if (match == after.end()) {
      found.gone.push_back(name);
      continue;
    }
    const Line& now = match->second;
    if (old.verdict != now.verdict) (now.verdict == "pass" ? found.better : found.worse).push_back(name);
    if (moved(old, now)) {
      found.moved.push_back(fmt::format("{}: {} -> {} (expected {}, tolerance {} {})", name, old.computed, now.computed,
                                        now.expected, now.tolerance, now.metric));
    }
  }
  for (const auto& [name, now] : after) {
    if (!before.contains(name)) found.added.push_back(name);
  }
  return found;
}

void print(const char* what, const std::vector<std::string>& names) {
  fmt::print("{}: {}\n", what, names.size());
  for (const std::string& name : names) fmt::print("  {}\n", name);
}

int compare_folders(const std::string& before, const std::string& after) {
  const Lines old = lines_of(before), now = lines_of(after);
  if (!old.empty() && !now.empty() && old.begin()->second.run != now.begin()->second.run) {
    fmt::print("note: a {} run against a {} run\n", old.begin()->second.run, now.begin()->second.run);
  }
  const Differences found = compare(old, now);
  print("verdicts that got worse", found.worse);
  print("rows that are gone", found.gone);
  print("verdicts that got better", found.better);
  print("rows that are new", found.added);
  print("values that moved by more than their tolerance", found.moved);
  return found.worse.empty() && found.gone.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return report::guarded("compare_rows", [&] {
    if (argc == 2 && std::string_view(argv[1]) == "--help") {
      fmt::print(
          "compare_rows BEFORE AFTER: what changed between the rows.csv of two folders.\n"
          "Exit status 1 if a verdict got worse or a row is gone, 2 if the folders cannot be compared.\n");
      return 0;
    }
    if (argc != 3) {
      throw std::invalid_argument(fmt::format("two folders must be given, got {}. See --help.", argc - 1));
    }
    return compare_folders(argv[1], argv[2]);
  });
}
