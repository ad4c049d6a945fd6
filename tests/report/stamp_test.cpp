#include <particulate/report/stamp.hpp>

#include <algorithm>
#include <cctype>

#include "says.hpp"

namespace tests::stamp_test {

using namespace particulate::report;

BOOST_AUTO_TEST_SUITE(make_stamp_)

BOOST_AUTO_TEST_CASE(knows_build_machine_and_time) {
  const Stamp stamp = make_stamp("ch01 --quick", 7, "avx2");
  const std::string hash = stamp.revision.substr(0, stamp.revision.find("-dirty"));
  const bool is_hash =
      hash.size() == 40 && std::all_of(hash.begin(), hash.end(), [](unsigned char c) { return std::isxdigit(c); });
  BOOST_TEST((is_hash || stamp.revision == "unknown"));
  BOOST_TEST(!stamp.compiler.empty());
  BOOST_TEST(!stamp.build_type.empty());
  BOOST_TEST(!stamp.processor.empty());
  BOOST_TEST(stamp.date.size() == std::string("2007-01-01T00:00:00Z").size());
  BOOST_TEST(stamp.kernel == "avx2");
  BOOST_TEST(stamp.options == "ch01 --quick");
  BOOST_TEST(stamp.seed == 7U);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(json_)

BOOST_AUTO_TEST_CASE(writes_every_field) {
  const Stamp stamp{.revision = "abc-dirty",
                    .compiler = "GNU 12",
                    .flags = "-O3 -DX=\"y\"",
                    .build_type = "Release",
                    .processor = "P",
                    .kernel = "k",
                    .options = "o",
                    .seed = 18446744073709551615U,
                    .date = "d",
                    .files = {"a.csv"}};
  BOOST_TEST(json(stamp) ==
             "{\n  \"revision\": \"abc-dirty\",\n  \"compiler\": \"GNU 12\",\n  \"flags\": \"-O3 -DX=\\\"y\\\"\",\n"
             "  \"build_type\": \"Release\",\n  \"processor\": \"P\",\n  \"kernel\": \"k\",\n  \"options\": \"o\",\n"
             "  \"seed\": 18446744073709551615,\n  \"date\": \"d\",\n"
             "  \"files\": [\n    \"a.csv\"\n  ]\n}\n");
  BOOST_TEST(files_of_stamp(json(stamp)) == stamp.files, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(names_no_file_where_it_is_none) {
  for (const char* text : {"", "{", "[1]", "{}", "{\"files\": 1}", "{\"files\": [1, null]}"}) {
    BOOST_TEST(files_of_stamp(text).empty());
  }
}

BOOST_AUTO_TEST_CASE(fits_one_line) {
  const std::string line = one_line(make_stamp("o", 1, "baseline"));
  BOOST_TEST(line.find('\n') == std::string::npos);
  BOOST_TEST(contains(line, "kernel baseline, seed 1"));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::stamp_test
