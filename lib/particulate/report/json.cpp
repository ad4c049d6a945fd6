#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <particulate/report/stamp.hpp>
#include <particulate/report/table.hpp>

namespace particulate::report {
namespace {

using nlohmann::ordered_json;

ordered_json json_of(const Cell& cell) {
  if (cell.is_missing()) return nullptr;
  if (cell.is_text()) return std::get<std::string>(cell.value());
  if (const long long* whole = std::get_if<long long>(&cell.value())) return *whole;
  const double number = std::get<double>(cell.value());
  if (!std::isfinite(number)) return fmt::format("{}", number);
  return number;
}

// A text from outside that is no UTF-8 must not stop a report.
std::string dumped(const ordered_json& value, int indent) {
  return value.dump(indent, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace

std::string Table::json() const {
  std::string out = "[";
  for (const std::vector<Cell>& row : rows_) {
    ordered_json object;
    for (std::size_t i = 0; i < row.size(); ++i) object[columns_[i]] = json_of(row[i]);
    out += (out.size() > 1 ? ",\n " : "\n ") + dumped(object, -1);
  }
  return out + "\n]\n";
}

std::string json(const Stamp& stamp) {
  const ordered_json object{{"revision", stamp.revision},   {"compiler", stamp.compiler},
                            {"flags", stamp.flags},         {"build_type", stamp.build_type},
                            {"processor", stamp.processor}, {"kernel", stamp.kernel},
                            {"options", stamp.options},     {"seed", stamp.seed},
                            {"date", stamp.date},           {"files", stamp.files}};
  return dumped(object, 2) + "\n";
}

std::vector<std::string> files_of_stamp(const std::string& json) {
  std::vector<std::string> files;
  const ordered_json stamp = ordered_json::parse(json, nullptr, false);
  if (!stamp.is_object() || !stamp.contains("files")) return files;
  for (const ordered_json& file : stamp["files"]) {
    if (file.is_string()) files.push_back(file.get<std::string>());
  }
  return files;
}

}  // namespace particulate::report
