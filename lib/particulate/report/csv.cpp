#include <particulate/report/table.hpp>

#include <stdexcept>

#include <fmt/format.h>

namespace particulate::report {
namespace {

// Takes a CSV text apart field by field; knows the line it is on, for messages.
class CsvReader {
 public:
  CsvReader(std::string_view content, const std::string& origin) : rest_(content), origin_(origin) {}

  bool at_end() const { return rest_.empty(); }
  std::size_t line() const { return line_; }

  std::vector<std::string> record() {
    std::vector<std::string> fields{field()};
    while (skip(",")) fields.push_back(field());
    if (!skip("\r\n") && !skip("\n") && !rest_.empty()) refuse("a quoted field must end at its closing quote");
    ++line_;
    return fields;
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw std::runtime_error(fmt::format("{}:{}: not readable as CSV: {}", origin_, line_, what));
  }

 private:
  bool skip(std::string_view what) {
    if (!rest_.starts_with(what)) return false;
    rest_.remove_prefix(what.size());
    return true;
  }

  std::string take(std::size_t length) {
    const std::string taken(rest_.substr(0, length));
    rest_.remove_prefix(taken.size());
    return taken;
  }

  std::string field() { return skip("\"") ? quoted() : take(rest_.find_first_of(",\r\n")); }

  std::string quoted() {
    std::string text;
    do {
      const std::size_t close = rest_.find('"');
      if (close == std::string_view::npos) refuse("a quote is opened and not closed");
      text += take(close);
      skip("\"");
      if (rest_.starts_with('"')) text += '"';
    } while (skip("\""));
    for (const char c : text) line_ += c == '\n' ? 1 : 0;
    return text;
  }

  std::string_view rest_;
  const std::string& origin_;
  std::size_t line_ = 1;
};

}  // namespace

std::vector<std::vector<std::string>> parse_csv(std::string_view content, const std::string& origin) {
  CsvReader reader(content, origin);
  std::vector<std::vector<std::string>> records;
  while (!reader.at_end()) {
    records.push_back(reader.record());
    if (records.back().size() != records.front().size()) {
      throw std::runtime_error(fmt::format("{}:{}: not readable as CSV: the header has {} fields, this line {}", origin,
                                           reader.line() - 1, records.front().size(), records.back().size()));
    }
  }
  return records;
}

}  // namespace particulate::report
