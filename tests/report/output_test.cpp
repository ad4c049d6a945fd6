#include <particulate/report/output.hpp>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <particulate/report/files.hpp>

#include "report/full_disk.hpp"
#include "says.hpp"
#include "scratch_folder.hpp"

namespace tests::output_test {

using namespace particulate::report;
using Names = std::vector<std::string>;

Table one_number(double x) {
  Table table({"x"});
  table.add({x});
  return table;
}

Names sorted(const ScratchFolder& folder) {
  Names names = folder.files();
  std::sort(names.begin(), names.end());
  return names;
}

// Two tables and the parameters, finished.
void run_to_the_end(const ScratchFolder& folder) {
  const Output output(folder.path());
  output.write_parameters("x = 1.0\n");
  output.write("a", one_number(1.0));
  output.write("b", one_number(1.0));
  output.write("a", one_number(2.0));  // what is written twice is listed once
  output.finish(make_stamp("ch99", 1, "avx2"));
}

BOOST_AUTO_TEST_SUITE(output_)

BOOST_AUTO_TEST_CASE(ends_with_a_stamp_that_names_every_file) {
  const ScratchFolder folder;
  run_to_the_end(folder);
  BOOST_TEST(sorted(folder) == (Names{"a.csv", "b.csv", "parameters.toml", "stamp.json"}),
             boost::test_tools::per_element());
  BOOST_TEST(read_whole(folder.path() / "a.csv") == "x\n2\n");
  BOOST_TEST(files_of_stamp(read_whole(folder.path() / "stamp.json")) == (Names{"parameters.toml", "a.csv", "b.csv"}),
             boost::test_tools::per_element());
  BOOST_CHECK_NO_THROW(require_finished(folder.path()));
}

BOOST_AUTO_TEST_CASE(a_run_that_is_cut_short_keeps_nothing_of_the_one_before_and_looks_unfinished) {
  const ScratchFolder folder;
  run_to_the_end(folder);
  write_whole(folder.path() / "my_fit.csv", "x\n");  // of no run
  { const Output cut_short(folder.path()); }
  BOOST_TEST(sorted(folder) == (Names{"my_fit.csv", "unfinished.txt"}), boost::test_tools::per_element());
  Output(folder.path()).write("c", one_number(3.0));
  BOOST_CHECK_EXCEPTION(
      require_finished(folder.path()), std::runtime_error,
      says("must hold the results of a run that ended, with a stamp.json and without unfinished.txt"));
  run_to_the_end(folder);  // takes down c.csv, which no stamp has named
  BOOST_TEST(sorted(folder) == (Names{"a.csv", "b.csv", "my_fit.csv", "parameters.toml", "stamp.json"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(takes_down_no_file_that_is_none_of_a_run_whatever_a_list_says) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path() / "run");
  for (const char* name : {"up.csv", "run/My.csv", "run/thesis.tex"}) write_whole(folder.path() / name, "x");
  write_whole(folder.path() / "run" / "unfinished.txt", "../up.csv\nMy.csv\n");
  write_whole(folder.path() / "run" / "stamp.json", R"({"files": ["thesis.tex", "../up.csv", ".csv", ""]})");
  const Output output(folder.path() / "run");
  for (const char* name : {"up.csv", "run/My.csv", "run/thesis.tex"}) {
    BOOST_TEST(std::filesystem::exists(folder.path() / name), name);
  }
}

BOOST_AUTO_TEST_CASE(serves_one_run_at_a_time) {
  const ScratchFolder folder;
  {
    const Output output(folder.path());
    output.write("a", one_number(1.0));
    BOOST_CHECK_EXCEPTION(Output(folder.path()), std::runtime_error, says("another is at work there"));
    BOOST_TEST(sorted(folder) == (Names{"a.csv", "unfinished.txt"}), boost::test_tools::per_element());
  }
  BOOST_CHECK_NO_THROW(Output(folder.path()));
}

BOOST_AUTO_TEST_CASE(leaves_what_is_there_where_it_cannot_write) {
  const ScratchFolder folder;
  run_to_the_end(folder);
  {
    const FullDisk full(10);  // enough for the first try, too little for the list
    BOOST_CHECK_EXCEPTION(Output(folder.path()), std::runtime_error, says("unfinished.txt cannot be written"));
  }
  BOOST_TEST(folder.files().size() == 4U);
  BOOST_CHECK_NO_THROW(require_finished(folder.path()));
}

BOOST_AUTO_TEST_CASE(writes_files_for_other_programs_and_takes_them_down_again) {
  const ScratchFolder folder;
  {
    const Output output(folder.path());
    output.write_file("cloud.xyz", "0\n\n");
    output.finish(make_stamp("ch99", 1, "avx2"));
  }
  BOOST_TEST((sorted(folder) == Names{"cloud.xyz", "stamp.json"}));
  const Output next(folder.path());
  BOOST_TEST((sorted(folder) == Names{"unfinished.txt"}));
  BOOST_CHECK_EXCEPTION(
      next.write_file("../cloud.xyz", ""), std::invalid_argument,
      says("a file's name must be lower-case letters, digits and underscores, with .xyz, .vtp or .vti"));
}

BOOST_AUTO_TEST_CASE(refuses_a_name_that_leads_elsewhere) {
  const ScratchFolder folder;
  const Output output(folder.path());
  for (const char* name : {"", "../x", "rows.csv", "Rows"}) {
    CHECK_REFUSED(output.write(name, one_number(1.0)), "must be lower-case letters");
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::output_test
