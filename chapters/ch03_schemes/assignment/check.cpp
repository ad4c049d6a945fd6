#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/phi_family.hpp>

#include "grading.hpp"

using grading::Answers;
using grading::Draw;
using grading::Finding;
using grading::Line;
using grading::mistakes;
using grading::Question;

/// What a step of two stages must give once its sweeps have converged; it stands in check_gauss.cpp.
/// @param variant  without meaning here
/// @param draw     numbers of the student
/// @return the line
Line gauss_step(int variant, Draw& draw);

/// What it must give after so many sweeps.
/// @param variant  without meaning here
/// @param draw     numbers of the student
/// @return the line
Line gauss_sweeps(int variant, Draw& draw);

namespace {

namespace schemes = particulate::schemes;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Sweeps, settings and a step as the student gets them.
struct Field {
  double w_0 = 0.0, w_K = 0.0;
  int K = 0, p = 2;
  double TOL = 0.0;
};

struct Step {
  double dt = 0.0;
  schemes::PhiControl control;  // of which TOL is not used
  std::vector<Field> fields;
};

schemes::Iteration iteration(const Field& field, double unit) {
  // The library keeps what is no number out of its measure: to it, sweeps that overflow have a last change beyond any.
  const double w_K = std::isnan(field.w_K) ? infinity : field.w_K, w_0 = std::isfinite(field.w_0) ? field.w_0 : 1.0;
  return {.w_0 = w_0 / unit, .w_K = w_K / unit, .K = field.K, .p = field.p};
}

double factor_by_library(const Field& field, int K_d) {
  if (field.K == 0) return infinity;
  return schemes::phi_K(iteration(field, 1.0), field.TOL, K_d);
}

// Staggered fields come to the controller in units of their tolerances, the worst as the iteration of the step.
std::vector<double> decision_by_library(const Step& step) {
  std::vector<schemes::Iteration> all;
  for (const Field& field : step.fields) all.push_back(iteration(field, field.TOL));
  const auto worst =
      std::max_element(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.w_K < b.w_K; });
  schemes::PhiControl control = step.control;
  control.TOL = 1.0;
  control.step = step.dt;
  validate(control);
  const schemes::Decision decision = control.judge({.dt = step.dt, .iteration = *worst, .fields = all});
  return {decision.accepted ? 1.0 : 0.0, control.step};
}

// What can be wrong. Where several mistakes give the same answer, the hint of the first one is shown.
struct Flaw {
  bool whole_numbers = false, forgotten_p = false, p_outside = false, swapped_contractions = false,
       counts_sweeps = false, same_root = false, same_root_desired = false, upside_down = false,
       contraction_inverted = false, last_change = false, forgotten_first = false, no_guard = false,
       small_is_zero = false, turned_decision = false, strictly_below = false, no_limit = false, forgotten_dt = false,
       no_floor = false, no_growth_bound = false, no_retry_bound = false, no_shrink_bound = false, first_field = false,
       common_tolerance = false, any_field = false, summed_errors = false, mean_factor = false, largest_factor = false;
};

const std::vector<std::pair<Flaw, std::string>> flaws{
    {{.strictly_below = true}, "a step that meets TOL exactly stands: w_K <= TOL"},
    {{.any_field = true}, "a step stands if every field has met its tolerance, not if some field has"},
    {{.summed_errors = true}, "the largest w_K/TOL decides, not the sum over the fields"},
    {{.turned_decision = true}, "the decision is turned round: a step stands if w_K <= TOL"},
    {{.no_limit = true}, "cap forgotten: no step is larger than limit"},
    {{.forgotten_dt = true}, "dt is forgotten: Phi_K and its bounds are factors, the next step is so many times dt"},
    {{.no_floor = true}, "bound forgotten: after an accepted step the next is not smaller, max(1, ...) dt"},
    {{.no_growth_bound = true}, "cap forgotten: after an accepted step at most growth dt"},
    {{.no_retry_bound = true}, "cap forgotten: after a refused step at most retry dt, or it fails by a hair again"},
    {{.no_shrink_bound = true}, "bound forgotten: after a refused step at least shrink dt"},
    {{.first_field = true}, "every field counts, not the first alone"},
    {{.common_tolerance = true}, "each field has a tolerance of its own"},
    {{.mean_factor = true}, "the smallest Phi_K of all fields rules, not their mean"},
    {{.largest_factor = true}, "the smallest Phi_K of all fields rules, not the largest"},
    {{.whole_numbers = true}, "1/(p K) of whole numbers is 0, and any number to the power of 0 is 1: write 1.0/(p K)"},
    {{.forgotten_p = true}, "p is forgotten: w_K = (S dt^p)^K w_0, so both roots are 1/(p K_d) and 1/(p K)"},
    {{.p_outside = true}, "p divides both exponents, 1/(p K_d) and 1/(p K): solve w_K = (S dt^p)^K w_0 for dt"},
    {{.swapped_contractions = true}, "K_d and K are swapped: K_d belongs to TOL, K to the w_K that was seen"},
    {{.counts_sweeps = true}, "K counts contractions, not sweeps: it is K as given, not K + 1"},
    {{.same_root = true}, "two roots: w_K was seen after K contractions, TOL is wanted after K_d"},
    {{.same_root_desired = true}, "two roots: w_K was seen after K contractions, TOL is wanted after K_d"},
    {{.upside_down = true}, "the ratio is inverted: a larger TOL allows a larger step"},
    {{.contraction_inverted = true}, "the contraction that was seen is (w_K/w_0)^(1/K), below 1 if it converges"},
    {{.last_change = true}, "TOL is compared with w_0, not with w_K: both errors start from the first change"},
    {{.forgotten_first = true}, "w_0 is forgotten: TOL and w_K are both reached from it, TOL/w_0 and w_K/w_0"},
    {{.no_guard = true}, "guard 0/0 and 1/0: w_K = 0 or K = 0 gives an infinite factor, before anything is divided"},
    {{.small_is_zero = true},
     "a small w_K is a number like any other: the factor is infinite only where it is exactly 0"}};

double flawed_factor(const Field& field, int K_d, const Flaw& flaw) {
  const bool saw_none = field.w_K == 0.0 || field.K == 0 || (flaw.small_is_zero && field.w_K < 1e-12);
  if (saw_none && !flaw.no_guard) return infinity;
  if (!std::isfinite(field.w_K)) return 0.0;
  double wanted = field.TOL / field.w_0, seen = field.w_K / field.w_0;
  double p = field.p, K = field.K, desired = K_d;
  if (flaw.whole_numbers) return 1.0;
  if (flaw.forgotten_p) p = 1.0;
  if (flaw.p_outside) p = 1.0 / p;
  if (flaw.swapped_contractions) std::swap(desired, K);
  if (flaw.counts_sweeps) K += 1.0;
  if (flaw.same_root) desired = K;
  if (flaw.same_root_desired) K = desired;
  if (flaw.contraction_inverted) seen = 1.0 / seen;
  if (flaw.last_change) wanted = field.TOL / field.w_K;
  if (flaw.forgotten_first) wanted = field.TOL, seen = field.w_K;
  if (flaw.upside_down) return 1.0 / flawed_factor(field, K_d, {});
  return std::pow(wanted, 1.0 / (p * desired)) / std::pow(seen, 1.0 / (p * K));
}

double flawed_factor(const Step& step, const Flaw& flaw) {
  double smallest = infinity, largest = 0.0, sum = 0.0;
  for (const Field& field : step.fields) {
    const double phi = flawed_factor(field, step.control.K_d, flaw);
    smallest = std::min(smallest, phi);
    largest = std::max(largest, phi);
    sum += phi;
  }
  if (flaw.largest_factor) return largest;
  if (flaw.mean_factor) return sum / static_cast<double>(step.fields.size());
  return smallest;
}

bool flawed_acceptance(const Step& step, const Flaw& flaw) {
  double smallest = infinity, largest = 0.0, sum = 0.0;
  for (const Field& field : step.fields) {
    const double w = std::isnan(field.w_K) ? infinity : field.w_K / field.TOL;
    smallest = std::min(smallest, w);
    largest = std::max(largest, w);
    sum += w;
  }
  if (flaw.turned_decision) return !(largest <= 1.0);
  if (flaw.strictly_below) return largest < 1.0;
  if (flaw.any_field) return smallest <= 1.0;
  if (flaw.summed_errors) return sum <= 1.0;
  return largest <= 1.0;
}

std::vector<double> flawed_decision(const Step& step, double phi, const Flaw& flaw) {
  const schemes::PhiControl& control = step.control;
  const bool accepted = flawed_acceptance(step, flaw);
  const bool is_free = accepted ? flaw.no_floor : flaw.no_shrink_bound;
  const double low = is_free ? 0.0 : accepted ? 1.0 : control.shrink;
  double high = accepted ? control.growth : control.retry;
  if (accepted ? flaw.no_growth_bound : flaw.no_retry_bound) high = infinity;
  const double next = std::clamp(phi, low, high) * (flaw.forgotten_dt ? 1.0 : step.dt);
  return {accepted ? 1.0 : 0.0, flaw.no_limit ? next : std::min(next, control.limit)};
}

std::vector<double> flawed_decision(Step step, const Flaw& flaw) {
  if (flaw.first_field) step.fields.resize(1);
  if (flaw.common_tolerance) {
    for (Field& field : step.fields) field.TOL = step.fields.front().TOL;
  }
  return flawed_decision(step, flawed_factor(step, flaw), flaw);
}

std::vector<double> inputs(const Field& field) {
  return {field.w_0, field.w_K, static_cast<double>(field.K), static_cast<double>(field.p), field.TOL};
}

// In the order in which the driver takes them.
std::vector<double> inputs(const Step& step) {
  const schemes::PhiControl& control = step.control;
  std::vector<double> all{step.dt,       static_cast<double>(control.K_d), control.limit, control.growth, control.retry,
                          control.shrink};
  for (const Field& field : step.fields) {
    for (const double x : inputs(field)) all.push_back(x);
  }
  return all;
}

Question ask_factor(const Field& field, int K_d) {
  Question question{.function = "step_factor", .inputs = inputs(field), .expected = {factor_by_library(field, K_d)}};
  question.inputs.push_back(K_d);
  question.mistakes =
      mistakes(flaws, [&](const Flaw& flaw) { return std::vector<double>{flawed_factor(field, K_d, flaw)}; });
  return question;
}

Question ask_decision(const Step& step) {
  return {.function = "next_step",
          .inputs = inputs(step),
          .expected = decision_by_library(step),
          .mistakes = mistakes(flaws, [&](const Flaw& flaw) { return flawed_decision(step, flaw); })};
}

// With the student's own Phi_K of the fields that have one.
void add_decision(Line& line, const Step& step, Question decision) {
  for (const Field& field : step.fields) {
    if (!std::isfinite(field.w_K)) continue;
    line.questions.push_back(ask_factor(field, step.control.K_d));
    line.questions.back().is_judged = false;
    ++decision.built_on;
  }
  decision.with_own = [step](const Answers& own) {
    double phi = own.size() < step.fields.size() ? 0.0 : infinity;
    for (const std::vector<double>& factor : own) phi = std::min(phi, factor[0]);
    return Answers{flawed_decision(step, phi, {})};
  };
  line.questions.push_back(std::move(decision));
}

void add_decision(Line& line, const Step& step) { add_decision(line, step, ask_decision(step)); }

// A field whose last change is `share` of its tolerance after K contractions.
Field field(int p, int K, double share, Draw& draw) {
  const double w_0 = draw.between(0.05, 0.2), TOL = p == 2 ? draw.between(1e-6, 3e-6) : draw.between(5e-6, 9e-6);
  return {.w_0 = w_0, .w_K = share * TOL, .K = K, .p = p, .TOL = TOL};
}

// The exponents of the fields: one of second order, or a motion with a temperature. Where both converge alike, the
// larger exponent has the smaller Phi_K.
std::vector<int> exponents(int variant) { return variant == 1 ? std::vector<int>{2} : std::vector<int>{2, 1}; }

// All fields that the variant has, alike, with bounds that no Phi_K in the exact case comes near to.
Step step(int variant, int K, int K_d, Draw& draw) {
  Step step;
  step.dt = draw.between(0.001, 0.009);
  step.control = {.K_d = K_d, .limit = 20.0 * step.dt, .growth = 8.0, .retry = 0.95, .shrink = 0.1};
  for (const int p : exponents(variant)) step.fields.push_back(field(p, K, draw.between(0.55, 0.9), draw));
  return step;
}

Step reversed(Step step) {
  std::reverse(step.fields.begin(), step.fields.end());
  return step;
}

// Steps that converge early, and others that do not, wholly or in their last field.
struct PlainSteps {
  Step early, late, one_late;
};

PlainSteps plain_steps(int variant, Draw& draw) {
  const int K = 4 + draw.one_of(2), K_d = 7 + draw.one_of(3);
  PlainSteps all{step(variant, K, K_d, draw), step(variant, K_d, K_d, draw), step(variant, K_d, K_d, draw)};
  for (Field& field : all.late.fields) field.w_K *= draw.between(20.0, 100.0);
  all.one_late.fields.back().w_K *= draw.between(20.0, 100.0);
  return all;
}

Line plain_factor(int variant, Draw& draw) {
  const PlainSteps all = plain_steps(variant, draw);
  Line line{.name = "step_factor: sweeps that converge early, sweeps that do not", .points = 3.0, .relative = 1e-10};
  for (const Step& step : {all.early, all.late}) {
    for (const Field& field : step.fields) line.questions.push_back(ask_factor(field, step.control.K_d));
  }
  return line;
}

Line plain_decision(int variant, Draw& draw) {
  const auto [early, late, one_late] = plain_steps(variant, draw);
  Line line{.name = "next_step: steps that converge early, steps that do not", .points = 3.0, .relative = 1e-10};
  // In this order each mistake first shows where no other one gives the same answer.
  for (const Step& step : {reversed(late), late, one_late, reversed(one_late), early, reversed(early)}) {
    add_decision(line, step);
  }
  return line;
}

// TOL is met exactly.
Step exactly_met(int variant, Draw& draw) {
  const int K_d = 6 + draw.one_of(3);
  Step met = step(variant, K_d, K_d, draw);
  for (Field& field : met.fields) field.w_K = field.TOL;
  return met;
}

Line bounds(int variant, Draw& draw) {
  const int K_d = 6 + draw.one_of(3);
  const Step met = exactly_met(variant, draw);
  Step grows = step(variant, 2, K_d, draw);
  for (Field& field : grows.fields) field.w_K *= 1e-3;
  grows.control.growth = draw.between(1.2, 1.8);
  Step limited = step(variant, 4, K_d + 3, draw);
  limited.fields.front().w_K = 0.95 * limited.fields.front().TOL;
  limited.fields.back().w_K = 0.1 * limited.fields.back().TOL;
  limited.control.limit = draw.between(1.02, 1.1) * limited.dt;
  Step barely = step(variant, K_d, K_d, draw);
  barely.fields.back().w_K = 1.01 * barely.fields.back().TOL;
  barely.control.retry = draw.between(0.7, 0.9);
  // Its sweeps diverge, and it stands all the same.
  Step slow = step(variant, 2, 8, draw);
  for (Field& field : slow.fields) field.w_0 = draw.between(0.05, 0.1) * field.TOL;
  Line line{.name = "next_step: TOL met exactly, and each bound", .points = 3.0, .relative = 1e-10};
  for (const Step& step : {grows, limited, met, slow, barely}) add_decision(line, step);
  return line;
}

// Linear problems on which a sweep contracts by the model exactly: from rest w_0 = 1, whatever the step.
struct Spring {
  double omega = 1.0;
  bool acceleration(double, schemes::In r, schemes::Out a) const {
    a = -omega * omega * r;
    return true;
  }
};

struct Decay {
  double c = 1.0;
  bool rate(double, schemes::In y, schemes::Out dy) const {
    dy = -c * y;
    return true;
  }
};

// Sweeps of the library's backward Euler, as many contractions as asked for.
template <class Problem, class State>
schemes::Iteration sweep(Problem problem, const State& from, double dt, int contractions) {
  schemes::BackwardEuler scheme;
  State to;
  schemes::Iteration it;
  scheme.predict(problem, from, dt, to);
  for (int k = 0; k <= contractions; ++k) it = scheme.sweep(problem, from, dt, to);
  if (!it.evaluated) it.w_K = infinity;
  return it;
}

// A field is known by its exponent: the spring has p = 2, the decay p = 1; one constant serves both.
schemes::Iteration sweep(int p, double constant, double dt, int contractions) {
  if (p == 1) {
    schemes::State start;
    start.y = Eigen::VectorXd::Ones(1);
    return sweep(Decay{constant}, start, dt, contractions);
  }
  schemes::State start;
  start.r = Eigen::VectorXd::Ones(1);
  start.v = Eigen::VectorXd::Zero(1);
  return sweep(Spring{constant}, start, dt, contractions);
}

struct Trial {
  Step step;
  std::vector<double> constants;  // of its fields, 1/s
};

// A step with these contractions, swept by the library until every field has met its tolerance, or K_d times.
Trial trial(int variant, double contraction_2, double contraction_1, Draw& draw) {
  Trial trial;
  Step& step = trial.step;
  step.dt = draw.between(0.01, 0.09);
  step.control = {.K_d = 6, .limit = 100.0 * step.dt, .growth = 50.0, .retry = 0.99, .shrink = 0.01};
  for (const int p : exponents(variant)) {
    trial.constants.push_back((p == 2 ? std::sqrt(contraction_2) : contraction_1) / step.dt);
    step.fields.push_back({.p = p, .TOL = p == 2 ? draw.between(1e-5, 2e-5) : draw.between(1e-4, 2e-4)});
  }
  bool met = false;
  for (int K = 1; K <= step.control.K_d && !met; ++K) {
    met = true;
    for (std::size_t k = 0; k < step.fields.size(); ++k) {
      Field& field = step.fields[k];
      const schemes::Iteration it = sweep(field.p, trial.constants[k], step.dt, K);
      field = {.w_0 = it.w_0, .w_K = it.w_K, .K = it.K, .p = field.p, .TOL = field.TOL};
      met = met && it.w_K <= field.TOL;
    }
  }
  return trial;
}

// What the step that the student proposes leaves after K_d contractions, over the tolerance, in the worst field.
double left_over(const Trial& trial, double dt) {
  if (!(dt > 0.0 && std::isfinite(dt))) return nan;
  double worst = 0.0;
  for (std::size_t k = 0; k < trial.constants.size(); ++k) {
    const Field& field = trial.step.fields[k];
    worst = std::max(worst, sweep(field.p, trial.constants[k], dt, trial.step.control.K_d).w_K / field.TOL);
  }
  return worst;
}

std::optional<Finding> meets_in_desired(const Trial& trial, const std::vector<double>& answer, double tolerance) {
  const int K_d = trial.step.control.K_d;
  const bool accepts = decision_by_library(trial.step).front() == 1.0;
  if ((answer[0] == 1.0) != accepts) {
    return Finding{fmt::format("the step of {:.6g} s is {}", trial.step.dt, accepts ? "accepted" : "refused"),
                   "the opposite", "a step stands if every field has w_K <= TOL, and only then"};
  }
  const double left = left_over(trial, answer[1]);
  if (std::abs(left - 1.0) <= tolerance) return std::nullopt;
  return Finding{
      fmt::format("w/TOL = 1 after {} contractions, swept by the library with your next step after {:.6g} s", K_d,
                  trial.step.dt),
      fmt::format("w/TOL = {:.10g} with your {:.10g} s", left, answer[1]),
      left > 1.0
          ? "your step is too large to meet TOL in K_d contractions: look at p, K, K_d and at the field that rules"
      : left < 1.0 ? "your step is smaller than TOL asks for: look at p, K, K_d and at the field that rules"
                   : "the next step must be positive and finite"};
}

Line order(int variant, Draw& draw) {
  // On the first the motion rules, on the second the temperature.
  const double small = draw.between(0.04, 0.06), large = draw.between(0.6, 0.8);
  Line line{.name = "order: the library sweeps with your next step, and meets TOL in K_d contractions", .points = 2.0};
  // Sweeps that have converged to TOL keep so many digits of their last change.
  line.relative = 1e-6;
  for (const Trial& swept : {trial(variant, small, small, draw), trial(variant, 0.5 * large, large, draw)}) {
    line.questions.push_back({.function = "next_step", .inputs = inputs(swept.step), .count = 2});
    line.questions.back().holds = [swept, tolerance = line.relative](const Answers& answers, std::size_t own) {
      return meets_in_desired(swept, answers[own], tolerance);
    };
  }
  return line;
}

// Steps whose last field is out of the ordinary.
Step extreme(int variant, double w_0, double w_K, int K, Draw& draw) {
  Step extreme = step(variant, K, 8, draw);
  extreme.control.growth = draw.between(1.2, 1.8);
  extreme.control.shrink = draw.between(0.2, 0.4);
  Field& last = extreme.fields.back();
  last.w_0 = w_0;
  last.w_K = w_K;
  return extreme;
}

Question ask_without_number(const Step& step) {
  Question question = ask_decision(step);
  const std::string accepts = "NaN fails every comparison: accept where w_K <= TOL, do not refuse where w_K > TOL";
  const std::string passes =
      "a field whose w_K is NaN or infinite counts with Phi_K = 0: ask for it first, std::min and std::clamp may pass "
      "a NaN by";
  const schemes::PhiControl& control = step.control;
  question.mistakes.insert(question.mistakes.begin(), {{{1.0, control.growth * step.dt}, accepts},
                                                       {{1.0, step.dt}, accepts},
                                                       {{0.0, control.retry * step.dt}, passes},
                                                       {{0.0, control.limit}, passes},
                                                       {{0.0, nan}, passes}});
  return question;
}

// Bounds far away: they must not hide what a single sweep says.
Step at_once(int variant, Draw& draw) {
  Step step = extreme(variant, 1e-9, 1e-9, 0, draw);
  step.control.growth = 500.0;
  step.control.limit = 1000.0 * step.dt;
  return step;
}

Step sharp(int variant, Draw& draw) {
  Step sharp = step(variant, 4, 6, draw);
  sharp.control.growth = 50.0;
  for (Field& field : sharp.fields) field = {.w_0 = 1e-3, .w_K = 1e-16, .K = 4, .p = field.p, .TOL = 1e-15};
  return sharp;
}

// Nothing is left to change: at once, after some sweeps, from the start.
std::vector<Step> without_change(int variant, Draw& draw) {
  return {extreme(variant, 0.1, 0.0, 3, draw), extreme(variant, 0.0, 0.0, 0, draw), extreme(variant, 0.0, 0.0, 3, draw),
          at_once(variant, draw)};
}

Line extreme_line(const char* name) {
  Line line{.name = name, .points = 2.0, .relative = 1e-10};
  line.otherwise =
      "w_K = 0 or K = 0 gives an infinite factor; a w_K that is infinite or NaN is refused with shrink dt; no small "
      "number belongs into a quotient";
  return line;
}

Line extreme_factor(int variant, Draw& draw) {
  Line line = extreme_line("step_factor: TOL met exactly, nothing moves, one sweep is enough, TOL = 1e-15");
  for (const Step& step : {sharp(variant, draw), exactly_met(variant, draw)}) {
    line.questions.push_back(ask_factor(step.fields.front(), step.control.K_d));
  }
  for (const Step& step : without_change(variant, draw)) line.questions.push_back(ask_factor(step.fields.back(), 8));
  return line;
}

Line extreme_decision(int variant, Draw& draw) {
  Line line = extreme_line("next_step: divergence, overflow, nothing moves, TOL = 1e-15");
  for (const Step& step :
       {sharp(variant, draw), extreme(variant, 0.1, 1e30, 8, draw), extreme(variant, 0.1, infinity, 8, draw)}) {
    add_decision(line, step);
  }
  const Step no_number = extreme(variant, 0.1, nan, 8, draw);
  add_decision(line, no_number, ask_without_number(no_number));
  add_decision(line, extreme(variant, infinity, infinity, 3, draw));
  for (const Step& step : without_change(variant, draw)) add_decision(line, step);
  return line;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string sweeps = "w_0 w_K K p TOL";
  return grading::run(
      argc, argv,
      {.title = "Chapter 3: the step size from the sweeps, and a step of two stages",
       .variants = {"one field of second order, p = 2", "two staggered fields, p = 2 and 1, each with its tolerance"},
       .lines = {plain_factor, extreme_factor, plain_decision, bounds, extreme_decision, order, gauss_step,
                 gauss_sweeps},
       .calls = {{"step_factor", sweeps + " K_d -> Phi_K"},
                 {"next_step", "dt K_d limit growth retry shrink ... " + sweeps + " -> accepted next"},
                 {"gauss2_step", "r v dt sweeps A B k -> r v"}}});
}
