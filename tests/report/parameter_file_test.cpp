#include <particulate/report/parameter_file.hpp>

#include <stdexcept>

#include <particulate/report/files.hpp>

#include "says.hpp"
#include "scratch_folder.hpp"

namespace tests::parameter_file_test {

using namespace particulate::report;

std::vector<Setting> read(const std::string& content) {
  const ScratchFolder folder;
  write_whole(folder.path() / "p.toml", content);
  return read_parameter_file(folder.path() / "p.toml");
}

BOOST_AUTO_TEST_SUITE(read_parameter_file_)

BOOST_AUTO_TEST_CASE(gives_keys_in_the_order_of_the_file_with_their_lines) {
  const std::vector<Setting> settings = read("# first\nz = 1.5\n\na = true  # why\nm = \"x#y\"\nk = -3\n");
  BOOST_TEST(settings.size() == 4U);
  BOOST_TEST((settings[0].key == "z" && settings[0].kind == Setting::Kind::number && settings[0].value == "1.5"));
  BOOST_TEST((settings[1].key == "a" && settings[1].kind == Setting::Kind::truth && settings[1].line == 4));
  BOOST_TEST((settings[2].key == "m" && settings[2].kind == Setting::Kind::text && settings[2].value == "x#y"));
  BOOST_TEST((settings[3].key == "k" && settings[3].kind == Setting::Kind::whole && settings[3].value == "-3"));
}

BOOST_AUTO_TEST_CASE(keeps_the_digits_of_a_number) {
  const std::vector<Setting> settings =
      read("a = 1e-400\nb=0.1000000000000000055\r\nc = +1_000.5\n  d   =   -0.0   \n");
  BOOST_TEST(settings[0].value == "1e-400");
  BOOST_TEST(settings[1].value == "0.1000000000000000055");
  BOOST_TEST(settings[2].value == "1000.5");
  BOOST_TEST(settings[3].value == "-0.0");
}

BOOST_AUTO_TEST_CASE(names_file_and_line_of_what_is_no_toml) {
  BOOST_CHECK_EXCEPTION(read("a = 1\nb = 0.5x\n"), std::runtime_error, says("p.toml:2: not readable as TOML"));
  BOOST_CHECK_EXCEPTION(read("a = 1\n\na = 2\n"), std::runtime_error, says("p.toml:3: not readable as TOML"));
  BOOST_CHECK_EXCEPTION(read("a = 1e400\n"), std::runtime_error, says("p.toml:1: not readable as TOML"));
}

BOOST_AUTO_TEST_CASE(marks_what_is_no_single_value) {
  for (const char* content : {"[a]\nb = 1\n", "a = [1, 2]\n", "a = 2007-01-01\n", "a.b = 1\n", "[[a]]\nb = 1\n"}) {
    BOOST_TEST((read(content).at(0).kind == Setting::Kind::other));
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(toml_number_)

BOOST_AUTO_TEST_CASE(is_a_float_to_toml_and_exact) {
  BOOST_TEST(toml_number(1.0) == "1.0");
  BOOST_TEST(toml_number(-0.0) == "-0.0");
  BOOST_TEST(toml_number(0.1 + 0.2) == "0.30000000000000004");
  BOOST_TEST(toml_number(5e-324) == "5e-324");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::parameter_file_test
