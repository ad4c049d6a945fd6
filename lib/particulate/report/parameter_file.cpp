#include <particulate/report/parameter_file.hpp>

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <toml++/toml.h>

#include <particulate/report/files.hpp>

namespace particulate::report {
namespace {

Setting::Kind kind_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::floating_point:
      return Setting::Kind::number;
    case toml::node_type::integer:
      return Setting::Kind::whole;
    case toml::node_type::boolean:
      return Setting::Kind::truth;
    case toml::node_type::string:
      return Setting::Kind::text;
    default:
      return Setting::Kind::other;
  }
}

// TOML numbers may carry underscores between digits and a plus in front; nothing else does.
std::string without_ornaments(std::string digits) {
  std::erase(digits, '_');
  if (digits.starts_with('+')) digits.erase(0, 1);
  return digits;
}

// The digits as written: the parser rounds 1e-400 to zero without a word, and the caller shall see it.
std::string digits_of(const toml::source_region& where, const std::vector<std::string>& lines) {
  const std::string& line = lines.at(where.begin.line - 1);
  return without_ornaments(line.substr(where.begin.column - 1, where.end.column - where.begin.column));
}

std::vector<std::string> split_lines(const std::string& content) {
  std::vector<std::string> lines(1);
  for (const char c : content) {
    if (c == '\n') lines.emplace_back();
    else lines.back() += c;
  }
  return lines;
}

std::string value_of(const toml::node& node, const std::vector<std::string>& lines) {
  switch (kind_of(node)) {
    case Setting::Kind::number:
      return digits_of(node.source(), lines);
    case Setting::Kind::whole:
      return std::to_string(node.as_integer()->get());
    case Setting::Kind::truth:
      return node.as_boolean()->get() ? "true" : "false";
    case Setting::Kind::text:
      return node.as_string()->get();
    case Setting::Kind::other:
      break;
  }
  return digits_of(node.source(), lines);
}

}  // namespace

std::vector<Setting> read_parameter_file(const std::filesystem::path& file) {
  const std::string content = read_whole(file);
  const std::vector<std::string> lines = split_lines(content);
  std::vector<Setting> settings;
  try {
    const toml::table table = toml::parse(std::string_view(content), std::string_view(file.native()));
    for (const auto& [key, node] : table) {
      settings.push_back({.key = std::string(key.str()),
                          .kind = kind_of(node),
                          .value = node.is_table() ? "a table" : value_of(node, lines),
                          .line = node.source().begin.line});
    }
  } catch (const toml::parse_error& error) {
    throw std::runtime_error(fmt::format("{}:{}: not readable as TOML: {}. Write one `key = value` a line.",
                                         file.native(), error.source().begin.line, error.description()));
  }
  // TOML puts every key on a line of its own.
  std::sort(settings.begin(), settings.end(), [](const Setting& a, const Setting& b) { return a.line < b.line; });
  return settings;
}

std::string toml_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

std::string toml_number(double number) {
  std::string digits = fmt::format("{}", number);
  if (digits.find_first_of(".en") == std::string::npos) digits += ".0";
  return digits;
}

}  // namespace particulate::report
