#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <particulate/report/checks.hpp>
#include <particulate/report/command_line.hpp>
#include <particulate/report/guarded.hpp>
#include <particulate/report/output.hpp>

namespace particulate::report {

/// What a chapter's program works with, and how it ends: its options, its folder, and what it claims of itself.
class Chapter {
 public:
  /// @param line  parsed; must outlive this object
  /// @throws std::runtime_error if no file can be written to the folder of the results, or another run is at work there
  explicit Chapter(const CommandLine& line);

  /// @return the options that every program has
  const Common& common() const { return line_.common(); }
  /// @return the folder of the results
  const Output& output() const { return output_; }
  /// A table of claims, written and printed when the program ends, in the order in which they were first asked for.
  /// @param table  name of the table, as Output::write() takes it
  /// @return the claims under that name so far; the reference stays good
  Checks& claims(const std::string& table);

  /// What the run did, in a few numbers: impacts, energies, overlap.
  /// @return the table `summary`, of quantities and their values, which is written and printed when the program ends
  Table& summary() { return summary_; }
  /// Tells whoever ran the program what no claim is about: that an answer is poor, and which parameter to change.
  /// @param text  what was seen and what to do, printed when the program ends
  void note(std::string text) { notes_.push_back(std::move(text)); }

  /// Ends the run: writes and prints the tables of claims and the summary, prints the notes, writes `stamp.json`, and
  /// says where all of that is and how its figures are drawn. The `parameters.toml` that repeats it is there from the
  /// beginning.
  /// @param kernel  the variant of the force kernel that ran, for the stamp
  /// @return the exit status: 0 if something is claimed and every claim holds, otherwise 1
  /// @throws std::runtime_error if a file cannot be written
  int end(std::string_view kernel) const;

 private:
  const CommandLine& line_;
  Output output_;
  std::deque<std::pair<std::string, Checks>> claims_;
  Table summary_{{"quantity", "value"}};
  std::vector<std::string> notes_;
};

/// The main() of a chapter's program: parameters in, claims out.
///
/// `Parameters` is a struct whose first member is a `CommandLine&` and whose others are `line.field(...)`. What does
/// not hold between several of them may be refused by a function `validate(parameters)`, which throws before anything
/// is written.
/// @param argc     as main() gets it
/// @param argv     as main() gets it
/// @param program  name, sentence, default folder
/// @param kernel   the variant of the force kernel that runs, for the stamp
/// @param run      the chapter
/// @return the exit status: 0 if every claim holds or --help was asked for, 1 if one fails, 2 after a refusal
template <class Parameters>
int run_chapter(int argc, const char* const* argv, const Program& program, std::string_view kernel,
                void (*run)(const Parameters&, Chapter&)) {
  return guarded(program.name, [&] {
    CommandLine line(program);
    const Parameters parameters{line};
    if (const std::optional<int> status = line.parse(argc, argv)) return *status;
    if constexpr (requires { validate(parameters); }) validate(parameters);
    Chapter chapter(line);
    run(parameters, chapter);
    return chapter.end(kernel);
  });
}

}  // namespace particulate::report
