#pragma once

#include <string_view>

namespace verification {

/// Runs the cases linked into this program, and writes rows.csv, cases.csv, work_precision.csv, stability.csv and
/// stamp.json.
///
/// Cases run theme by theme, that is source by source, each in the order of names. One that throws fails, and the
/// others still run; one that compares nothing fails.
/// @param argc     as main() gets it
/// @param argv     as main() gets it
/// @param chapter  `ch01` ... `ch09`, `appA`, `appB`
/// @param title    of the chapter, for a reader
/// @return 0 if every claim holds, 1 if one failed or there is none, 2 for a wrong command line, a wrong registration
/// or
///         results that cannot be written
int run(int argc, const char* const* argv, std::string_view chapter, std::string_view title);

}  // namespace verification
