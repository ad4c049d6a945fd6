#include <particulate/report/table.hpp>

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include <particulate/report/files.hpp>

namespace particulate::report {
namespace {

// RFC 4180: a field that holds a separator, a quote or a line break stands in quotes, its own quotes doubled.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

// Columns as a reader counts them: bytes that continue a UTF-8 character take no room.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string padded(const std::string& text, std::size_t room, bool to_the_right) {
  const std::string blanks(room - width(text), ' ');
  return to_the_right ? blanks + text : text + blanks;
}

}  // namespace

std::string Cell::exact() const {
  if (const double* number = std::get_if<double>(&value_)) return fmt::format("{}", *number);
  if (const long long* whole = std::get_if<long long>(&value_)) return fmt::format("{}", *whole);
  if (const std::string* text = std::get_if<std::string>(&value_)) return *text;
  return "";
}

std::string Cell::readable() const {
  if (const double* number = std::get_if<double>(&value_)) return fmt::format("{:.6g}", *number);
  return exact();
}

Table::Table(std::vector<std::string> columns) : columns_(std::move(columns)), kinds_(columns_.size()) {
  if (columns_.empty()) throw std::invalid_argument("table: there must be at least one column, got none");
  for (auto column = columns_.begin(); column != columns_.end(); ++column) {
    if (column->empty()) throw std::invalid_argument("table: every column must have a header, got an empty one");
    if (std::find(columns_.begin(), column, *column) != column) {
      throw std::invalid_argument(fmt::format("table: headers must differ, got \"{}\" twice", *column));
    }
  }
}

void Table::add(std::vector<Cell> row) {
  if (row.size() != columns_.size()) {
    throw std::invalid_argument(
        fmt::format("table: a row must have {} entries, one a column, got {}", columns_.size(), row.size()));
  }
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i].is_missing()) continue;
    const Kind kind = row[i].is_text() ? Kind::texts : Kind::numbers;
    if (kinds_[i] == Kind::undecided) kinds_[i] = kind;
    if (kinds_[i] != kind) {
      throw std::invalid_argument(fmt::format("table: column \"{}\" must hold {} only, got \"{}\"", columns_[i],
                                              kinds_[i] == Kind::texts ? "texts" : "numbers", row[i].exact()));
    }
  }
  rows_.push_back(std::move(row));
}

std::string Table::csv() const {
  std::string out;
  const auto line = [&](const auto& entries, const auto& text_of) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (i > 0) out += ',';
      out += csv_field(text_of(entries[i]));
    }
    out += '\n';
  };
  line(columns_, [](const std::string& header) { return header; });
  for (const std::vector<Cell>& row : rows_) line(row, [](const Cell& cell) { return cell.exact(); });
  return out;
}

std::string Table::text() const {
  std::vector<std::size_t> room;
  for (const std::string& header : columns_) room.push_back(width(header));
  for (const std::vector<Cell>& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) room[i] = std::max(room[i], width(row[i].readable()));
  }
  std::string out;
  const auto line = [&](const auto& text_of) {
    std::string printed;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (i > 0) printed += "  ";
      printed += padded(text_of(i), room[i], kinds_[i] == Kind::numbers);
    }
    out += printed.substr(0, printed.find_last_not_of(' ') + 1) + '\n';
  };
  line([&](std::size_t i) { return columns_[i]; });
  line([&](std::size_t i) { return std::string(room[i], '-'); });
  for (const std::vector<Cell>& row : rows_) line([&](std::size_t i) { return row[i].readable(); });
  return out;
}

}  // namespace particulate::report
