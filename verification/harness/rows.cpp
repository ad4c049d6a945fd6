#include <harness/rows.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace verification {
namespace {

// Rule 2 of orders: how far the fit may be off, how many points, how far apart, and where their errors lie.
constexpr double order_slack = 0.2;
constexpr std::size_t fewest_points = 5;
constexpr double least_refinement = 1.25, largest_refinement = 16.0;
constexpr double floors_below = 1e3, largest_error = 1e-2;

std::string wrong_tolerance(const Tolerance& tolerance, double expected) {
  const bool sound = tolerance.relative >= 0.0 && tolerance.absolute >= 0.0 && std::isfinite(tolerance.relative) &&
                     std::isfinite(tolerance.absolute);
  if (!sound) return "a tolerance must be finite and not negative";
  if (tolerance.absolute == 0.0 && tolerance.relative > 0.0 && expected == 0.0) {
    return "a relative tolerance says nothing about an expected 0: use absolute() or mixed()";
  }
  return "";
}

// The error in the unit of the tolerance, so that every row passes if error <= tolerance.
void measure(const Comparison& comparison, Row& row) {
  const auto& [expected, computed, tolerance, because] = comparison;
  const double distance = std::abs(computed - expected);
  if (tolerance.relative == 0.0) {
    row.metric = "absolute", row.error = distance, row.tolerance = tolerance.absolute;
    row.passed = distance <= tolerance.absolute;
    return;
  }
  const double scale = std::max(std::abs(expected), tolerance.absolute / tolerance.relative);
  const double error = distance == 0.0 ? 0.0 : distance / scale;
  row.metric = tolerance.absolute > 0.0 ? "mixed" : "relative", row.error = error, row.tolerance = tolerance.relative;
  row.passed = error <= tolerance.relative;
}

void require_finite(std::initializer_list<double> numbers, Row& row) {
  for (const double number : numbers) {
    if (!std::isfinite(number)) row.failure = fmt::format("every number must be finite, got {}", number);
  }
}

// What is wrong with the points of an order of accuracy, or nothing.
std::string wrong_points(const Convergence& points) {
  const auto& [nominal, steps, errors, floor, because] = points;
  if (!(nominal > 0.0) || !std::isfinite(nominal))
    return fmt::format("the nominal order must be positive, got {}", nominal);
  if (!(floor > 0.0)) return fmt::format("the floor must be positive, got {}", floor);
  if (steps.size() != errors.size()) {
    return fmt::format("there must be one error a step, got {} steps and {} errors", steps.size(), errors.size());
  }
  if (steps.size() < fewest_points) {
    return fmt::format("there must be at least four refinements, that is {} points, got {}", fewest_points,
                       steps.size());
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!(errors[i] >= floors_below * floor && errors[i] <= largest_error)) {
      return fmt::format(
          "every error must lie in [{:.3g}, {:.3g}] (1000 times that of the reference, and 1e-2), got {:.3g} at step "
          "{:.3g}",
          floors_below * floor, largest_error, errors[i], steps[i]);
    }
    const double factor = i == 0 ? 2.0 : steps[i - 1] / steps[i];
    if (!(steps[i] > 0.0 && factor >= least_refinement * (1.0 - 1e-12) && factor <= largest_refinement)) {
      return fmt::format("every step must be {} to {} times smaller than the one before, got {:.6g} after {:.6g}",
                         least_refinement, largest_refinement, steps[i], i == 0 ? missing : steps[i - 1]);
    }
  }
  return "";
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

// Runs an extreme case; what it throws is its refusal.
Ending ended(const std::function<Ending()>& attempt) {
  try {
    return attempt();
  } catch (const std::exception& error) { return Ending::refused(error.what()); } catch (...) {
    return Ending::refused("something that is no std::exception was thrown");
  }
}

std::string wrong_answer(const Ending::Answer& answer) {
  if (answer.error >= 0.0 && answer.error <= answer.tolerance && std::isfinite(answer.tolerance)) return "";
  return fmt::format("the answer is wrong: its error {} must not exceed {}", answer.error, answer.tolerance);
}

}  // namespace

Rows::Rows(std::string case_name, Settings settings)
    : case_name_(std::move(case_name)), settings_(std::move(settings)), last_(std::chrono::steady_clock::now()) {}

void Rows::add(Row row) {
  if (row.failure.empty() && row.because.find_first_not_of(' ') == std::string::npos) {
    row.failure = "every row must say why its tolerance has this size, or why nothing else will do";
  }
  row.passed = row.passed && row.failure.empty();
  const auto now = std::chrono::steady_clock::now();
  row.seconds = std::chrono::duration<double>(now - last_).count();
  last_ = now;
  rows_.push_back(std::move(row));
}

void Rows::compare(const std::string& quantity, const Comparison& comparison) {
  Row row{.quantity = quantity,
          .expected = comparison.expected,
          .computed = comparison.computed,
          .because = comparison.because,
          .failure = wrong_tolerance(comparison.tolerance, comparison.expected)};
  measure(comparison, row);
  require_finite({comparison.expected, comparison.computed}, row);
  add(std::move(row));
}

void Rows::at_most(const std::string& quantity, const Bound& bound) {
  Row row{.quantity = quantity,
          .expected = bound.limit,
          .computed = bound.computed,
          .error = bound.computed - bound.limit,
          .metric = "at most",
          .tolerance = 0.0,
          .because = bound.because,
          .passed = bound.computed <= bound.limit};
  require_finite({bound.limit, bound.computed}, row);
  add(std::move(row));
}

void Rows::at_least(const std::string& quantity, const Bound& bound) {
  Row row{.quantity = quantity,
          .expected = bound.limit,
          .computed = bound.computed,
          .error = bound.limit - bound.computed,
          .metric = "at least",
          .tolerance = 0.0,
          .because = bound.because,
          .passed = bound.computed >= bound.limit};
  require_finite({bound.limit, bound.computed}, row);
  add(std::move(row));
}

void Rows::leave_out(const std::string& quantity, const Bound& bound) {
  add({.quantity = quantity,
       .expected = bound.limit,
       .computed = bound.computed,
       .metric = left_out,
       .because = bound.because,
       .passed = true});
}

void Rows::equal(const std::string& quantity, const Equality& equality) {
  const bool same = equality.expected.text() == equality.computed.text();
  Row row{.quantity = quantity,
          .expected = equality.expected.text(),
          .computed = equality.computed.text(),
          .error = same ? 0 : 1,
          .metric = "equal",
          .tolerance = 0,
          .because = equality.because,
          .passed = same};
  if (!equality.expected.given() || !equality.computed.given()) {
    row.failure = "both the expected and the computed value must be given";
  }
  add(std::move(row));
}

void Rows::order(const std::string& quantity, const Convergence& convergence) {
  add_order(quantity, convergence, true);
}

void Rows::order_at_least(const std::string& quantity, const Convergence& convergence) {
  add_order(quantity, convergence, false);
}

void Rows::add_order(const std::string& quantity, const Convergence& convergence, bool two_sided) {
  Row row{.quantity = quantity,
          .expected = convergence.nominal,
          .metric = two_sided ? "order" : "order at least",
          .tolerance = order_slack,
          .because = convergence.because,
          .failure = wrong_points(convergence)};
  if (row.failure.empty()) {
    const double order = fitted_order(convergence.steps, convergence.errors);
    const double error = two_sided ? std::abs(order - convergence.nominal) : convergence.nominal - order;
    row.computed = order, row.error = error, row.passed = error <= order_slack;
  }
  add(std::move(row));
}

void Rows::must_be_solved(const std::string& name, const std::function<Ending()>& attempt) {
  const Ending ending = ended(attempt);
  Row row{.quantity = name, .expected = "solved", .metric = "verdict", .because = "the library must give an answer"};
  if (const std::string* reason = ending.reason()) {
    row.failure = "it was refused: " + *reason;
    return add_verdict({.name = name, .must = "solved", .verdict = "refused", .reason = *reason}, std::move(row));
  }
  const Ending::Answer& answer = *ending.answer();
  row.error = answer.error, row.tolerance = answer.tolerance, row.because = answer.because;
  row.failure = wrong_answer(answer);
  row.passed = row.failure.empty();
  add_verdict({.name = name, .must = "solved", .verdict = row.passed ? "solved" : "wrong", .reason = row.failure},
              std::move(row));
}

void Rows::must_be_refused(const std::string& name, const std::string& key_words,
                           const std::function<Ending()>& attempt) {
  const Ending ending = ended(attempt);
  Row row{.quantity = name,
          .expected = "refused",
          .metric = "verdict",
          .because = fmt::format("the reason given must have the words: {}", fmt::join(words_of(key_words), ", "))};
  if (const Ending::Answer* answer = ending.answer()) {
    row.error = answer->error, row.tolerance = answer->tolerance;
    const std::string wrong = wrong_answer(*answer);
    row.failure = "it must be refused, and was not" + (wrong.empty() ? "" : "; " + wrong);
    return add_verdict(
        {.name = name, .must = "refused", .verdict = wrong.empty() ? "solved" : "wrong", .reason = row.failure},
        std::move(row));
  }
  const std::string& reason = *ending.reason();
  const std::vector<std::string> words = words_of(key_words);
  if (words.empty()) row.failure = "there must be key words to know the reason by, got none";
  for (const std::string& word : words) {
    if (reason.find(word) == std::string::npos) {
      row.failure = fmt::format("it was refused for another reason, without the word \"{}\": {}", word, reason);
    }
  }
  row.passed = row.failure.empty();
  add_verdict({.name = name,
               .must = "refused",
               .verdict = row.passed ? "refused" : "wrong",
               .reason = row.passed ? reason : row.failure},
              std::move(row));
}

void Rows::add_verdict(Stability verdict, Row row) {
  row.computed = verdict.verdict;
  stability_.push_back(std::move(verdict));
  add(std::move(row));
}

void Rows::fail(const std::string& quantity, const std::string& failure) {
  add({.quantity = quantity,
       .metric = "none",
       .because = "a case must end with its claim compared",
       .failure = failure});
}

void Rows::write(const std::string& name, const particulate::report::Table& table) const {
  if (settings_.output == nullptr) throw std::logic_error("rows: a run that writes tables must have a folder");
  settings_.output->write(name, table);
}

// FNV-1a over the name, then the finalizer of splitmix64 over both: cases whose names or seeds differ little get seeds
// that differ much.
std::uint64_t Rows::case_seed() const {
  std::uint64_t mixed = 0xcbf29ce484222325ULL;
  for (const char c : case_name_) mixed = (mixed ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  mixed += settings_.seed * 0x9e3779b97f4a7c15ULL;
  mixed = (mixed ^ (mixed >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  mixed = (mixed ^ (mixed >> 27U)) * 0x94d049bb133111ebULL;
  return mixed ^ (mixed >> 31U);
}

}  // namespace verification
