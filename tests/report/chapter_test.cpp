#include <particulate/report/chapter.hpp>

#include <filesystem>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include <particulate/report/files.hpp>

#include "says.hpp"
#include "scratch_folder.hpp"

namespace tests::chapter_test {

using namespace particulate::report;

// A chapter that claims of two numbers that they are at most one.
struct Parameters {
  CommandLine& line;
  double& x = line.field(0.5, {"x", "first"});
  double& y = line.field(0.5, {"y", "second"});
};

void validate(const Parameters& p) {
  if (p.x < 0.0) throw std::invalid_argument("x must be at least 0");
}

void claim(const Parameters& p, Chapter& chapter) {
  chapter.claims("checks").add("x", p.x, 1.0);
  chapter.claims("others").add("y", p.y, 1.0);
  chapter.claims("checks").add("x again", p.x, 1.0);
}

void claim_nothing(const Parameters&, Chapter&) {}

void ask_only(const Parameters&, Chapter& chapter) { chapter.claims("checks"); }

// A run in a folder that does not exist yet, and what it printed.
struct Ran {
  ScratchFolder scratch;
  std::filesystem::path folder = scratch.path() / "made";
  std::ostringstream printed, refused;
  int status = -1;

  explicit Ran(std::vector<std::string> words, void (*run)(const Parameters&, Chapter&) = claim,
               const std::string& figures = {}) {
    words.insert(words.begin(), {"ch99", "--out", folder.native()});
    std::vector<const char*> argv;
    for (const std::string& word : words) argv.push_back(word.c_str());
    std::streambuf *const out = std::cout.rdbuf(printed.rdbuf()), *const error = std::cerr.rdbuf(refused.rdbuf());
    status = run_chapter(static_cast<int>(argv.size()), argv.data(),
                         {.name = "ch99", .summary = "s.", .figures = figures}, "avx2", run);
    std::cout.rdbuf(out), std::cerr.rdbuf(error);
  }
  std::string file(const std::string& name) const { return read_whole(folder / name); }
};

BOOST_AUTO_TEST_SUITE(run_chapter_)

BOOST_AUTO_TEST_CASE(ends_well_if_every_claim_holds_and_leaves_all_that_repeats_it) {
  const Ran ran({"--x", "0.25"});
  BOOST_TEST(ran.status == 0);
  BOOST_TEST(ran.file("checks.csv") == "claim,error,allowed,verdict\nx,0.25,1,holds\nx again,0.25,1,holds\n");
  BOOST_TEST(ran.file("others.csv") == "claim,error,allowed,verdict\ny,0.5,1,holds\n");
  BOOST_TEST(ran.file("parameters.toml").find("\nx = 0.25\n") != std::string::npos);
  BOOST_TEST(ran.file("stamp.json").find("\"kernel\": \"avx2\"") != std::string::npos);
  BOOST_TEST(ran.printed.str() ==
             "verdict     error   allowed  claim\n"
             "holds        0.25         1  x\n"
             "holds        0.25         1  x again\n"
             "\n"
             "verdict     error   allowed  claim\n"
             "holds         0.5         1  y\n"
             "\n"
             "Every claim holds. The results are 4 files in " +
                 ran.folder.native() + ".\n");
}

BOOST_AUTO_TEST_CASE(sums_up_tells_what_to_change_and_how_to_draw_the_figures) {
  const Ran ran(
      {},
      [](const Parameters& p, Chapter& chapter) {
        chapter.claims("checks").add("x", p.x, 1.0);
        chapter.summary().add({"impacts", 3});
        chapter.note("lower --x.");
      },
      "mine/figures.gp");
  BOOST_TEST(ran.file("summary.csv") == "quantity,value\nimpacts,3\n");
  const std::string folder = ran.folder.native();
  BOOST_TEST(contains(ran.printed.str(),
                      "\n\nquantity  value\n--------  -----\nimpacts       3\n\nNote: lower --x.\n\n"
                      "Every claim holds. The results are 4 files in " +
                          folder + ". To draw their figures:\ndocs/draw.sh mine/figures.gp " + folder +
                          "/figures data=" + folder + "\n"));
}

BOOST_AUTO_TEST_CASE(fails_for_one_claim_in_any_table_and_still_writes) {
  for (const char* option : {"--x", "--y"}) {
    const Ran ran({option, "2"});
    BOOST_TEST(ran.status == 1);
    BOOST_TEST(contains(ran.printed.str(), "NOT every claim holds."));
    BOOST_TEST((ran.file("checks.csv") + ran.file("others.csv")).find("2,1,FAILS") != std::string::npos);
    BOOST_TEST(std::filesystem::exists(ran.folder / "stamp.json"));
  }
}

BOOST_AUTO_TEST_CASE(fails_if_nothing_is_claimed) {
  BOOST_TEST(Ran({}, claim_nothing).status == 1);
  BOOST_TEST(Ran({}, ask_only).status == 1);
}

BOOST_AUTO_TEST_CASE(writes_nothing_after_help_and_refusals) {
  const Ran helped({"--help"}), wrong({"--x", "much"}), invalid({"--x", "-1"});
  BOOST_TEST(helped.status == 0);
  BOOST_TEST(contains(helped.printed.str(), "--y NUMBER"));
  BOOST_TEST(wrong.status == 2);
  BOOST_TEST(wrong.refused.str().starts_with("ch99: --x must be a number"));
  BOOST_TEST(invalid.status == 2);
  BOOST_TEST(invalid.refused.str() == "ch99: x must be at least 0\n");
  for (const Ran* ran : {&helped, &wrong, &invalid}) BOOST_TEST(!std::filesystem::exists(ran->folder));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::chapter_test
