#include "grading.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#ifdef __linux__
#include <grp.h>
#include <sys/prctl.h>
#endif
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <particulate/report/guarded.hpp>

namespace grading {

namespace {

using Clock = std::chrono::steady_clock;

// Limits of one run of a submission, which takes milliseconds. The processor time ends a loop; the wall time ends one
// that sleeps, and leaves a right answer enough of it on a machine that has other things to do.
struct Limits {
  unsigned cpu_seconds;
  std::chrono::seconds wall;
  rlim_t memory = rlim_t{1} << 28;  // address space in bytes
};

// What came back from one run of a submission: all answers, or why not.
struct Run {
  Answers answers;
  Finding wrong;
};

// How one line went. Where all is right there is no hint.
struct Score {
  std::string name;
  double points = 0.0, possible = 0.0;
  std::string tolerance = {};
  Finding wrong = {};
  bool is_on_own = false;  // right, but built on what is wrong
};

// A pipe whose ends close themselves.
class Pipe {
 public:
  Pipe() {
    if (pipe(ends_.data()) != 0) throw std::runtime_error("no pipe can be made for the submission");
    for (const int end : ends_) fcntl(end, F_SETFD, FD_CLOEXEC);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  int read_end() const { return ends_[0]; }
  int write_end() const { return ends_[1]; }
  void close_end(std::size_t end) {
    if (ends_[end] >= 0) close(std::exchange(ends_[end], -1));
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

std::string as_text(const std::vector<Question>& questions) {
  std::string text;
  for (const Question& question : questions) {
    text += fmt::format("{} {}", question.function, question.inputs.size());
    for (const double x : question.inputs) text += fmt::format(" {:a}", x);
    text += '\n';
  }
  return text;
}

void limit(decltype(RLIMIT_CPU) resource, rlim_t value) {
  const rlimit both{value, value};
  setrlimit(resource, &both);
}

constexpr int answers_end = 3;
constexpr int not_started = 127;

// The three files that a submission has: questions, nowhere for what it prints, answers.
void keep_three_files(int questions, int answers) {
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(questions, STDIN_FILENO);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  dup2(answers, answers_end);
  fcntl(STDIN_FILENO, F_SETFD, 0);
  fcntl(answers_end, F_SETFD, 0);
  constexpr int most_files = 256;
  for (int other = answers_end + 1; other < most_files; ++other) close(other);
}

// Between fork and exec: only what is allowed there. The program is opened by whoever runs this, then root's rights go.
[[noreturn]] void become(const char* program, int questions, int answers, const Limits& limits) {
  setpgid(0, 0);
  limit(RLIMIT_CPU, limits.cpu_seconds);
  limit(RLIMIT_AS, limits.memory);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  keep_three_files(questions, answers);
  char name[] = "submission", number[] = "3";
  char* const words[] = {name, number, nullptr};
#ifdef __linux__
  const int file = open(program, O_RDONLY | O_CLOEXEC);
  constexpr uid_t nobody = 65534;
  const bool is_root = geteuid() == 0;
  // Containers may refuse this to their root; the other limits hold even so.
  if (is_root && setgroups(0, nullptr) == 0 && setgid(nobody) == 0) std::ignore = setuid(nobody);
  fexecve(file, words, environ);
#else
  execv(program, words);
#endif
  _exit(not_started);
}

// Far more than any line asks for [bytes].
constexpr std::size_t most_answers = 1 << 20;

// Writes the questions and reads the answers as both get through, until the end, the deadline or too much.
std::string converse(Pipe& in, Pipe& out, const std::string& questions, Clock::time_point deadline) {
  fcntl(in.write_end(), F_SETFL, O_NONBLOCK);
  std::string answers;
  std::size_t written = 0;
  std::array<char, 4096> buffer{};
  while (answers.size() < most_answers) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) break;
    std::array<pollfd, 2> ends{pollfd{out.read_end(), POLLIN, 0}, pollfd{in.write_end(), POLLOUT, 0}};
    poll(ends.data(), in.write_end() >= 0 ? 2 : 1, static_cast<int>(left));
    if (in.write_end() >= 0 && ends[1].revents != 0) {
      const ssize_t n = write(in.write_end(), questions.data() + written, questions.size() - written);
      written += n > 0 ? static_cast<std::size_t>(n) : 0;
      if (n <= 0 || written == questions.size()) in.close_end(1);
    }
    if (ends[0].revents != 0) {
      const ssize_t n = read(out.read_end(), buffer.data(), buffer.size());
      if (n <= 0) break;
      answers.append(buffer.data(), static_cast<std::size_t>(n));
    }
  }
  return answers;
}

// Waits for the process until the deadline, then kills it and whatever it has started.
std::optional<int> end_of(pid_t process, Clock::time_point deadline) {
  int status = 0;
  std::optional<int> ended;
  while (!ended && Clock::now() < deadline) {
    if (waitpid(process, &status, WNOHANG) == process) {
      ended = status;
    } else {
      usleep(1000);
    }
  }
  kill(-process, SIGKILL);
  if (!ended) waitpid(process, &status, 0);
  return ended;
}

// Why a run has not given all its answers.
void explain(Run& run, std::optional<int> status, std::size_t asked) {
  const std::string after = fmt::format(" after {} of {} answers", std::min(run.answers.size(), asked), asked);
  const int signal = status && WIFSIGNALED(*status) ? WTERMSIG(*status) : 0;
  const int left = status && WIFEXITED(*status) ? WEXITSTATUS(*status) : 0;
  if (run.answers.size() > asked) {
    run.wrong.obtained = fmt::format("more than the {} answers asked for", asked);
    run.wrong.hint = "functions must return their result and write to no file";
  } else if (!status || signal == SIGXCPU || signal == SIGKILL) {
    run.wrong.obtained = "took too long" + after;
    run.wrong.hint = "a loop does not end, or does far too much work";
  } else if (signal != 0) {
    run.wrong.obtained = fmt::format("crashed ({}){}", strsignal(signal), after);
    run.wrong.hint =
        "run it in a debugger, or build it with -fsanitize=address: an index or a pointer is wrong, an exception "
        "was thrown, a file was written, or memory ran out";
  } else if (left == not_started) {
    run.wrong.obtained = "the program could not be started";
    run.wrong.hint = "its file must exist, and everyone must be allowed to read and execute it";
  } else {
    run.wrong.obtained = fmt::format("left with exit status {}{}", left, after);
    run.wrong.hint = "functions must return to their caller: do not call exit()";
  }
}

std::string shown(const std::vector<double>& values) { return fmt::format("{:.15g}", fmt::join(values, ", ")); }

// Values with their names, from a list such as "m v[3]": "m = 1, v = (2, 0, 0)". Behind "..." the names repeat.
std::string named(const std::string& names, const std::vector<double>& values) {
  std::istringstream words(names);
  std::vector<std::string> list;
  std::size_t repeated = 0;
  for (std::string word; words >> word;) {
    if (word == "...") {
      repeated = list.size();
    } else {
      list.push_back(word);
    }
  }
  std::vector<std::string> parts;
  std::size_t at = 0;
  for (std::size_t k = 0; k < values.size(); ++at) {
    if (at == list.size()) at = repeated;
    const std::string& word = list.at(at);
    const std::size_t bracket = word.find('[');
    const bool is_vector = bracket != std::string::npos;
    const std::size_t size = is_vector ? std::stoul(word.substr(bracket + 1)) : 1,
                      end = std::min(k + size, values.size());
    const std::string numbers =
        shown({values.begin() + static_cast<std::ptrdiff_t>(k), values.begin() + static_cast<std::ptrdiff_t>(end)});
    parts.push_back(fmt::format("{} = {}", word.substr(0, bracket), is_vector ? "(" + numbers + ")" : numbers));
    k = end;
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

// The names of a function's arguments and of what it returns.
std::pair<std::string, std::string> signature(const Assignment& assignment, const std::string& function) {
  const auto found = assignment.calls.find(function);
  const std::size_t arrow = found == assignment.calls.end() ? std::string::npos : found->second.find(" -> ");
  if (arrow == std::string::npos) {
    throw std::logic_error(
        fmt::format("a check must name the numbers of every call, such as 'm v[3] -> J'; "
                    "it does not for {}: add it to its calls",
                    function));
  }
  return {found->second.substr(0, arrow), found->second.substr(arrow + 4)};
}

bool is_close(double answer, double expected, const Line& line) {
  if (!std::isfinite(expected)) return answer == expected;
  return std::abs(answer - expected) <= line.relative * std::abs(expected) + line.absolute;
}

bool is_close(const std::vector<double>& answer, const std::vector<double>& expected, const Line& line) {
  return !answer.empty() && answer.size() == expected.size() &&
         std::equal(answer.begin(), answer.end(), expected.begin(),
                    [&](double a, double b) { return is_close(a, b, line); });
}

// What a mistake gives may be no number.
bool same(double answer, double given, const Line& line) {
  return is_close(answer, given, line) || (std::isnan(answer) && std::isnan(given));
}

// The hint to the mistake that gives this answer.
std::optional<std::string> mistake_in(const Question& question, const std::vector<double>& answer, const Line& line) {
  for (const Mistake& mistake : question.mistakes) {
    const bool made = std::equal(answer.begin(), answer.end(), mistake.gives.begin(), mistake.gives.end(),
                                 [&](double a, double b) { return same(a, b, line); });
    if (made) return mistake.hint;
  }
  return std::nullopt;
}

bool is_zero(const std::vector<double>& answer) {
  return std::all_of(answer.begin(), answer.end(), [](double x) { return x == 0.0; });
}

std::string hint_for(const Question& question, const std::vector<double>& answer, const Line& line) {
  if (is_zero(answer)) return "the answer is zero: is this still the stub?";
  if (const std::optional<std::string> hint = mistake_in(question, answer, line)) return *hint;
  const auto is_finite = [](double x) { return std::isfinite(x); };
  if (std::all_of(answer.begin(), answer.end(), is_finite)) {
    return line.otherwise.empty() ? question.otherwise : line.otherwise;
  }
  return "the answer is not a finite number: look for 0/0, overflow, a root or a logarithm of a negative number";
}

// Whether a function answers more than zero somewhere in the line, as a source with holes does not.
bool is_filled(const std::string& function, const Line& line, const Answers& answers) {
  for (std::size_t k = 0; k < line.questions.size(); ++k) {
    if (line.questions[k].function == function && !is_zero(answers[k])) return true;
  }
  return false;
}

// Answers to what a question is built on; none where one of them is none to build on.
Answers own_answers(const Line& line, const Answers& answers, std::size_t number) {
  Answers own;
  for (std::size_t k = number - line.questions[number].built_on; k < number; ++k) {
    const Question& before = line.questions[k];
    if (answers[k].size() != before.expected.size() || !is_filled(before.function, line, answers)) return {};
    own.push_back(answers[k]);
  }
  return own;
}

// How an answer that is not the expected one stands to the student's own answers before it.
enum class Own { wrong, right, not_judged };

Own on_its_own(const Line& line, const Answers& answers, std::size_t number) {
  const Question& question = line.questions[number];
  if (!question.with_own || !is_filled(question.function, line, answers)) return Own::wrong;
  const Answers own = own_answers(line, answers, number);
  if (own.empty()) return Own::wrong;
  const auto has_nan = [](const auto& of) {
    return std::any_of(of.begin(), of.end(), [](double x) { return std::isnan(x); });
  };
  if (std::any_of(own.begin(), own.end(), has_nan)) return Own::not_judged;
  const Answers right = question.with_own(own);
  const auto gives = [&](const auto& one) { return is_close(answers[number], one, line); };
  return std::any_of(right.begin(), right.end(), gives) ? Own::right : Own::wrong;
}

// The first answer of a line that is wrong. Answers that are right on the student's own terms are marked in the score.
std::optional<Finding> first_wrong(const Assignment& assignment, const Line& line, const Answers& answers,
                                   Score& score) {
  const auto call = [&](const Question& question) {
    return fmt::format("{}({})", question.function,
                       named(signature(assignment, question.function).first, question.inputs));
  };
  const auto finding = [&](std::size_t k) {
    const Question& question = line.questions[k];
    const std::string results = signature(assignment, question.function).second;
    return Finding{.expected = named(results, question.expected),
                   .obtained = named(results, answers[k]),
                   .hint = hint_for(question, answers[k], line),
                   .call = call(question)};
  };
  // Where nothing could be judged, nothing is right.
  std::optional<std::size_t> not_judged;
  bool is_any_right = false;
  for (std::size_t k = 0; k < line.questions.size(); ++k) {
    const Question& question = line.questions[k];
    const bool is_judged_later = question.expected.empty() && answers[k].size() == question.count;
    if (!question.is_judged || is_judged_later) continue;
    const bool is_right = is_close(answers[k], question.expected, line);
    const Own own = is_right ? Own::right : on_its_own(line, answers, k);
    if (own == Own::wrong) return finding(k);
    if (own == Own::not_judged) not_judged = k;
    if (own == Own::right) is_any_right = true;
    if (!is_right) score.is_on_own = true;
  }
  if (not_judged && !is_any_right) return finding(*not_judged);
  for (std::size_t k = 0; k < line.questions.size(); ++k) {
    const Question& question = line.questions[k];
    std::optional<Finding> wrong = question.holds ? question.holds(answers, k) : std::nullopt;
    if (!wrong) continue;
    wrong->hint = mistake_in(question, answers[k], line).value_or(wrong->hint);
    wrong->call = call(question);
    return wrong;
  }
  return std::nullopt;
}

// For JSON. What is not ASCII may come from a compiler, cut off in the middle of a letter.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      out += static_cast<unsigned char>(c) < 0x7f ? c : '?';
    }
  }
  return out;
}

const char* const on_own = "built on your own answers";

// What is told of a line that is wrong: names and texts.
std::vector<std::pair<std::string, std::string>> told(const Score& score) {
  std::vector<std::pair<std::string, std::string>> rows;
  if (!score.wrong.call.empty()) rows.emplace_back("call", score.wrong.call);
  rows.insert(rows.end(), {{"expected", score.wrong.expected},
                           {"obtained", score.wrong.obtained},
                           {"tolerance", score.tolerance},
                           {"hint", score.wrong.hint}});
  return rows;
}

std::string story(const Score& score) {
  if (score.wrong.hint.empty()) return score.is_on_own ? on_own : "right";
  if (score.wrong.expected.empty()) return score.wrong.hint;
  std::string text;
  for (const auto& [name, what] : told(score)) text += fmt::format("{}{}: {}", text.empty() ? "" : "\n", name, what);
  return text;
}

// Answers, a line each, up to "end". Whether they are complete: as many as asked, and nothing behind.
bool read_answers(const std::string& text, std::size_t asked, Answers& answers) {
  std::istringstream lines(text);
  std::string line;
  while (std::getline(lines, line)) {
    if (line == "end" && answers.size() == asked) return lines.peek() == std::char_traits<char>::eof();
    std::istringstream numbers(line);
    std::vector<double> answer;
    for (std::string number; numbers >> number;) answer.push_back(std::strtod(number.c_str(), nullptr));
    answers.push_back(answer);
  }
  return false;
}

// Runs a submission in a process of its own and puts questions to it. Questions go in by its standard input, answers
// come back by a pipe of their own: what it prints is thrown away. It can write no file, and cannot read this process's
// memory. Where this process is root's, it becomes `nobody` if the system lets it.
Run ask(const std::string& program, const std::vector<Question>& questions, const Limits& limits) {
  const Clock::time_point deadline = Clock::now() + limits.wall;
  signal(SIGPIPE, SIG_IGN);
#ifdef __linux__
  prctl(PR_SET_DUMPABLE, 0);  // Expected values stand in this memory: no process of the same user may read it.
#endif
  Pipe in, out;
  const pid_t process = fork();
  if (process < 0) throw std::runtime_error("no process can be made for the submission");
  if (process == 0) become(program.c_str(), in.read_end(), out.write_end(), limits);
  setpgid(process, process);
  in.close_end(0);
  out.close_end(1);
  const std::string text = converse(in, out, as_text(questions), deadline);
  const bool too_much = text.size() >= most_answers;
  const std::optional<int> status = end_of(process, too_much ? Clock::now() : deadline);

  Run run;
  const bool complete = read_answers(text, questions.size(), run.answers) && !too_much;
  if (!complete || !status || !WIFEXITED(*status) || WEXITSTATUS(*status) != 0) {
    explain(run, status, questions.size());
  }
  return run;
}

// All points of a line or none, and why.
Score grade(const std::string& program, const Assignment& assignment, const Line& line, const Limits& limits) {
  Score score{.name = line.name, .possible = line.points};
  score.tolerance = fmt::format("{:g} relative", line.relative);
  if (line.absolute > 0.0) score.tolerance += fmt::format(" + {:g}", line.absolute);
  const Run run = ask(program, line.questions, limits);
  if (!run.wrong.obtained.empty()) {
    score.wrong = run.wrong;
    score.wrong.expected = fmt::format("{} answers", line.questions.size());
  } else if (const std::optional<Finding> wrong = first_wrong(assignment, line, run.answers, score)) {
    score.wrong = *wrong;
  } else {
    score.points = line.points;
  }
  return score;
}

// The command line, option by option.
struct Options {
  std::string program, log, student, json, variant, seconds;
};

[[nodiscard]] bool refuse(const std::string& why) {
  fmt::print(stderr, "{}\n", why);
  return false;
}

// An ID however it was typed: small letters, no blanks at its ends. Letters beyond ASCII stay as they are.
std::string normalized(const std::string& id) {
  constexpr const char* blanks = " \t\r\n";
  const std::size_t first = id.find_first_not_of(blanks);
  if (first == std::string::npos) return "";
  std::string out = id.substr(first, id.find_last_not_of(blanks) - first + 1);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

bool parse(int argc, char** argv, Options& options) {
  const std::map<std::string, std::string*> known{{"--program", &options.program}, {"--log", &options.log},
                                                  {"--student", &options.student}, {"--json", &options.json},
                                                  {"--variant", &options.variant}, {"--seconds", &options.seconds}};
  for (int k = 1; k < argc; k += 2) {
    const auto option = known.find(argv[k]);
    if (option == known.end()) {
      return refuse(fmt::format("there is no option '{}'; an option and its value are two words", argv[k]));
    }
    if (k + 1 == argc) return refuse(fmt::format("a value must follow {}", argv[k]));
    if (argv[k + 1][0] == '-') {
      return refuse(
          fmt::format("a value must follow {}, one that does not begin with '-', got '{}'", argv[k], argv[k + 1]));
    }
    *option->second = argv[k + 1];
  }
  if (options.program.empty() == options.log.empty()) {
    return refuse("give either --program FILE or, if it did not compile, --log FILE");
  }
  options.student = normalized(options.student);
  if (options.student.empty()) {
    return refuse("name the student, --student ID: the ID draws the numbers and chooses the variant");
  }
  return true;
}

// A whole number in [1, most], or nothing.
std::optional<int> counted(const std::string& text, int most) {
  char* end = nullptr;
  const long value = std::strtol(text.c_str(), &end, 10);
  const bool is_good = !text.empty() && *end == '\0' && value >= 1 && value <= most;
  return is_good ? std::optional<int>(static_cast<int>(value)) : std::nullopt;
}

// What the compiler or the linker minds first.
std::string first_error(const std::string& file) {
  std::ifstream log(file);
  for (std::string line; std::getline(log, line);) {
    for (const char* sign : {"error:", "undefined reference", "multiple definition", "Undefined symbols"}) {
      if (line.find(sign) != std::string::npos) return line;
    }
  }
  return fmt::format("no program was made, see {}", file);
}

Score compiles(const std::string& log) {
  Score score{.name = "compiles"};
  if (log.empty()) return score;
  score.tolerance = "none";
  score.wrong = {.expected = "a program",
                 .obtained = first_error(log),
                 .hint = "mend the first error first; hand in every function of the header, as it is declared there"};
  return score;
}

// A name and a text, which is broken between words where it would leave a screen of 100 columns.
void print_row(const std::string& name, const std::string& text) {
  constexpr std::size_t width = 75;
  fmt::print("{:14}{:<10}", "", name);
  std::istringstream words(text);
  std::size_t column = 0;
  for (std::string word; words >> word;) {
    if (column > 0 && column + 1 + word.size() > width) {
      fmt::print("\n{:24}", "");
      column = 0;
    }
    fmt::print(" {}", word);
    column += 1 + word.size();
  }
  fmt::print("\n");
}

void print(const std::vector<Score>& scores) {
  double reached = 0.0, possible = 0.0;
  for (const Score& score : scores) {
    const Finding& wrong = score.wrong;
    reached += score.points;
    possible += score.possible;
    if (score.possible > 0.0) {
      fmt::print("{:5g} of {:<5g}{}", score.points, score.possible, score.name);
    } else {
      fmt::print("{:>5}         {}", wrong.hint.empty() ? "yes" : "no", score.name);
    }
    const bool is_asked = !wrong.expected.empty();
    const std::string remark = is_asked ? "" : score.is_on_own ? on_own : wrong.hint;
    fmt::print("{}\n", remark.empty() ? "" : " (" + remark + ")");
    if (!is_asked) continue;
    for (const auto& [name, what] : told(score)) print_row(name, what);
  }
  fmt::print("{:5g} of {:<5g}in all\n", reached, possible);
}

// Results are written beside their file, which then takes its place: there are never half of them.
std::string part(const std::string& file) { return file + ".part"; }

[[nodiscard]] bool refuse_file(const std::string& file) {
  return refuse(fmt::format("{} cannot be written: name a file in a folder that exists and can be written to", file));
}

// Asked before anything is graded. The scores of another submission go: one that dies must not be given them.
bool can_write(const std::string& file) {
  std::error_code failed;
  if (std::filesystem::is_directory(file, failed) || !std::ofstream(part(file))) return refuse_file(file);
  std::filesystem::remove(part(file), failed);
  std::filesystem::remove(file, failed);
  return true;
}

bool write_json(const std::string& file, const std::vector<Score>& scores) {
  std::string tests;
  double reached = 0.0;
  for (const Score& score : scores) {
    reached += score.points;
    tests += fmt::format(
        "{}\n    {{\"name\": \"{}\", \"score\": {}, \"max_score\": {}, \"status\": \"{}\", \"output\": \"{}\"}}",
        tests.empty() ? "" : ",", escaped(score.name), score.points, score.possible,
        score.wrong.hint.empty() ? "passed" : "failed", escaped(story(score)));
  }
  const std::string whole = part(file);
  {
    std::ofstream out(whole);
    out << fmt::format("{{\n  \"score\": {},\n  \"visibility\": \"visible\",\n  \"tests\": [{}\n  ]\n}}\n", reached,
                       tests);
    if (!out.flush()) return false;
  }
  std::error_code failed;
  std::filesystem::rename(whole, file, failed);
  return !failed;
}

}  // namespace

Draw::Draw(const std::string& student) {
  std::uint64_t hash = 14695981039346656037ULL;  // FNV-1a
  for (const char c : student) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  engine_.seed(hash);
}

double Draw::between(double low, double high) {
  const double share = std::ldexp(static_cast<double>(engine_() >> 11), -53);
  const double x = low + share * (high - low);
  return std::strtod(fmt::format("{:.4g}", x).c_str(), nullptr);
}

int Draw::one_of(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }

namespace {

int graded(int argc, char** argv, const Assignment& assignment) {
  Options options;
  if (!parse(argc, argv, options)) return 2;
  Draw numbers(options.student);
  const int variants = static_cast<int>(assignment.variants.size());
  const int by_id = numbers.one_of(variants) + 1;
  const std::optional<int> variant = options.variant.empty() ? by_id : counted(options.variant, variants);
  constexpr int most_seconds = 600;
  const std::optional<int> seconds = options.seconds.empty() ? 2 : counted(options.seconds, most_seconds);
  if (!variant) std::ignore = refuse(fmt::format("--variant must be 1 to {}, got '{}'", variants, options.variant));
  if (!seconds) std::ignore = refuse(fmt::format("--seconds must be 1 to {}, got '{}'", most_seconds, options.seconds));
  if (!variant || !seconds) return 2;
  if (!options.json.empty() && !can_write(options.json)) return 2;
  const Limits limits{.cpu_seconds = static_cast<unsigned>(*seconds), .wall = std::chrono::seconds(10 * *seconds)};
  fmt::print("{}\nstudent {}, variant {}: {}\n\n", assignment.title, options.student, *variant,
             assignment.variants[static_cast<std::size_t>(*variant - 1)]);
  std::vector<Score> scores{compiles(options.log)};
  for (const auto make_line : assignment.lines) {
    const Line line = make_line(*variant, numbers);
    scores.push_back(
        options.log.empty()
            ? grade(options.program, assignment, line, limits)
            : Score{.name = line.name, .possible = line.points, .wrong = {.hint = "not asked: it does not compile"}});
  }
  print(scores);
  if (!options.json.empty() && !write_json(options.json, scores)) {
    std::ignore = refuse_file(options.json);
    return 2;
  }
  const bool full = std::all_of(scores.begin(), scores.end(), [](const Score& s) { return s.wrong.hint.empty(); });
  return full ? 0 : 1;
}

}  // namespace

int run(int argc, char** argv, const Assignment& assignment) {
  return particulate::report::guarded("check", [&] { return graded(argc, argv, assignment); });
}

}  // namespace grading
