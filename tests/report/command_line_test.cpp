#include <particulate/report/command_line.hpp>

#include <bit>
#include <cstdint>
#include <sstream>
#include <stdexcept>

#include <particulate/report/files.hpp>

#include "numbers.hpp"
#include "says.hpp"
#include "scratch_folder.hpp"

namespace tests::command_line_test {

using namespace particulate::report;

constexpr double inf = infinity;

// A program with one field of every type.
struct Tried {
  CommandLine command;
  double& alpha1 = command.field(
      0.5, {.name = "alpha1", .meaning = "attraction", .unit = "N", .range = at_least(0), .source = "M 1.30"});
  double& v_star = command.field(
      inf, {.name = "v_star", .meaning = "critical speed", .unit = "m/s", .range = more_than(0).or_infinite()});
  double& shift = command.field(0.0, {.name = "shift", .meaning = "any number"});
  int& members = command.field(5, {.name = "members", .meaning = "bodies", .range = between(1, 100)});
  bool& friction = command.field(false, {.name = "friction", .meaning = "whether contacts rub"});
  std::string& scheme =
      command.field("verlet", {.name = "scheme", .meaning = "time stepping", .range = one_of({"verlet", "rk4"})});
  std::string printed, refused;

  explicit Tried(bool has_cases = false)
      : command({.name = "ch01", .summary = "shows a pair.", .has_cases = has_cases}) {}

  std::optional<int> parse(std::vector<std::string> words) {
    std::vector<const char*> argv{"/somewhere/ch01"};
    for (const std::string& word : words) argv.push_back(word.c_str());
    std::ostringstream out, error;
    const std::optional<int> status = command.parse(static_cast<int>(argv.size()), argv.data(), out, error);
    printed = out.str(), refused = error.str();
    return status;
  }
  // Whether the words are refused with status 2 and a message that says so.
  bool refuses(const std::vector<std::string>& words, const std::string& message) {
    const bool refused_at_all = parse(words) == 2 && printed.empty() && refused.starts_with("ch01: ");
    BOOST_TEST_INFO("message: " << refused);
    BOOST_TEST(contains(refused, message));
    return refused_at_all;
  }
  bool refuses_file(const std::string& content, const std::string& message) {
    const ScratchFolder folder;
    write_whole(folder.path() / "p.toml", content);
    return refuses({"--config", (folder.path() / "p.toml").native()}, message);
  }
};

BOOST_AUTO_TEST_SUITE(command_line_parse)

BOOST_AUTO_TEST_CASE(leaves_the_defaults_where_nothing_is_said) {
  Tried tried;
  BOOST_TEST(!tried.parse({}));
  BOOST_TEST(tried.alpha1 == 0.5);
  BOOST_TEST(tried.v_star == inf);
  BOOST_TEST(!tried.command.common().quick);
  BOOST_TEST(tried.command.common().seed == 1U);
  BOOST_TEST(tried.command.common().threads == 1);
  BOOST_TEST(tried.command.common().out.native() == "out/ch01");
}

BOOST_AUTO_TEST_CASE(reads_every_type_of_field) {
  Tried tried;
  BOOST_TEST(!tried.parse({"--alpha1", "2.5e-3", "--v_star=7", "--shift", "-1.5", "--members=12", "--friction", "true",
                           "--scheme", "rk4"}));
  BOOST_TEST(tried.alpha1 == 2.5e-3);
  BOOST_TEST(tried.v_star == 7.0);
  BOOST_TEST(tried.shift == -1.5);
  BOOST_TEST(tried.members == 12);
  BOOST_TEST(tried.friction);
  BOOST_TEST(tried.scheme == "rk4");
}

BOOST_AUTO_TEST_CASE(reads_the_options_of_every_program) {
  Tried tried(true);
  BOOST_TEST(!tried.parse({"--quick", "--out", "a b", "--seed", "9223372036854775807", "--threads=2", "--case", "x",
                           "--case=y", "--list"}));
  const Common& common = tried.command.common();
  BOOST_TEST(common.quick);
  BOOST_TEST(common.out.native() == "a b");
  BOOST_TEST(common.seed == 9223372036854775807U);
  BOOST_TEST(common.threads == 2);
  BOOST_TEST((common.cases == std::vector<std::string>{"x", "y"}));
  BOOST_TEST(common.list);
  BOOST_TEST(tried.command.line() ==
             "ch01 --quick --out 'a b' --seed 9223372036854775807 --threads=2 --case x --case=y --list");
}

BOOST_AUTO_TEST_CASE(a_number_must_be_one_to_its_last_character) {
  Tried tried;
  for (const char* text : {"0.5x", "x", "0.5 ", " 0.5", "0,5", "0x10", "1e", "--5"}) {
    BOOST_TEST(tried.refuses({std::string("--alpha1=") + text}, "--alpha1 must"));
  }
  BOOST_TEST(tried.refuses({"--alpha1", "0.5x"},
                           "--alpha1 must be a number, got \"0.5x\". Give another value, or leave it out for 0.5."));
  BOOST_TEST(tried.alpha1 == 0.5);
}

BOOST_AUTO_TEST_CASE(a_number_must_fit_a_double_and_be_one) {
  Tried tried;
  BOOST_TEST(tried.refuses({"--alpha1", "1e400"}, "--alpha1 must be a number that fits its type, got \"1e400\""));
  BOOST_TEST(tried.refuses({"--alpha1", "1e-400"}, "--alpha1 must be a number that fits its type, got \"1e-400\""));
  BOOST_TEST(tried.refuses({"--alpha1", "nan"}, "--alpha1 must be at least 0, got \"nan\""));
  BOOST_TEST(tried.refuses({"--shift", "nan"}, "--shift must be a finite number, got \"nan\""));
  BOOST_TEST(tried.refuses({"--shift", "-inf"}, "--shift must be a finite number, got \"-inf\""));
  BOOST_TEST(!tried.parse({"--v_star", "inf"}));
}

BOOST_AUTO_TEST_CASE(a_number_must_lie_in_its_range) {
  Tried tried;
  BOOST_TEST(tried.refuses({"--alpha1", "-1"}, "--alpha1 must be at least 0, got \"-1\""));
  BOOST_TEST(tried.refuses({"--v_star", "0"}, "--v_star must be greater than 0 or inf, got \"0\""));
  BOOST_TEST(tried.refuses({"--members", "101"}, "--members must lie in [1, 100], got \"101\""));
  BOOST_TEST(tried.refuses({"--threads", "0"}, "--threads must lie in [1, 4096], got \"0\""));
  BOOST_TEST(tried.refuses({"--seed", "-1"}, "--seed must be at least 0, got \"-1\""));
  BOOST_TEST(tried.refuses({"--seed", "9223372036854775808"}, "that fits its type"));
}

BOOST_AUTO_TEST_CASE(whole_numbers_choices_and_switches_take_nothing_else) {
  Tried tried;
  BOOST_TEST(tried.refuses({"--members", "2.5"}, "--members must be a whole number, got \"2.5\""));
  BOOST_TEST(tried.refuses({"--scheme", "euler"}, "--scheme must be one of verlet, rk4, got \"euler\""));
  BOOST_TEST(tried.refuses({"--friction", "yes"}, "--friction must be true or false, got \"yes\""));
}

BOOST_AUTO_TEST_CASE(an_unknown_word_is_refused_with_what_is_near) {
  Tried tried;
  BOOST_TEST(tried.refuses({"--alpah1", "1"}, "got \"--alpah1\". Did you mean --alpha1?"));
  BOOST_TEST(tried.refuses({"--memebrs=3"}, "Did you mean --members?"));
  BOOST_TEST(tried.refuses({"word"}, "every word must be an option of this program, got \"word\""));
  BOOST_TEST(tried.refuses({"-x"}, "got \"-x\""));
  BOOST_TEST(tried.refuses({"--case", "x"}, "got \"--case\""));
  BOOST_TEST(tried.refuses({"--", "x"}, "got \""));
}

BOOST_AUTO_TEST_CASE(an_option_must_have_one_value) {
  Tried tried;
  BOOST_TEST(tried.refuses({"--alpha1", "1", "--alpha1", "2"}, "--alpha1 must be given once, got \"1\" and \"2\""));
  BOOST_TEST(tried.refuses({"--alpha1"}, "--alpha1"));
  BOOST_TEST(tried.refuses({"--out", "--quick"}, "--out must have a value, got \"--quick\""));
  BOOST_TEST(tried.refuses({"--out="}, "--out"));
  BOOST_TEST(tried.refuses({"--quick", "--full"}, "quick or full"));
  BOOST_TEST(tried.refuses({"--quick=maybe"}, "--quick"));
}

BOOST_AUTO_TEST_CASE(help_tells_meaning_unit_default_and_range_and_ends_with_success) {
  Tried tried;
  BOOST_TEST((tried.parse({"--help"}) == 0));
  BOOST_TEST(
      contains(tried.printed, "--alpha1 NUMBER         attraction [N]; default 0.5; must be at least 0 (M 1.30)\n"));
  BOOST_TEST(contains(tried.printed, "time stepping [-]; default verlet; must be one of verlet, rk4\n"));
  for (const char* option :
       {"--quick", "--full", "--out", "--seed", "--threads", "--config", "--help", "--friction true|false"}) {
    BOOST_TEST(contains(tried.printed, option));
  }
  BOOST_TEST(!contains(tried.printed, "--case"));
  const std::string in_full = tried.printed;
  BOOST_TEST((tried.parse({"-h", "--alpha1", "-1"}) == 0));
  BOOST_TEST(tried.printed == in_full);
}

BOOST_AUTO_TEST_CASE(help_fits_a_terminal) {
  CommandLine command({.name = "ch01", .summary = "shows a pair."});
  command.field(0.5, {.name = "x", .meaning = std::string(60, 'a') + " b", .range = between(0.0, 1.0)});
  BOOST_TEST(contains(command.help(), "  --x NUMBER              " + std::string(60, 'a') + " b [-];\n" +
                                          std::string(26, ' ') + "default 0.5; must lie in [0, 1]\n"));
}

BOOST_AUTO_TEST_CASE(version_tells_program_revision_and_compiler_and_ends_with_success) {
  Tried tried;
  BOOST_TEST((tried.parse({"--version"}) == 0));
  BOOST_TEST(tried.printed.starts_with("ch01 of particulate, revision "));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(command_line_config)

BOOST_AUTO_TEST_CASE(the_command_line_beats_the_file_and_the_file_the_default) {
  const ScratchFolder folder;
  const std::string file = (folder.path() / "p.toml").native();
  write_whole(file, "alpha1 = 2\nshift = 3.5\nquick = true\nseed = 4\nscheme = \"rk4\"\nfriction = true\n");
  Tried tried;
  BOOST_TEST(!tried.parse({"--shift", "7", "--config", file, "--full"}));
  BOOST_TEST(tried.alpha1 == 2.0);
  BOOST_TEST(tried.shift == 7.0);
  BOOST_TEST(tried.members == 5);
  BOOST_TEST(tried.scheme == "rk4");
  BOOST_TEST(tried.friction);
  BOOST_TEST(!tried.command.common().quick);
  BOOST_TEST(tried.command.common().seed == 4U);
}

BOOST_AUTO_TEST_CASE(names_file_line_and_what_to_do) {
  Tried tried;
  BOOST_TEST(
      tried.refuses_file("shift = 1.0\n\nalpha1 = -1.0\n",
                         "p.toml:3: alpha1 must be at least 0, got -1.0. Mend this line, or remove it for 0.5."));
  BOOST_TEST(tried.refuses_file("alpah1 = 1.0\n",
                                "p.toml:1: every key must be a parameter of this program, got "
                                "\"alpah1\". Did you mean alpha1?"));
}

BOOST_AUTO_TEST_CASE(refuses_a_value_of_another_type_or_size) {
  Tried tried;
  BOOST_TEST(tried.refuses_file("alpha1 = \"0.5\"\n", "alpha1 must be a number, got \"0.5\""));
  BOOST_TEST(tried.refuses_file("alpha1 = true\n", "alpha1 must be a number, got true"));
  BOOST_TEST(tried.refuses_file("alpha1 = nan\n", "alpha1 must be at least 0, got nan"));
  BOOST_TEST(tried.refuses_file("alpha1 = 1e-400\n", "alpha1 must be a number that fits its type, got 1e-400"));
  BOOST_TEST(tried.refuses_file("alpha1 = 1e400\n", "p.toml:1: not readable as TOML"));
  BOOST_TEST(tried.refuses_file("alpha1 = 0.5x\n", "p.toml:1: not readable as TOML"));
  BOOST_TEST(tried.refuses_file("alpha1 = [1.0]\n", "alpha1 must be a number, got [1.0]"));
  BOOST_TEST(tried.refuses_file("[alpha1]\nx = 1\n", "alpha1 must be a number, got a table"));
  BOOST_TEST(tried.refuses_file("members = 2.0\n", "members must be a whole number, got 2.0"));
  BOOST_TEST(tried.refuses_file("members = 4294967297\n", "members must lie in [1, 100]"));
  BOOST_TEST(tried.refuses_file("friction = 1\n", "friction must be true or false, got 1"));
  BOOST_TEST(tried.refuses_file("scheme = 1\n", "scheme must be a text in quotes, got 1"));
  BOOST_TEST(tried.refuses_file("out = \"x\"\n", "got \"out\""));
  BOOST_TEST(tried.refuses({"--config", "no/such.toml"}, "no/such.toml cannot be read: No such file"));
}

BOOST_AUTO_TEST_CASE(what_a_run_wrote_gives_the_same_bits_again) {
  const ScratchFolder folder;
  for (const double awkward :
       {0.1 + 0.2, 5e-324, 1.7976931348623157e308, -0.0, 2.2250738585072011e-308, 1.0, 1e22, -1.0 / 3.0}) {
    Tried first;
    BOOST_TEST(!first.parse({"--out", folder.path().native(), "--quick", "--seed", "9223372036854775807", "--members=7",
                             "--scheme=rk4", "--friction=true"}));
    first.shift = awkward;
    write_whole(folder.path() / "parameters.toml", first.command.parameters_toml());
    Tried again;
    BOOST_TEST(!again.parse({"--config", (folder.path() / "parameters.toml").native()}));
    BOOST_TEST(std::bit_cast<std::uint64_t>(again.shift) == std::bit_cast<std::uint64_t>(awkward));
    BOOST_TEST(again.v_star == inf);
    BOOST_TEST(again.members == 7);
    BOOST_TEST(again.friction);
    BOOST_TEST(again.scheme == "rk4");
    BOOST_TEST(again.command.common().quick);
    BOOST_TEST(again.command.common().seed == 9223372036854775807U);
    BOOST_TEST(again.command.parameters_toml() == first.command.parameters_toml());
  }
}

BOOST_AUTO_TEST_CASE(knows_whether_all_is_as_where_nothing_is_given) {
  Tried same, other, seeded;
  BOOST_TEST(!same.parse({"--quick", "--threads=2", "--alpha1=0.5"}));
  BOOST_TEST(same.command.has_defaults());
  BOOST_TEST(!other.parse({"--alpha1=0.25"}));
  BOOST_TEST(!other.command.has_defaults());
  BOOST_TEST(!seeded.parse({"--seed=2"}));
  BOOST_TEST(!seeded.command.has_defaults());
}

BOOST_AUTO_TEST_CASE(the_file_tells_meaning_and_unit) {
  Tried tried;
  BOOST_TEST(!tried.parse({}));
  BOOST_TEST(contains(tried.command.parameters_toml(), "\n# attraction [N]\nalpha1 = 0.5\n"));
}

BOOST_AUTO_TEST_CASE(any_printable_text_comes_back) {
  const std::string awkward = R"(a "quoted" \n back\slash # and = sign)";
  const ScratchFolder folder;
  const std::string file = (folder.path() / "p.toml").native();

  CommandLine first({.name = "p", .summary = "s"});
  first.field(awkward, {.name = "text", .meaning = "any text"});
  write_whole(file, first.parameters_toml());

  CommandLine second({.name = "p", .summary = "s"});
  const std::string& again = second.field("plain", {.name = "text", .meaning = "any text"});
  const char* const argv[] = {"p", "--config", file.c_str()};
  BOOST_TEST(!second.parse(3, argv));
  BOOST_TEST(again == awkward);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(command_line_field)

BOOST_AUTO_TEST_CASE(a_default_must_lie_in_its_own_range) {
  CommandLine command({.name = "p", .summary = "s"});
  CHECK_REFUSED(command.field(-1.0, {.name = "a", .meaning = "m", .range = at_least(0)}),
                "field a: its default must be at least 0, got -1");
  CHECK_REFUSED(command.field(not_a_number, {.name = "a", .meaning = "m"}), "must be a finite number, got nan");
  CHECK_REFUSED(command.field("euler", {.name = "a", .meaning = "m", .range = one_of({"rk4"})}),
                "must be one of rk4, got euler");
}

BOOST_AUTO_TEST_CASE(a_name_must_be_free_and_well_formed_and_have_a_meaning) {
  CommandLine command({.name = "p", .summary = "s"});
  command.field(1.0, {.name = "x", .meaning = "m"});
  CHECK_REFUSED(command.field(1.0, {.name = "x", .meaning = "m"}), "got \"x\" twice");
  for (const char* taken : {"seed", "quick", "full", "out", "config", "help", "threads"}) {
    CHECK_REFUSED(command.field(1.0, {.name = taken, .meaning = "m"}), "twice");
  }
  for (const char* wrong : {"", "1x", "a-b", "Alpha", "a b"}) {
    CHECK_REFUSED(command.field(1.0, {.name = wrong, .meaning = "m"}), "a name must be a lower-case letter");
  }
  CHECK_REFUSED(command.field(1.0, {.name = "y", .meaning = ""}), "meaning must be told");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::command_line_test
