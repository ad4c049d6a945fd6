#include <harness/results.hpp>

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include <particulate/report/wrapped.hpp>

namespace verification {
namespace {

using particulate::report::Cell;
using particulate::report::Table;
using particulate::report::wrapped;

Cell cell(const std::optional<double>& number) { return number ? Cell(*number) : Cell(); }

}  // namespace

std::size_t CaseResult::failed() const {
  return static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.passed; }));
}

CaseResult prove(const Case& claimed, const Rows::Settings& settings) {
  const auto begin = std::chrono::steady_clock::now();
  Rows rows(claimed.claim().name, settings);
  try {
    claimed.prove(rows);
    const bool judged = std::ranges::any_of(rows.all(), [](const Row& row) { return row.metric != left_out; });
    if (!judged) rows.fail("rows", "the case compared nothing");
  } catch (const std::exception& error) {
    rows.fail("end of the case", fmt::format("it threw: {}", error.what()));
  } catch (...) { rows.fail("end of the case", "it threw something that is no std::exception"); }
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
  return {.claim = claimed.claim(),
          .rows = rows.all(),
          .stability = rows.stability(),
          .points = rows.points(),
          .seconds = spent.count(),
          .source = claimed.source()};
}

Table rows_table(const std::string& chapter, const std::vector<CaseResult>& results, bool quick) {
  Table table({"chapter", "case", "claim", "equation", "reference", "quantity", "expected", "computed", "error",
               "metric", "tolerance", "because", "verdict", "run", "seconds"});
  for (const CaseResult& result : results) {
    const Claim& claim = result.claim;
    for (const Row& row : result.rows) {
      // Expected and computed are numbers in one row and texts in the next, so their columns hold texts.
      table.add({chapter, claim.name, claim.claim, claim.equation, name_of(claim.reference), row.quantity,
                 row.expected.exact(), row.computed.exact(), row.error, row.metric, row.tolerance, row.because,
                 row.passed ? "pass" : "fail", quick ? "quick" : "full", row.seconds});
    }
  }
  return table;
}

Table work_precision_table(const std::string& chapter, const std::vector<CaseResult>& results) {
  Table table({"chapter", "problem", "method", "setting", "tuned", "error_end", "error_max", "floor", "reference",
               "seconds_min", "seconds_median", "seconds_overhead", "evaluations", "iterations", "status"});
  for (const CaseResult& result : results) {
    for (const WorkPrecisionPoint& point : result.points) {
      if (!point.timed) continue;
      table.add({chapter, point.problem, point.method, point.setting, point.tuned ? "yes" : "no",
                 point.errors ? Cell(point.errors->end) : Cell(), point.errors ? Cell(point.errors->max) : Cell(),
                 point.floor, point.reference, cell(point.seconds_min), cell(point.seconds_median),
                 cell(point.seconds_overhead), point.counts.evaluations, point.counts.iterations, point.status});
    }
  }
  return table;
}

Table stability_table(const std::string& chapter, const std::vector<CaseResult>& results) {
  Table table({"chapter", "case", "must", "verdict", "reason"});
  for (const CaseResult& result : results) {
    for (const Stability& line : result.stability) {
      table.add({chapter, fmt::format("{}: {}", result.claim.name, line.name), line.must, line.verdict, line.reason});
    }
  }
  return table;
}

Table cases_table(const std::string& chapter, const std::vector<CaseResult>& results) {
  Table table({"chapter", "case", "claim", "equation", "reference", "source"});
  for (const CaseResult& result : results) {
    const Claim& claim = result.claim;
    table.add({chapter, claim.name, claim.claim, claim.equation, name_of(claim.reference), result.source});
  }
  return table;
}

std::string row_in_brief(const Row& row) {
  if (row.metric == left_out) {
    return wrapped(fmt::format("  left out  {}: {}; {}", row.quantity, row.computed.readable(), row.because), 8) + '\n';
  }
  std::string text = fmt::format("  {}  {}: ", row.passed ? "pass" : "FAIL", row.quantity);
  if (row.metric == "at most" || row.metric == "at least") {
    text += fmt::format("{}, {} {}", row.computed.readable(), row.metric, row.expected.readable());
  } else {
    text += fmt::format("{}, expected {}", row.computed.readable(), row.expected.readable());
  }
  if (!row.error.is_missing() && row.metric != "equal" && !row.metric.starts_with("at ")) {
    text += fmt::format(", error {} ({}), tolerance {}", row.error.readable(), row.metric, row.tolerance.readable());
  }
  return wrapped(text, 8) + '\n';
}

std::string failure_in_full(const CaseResult& result, const Row& row) {
  std::string text = wrapped(fmt::format("FAILED {}: {}", result.claim.name, row.quantity), 2) + '\n';
  const auto line = [&](const char* what, const std::string& said) {
    if (!said.empty()) text += wrapped(fmt::format("  {:<10}{}", what, said), 12) + '\n';
  };
  line("claim", fmt::format("{} ({})", result.claim.claim, result.claim.equation));
  line("expected", row.expected.exact());
  line("computed", row.computed.exact());
  line("error", row.error.is_missing() ? "" : fmt::format("{} ({})", row.error.exact(), row.metric));
  line("tolerance", row.tolerance.exact());
  line("because", row.because);
  line("wrong", row.failure);
  return text;
}

}  // namespace verification
