#include <filesystem>
#include <string>

#include <boost/test/unit_test.hpp>

#include <particulate/report/files.hpp>

#include "harness/child.hpp"
#include "scratch_folder.hpp"

namespace tests::compare_runs_test {

using particulate::report::write_whole;

const std::string header = "chapter,case,quantity,expected,computed,error,metric,tolerance,verdict,run\n";

Ended compare(const std::string& before, const std::string& after) {
  const ScratchFolder folder;
  for (const auto& [name, rows] : {std::pair("before", before), std::pair("after", after)}) {
    std::filesystem::create_directory(folder.path() / name);
    write_whole(folder.path() / name / "rows.csv", header + rows);
    write_whole(folder.path() / name / "stamp.json", "{}");
  }
  return tests::run("compare_runs", (folder.path() / "before").native() + " " + (folder.path() / "after").native());
}

BOOST_AUTO_TEST_SUITE(compare_runs_of_a_verification)

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
  const Ended none = tests::run("compare_runs", "no/such/folder neither/this");
  BOOST_TEST(none.status == 2);
  BOOST_TEST(none.has("no/such/folder must hold the results of a run that ended"));
  BOOST_TEST(tests::run("compare_runs", "one").status == 2);
  BOOST_TEST(tests::run("compare_runs", "--help").status == 0);
}

BOOST_AUTO_TEST_CASE(ends_with_status_2_for_rows_of_another_kind) {
  const ScratchFolder folder;
  write_whole(folder.path() / "rows.csv", "chapter,case\nch01,a\n");
  write_whole(folder.path() / "stamp.json", "{}");
  const Ended ended = tests::run("compare_runs", folder.path().native() + " " + folder.path().native());
  BOOST_TEST(ended.status == 2);
  BOOST_TEST(ended.has("must have a column \"quantity\""));
}

BOOST_AUTO_TEST_SUITE_END()

// A run of a chapter: its parameters and one table, or two.
void write_run(const std::filesystem::path& folder, const std::string& e, const std::string& energy,
               const std::string& other = "") {
  std::filesystem::create_directory(folder);
  write_whole(folder / "parameters.toml", "e = " + e + "\nside = 4\n");
  write_whole(folder / "energy.csv", energy);
  if (!other.empty()) write_whole(folder / (other + ".csv"), "n\n1\n");
  const std::string file = other.empty() ? "" : ", \"" + other + ".csv\"";
  write_whole(folder / "stamp.json", "{\"files\": [\"parameters.toml\", \"energy.csv\"" + file + "]}");
}

BOOST_AUTO_TEST_SUITE(compare_runs_of_a_chapter)

BOOST_AUTO_TEST_CASE(says_where_a_column_changed_most_as_a_share_of_its_largest_value) {
  const ScratchFolder folder;
  const std::filesystem::path one = folder.path() / "one", two = folder.path() / "two";
  const std::string both = one.native() + " " + two.native();
  write_run(one, "0.5", "t [s],E [J],phase\n0,0,a\n1,-8,b\n2,4,c\n");
  write_run(two, "0.25", "t [s],E [J],phase\n0,0.5,a\n1,-8,b\n2,3,c\n");
  const Ended ended = tests::run("compare_runs", both);
  BOOST_TEST(ended.status == 1);
  BOOST_TEST(ended.has("parameters that differ: 1\n  e: 0.5 -> 0.25\n"));
  BOOST_TEST(ended.has("tables that are the same to the last digit: 0\n"));
  BOOST_TEST(ended.has("columns that differ: 1\n"));
  BOOST_TEST(ended.has("\nenergy  E [J]    0.125    3  4       3\n"));
  BOOST_TEST(tests::run("compare_runs", "--within 0.125 " + both).status == 0);
  BOOST_TEST(tests::run("compare_runs", "--within 0.124 " + both).status == 1);
}

BOOST_AUTO_TEST_CASE(counts_other_texts_and_what_is_no_number_as_infinitely_far) {
  for (const char* changed : {"t,w\n1,a\n2,c\n", "t,w\n1,a\nnan,b\n", "t,w\n1,a\ninf,b\n", "t,w\n1,a\n,b\n"}) {
    BOOST_TEST_CONTEXT(changed) {
      const ScratchFolder folder;
      write_run(folder.path() / "one", "1", "t,w\n1,a\n2,b\n");
      write_run(folder.path() / "two", "1", changed);
      const Ended ended = tests::run("compare_runs", "--within 1e300 " + (folder.path() / "one").native() + " " +
                                                         (folder.path() / "two").native());
      BOOST_TEST(ended.status == 1);
      BOOST_TEST(ended.has("inf    2"));
    }
  }
}

BOOST_AUTO_TEST_CASE(finds_nothing_between_equal_runs) {
  const ScratchFolder folder;
  for (const char* name : {"one", "two"}) write_run(folder.path() / name, "1", "t,w\n1,nan\n");
  const Ended ended =
      tests::run("compare_runs", (folder.path() / "one").native() + " " + (folder.path() / "two").native());
  BOOST_TEST(ended.status == 0);
  BOOST_TEST(ended.output ==
             "parameters that differ: 0\ntables that are the same to the last digit: 1 energy\n"
             "tables that cannot be compared: 0\ncolumns that differ: 0\n");
}

BOOST_AUTO_TEST_CASE(names_tables_that_cannot_be_compared) {
  struct Pair {
    const char *table, *before, *after, *words;
  };
  for (const Pair& pair : {Pair{"t\n1\n2\n", "", "", "energy has 1 rows -> 2"}, Pair{"u\n1\n", "", "", "other columns"},
                           Pair{"t\n1\n", "", "more", "more is new"}, Pair{"t\n1\n", "more", "", "more is gone"}}) {
    const ScratchFolder folder;
    write_run(folder.path() / "one", "1", "t\n1\n", pair.before);
    write_run(folder.path() / "two", "1", pair.table, pair.after);
    const Ended ended = tests::run(
        "compare_runs", "--within 1e300 " + (folder.path() / "one").native() + " " + (folder.path() / "two").native());
    BOOST_TEST(ended.status == 1);
    BOOST_TEST(ended.has(pair.words));
  }
}

BOOST_AUTO_TEST_CASE(refuses_a_share_that_is_none) {
  for (const char* share : {"-1", "nan", "much"}) {
    const Ended ended = tests::run("compare_runs", std::string("--within ") + share + " one two");
    BOOST_TEST(ended.status == 2);
    BOOST_TEST(ended.has("--within must be a number, 0 or more"));
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::compare_runs_test
