#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <particulate/report/parameter_file.hpp>
#include <particulate/report/range.hpp>

namespace particulate::report {

/// What every program can be asked for.
struct Common {
  bool quick = false;              ///< --quick: smaller sizes and fewer repeats, no claim dropped; --full: false
  std::filesystem::path out;       ///< --out: folder for the results
  std::uint64_t seed = 1;          ///< --seed: start of every sequence of random numbers, 0 ... 2^63 - 1
  int threads = 1;                 ///< --threads: 1 or more; results do not depend on it
  std::vector<std::string> cases;  ///< --case, once for each; empty: all
  bool list = false;               ///< --list: name the cases and end
  bool verbose = false;            ///< --verbose: print every row
};

/// What a program says of itself.
struct Program {
  std::string name;                ///< file name of the program, `ch01_fundamentals`
  std::string summary;             ///< one sentence for --help
  std::filesystem::path out = {};  ///< where results go unless --out says otherwise; empty: `out/<name>`
  std::string figures = {};        ///< script that docs/draw.sh draws them with, as seen from its tree; empty: none
  bool has_cases = false;          ///< offers --case, --list and --verbose (a verification program does)
};

/// What a reader must know of one parameter.
struct Field {
  std::string name;         ///< option (`--name`) and TOML key: a lower-case letter, then letters, digits, underscores
  std::string meaning;      ///< one line
  std::string unit = "-";   ///< SI unit as text; "-" for a pure number
  Range range = any();      ///< values allowed, the default among them
  std::string source = {};  ///< where the default comes from; may be empty
};

/// The command line and the parameter file of one program.
///
/// A value on the command line beats one in the file given with --config, which beats the default. Whatever a program
/// was run with, parameters_toml() says completely, and --config reads that back to the same bits.
class CommandLine {
 public:
  /// @param program  name, sentence, default folder, and whether it has cases
  explicit CommandLine(Program program);
  // Values are known by their addresses, which are in here.
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// Makes a number a parameter, in one place: its default, what a reader must know of it, and the variable.
  ///
  ///     double& step = line.field(1e-3, {"step", "of the cloud", "s", more_than(0.0), "our choice"});
  ///
  /// The reference is not const, so that a default of another type does not compile.
  /// @param value  its default, kept until parse() finds another value
  /// @param field  name, meaning, unit, range, source
  /// @return the variable, which lives as long as this object
  /// @throws std::invalid_argument if the name is taken or ill-formed, the meaning empty, or the default out of range
  double& field(double value, const Field& field);
  /// Makes a whole number a parameter.
  /// @param value  its default
  /// @param field  name, meaning, unit, range, source
  /// @return the variable
  /// @throws std::invalid_argument as for a number
  int& field(int value, const Field& field);
  /// Makes a switch a parameter: true or false.
  /// @param value  its default
  /// @param field  name and meaning
  /// @return the variable
  /// @throws std::invalid_argument as for a number
  bool& field(bool value, const Field& field);
  /// Makes a text a parameter, usually with one_of().
  /// @param value  its default
  /// @param field  name, meaning, range
  /// @return the variable
  /// @throws std::invalid_argument as for a number
  std::string& field(std::string value, const Field& field);
  /// Makes a text a parameter: the other overload, for a literal.
  /// @param value  its default
  /// @param field  name, meaning, range
  /// @return the variable
  std::string& field(const char* value, const Field& field) { return this->field(std::string(value), field); }

  /// Reads the command line, and the file that --config names, into the fields and common().
  /// @param argc   as main() gets it
  /// @param argv   as main() gets it
  /// @param out    where --help and --version are printed
  /// @param error  where a refusal is printed: what must hold, what was given, what to do
  /// @return the exit status if the program should end now: 0 after --help or --version, 2 after a refusal
  [[nodiscard]] std::optional<int> parse(int argc, const char* const* argv, std::ostream& out, std::ostream& error);
  /// Reads the command line, printing to the standard streams. See the other overload.
  /// @param argc  as main() gets it
  /// @param argv  as main() gets it
  /// @return the exit status if the program should end now: 0 after --help or --version, 2 after a refusal
  [[nodiscard]] std::optional<int> parse(int argc, const char* const* argv);

  /// @return the options that every program has, as parsed
  const Common& common() const { return common_; }
  /// @return the command as one line that a shell would take, as parsed
  const std::string& line() const { return line_; }
  /// @return the command that draws the figures of this run, on a line of its own; nothing where there are none
  std::string how_to_draw() const;
  /// @return whether every field, and the seed, has the value that it has where nothing is given; quick or not, and on
  /// any
  ///         number of threads
  bool has_defaults() const;
  /// @return the text that --help prints: every option, with meaning, unit, default and range
  std::string help() const;
  /// @return a TOML file of all fields as they are now, with seed and quick: what --config needs to repeat the run
  std::string parameters_toml() const;

 private:
  using Target = std::variant<double*, int*, std::uint64_t*, bool*, std::string*>;
  struct Entry {
    Field field;
    Target target;
    std::string default_text;
    bool everywhere;  // seed, threads, quick: every program has them
  };

  template <class T>
  T& keep(T value, const Field& field);
  void enter(Field field, Target target, bool everywhere);
  std::optional<int> read_tokens(int argc, const char* const* argv, std::ostream& out);
  void read_file(const std::filesystem::path& file);
  const Entry* entry_named(const std::string& name) const;
  std::vector<std::string> option_names() const;

  Program program_;
  Common common_;
  std::deque<std::variant<double, int, bool, std::string>> values_;  // a deque leaves them where they are
  std::vector<Entry> entries_;
  std::string line_;
};

}  // namespace particulate::report
