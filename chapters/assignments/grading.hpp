#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <vector>

/// @file
/// Grades a submission: it asks a program that holds the student's functions, compares its answers with the library's,
/// and prints a table of scores. The program runs apart, knows no expected value, and may crash, hang or lie.

namespace grading {

/// What a typical mistake makes of an answer.
struct Mistake {
  std::vector<double> gives;  ///< the answer with that mistake, as long as the right one; NaN and infinity are answers
  std::string hint;           ///< what to look for
};

/// One call of a student's function.
struct Question {
  std::string function;                ///< its name, as the driver knows it
  std::vector<double> inputs;          ///< in the order of its arguments
  std::vector<double> expected = {};   ///< by the library, or by a closed form; empty: `Line::holds` alone judges
  std::vector<Mistake> mistakes = {};  ///< tried in this order where the answer is wrong
  /// The hint where no mistake gives this answer.
  std::string otherwise = "compare with the formula of the brief, term by term, for these inputs";
  std::size_t count = 1;  ///< of numbers in the answer, where nothing is expected of them
};

/// The answers to a line's questions, in their order.
using Answers = std::vector<std::vector<double>>;

/// What is wrong with an answer, as the table shows it.
struct Finding {
  std::string expected;      ///< what must hold
  std::string obtained;      ///< what was given
  std::string hint;          ///< what to look for
  std::size_t question = 0;  ///< of the line, from 0: the call that the table shows
};

/// One line of the score table. All its questions are put to one run of the program; each must be answered rightly.
struct Line {
  std::string name;                      ///< such as "exact case"
  double points = 0.0;                   ///< for the whole line
  double relative = 1e-12;               ///< |answer - expected| <= relative |expected| + absolute
  double absolute = 0.0;                 ///< in the unit of the answer
  std::vector<Question> questions = {};  ///< at least one
  /// A fact that the answers must obey together, such as a conservation law, looked at once every comparison was
  /// right. NaN must break it. None: comparison is all.
  std::function<std::optional<Finding>(const Answers&)> holds = {};
};

/// Limits of one run of a submission, which takes milliseconds. The processor time ends a loop; the wall time ends one
/// that sleeps, and leaves a right answer enough of it on a machine that has other things to do.
struct Limits {
  unsigned cpu_seconds = 2;                       ///< of processor time [s]
  std::chrono::seconds wall{20};                  ///< until it is killed
  std::uint64_t memory = std::uint64_t{1} << 28;  ///< address space [bytes]
};

/// What came back from one run of a submission.
struct Run {
  Answers answers;      ///< complete if there is no failure
  std::string failure;  ///< why not: it crashed, took too long, left too early, wrote too much
  std::string hint;     ///< what to look for then
};

/// Runs a submission in a process of its own and puts questions to it.
///
/// Questions go in by its standard input, answers come back by a pipe of their own: what it prints is thrown away. It
/// can write no file, and cannot read this process's memory. Where this process is root's, it becomes `nobody` if
/// the system lets it.
/// @param program    the driver, linked with the student's functions
/// @param questions  what to ask
/// @param limits     beyond which it is killed
/// @return its answers, or why there are none
/// @throws std::runtime_error if no process can be made
Run ask(const std::filesystem::path& program, const std::vector<Question>& questions, const Limits& limits = {});

/// How one line went.
struct Score {
  std::string name;            ///< of the line
  double points = 0.0;         ///< reached
  double possible = 0.0;       ///< points of the line
  std::string expected = {};   ///< of the first wrong answer
  std::string obtained = {};   ///< of the first wrong answer, or why there is none
  std::string tolerance = {};  ///< of the line
  std::string hint = {};       ///< what to look for; empty where all is right
};

/// Grades one line.
///
/// @param program  the driver, linked with the student's functions
/// @param line     questions and what holds of their answers
/// @param limits   of the run
/// @return all its points or none, and why
Score grade(const std::filesystem::path& program, const Line& line, const Limits& limits = {});

/// Numbers that belong to a student: equal for equal IDs, on every machine.
class Draw {
 public:
  /// @param student  any text; every byte of it counts
  explicit Draw(const std::string& student);
  /// @param low   lower bound
  /// @param high  upper bound
  /// @return a number between them, rounded to four digits so that it can be read
  double between(double low, double high);
  /// @param count  > 0
  /// @return a whole number in [0, count)
  int one_of(int count);

 private:
  std::mt19937_64 engine_;
};

/// A problem for one student.
struct Assignment {
  std::string title;                  ///< for the head of the table
  std::vector<std::string> variants;  ///< what each variant of the problem asks
  /// The table, but for "compiles". Lines are made in this order, each with its numbers from the same stream.
  std::vector<Line (*)(int variant, Draw& numbers)> lines;
};

/// The main program of a check: reads the command line, grades, prints the table, writes the results for Gradescope.
///
/// Options: `--program FILE` the driver with the submission; `--log FILE` instead, if that did not compile: what the
/// compiler said; `--student ID`, required, taken in small letters (of ASCII) and without blanks at its ends;
/// `--variant N`, from 1, without it chosen by the ID; `--json FILE`, which must be writable before anything is graded;
/// `--seconds N`, processor time of a line.
/// @param argc        as main() gets it
/// @param argv        as main() gets it
/// @param assignment  what is asked
/// @return 0 for full marks, 1 for less, 2 for a wrong command line or results that cannot be written
int run(int argc, char** argv, const Assignment& assignment);

}  // namespace grading
