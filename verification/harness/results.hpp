#pragma once

#include <string>
#include <vector>

#include <harness/case.hpp>
#include <particulate/report/table.hpp>

namespace verification {

/// What one case gave.
struct CaseResult {
  Claim claim;                             ///< what it claims
  std::vector<Row> rows;                   ///< at least one
  std::vector<Stability> stability;        ///< verdicts on extreme cases
  std::vector<WorkPrecisionPoint> points;  ///< measured
  double seconds = 0.0;                    ///< wall time of the whole case
  std::string source;                      ///< folder and file of the case

  /// @return how many rows failed
  std::size_t failed() const;
};

/// Runs one case. What it throws becomes a failed row; so does a case that compares nothing.
/// @param claimed   the case
/// @param settings  what the run was asked for
/// @return its rows, at least one
CaseResult prove(const Case& claimed, const Rows::Settings& settings);

/// @param chapter  `ch01` ... `appB`
/// @param results  of every case that ran
/// @param quick    which run it was
/// @return the table written as rows.csv
particulate::report::Table rows_table(const std::string& chapter, const std::vector<CaseResult>& results, bool quick);
/// @param chapter  `ch01` ... `appB`
/// @param results  of every case that ran
/// @return the table written as work_precision.csv
particulate::report::Table work_precision_table(const std::string& chapter, const std::vector<CaseResult>& results);
/// @param chapter  `ch01` ... `appB`
/// @param results  of every case that ran
/// @return the table written as stability.csv
particulate::report::Table stability_table(const std::string& chapter, const std::vector<CaseResult>& results);

/// @param chapter  `ch01` ... `appB`
/// @param results  of every case that ran
/// @return the table written as cases.csv: what is claimed, and in which file it is proved
particulate::report::Table cases_table(const std::string& chapter, const std::vector<CaseResult>& results);

/// @param row  of a case
/// @return its quantity and numbers in a line for a terminal, or two
std::string row_in_brief(const Row& row);
/// @param result  of one case
/// @param row     one of its rows that failed
/// @return everything about it, for a terminal
std::string failure_in_full(const CaseResult& result, const Row& row);

}  // namespace verification
