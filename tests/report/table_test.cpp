#include <particulate/report/table.hpp>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "says.hpp"

namespace tests::table_test {

using namespace particulate::report;

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan_ = std::numeric_limits<double>::quiet_NaN();

Table example() {
  Table table({"time [s]", "steps", "name"});
  table.add({0.1 + 0.2, 12, "a"});
  table.add({-0.0, 3L, "longer"});
  return table;
}

BOOST_AUTO_TEST_SUITE(table_add)

BOOST_AUTO_TEST_CASE(refuses_a_row_of_another_length) {
  Table table({"a", "b"});
  CHECK_REFUSED(table.add({1.0}), "a row must have 2 entries, one a column, got 1");
}

BOOST_AUTO_TEST_CASE(refuses_a_text_among_numbers_and_a_number_among_texts) {
  Table table({"a", "b"});
  table.add({{}, "x"});
  table.add({1.0, {}});
  CHECK_REFUSED(table.add({"x", "x"}), "\"a\" must hold numbers only, got \"x\"");
  CHECK_REFUSED(table.add({1, 2}), "\"b\" must hold texts only, got \"2\"");
  BOOST_TEST(table.rows().size() == 2U);
}

BOOST_AUTO_TEST_CASE(a_header_must_be_there_and_be_there_once) {
  CHECK_REFUSED(Table({}), "at least one column");
  CHECK_REFUSED(Table({"a", ""}), "got an empty one");
  CHECK_REFUSED(Table({"a", "b", "a"}), "got \"a\" twice");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(table_csv)

BOOST_AUTO_TEST_CASE(keeps_units_in_the_header_and_prints_the_shortest_exact_digits) {
  BOOST_TEST(example().csv() == "time [s],steps,name\n0.30000000000000004,12,a\n-0,3,longer\n");
}

BOOST_AUTO_TEST_CASE(every_double_comes_back_with_the_same_bits) {
  for (const double number :
       {0.1 + 0.2, 5e-324, 1.7976931348623157e308, -0.0, 1.0 / 3.0, 2.2250738585072011e-308, 1e22}) {
    const double back = std::strtod(Cell(number).exact().c_str(), nullptr);
    BOOST_TEST(back == number);
    BOOST_TEST(std::signbit(back) == std::signbit(number));
  }
}

BOOST_AUTO_TEST_CASE(quotes_what_would_break_a_line_or_a_field) {
  Table table({"a,b", "c"});
  table.add({"say \"hi\"", "two\nlines"});
  table.add({"", {}});
  BOOST_TEST(table.csv() == "\"a,b\",c\n\"say \"\"hi\"\"\",\"two\nlines\"\n,\n");
}

BOOST_AUTO_TEST_CASE(names_what_is_no_number) {
  Table table({"a"});
  for (const double number : {nan_, inf, -inf}) table.add({number});
  BOOST_TEST(table.csv() == "a\nnan\ninf\n-inf\n");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(table_json)

BOOST_AUTO_TEST_CASE(has_one_object_a_row_with_keys_in_the_order_of_the_columns) {
  BOOST_TEST(example().json() ==
             "[\n {\"time [s]\":0.30000000000000004,\"steps\":12,\"name\":\"a\"},"
             "\n {\"time [s]\":-0.0,\"steps\":3,\"name\":\"longer\"}\n]\n");
}

BOOST_AUTO_TEST_CASE(writes_texts_for_numbers_that_json_does_not_know_and_null_for_nothing) {
  Table table({"a"});
  for (const double number : {nan_, -inf}) table.add({number});
  table.add({{}});
  BOOST_TEST(table.json() == "[\n {\"a\":\"nan\"},\n {\"a\":\"-inf\"},\n {\"a\":null}\n]\n");
}

BOOST_AUTO_TEST_CASE(a_text_that_is_no_utf_8_does_not_stop_it) {
  Table table({"a"});
  table.add({"\xff"});
  BOOST_TEST(table.json() == "[\n {\"a\":\"\xef\xbf\xbd\"}\n]\n");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(table_text)

BOOST_AUTO_TEST_CASE(puts_numbers_to_the_right_and_texts_to_the_left) {
  BOOST_TEST(example().text() ==
             "time [s]  steps  name\n"
             "--------  -----  ------\n"
             "     0.3     12  a\n"
             "      -0      3  longer\n");
}

BOOST_AUTO_TEST_CASE(counts_characters_not_bytes) {
  Table table({"\xce\xb1", "b"});
  table.add({"\xce\xb1\xce\xb2", "x"});
  BOOST_TEST(table.text() == "\xce\xb1   b\n--  -\n\xce\xb1\xce\xb2  x\n");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(parse_csv_)

BOOST_AUTO_TEST_CASE(reads_back_what_a_table_wrote) {
  Table table({"a,b", "c"});
  table.add({"say \"hi\"", "two\r\nlines"});
  table.add({"", "\"\""});
  const auto lines = parse_csv(table.csv(), "rows.csv");
  BOOST_TEST(lines.size() == 3U);
  BOOST_TEST(lines[0][0] == "a,b");
  BOOST_TEST(lines[1][0] == "say \"hi\"");
  BOOST_TEST(lines[1][1] == "two\r\nlines");
  BOOST_TEST(lines[2][1] == "\"\"");
}

BOOST_AUTO_TEST_CASE(takes_either_line_end_and_a_last_line_without_one) {
  const auto lines = parse_csv("a,b\r\n1,2\n3,", "f");
  BOOST_TEST(lines.size() == 3U);
  BOOST_TEST(lines[1][1] == "2");
  BOOST_TEST(lines[2][1] == "");
}

BOOST_AUTO_TEST_CASE(names_file_and_line_of_what_it_cannot_read) {
  BOOST_CHECK_EXCEPTION(parse_csv("a,b\n1\n", "f.csv"), std::runtime_error,
                        says("f.csv:2: not readable as CSV: the header has 2 fields, this line 1"));
  BOOST_CHECK_EXCEPTION(parse_csv("a,b\n1,\"2\n", "f.csv"), std::runtime_error,
                        says("f.csv:2: not readable as CSV: a quote"));
  BOOST_CHECK_EXCEPTION(parse_csv("a\n\"1\"2\n", "f.csv"), std::runtime_error, says("f.csv:2"));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::table_test
