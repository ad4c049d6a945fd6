#include <filesystem>
#include <string>

#include <boost/test/unit_test.hpp>

#include <particulate/report/files.hpp>

#include "harness/child.hpp"
#include "scratch_folder.hpp"

namespace tests::compare_rows_test {

using particulate::report::write_whole;

const std::string header = "chapter,case,quantity,expected,computed,error,metric,tolerance,verdict,run\n";

Ended compare(const std::string& before, const std::string& after) {
  const ScratchFolder folder;
  for (const auto& [name, rows] : {std::pair("before", before), std::pair("after", after)}) {
    std::filesystem::create_directory(folder.path() / name);
    write_whole(folder.path() / name / "rows.csv", header + rows);
    write_whole(folder.path() / name / "stamp.json", "{}");
  }
  return tests::run("compare_rows", (folder.path() / "before").native() + " " + (folder.path() / "after").native());
}

BOOST_AUTO_TEST_SUITE(compare_rows)

BOOST_AUTO_TEST_CASE(finds_nothing_between_equal_runs) {
  const std::string rows = "ch01,a,x,1,1.5,0,relative,0.5,pass,full\nch01,b,x,none,none,0,equal,0,fail,full\n";
  const Ended ended = compare(rows, rows);
  BOOST_TEST(ended.status == 0);
  BOOST_TEST(ended.output ==
             "verdicts that got worse: 0\nrows that are gone: 0\nverdicts that got better: 0\nrows that are new: 0\n"
             "values that moved by more than their tolerance: 0\n");
}

BOOST_AUTO_TEST_CASE(fails_if_a_verdict_got_worse) {
  const Ended ended = compare("ch01,a,x,1,1,0,relative,1e-9,pass,full\n", "ch01,a,x,1,2,0,relative,1e-9,fail,full\n");
  BOOST_TEST(ended.status == 1);
  BOOST_TEST(ended.has("verdicts that got worse: 1\n  ch01, a, x\n"));
  BOOST_TEST(
      ended.has("moved by more than their tolerance: 1\n  ch01, a, x: 1 -> 2 (expected 1, tolerance 1e-9 relative)"));
}

BOOST_AUTO_TEST_CASE(fails_if_a_row_is_gone_and_names_new_and_better_ones) {
  const Ended ended = compare("ch01,a,x,1,1,0,absolute,0,pass,full\nch01,b,x,1,0,0,absolute,1,fail,full\n",
                              "ch01,c,x,1,1,0,absolute,0,pass,full\nch01,b,x,1,1,0,absolute,1,pass,full\n");
  BOOST_TEST(ended.status == 1);
  BOOST_TEST(ended.has("rows that are gone: 1\n  ch01, a, x\n"));
  BOOST_TEST(ended.has("verdicts that got better: 1\n  ch01, b, x\n"));
  BOOST_TEST(ended.has("rows that are new: 1\n  ch01, c, x\n"));
}

// A move of 0.09 against a thousandth of 100, that is 0.1, and against half of that.
BOOST_AUTO_TEST_CASE(measures_moves_in_the_unit_of_the_tolerance) {
  struct Move {
    const char *before, *after;
    bool beyond;
  };
  for (const Move& move : {Move{"100,100,0,relative,0.001,pass", "100,100.09,0,relative,0.001,pass", false},
                           Move{"100,100,0,relative,0.0005,pass", "100,100.09,0,relative,0.0005,pass", true},
                           Move{"100,100,0,absolute,0.1,pass", "100,100.09,0,absolute,0.1,pass", false},
                           Move{"100,100,0,absolute,0.1,pass", "100,nan,0,absolute,0.1,pass", true},
                           // |expected| counts as at least 2: an error of 0.25 is a distance of 0.5, the tolerance 1.
                           Move{"0,0,0,mixed,0.5,pass", "0,0.5,0.25,mixed,0.5,pass", false},
                           Move{"0,0,0,mixed,0.5,pass", "0,1.5,0.75,mixed,0.5,fail", true},
                           Move{"1,0.5,-0.5,at most,0,pass", "1,0.9,-0.1,at most,0,pass", false},
                           Move{"none,none,0,equal,0,pass", "none,RK4,0,equal,0,pass", true}}) {
    const auto row = [](const char* numbers) { return std::string("c,a,x,") + numbers + ",full\n"; };
    BOOST_TEST_CONTEXT(move.before << " to " << move.after) {
      BOOST_TEST(compare(row(move.before), row(move.after))
                     .has(move.beyond ? "more than their tolerance: 1" : "more than their tolerance: 0"));
    }
  }
}

BOOST_AUTO_TEST_CASE(says_if_a_quick_run_stands_against_a_full_one) {
  BOOST_TEST(compare("c,a,x,1,1,0,absolute,0,pass,quick\n", "c,a,x,1,1,0,absolute,0,pass,full\n")
                 .has("note: a quick run against a full run"));
}

BOOST_AUTO_TEST_CASE(ends_with_status_2_where_there_is_nothing_to_compare) {
  const Ended none = tests::run("compare_rows", "no/such/folder neither/this");
  BOOST_TEST(none.status == 2);
  BOOST_TEST(none.has("no/such/folder must hold the results of a run that ended"));
  BOOST_TEST(tests::run("compare_rows", "one").status == 2);
  BOOST_TEST(tests::run("compare_rows", "--help").status == 0);
}

BOOST_AUTO_TEST_CASE(ends_with_status_2_for_rows_of_another_kind) {
  const ScratchFolder folder;
  write_whole(folder.path() / "rows.csv", "chapter,case\nch01,a\n");
  write_whole(folder.path() / "stamp.json", "{}");
  const Ended ended = tests::run("compare_rows", folder.path().native() + " " + folder.path().native());
  BOOST_TEST(ended.status == 2);
  BOOST_TEST(ended.has("must have a column \"quantity\""));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::compare_rows_test
