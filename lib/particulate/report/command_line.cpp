#include <particulate/report/command_line.hpp>

#include <algorithm>
#include <charconv>
#include <climits>
#include <cmath>
#include <exception>
#include <iostream>
#include <limits>
#include <map>
#include <stdexcept>
#include <type_traits>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <particulate/report/spelling.hpp>
#include <particulate/report/stamp.hpp>
#include <particulate/report/wrapped.hpp>

namespace particulate::report {
namespace {

// A value as it was given, and how to speak of it: where it stands and what its author can do.
struct Given {
  std::string text;
  std::optional<Setting::Kind> kind;  // none on the command line, where everything is text
  std::string where, remedy;
};

[[noreturn]] void refuse(const Given& given, const std::string& must) {
  const bool quoted = given.kind == Setting::Kind::text || !given.kind;
  const std::string mark = quoted ? "\"" : "";
  throw std::invalid_argument(
      fmt::format("{} must {}, got {}{}{}. {}", given.where, must, mark, given.text, mark, given.remedy));
}

void expect(const Given& given, std::initializer_list<Setting::Kind> kinds, const std::string& must) {
  if (given.kind && std::find(kinds.begin(), kinds.end(), *given.kind) == kinds.end()) refuse(given, must);
}

// The whole text as one number; what is no number, trails one, or does not fit the type is refused.
template <class Number>
Number number_in(const Given& given, const std::string& noun) {
  const std::string digits = given.text.starts_with('+') ? given.text.substr(1) : given.text;
  Number number{};
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error == std::errc::result_out_of_range) refuse(given, fmt::format("be {} that fits its type", noun));
  if (error != std::errc{} || end != digits.data() + digits.size()) refuse(given, fmt::format("be {}", noun));
  return number;
}

void assign(double& target, const Given& given, const Range& range) {
  expect(given, {Setting::Kind::number, Setting::Kind::whole}, "be a number");
  const double value = number_in<double>(given, "a number");
  if (!range.holds(value)) refuse(given, range.text());
  target = value;
}

template <std::integral Whole>
void assign(Whole& target, const Given& given, const Range& range) {
  expect(given, {Setting::Kind::whole}, "be a whole number");
  const long long value = number_in<long long>(given, "a whole number");
  if (!range.holds(static_cast<double>(value))) refuse(given, range.text());
  if (!std::in_range<Whole>(value)) {
    refuse(given, fmt::format("lie in [{}, {}]", std::numeric_limits<Whole>::min(), std::numeric_limits<Whole>::max()));
  }
  target = static_cast<Whole>(value);
}

void assign(bool& target, const Given& given, const Range&) {
  expect(given, {Setting::Kind::truth}, "be true or false");
  if (given.text != "true" && given.text != "false") refuse(given, "be true or false");
  target = given.text == "true";
}

bool is_printable(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

void assign(std::string& target, const Given& given, const Range& range) {
  expect(given, {Setting::Kind::text}, "be a text in quotes");
  if (!is_printable(given.text)) refuse(given, "be printable ASCII");
  if (!range.holds(given.text)) refuse(given, range.text());
  target = given.text;
}

bool holds(const Range& range, const std::string& value) { return is_printable(value) && range.holds(value); }
bool holds(const Range& range, double value) { return range.holds(value); }
template <std::integral T>
bool holds(const Range& range, T value) {
  return range.holds(static_cast<double>(value));
}

std::string toml(double value) { return toml_number(value); }
std::string toml(bool value) { return value ? "true" : "false"; }
std::string toml(const std::string& value) { return toml_text(value); }
template <std::integral T>
std::string toml(T value) {
  return std::to_string(value);
}

std::string plain(const std::string& value) { return value; }
std::string plain(bool value) { return toml(value); }
template <class Number>
requires std::is_arithmetic_v<Number> std::string plain(Number value) { return fmt::format("{}", value); }

constexpr std::string_view lower_case = "abcdefghijklmnopqrstuvwxyz";
constexpr std::string_view name_characters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";

bool is_name(const std::string& name) {
  return !name.empty() && lower_case.find(name.front()) != std::string_view::npos &&
         name.find_first_not_of(name_characters) == std::string::npos;
}

// One word as a shell takes it.
std::string shell_word(const std::string& word) {
  const bool harmless =
      !word.empty() && word.find_first_not_of(fmt::format("{}-./=,:+", name_characters)) == std::string::npos;
  if (harmless) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string did_you_mean(const std::string& given, const std::vector<std::string>& known) {
  const std::vector<std::string> near = near_matches(given, known);
  return near.empty() ? "" : fmt::format(" Did you mean {}?", either(near));
}

}  // namespace

CommandLine::CommandLine(Program program) : program_(std::move(program)) {
  common_.out = program_.out.empty() ? std::filesystem::path("out") / program_.name : program_.out;
  enter({.name = "quick", .meaning = "smaller sizes and fewer repeats; no claim is dropped"}, &common_.quick, true);
  enter({.name = "seed", .meaning = "start of the random numbers", .range = at_least(0)}, &common_.seed, true);
  enter({.name = "threads", .meaning = "threads; results do not depend on them", .range = between(1, 4096)},
        &common_.threads, true);
}

template <class T>
T& CommandLine::keep(T value, const Field& field) {
  T& kept = std::get<T>(values_.emplace_back(std::move(value)));
  enter(field, &kept, false);
  return kept;
}

double& CommandLine::field(double value, const Field& field) { return keep(value, field); }
int& CommandLine::field(int value, const Field& field) { return keep(value, field); }
bool& CommandLine::field(bool value, const Field& field) { return keep(value, field); }
std::string& CommandLine::field(std::string value, const Field& field) { return keep(std::move(value), field); }

void CommandLine::enter(Field field, Target target, bool everywhere) {
  if (!is_name(field.name)) {
    throw std::invalid_argument(fmt::format(
        "field: a name must be a lower-case letter, then letters, digits or underscores, got \"{}\"", field.name));
  }
  const std::vector<std::string> taken = option_names();
  if (std::find(taken.begin(), taken.end(), "--" + field.name) != taken.end()) {
    throw std::invalid_argument(fmt::format("field: names must differ, got \"{}\" twice", field.name));
  }
  if (field.meaning.empty()) {
    throw std::invalid_argument(fmt::format("field {}: the meaning must be told, got none", field.name));
  }
  std::visit(
      [&](const auto* value) {
        if (!holds(field.range, *value)) {
          throw std::invalid_argument(
              fmt::format("field {}: its default must {}, got {}", field.name, field.range.text(), plain(*value)));
        }
      },
      target);
  std::string default_text = std::visit([](const auto* value) { return plain(*value); }, target);
  entries_.push_back({std::move(field), target, std::move(default_text), everywhere});
}

std::vector<std::string> CommandLine::option_names() const {
  std::vector<std::string> names{"--help", "--version", "--full", "--out", "--config"};
  if (program_.has_cases) names.insert(names.end(), {"--case", "--list", "--verbose"});
  for (const Entry& entry : entries_) names.push_back("--" + entry.field.name);
  return names;
}

const CommandLine::Entry* CommandLine::entry_named(const std::string& name) const {
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.field.name == name; });
  return found == entries_.end() ? nullptr : &*found;
}

std::optional<int> CommandLine::parse(int argc, const char* const* argv) {
  return parse(argc, argv, std::cout, std::cerr);
}

std::optional<int> CommandLine::parse(int argc, const char* const* argv, std::ostream& out, std::ostream& error) {
  line_ = program_.name;
  for (int i = 1; i < argc; ++i) line_ += ' ' + shell_word(argv[i]);
  try {
    return read_tokens(argc, argv, out);
  } catch (const std::exception& refusal) {
    error << program_.name << ": " << refusal.what() << '\n';
    return 2;
  }
}

namespace {

// What the command line says, before any of it is believed: every value of every option, in order.
struct Tokens {
  std::map<std::string, std::vector<std::string>> values;
  std::map<std::string, bool> flags;
  std::vector<std::string> unknown;
};

Tokens split(int argc, const char* const* argv, const std::vector<std::string>& with_value,
             const std::vector<std::string>& without_value) {
  Tokens tokens;
  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  for (const std::string& name : with_value) {
    // Any number of times, one value each: what stands twice is refused below, in our own words.
    app.add_option(name, tokens.values[name])->expected(1, INT_MAX)->allow_extra_args(false);
  }
  for (const std::string& name : without_value) {
    app.add_flag(name == "--help" ? "-h,--help" : name, tokens.flags[name]);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& wrong) {
    throw std::invalid_argument(fmt::format("the options must be complete: {}. See --help.", wrong.what()));
  }
  tokens.unknown = app.remaining();
  return tokens;
}

// The one value of an option that may stand once, if it is there.
const std::string* only_value(const Tokens& tokens, const std::string& option) {
  const std::vector<std::string>& given = tokens.values.at(option);
  if (given.size() > 1) {
    throw std::invalid_argument(
        fmt::format("{} must be given once, got \"{}\" and \"{}\". Leave one out.", option, given[0], given[1]));
  }
  if (given.empty()) return nullptr;
  if (given[0].empty() || given[0].starts_with("--")) {
    throw std::invalid_argument(
        fmt::format("{} must have a value, got \"{}\". Write {}=VALUE.", option, given[0], option));
  }
  return given.data();
}

}  // namespace

std::optional<int> CommandLine::read_tokens(int argc, const char* const* argv, std::ostream& out) {
  std::vector<std::string> with_value{"--out", "--config"}, without_value{"--help", "--version", "--quick", "--full"};
  if (program_.has_cases) {
    with_value.push_back("--case");
    without_value.insert(without_value.end(), {"--list", "--verbose"});
  }
  for (const Entry& entry : entries_) {
    if (entry.field.name != "quick") with_value.push_back("--" + entry.field.name);
  }
  Tokens tokens = split(argc, argv, with_value, without_value);
  if (tokens.flags["--help"]) return out << help(), 0;
  if (tokens.flags["--version"]) {
    const Stamp made = make_stamp({}, 0, {});
    out << fmt::format("{} of particulate, revision {}, {} ({})\n", program_.name, made.revision, made.compiler,
                       made.build_type);
    return 0;
  }
  if (!tokens.unknown.empty()) {
    const std::string& word = tokens.unknown.front();
    throw std::invalid_argument(fmt::format("every word must be an option of this program, got \"{}\".{} See --help.",
                                            word, did_you_mean(word.substr(0, word.find('=')), option_names())));
  }
  if (tokens.flags["--quick"] && tokens.flags["--full"]) {
    throw std::invalid_argument("a run must be quick or full, got --quick and --full. Leave one out.");
  }
  if (const std::string* file = only_value(tokens, "--config")) read_file(*file);
  if (tokens.flags["--quick"] || tokens.flags["--full"]) common_.quick = tokens.flags["--quick"];
  if (const std::string* folder = only_value(tokens, "--out")) common_.out = *folder;
  for (const Entry& entry : entries_) {
    const std::string option = "--" + entry.field.name;
    const std::string* value = tokens.values.contains(option) ? only_value(tokens, option) : nullptr;
    if (value == nullptr) continue;
    const Given given{.text = *value,
                      .kind = {},
                      .where = option,
                      .remedy = fmt::format("Give another value, or leave it out for {}.", entry.default_text)};
    std::visit([&](auto* target) { assign(*target, given, entry.field.range); }, entry.target);
  }
  if (program_.has_cases) {
    common_.cases = tokens.values["--case"];
    common_.list = tokens.flags["--list"], common_.verbose = tokens.flags["--verbose"];
  }
  return {};
}

void CommandLine::read_file(const std::filesystem::path& file) {
  std::vector<std::string> keys;
  for (const Entry& entry : entries_) keys.push_back(entry.field.name);
  for (const Setting& setting : read_parameter_file(file)) {
    const Entry* entry = entry_named(setting.key);
    if (entry == nullptr) {
      throw std::invalid_argument(
          fmt::format("{}:{}: every key must be a parameter of this program, got \"{}\".{} "
                      "See --help.",
                      file.native(), setting.line, setting.key, did_you_mean(setting.key, keys)));
    }
    const Given given{.text = setting.value,
                      .kind = setting.kind,
                      .where = fmt::format("{}:{}: {}", file.native(), setting.line, setting.key),
                      .remedy = fmt::format("Mend this line, or remove it for {}.", entry->default_text)};
    std::visit([&](auto* target) { assign(*target, given, entry->field.range); }, entry->target);
  }
}

namespace {

std::string option_help(const std::string& option, const std::string& text) {
  constexpr std::size_t column = 26;
  std::string line = "  " + option;
  const bool beside = line.size() + 2 <= column;
  line += beside ? std::string(column - line.size(), ' ') : "\n" + std::string(column, ' ');
  const std::string indented = std::string(column, ' ') + text;
  return line + wrapped(indented, column).substr(column) + '\n';
}

std::string placeholder(double) { return "NUMBER"; }
std::string placeholder(bool) { return "true|false"; }
std::string placeholder(const std::string&) { return "TEXT"; }
template <std::integral T>
std::string placeholder(T) {
  return "N";
}

}  // namespace

bool CommandLine::has_defaults() const {
  return std::all_of(entries_.begin(), entries_.end(), [](const Entry& entry) {
    const bool of_the_run = entry.everywhere && entry.field.name != "seed";
    return of_the_run ||
           std::visit([](const auto* value) { return plain(*value); }, entry.target) == entry.default_text;
  });
}

std::string CommandLine::help() const {
  std::string text = fmt::format("{}: {}\n\nOptions:\n", program_.name, program_.summary);
  text += option_help("-h, --help", "print this and end");
  text += option_help("--version", "print the revision and the compiler, and end");
  text += option_help("--quick", entry_named("quick")->field.meaning);
  text += option_help("--full", "the opposite, and the default");
  text +=
      option_help("--out FOLDER", fmt::format("where results go; default {}",
                                              program_.out.empty() ? "out/" + program_.name : program_.out.native()));
  text += option_help("--config FILE", "parameters from a TOML file; options given here beat it");
  if (program_.has_cases) {
    text += option_help("--case NAME", "run this case only; may be repeated");
    text += option_help("--list", "name the cases and end");
    text += option_help("--verbose", "print every row, not failures alone");
  }
  for (const bool everywhere : {true, false}) {
    if (!everywhere && entries_.size() > 3) text += "\nParameters, also as keys of a TOML file:\n";
    for (const Entry& entry : entries_) {
      const auto& [field, target, default_text, common] = entry;
      if (common != everywhere || field.name == "quick") continue;
      const bool has_range = !std::holds_alternative<bool*>(target) &&
                             !(std::holds_alternative<std::string*>(target) && field.range.choices.empty());
      text += option_help(
          fmt::format("--{} {}", field.name, std::visit([](const auto* value) { return placeholder(*value); }, target)),
          fmt::format("{} [{}]; default {}{}{}", field.meaning, field.unit, default_text,
                      has_range ? "; must " + field.range.text() : "",
                      field.source.empty() ? "" : fmt::format(" ({})", field.source)));
    }
  }
  return text;
}

std::string CommandLine::how_to_draw() const {
  if (program_.figures.empty()) return "";
  return fmt::format(" To draw their figures:\ndocs/draw.sh {} {} {}", shell_word(program_.figures),
                     shell_word((common_.out / "figures").native()), shell_word("data=" + common_.out.native()));
}

std::string CommandLine::parameters_toml() const {
  std::string text = fmt::format("# Parameters of a run. To repeat it: {} --config <this file>\n", program_.name);
  for (const Entry& entry : entries_) {
    const auto& [field, target, default_text, everywhere] = entry;
    if (field.name == "threads") continue;  // results do not depend on it
    const std::string unit = std::holds_alternative<bool*>(target) ? "" : fmt::format(" [{}]", field.unit);
    text += fmt::format("\n# {}{}\n{} = {}\n", field.meaning, unit, field.name,
                        std::visit([](const auto* value) { return toml(*value); }, target));
  }
  return text;
}

}  // namespace particulate::report
