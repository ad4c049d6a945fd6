#include <harness/run.hpp>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <particulate/report/files.hpp>
#include <particulate/report/table.hpp>

#include "harness/child.hpp"
#include "says.hpp"
#include "scratch_folder.hpp"

namespace tests::run_test {

using particulate::report::parse_csv;
using particulate::report::read_whole;
using particulate::report::write_whole;

// A CSV file without the columns that differ from run to run.
std::string without(const std::filesystem::path& file, const std::vector<std::string>& columns) {
  const auto records = parse_csv(read_whole(file), file.native());
  std::string text;
  for (const auto& record : records) {
    std::string line;
    for (std::size_t i = 0; i < record.size(); ++i) {
      if (std::find(columns.begin(), columns.end(), records.front()[i]) == columns.end()) line += record[i] + "|";
    }
    text += line + "\n";
  }
  return text;
}

std::size_t widest(const std::string& text) {
  std::size_t width = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) width = std::max(width, line.size());
  return width;
}

BOOST_AUTO_TEST_SUITE(good_cases)

BOOST_AUTO_TEST_CASE(are_a_line_each_and_with_verbose_a_line_a_row) {
  const ScratchFolder folder;
  const Ended brief = run("harness_good", "--quick --out " + folder.path().native());
  BOOST_TEST(brief.has("\npass  converging "));
  BOOST_TEST(!contains(brief.output, "least order"));
  BOOST_TEST(brief.has("\nEvery row: " + (folder.path() / "rows.csv").native() + "\n"));
  const Ended verbose = run("harness_good", "--quick --verbose --out " + folder.path().native());
  BOOST_TEST(verbose.has("\npass  converging "));
  BOOST_TEST(verbose.has("\n  pass  least order: 4, expected 2, error -2 (order at least), tolerance 0.2\n"));
  BOOST_TEST(verbose.has("\n  pass  below: 0.5, at most 1\n"));
  BOOST_TEST(verbose.has("\n  pass  count: 3, expected 3\n"));
  for (const Ended& run : {brief, verbose}) BOOST_TEST(widest(run.output) <= 100U);
}

BOOST_AUTO_TEST_CASE(say_in_which_file_they_stand) {
  const ScratchFolder folder;
  BOOST_TEST(run("harness_good", "--quick --out " + folder.path().native()).status == 0);
  const std::string cases = read_whole(folder.path() / "cases.csv");
  BOOST_TEST(cases.rfind("chapter,case,claim,equation,reference,source\nch00,converging,", 0) == 0U);
  BOOST_TEST(contains(cases, "D 1.2,identity,programs/good.cpp\n"));
}

BOOST_AUTO_TEST_CASE(end_with_success_and_exactly_these_rows) {
  const ScratchFolder folder;
  const Ended ended = run("harness_good", "--quick --out " + folder.path().native());
  BOOST_TEST(ended.status == 0);
  BOOST_TEST(ended.has("\n15 rows, 0 failed\n"));
  const std::string one_sided = "ch00|one_sided|bounds hold, the bound itself included|D 1.2|identity|";
  const std::string two_sided = "ch00|two_sided|numbers, \"counts\" and texts agree|M 1.1|closed form|";
  const std::string converging = "ch00|converging|errors fall with the fourth power of the step|R 3.1|convergence|";
  const std::string extremes = "ch00|extremes|extreme cases end as they must|D 2.1|design|";
  const std::string measured = "ch00|measured|a measurement keeps its promises|R 3.2|closed form|decay";
  BOOST_TEST(
      without(folder.path() / "rows.csv", {"seconds"}) ==
      "chapter|case|claim|equation|reference|quantity|expected|computed|error|metric|tolerance|because|verdict|run|\n" +
          converging + "order|4|4|0|order|0.2|h^4 exactly|pass|quick|\n" + converging +
          "least order|2|4|-2|order at least|0.2|h^4 exactly|pass|quick|\n" + extremes +
          "nearly parabolic|solved|solved|0.25|verdict|0.5|half is enough|pass|quick|\n" + extremes +
          "coincident|refused|refused||verdict||the reason given must have the words: must, differ|pass|quick|\n" +
          extremes +
          "diverging|refused|refused||verdict||the reason given must have the words: contraction|pass|quick|\n" +
          measured +
          ", RK4: order fitted to the errors at the end, against evaluations|4|4|0|order|0.2|at fixed steps the error "
          "falls with the method's order; fitted where it is below 1e-2 and more than 1000 times that of the "
          "reference|pass|quick|\n" +
          measured +
          ": what is wrong with the measurement itself|nothing|nothing|0|equal|0|methods can be compared that do the "
          "same task, at settings without gaps, with the same work whenever they are run, and with errors that can be "
          "measured, beside one whose order is known|pass|quick|\n" +
          one_sided + "below|1|0.5|-0.5|at most|0|half is less than one|pass|quick|\n" + one_sided +
          "at it|1|1|0|at least|0|the bound belongs to it|pass|quick|\n" + two_sided +
          "relative [m]|-2|-2.5|0.25|relative|0.25|a quarter, exactly|pass|quick|\n" + two_sided +
          "absolute [m]|0|0.125|0.125|absolute|0.5|half, around zero|pass|quick|\n" + two_sided +
          "mixed [m]|1e-09|0|5e-10|mixed|0.5|the floor is one|pass|quick|\n" + two_sided +
          "last bit [m]|0.1|0.1|0|absolute|0|the same digits|pass|quick|\n" + two_sided +
          "count|3|3|0|equal|0|counted by hand|pass|quick|\n" + two_sided +
          "text|a, b|a, b|0|equal|0|by definition|pass|quick|\n");
}

BOOST_AUTO_TEST_CASE(write_verdicts_on_extremes) {
  const ScratchFolder folder;
  BOOST_TEST(run("harness_good", "--out " + folder.path().native()).status == 0);
  BOOST_TEST(read_whole(folder.path() / "stability.csv") ==
             "chapter,case,must,verdict,reason\n"
             "ch00,extremes: nearly parabolic,solved,solved,\n"
             "ch00,extremes: coincident,refused,refused,\"positions must differ, got twice 0\"\n"
             "ch00,extremes: diverging,refused,refused,\"the contraction is 1.001, which is not below 1\"\n");
}

BOOST_AUTO_TEST_CASE(write_error_against_run_time_failures_included) {
  const ScratchFolder folder;
  BOOST_TEST(run("harness_good", "--out " + folder.path().native()).status == 0);
  BOOST_TEST(without(folder.path() / "work_precision.csv", {"seconds_min", "seconds_median", "seconds_overhead"}) ==
             "chapter|problem|method|setting|tuned|error_end|error_max|floor|reference|evaluations|iterations|status|\n"
             "ch00|decay|RK4|0.25|no|0.00390625|0.0078125|1e-12|exp(-1)|16|0|solved|\n"
             "ch00|decay|RK4|0.125|no|0.000244140625|0.00048828125|1e-12|exp(-1)|32|0|solved|\n"
             "ch00|decay|RK4|0.0625|no|1.52587890625e-05|3.0517578125e-05|1e-12|exp(-1)|64|0|solved|\n"
             "ch00|decay|RK4|0.03125|no|9.5367431640625e-07|1.9073486328125e-06|1e-12|exp(-1)|128|0|solved|\n"
             "ch00|decay|RK4|0.015625|no|5.960464477539063e-08|1.1920928955078125e-07|1e-12|exp(-1)|256|0|solved|\n"
             "ch00|decay|stiff|0.5|yes|||1e-12|exp(-1)|7|0|failed: the step fell below its least|\n"
             "ch00|decay|stiff|0.25|yes|5e-12|6e-12|1e-12|exp(-1)|9|3|at floor|\n");
  BOOST_TEST(std::filesystem::exists(folder.path() / "stamp.json"));
}

BOOST_AUTO_TEST_CASE(can_be_listed_and_chosen) {
  const ScratchFolder folder;
  const Ended list = run("harness_good", "--list --out " + (folder.path() / "none").native());
  BOOST_TEST(list.status == 0);
  BOOST_TEST(list.has("one_sided   D 1.2     identity     bounds hold, the bound itself included"));
  BOOST_TEST(!std::filesystem::exists(folder.path() / "none"));
  const Ended two = run("harness_good", "--case one_sided --case converging --out " + folder.path().native());
  BOOST_TEST(two.status == 0);
  BOOST_TEST(two.has("\n4 rows, 0 failed\n"));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(bad_cases)

// Case and words that its failure must show.
const std::vector<std::pair<std::string, std::string>> defects{
    {"beyond_tolerance", "error     2.220446049250313e-16 (relative)\n  tolerance 1e-16\n  because   b"},
    {"one_of_two", "2 rows, 1 failed"},
    {"some_of_none", "1 rows, 1 failed"},
    {"seven_of_seven",
     "\n  because   a reason that is longer than a line of a terminal is broken at its blanks, so that\n"
     "            nothing is cut off\n\nseven_of_seven: 2 more rows failed; --verbose prints them\n"},
    {"computed_nan", "every number must be finite, got nan"},
    {"expected_nan", "every number must be finite, got nan"},
    {"tolerance_nan", "1 rows, 1 failed"},
    {"infinite", "every number must be finite, got inf"},
    {"infinite_bound", "every number must be finite, got -inf"},
    {"nan_bound", "every number must be finite, got nan"},
    {"above_bound", "(at most)"},
    {"below_bound", "(at least)"},
    {"without_reason", "every row must say why"},
    {"relative_to_zero", "use absolute() or mixed()"},
    {"unset", "both the expected and the computed value must be given"},
    {"empty", "the case compared nothing"},
    {"throwing", "it threw: the integrator stopped"},
    {"out_of_memory", "it threw: std::bad_alloc"},
    {"throwing_a_number", "it threw something that is no std::exception"},
    {"refused_but_solvable", "it was refused: no step is small enough"},
    {"solved_but_impossible", "it must be refused, and was not"},
    {"wrongly_solved", "the answer is wrong: its error 2 must not exceed 1"},
    {"solved_with_nan", "the answer is wrong: its error nan must not exceed 1"},
    {"wrong_words", "refused for another reason, without the word \"coincide\": particles overlap"},
    {"no_words", "there must be key words"},
    {"order_too_low", "computed  3.79"},
    {"order_too_high", "computed  4.21"},
    {"order_not_reached", "(order at least)"},
    {"too_few_points", "at least four refinements, that is 5 points, got 4"},
    {"error_too_large", "every error must lie in [1e-09, 0.01] (1000 times"},
    {"error_at_floor", "every error must lie in [1e-07, 0.01] (1000 times"},
    {"order_of_nan", "nan at step 0.25\n"},
    {"steps_not_refined", "every step must be 1.25 to 16 times smaller than the one before, got 0.09 after 0.1"},
    {"counts_do_not_repeat",
     "claim     something false (M 0.0)\n  expected  nothing\n"
     "  computed  runs that do other work when they are repeated: RK4 at 0.0625\n"},
    {"replay_takes_another_path",
     "repeated: RK4 at 0.25, RK4 at 0.125, RK4 at\n            0.0625, RK4 at 0.03125, RK4 at 0.015625\n"},
    {"without_replay", "RK4 must give run, errors and replay, got an empty one"},
    {"without_task", "RK4 must tell its task"},
    {"another_start", "or output times than the first: RK4 at 0.015625\n"},
    {"error_of_nan", "runs that claim an answer whose error is no number: RK4 at 0.015625\n"},
    {"nothing_solved", "methods that give no answer at any setting: hopeless\n"},
    {"coarse_settings", "half a decade apart: coarse\n"},
    {"rising_settings", "half a decade apart: rising\n"},
    {"without_ruler", "computed  no method of fixed step and known order\n"},
    {"wrong_slope", "order fitted to the errors at the end, against evaluations\n"},
    {"slope_below_its_bound", "order fitted to the errors at the end, against evaluations\n"},
};

BOOST_AUTO_TEST_CASE(end_with_status_1_and_say_what_is_wrong) {
  for (const auto& [name, words] : defects) {
    BOOST_TEST_CONTEXT(name) {
      const ScratchFolder folder;
      const Ended ended = run("harness_bad", "--quick --case " + name + " --out " + folder.path().native());
      BOOST_TEST(ended.status == 1);
      BOOST_TEST(ended.has("FAIL  " + name));
      BOOST_TEST(ended.has("FAILED " + name + ": "));
      BOOST_TEST(ended.has(words));
      BOOST_TEST(read_whole(folder.path() / "rows.csv").find(",fail,quick,") != std::string::npos);
    }
  }
}

BOOST_AUTO_TEST_CASE(are_all_tried_here) {
  const Ended list = run("harness_bad", "--list");
  const auto lines = std::count(list.output.begin(), list.output.end(), '\n');
  BOOST_TEST(static_cast<std::size_t>(lines) == defects.size() + 2);  // the header and its rule
}

BOOST_AUTO_TEST_CASE(are_printed_by_theme_where_they_would_not_fit_a_screen) {
  const ScratchFolder folder;
  const Ended all = run("harness_bad", "--quick --out " + folder.path().native());
  BOOST_TEST(all.has(fmt::format("FAIL  bad, {} cases ", defects.size())));
  BOOST_TEST(widest(all.output) <= 100U);
}

BOOST_AUTO_TEST_CASE(do_not_keep_one_another_from_running) {
  const ScratchFolder folder;
  const Ended ended = run(
      "harness_bad", "--case throwing --case out_of_memory --case beyond_tolerance --out " + folder.path().native());
  BOOST_TEST(ended.status == 1);
  BOOST_TEST(ended.has("\n4 rows, 3 failed\n"));
  BOOST_TEST(parse_csv(read_whole(folder.path() / "rows.csv"), "rows.csv").size() == 5U);
}

BOOST_AUTO_TEST_CASE(are_told_apart_in_the_stability_table) {
  const ScratchFolder folder;
  run("harness_bad",
      "--case refused_but_solvable --case solved_but_impossible --case wrongly_solved --case solved_with_nan "
      "--case wrong_words --out " +
          folder.path().native());
  BOOST_TEST(without(folder.path() / "stability.csv", {"reason"}) ==
             "chapter|case|must|verdict|\n"
             "ch00|refused_but_solvable: x|solved|refused|\n"
             "ch00|solved_but_impossible: x|refused|solved|\n"
             "ch00|solved_with_nan: x|solved|wrong|\n"
             "ch00|wrong_words: x|refused|wrong|\n"
             "ch00|wrongly_solved: x|solved|wrong|\n");
}

BOOST_AUTO_TEST_CASE(a_program_without_a_case_fails) {
  const ScratchFolder folder;
  const Ended ended = run("harness_no_case", "--out " + folder.path().native());
  BOOST_TEST(ended.status == 1);
  BOOST_TEST(ended.has("0 rows, 0 failed"));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(wrong_use)

BOOST_AUTO_TEST_CASE(an_unknown_case_ends_with_status_2_and_what_is_near) {
  const ScratchFolder folder;
  const Ended ended = run("harness_good", "--case one_sidde --case two_sided --out " + folder.path().native());
  BOOST_TEST(ended.status == 2);
  BOOST_TEST(
      ended.has("verify_ch00: --case must name a case of this program, got \"one_sidde\". Did you mean one_sided"));
  BOOST_TEST(folder.files().empty());
  BOOST_TEST(run("harness_good", "--case=").status == 2);
}

BOOST_AUTO_TEST_CASE(an_unknown_option_ends_with_status_2) {
  const Ended ended = run("harness_good", "--quik");
  BOOST_TEST(ended.status == 2);
  BOOST_TEST(ended.has("Did you mean --quick?"));
}

BOOST_AUTO_TEST_CASE(a_folder_that_takes_no_file_ends_with_status_2_before_any_case_runs) {
  const ScratchFolder folder;
  write_whole(folder.path() / "file", "x");
  const Ended ended = run("harness_bad", "--case throwing --out " + (folder.path() / "file" / "below").native());
  BOOST_TEST(ended.status == 2);
  BOOST_TEST(ended.has("file/below cannot be made a folder for results: Not a directory"));
  BOOST_TEST(!contains(ended.output, "throwing"));
}

// A directory where rows.csv should go lets the check before the cases pass, and the write after them fail.
BOOST_AUTO_TEST_CASE(results_that_cannot_be_written_end_with_status_2) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path() / "rows.csv");
  const Ended ended = run("harness_good", "--case one_sided --out " + folder.path().native());
  BOOST_TEST(ended.status == 2);
  BOOST_TEST(ended.has("rows.csv cannot be written: Is a directory"));
}

BOOST_AUTO_TEST_CASE(two_cases_of_one_name_end_with_status_2) {
  const Ended ended = run("harness_duplicate_names", "");
  BOOST_TEST(ended.status == 2);
  BOOST_TEST(ended.has("names of cases must differ, got \"twin\" twice"));
}

BOOST_AUTO_TEST_CASE(a_case_that_claims_nothing_ends_with_status_2) {
  const Ended ended = run("harness_unstated_claim", "");
  BOOST_TEST(ended.status == 2);
  BOOST_TEST(ended.has("case silent must state its claim and its equation"));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::run_test
