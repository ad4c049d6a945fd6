#pragma once

#include <concepts>
#include <initializer_list>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace particulate::report {

/// One entry of a table: a number, a whole number, a text, or nothing at all.
class Cell {
 public:
  /// Holds nothing: an empty field in CSV, null in JSON.
  Cell() = default;
  /// @param number  any double; NaN and the infinities are written as nan, inf and -inf
  Cell(double number) : value_(number) {}
  /// @param whole  a count, written without a decimal point
  template <std::integral T>
  requires(!std::same_as<T, bool>) Cell(T whole) : value_(static_cast<long long>(whole)) {}
  /// @param words  any text, quotes and line breaks included
  Cell(std::string words) : value_(std::move(words)) {}
  /// @param words  any text, quotes and line breaks included
  Cell(std::string_view words) : value_(std::string(words)) {}
  /// @param words  any text, quotes and line breaks included
  Cell(const char* words) : value_(std::string(words)) {}

  /// What the cell holds.
  using Value = std::variant<std::monostate, double, long long, std::string>;
  /// @return what the cell holds
  const Value& value() const { return value_; }
  /// @return whether it holds a text
  bool is_text() const { return std::holds_alternative<std::string>(value_); }
  /// @return whether it holds nothing
  bool is_missing() const { return std::holds_alternative<std::monostate>(value_); }

  /// Prints the cell so that reading it back gives the same bits.
  /// @return the shortest digits that round to the same double, a text as it stands, nothing for a missing entry
  std::string exact() const;
  /// Prints the cell for a reader.
  /// @return numbers to six significant digits, the rest as exact() does
  std::string readable() const;

 private:
  Value value_;
};

/// Rows under named columns, printed on a terminal or written as CSV or JSON.
///
/// A column holds numbers or texts, never both: the first entry that is not missing decides.
class Table {
 public:
  /// @param columns  headers such as "time [s]", at least one, none empty, no two alike
  /// @throws std::invalid_argument naming the header that is empty or there twice
  explicit Table(std::vector<std::string> columns);

  /// Adds one row.
  /// @param row  as many entries as there are columns
  /// @throws std::invalid_argument if their number is wrong, or a text stands in a column of numbers or the reverse
  void add(std::vector<Cell> row);

  /// @return the headers
  const std::vector<std::string>& columns() const { return columns_; }
  /// @return every row, in the order added
  const std::vector<std::vector<Cell>>& rows() const { return rows_; }

  /// @return the table with the quotes of RFC 4180, every line ended by LF; numbers by their shortest exact digits
  std::string csv() const;
  /// @return a JSON array with one object a row, keys in the order of the columns; numbers that JSON does not know
  ///         (nan, inf, -inf) stand as strings, missing entries as null
  std::string json() const;
  /// @return aligned columns under their headers for a terminal: numbers to the right, texts to the left
  std::string text() const;

 private:
  enum class Kind { undecided, numbers, texts };
  std::vector<std::string> columns_;
  std::vector<Kind> kinds_;
  std::vector<std::vector<Cell>> rows_;
};

/// Reads what Table::csv wrote, or any other file by RFC 4180. Lines end with LF or CRLF.
/// @param content  the file's bytes
/// @param origin   its name, for messages
/// @return the lines, the header first, each as many fields long as the header
/// @throws std::runtime_error naming origin and line, if a quote does not close, something follows a closing quote, or
///         a line has more or fewer fields than the header
std::vector<std::vector<std::string>> parse_csv(std::string_view content, const std::string& origin);

}  // namespace particulate::report
