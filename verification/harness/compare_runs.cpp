// Compares the results of two runs: compare_runs BEFORE AFTER, each the folder of one.
//
// Of two verifications the rows: a row that is gone and a verdict that got worse count. Of two runs of a chapter's
// program its parameters, and its tables column by column.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <particulate/report/files.hpp>
#include <particulate/report/guarded.hpp>
#include <particulate/report/output.hpp>
#include <particulate/report/parameter_file.hpp>
#include <particulate/report/stamp.hpp>
#include <particulate/report/table.hpp>
#include <particulate/report/wrapped.hpp>

namespace {

namespace report = particulate::report;
namespace fs = std::filesystem;
using Records = std::vector<std::vector<std::string>>;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Records table_of(const fs::path& file) {
  Records records = report::parse_csv(report::read_whole(file), file.native());
  if (records.empty()) throw std::runtime_error(fmt::format("{} must have a header, and is empty", file.native()));
  return records;
}

// --- The rows of a verification --------------------------------------------------------------------------------------

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

Lines lines_of(const fs::path& folder) {
  const fs::path file = folder / "rows.csv";
  const Records records = table_of(file);
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
  for (const std::string& name : names) fmt::print("{}\n", report::wrapped("  " + name, 4));
}

bool same_rows(const fs::path& before, const fs::path& after) {
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
  return found.worse.empty() && found.gone.empty();
}

// --- The parameters and tables of a chapter --------------------------------------------------------------------------

std::map<std::string, std::string> parameters_of(const fs::path& folder) {
  std::map<std::string, std::string> values;
  const fs::path file = folder / "parameters.toml";
  if (!fs::exists(file)) return values;
  for (const report::Setting& setting : report::read_parameter_file(file)) values[setting.key] = setting.value;
  return values;
}

std::vector<std::string> changed_parameters(const fs::path& before, const fs::path& after) {
  const auto old = parameters_of(before), now = parameters_of(after);
  auto all = old;
  all.insert(now.begin(), now.end());
  const auto in = [](const auto& values, const std::string& key) {
    return values.contains(key) ? values.at(key) : "none";
  };
  std::vector<std::string> changed;
  for (const auto& [key, value] : all) {
    if (in(old, key) != in(now, key)) changed.push_back(fmt::format("{}: {} -> {}", key, in(old, key), in(now, key)));
  }
  return changed;
}

std::map<std::string, Records> tables_of(const fs::path& folder) {
  std::map<std::string, Records> tables;
  for (const fs::path file : report::files_of_stamp(report::read_whole(folder / "stamp.json"))) {
    if (file.extension() == ".csv") tables[file.stem().native()] = table_of(folder / file);
  }
  return tables;
}

// Where a column changed most, and by how much: over its largest value in either run, because a curve may cross zero.
// Other texts, and numbers that are none, count as infinitely far.
struct Change {
  std::size_t row = 0;
  double distance = 0.0, scale = 0.0;
  double relative() const { return distance / (std::isfinite(distance) ? scale : 1.0); }
};

Change largest_change(const Records& before, const Records& after, std::size_t k) {
  Change change;
  for (std::size_t row = 1; row < before.size(); ++row) {
    const std::string &old = before[row][k], &now = after[row][k];
    const double from = number_in(old).value_or(missing), to = number_in(now).value_or(missing);
    for (const double value : {from, to}) {
      if (std::isfinite(value)) change.scale = std::max(change.scale, std::abs(value));
    }
    const double apart = std::isfinite(to - from) ? std::abs(to - from) : infinity;
    if (old != now && apart > change.distance) change.row = row, change.distance = apart;
  }
  return change;
}

// A field short enough for the screen; the tables hold every digit.
std::string shown(const std::string& field) {
  const std::optional<double> number = number_in(field);
  return number ? fmt::format("{:.9g}", *number) : field.substr(0, 16);
}

bool same_tables(const fs::path& before, const fs::path& after, double within) {
  const auto old = tables_of(before), now = tables_of(after);
  report::Table changes({"table", "column", "change", "row", "before", "after"});
  std::vector<std::string> alike, unlike;
  bool same = true;
  for (const auto& [file, was] : old) {
    const auto match = now.find(file);
    if (match == now.end()) {
      unlike.push_back(file + " is gone");
      continue;
    }
    const Records& is = match->second;
    if (was.front() != is.front()) {
      unlike.push_back(file + " has other columns");
    } else if (was.size() != is.size()) {
      unlike.push_back(fmt::format("{} has {} rows -> {}", file, was.size() - 1, is.size() - 1));
    } else if (was == is) {
      alike.push_back(file);
    } else {
      for (std::size_t k = 0; k < was.front().size(); ++k) {
        const Change change = largest_change(was, is, k);
        if (change.row == 0) continue;
        same = same && change.relative() <= within;
        changes.add(
            {file, was.front()[k], change.relative(), change.row, shown(was[change.row][k]), shown(is[change.row][k])});
      }
    }
  }
  for (const auto& [file, is] : now) {
    if (!old.contains(file)) unlike.push_back(file + " is new");
  }
  print("parameters that differ", changed_parameters(before, after));
  fmt::print("{}\n", report::wrapped(fmt::format("tables that are the same to the last digit: {}{}{}", alike.size(),
                                                 alike.empty() ? "" : " ", fmt::join(alike, ", ")),
                                     2));
  print("tables that cannot be compared", unlike);
  fmt::print("columns that differ: {}\n", changes.rows().size());
  if (!changes.rows().empty()) {
    fmt::print("\nTheir largest change, as a share of the column's largest value, and in which row:\n{}",
               changes.text());
  }
  return same && unlike.empty();
}

// ---------------------------------------------------------------------------------------------------------------------

int compare_folders(const fs::path& before, const fs::path& after, double within) {
  report::require_finished(before);
  report::require_finished(after);
  const bool verified = fs::exists(before / "rows.csv") && fs::exists(after / "rows.csv");
  return (verified ? same_rows(before, after) : same_tables(before, after, within)) ? 0 : 1;
}

constexpr const char* usage =
    "compare_runs [--within SHARE] BEFORE AFTER: what changed between the results in two folders.\n\n"
    "Of two verifications: the rows of rows.csv; it is worse if a verdict got worse or a row is gone.\n"
    "Of two runs of a chapter's program: parameters, and the largest change of every column of every table, as a "
    "share\n"
    "of the column's largest value; it differs if that exceeds --within (default 0), or a text or a table differs.\n\n"
    "Exit status: 0 if nothing is worse or differs, 1 if something does, 2 if the folders cannot be compared.\n";

}  // namespace

int main(int argc, char** argv) {
  return report::guarded("compare_runs", [&] {
    std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() == 1 && words[0] == "--help") {
      fmt::print("{}", usage);
      return 0;
    }
    double within = 0.0;
    if (words.size() > 1 && words[0] == "--within") {
      within = number_in(words[1]).value_or(missing);
      if (!(within >= 0.0)) {
        throw std::invalid_argument(fmt::format("--within must be a number, 0 or more, got \"{}\"", words[1]));
      }
      words.erase(words.begin(), words.begin() + 2);
    }
    if (words.size() != 2) {
      throw std::invalid_argument(fmt::format("two folders must be given, got {}. See --help.", words.size()));
    }
    return compare_folders(words[0], words[1], within);
  });
}
