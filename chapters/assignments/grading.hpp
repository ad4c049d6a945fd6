#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <utility>
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

/// What typical mistakes make of an answer.
/// @param flaws  what can be wrong, and the hint to it
/// @param gives  the answer with one of them
/// @return all, in this order
template <class Flaw, class Gives>
std::vector<Mistake> mistakes(const std::vector<std::pair<Flaw, std::string>>& flaws, const Gives& gives) {
  std::vector<Mistake> all;
  for (const auto& [flaw, hint] : flaws) all.push_back({gives(flaw), hint});
  return all;
}

/// What a pi of too few digits makes of an answer.
/// @param gives  the answer with a pi
/// @return some that are typed
template <class Gives>
std::vector<Mistake> rough_pi(const Gives& gives) {
  std::vector<Mistake> all;
  for (const double pi : {3.0, 22.0 / 7.0, 3.14, 3.1416, 3.14159, 3.141592, 3.141593, 3.1415926, 3.1415927}) {
    all.push_back({gives(pi), "pi has more digits than you gave it: write std::numbers::pi"});
  }
  return all;
}

/// The answers to a line's questions, in their order.
using Answers = std::vector<std::vector<double>>;

/// What is wrong with an answer, as the table shows it.
struct Finding {
  std::string expected = {};  ///< what must hold
  std::string obtained = {};  ///< what was given
  std::string hint = {};      ///< what to look for
  std::string call = {};      ///< of the student's function, with the names of its arguments
};

/// One call of a student's function.
struct Question {
  std::string function;                ///< its name, as the driver knows it
  std::vector<double> inputs;          ///< in the order of its arguments
  std::vector<double> expected = {};   ///< by the library, or by a closed form; empty: `holds` alone judges
  std::vector<Mistake> mistakes = {};  ///< tried in this order where the answer is wrong
  /// The hint where no mistake gives this answer.
  std::string otherwise = "compare with the formula of the brief, term by term, for these inputs";
  std::size_t count = 1;  ///< of numbers in the answer, where nothing is expected of them
  /// A fact that the answer of this number must obey, alone or with those behind it, such as a conservation law; looked
  /// at once every comparison of the line was right. NaN must break it. None: comparison is all.
  std::function<std::optional<Finding>(const Answers&, std::size_t number)> holds = {};
  bool is_judged = true;     ///< false: asked only for what is built on it
  std::size_t built_on = 0;  ///< so many questions just before this one, to functions that this one may call
  /// Right as well: the same formula with the student's own answers to what it is built on. A slip thus costs the
  /// points of its own function alone. A function that answers zero throughout the line is none to build on.
  std::function<Answers(const Answers& own)> with_own = {};
};

/// One line of the score table. All its questions are put to one run of the program; each must be answered rightly.
struct Line {
  std::string name;                      ///< such as "exact case"
  double points = 0.0;                   ///< for the whole line
  double relative = 1e-12;               ///< |answer - expected| <= relative |expected| + absolute
  double absolute = 0.0;                 ///< in the unit of the answer
  std::string otherwise = {};            ///< the hint where no mistake gives an answer; empty: that of the question
  std::vector<Question> questions = {};  ///< at least one
};

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
  /// What the numbers of a call and of its answer mean, by function: "m v[3] e -> J" for a mass, the three components
  /// of a velocity and a ratio, answered by one number. What stands behind "..." repeats itself.
  std::map<std::string, std::string> calls;
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
